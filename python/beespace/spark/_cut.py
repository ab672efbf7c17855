"""Space cut into cells by planes across its axes: which cell is a point's home, and in which halos it is."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

Axes = list[NDArray[np.float64]]
Rows = NDArray[np.int64]

# Each side of a plane has at least this share of the points: one of so many.
_FEWEST_ASIDE = 64
# A plane so many points farther from the middle is as good as one with a point more in halos.
_OFF_THE_MIDDLE = 8
# At most one of so many points is in halos because of a plane: where a cell has more points than the
# limit, and where it is cut only to give work to all processors.
_MOST_IN_HALOS = 2
_MOST_IN_HALOS_OF_SMALL = 8
_LEAF = -1
# Of points from cells, so many are computed at a time.
_DISTANCES_AT_ONCE = 1 << 20


class Cut:
    """A tree of planes. What is below a plane belongs to its left side.

    Two points within reach of each other along each axis are together in the cell that is home of
    either: if a < plane <= b and b - a <= reach as real numbers, then a is not below the rounded
    plane - reach and b not above the rounded plane + reach, as rounding keeps order.
    """

    def __init__(self) -> None:
        self.axis = [_LEAF]
        self.plane = [0.0]
        self.low = [0.0]
        self.high = [0.0]
        self.child = [0]  # of a leaf: its cell
        self.homes: list[int] = []  # of each cell, how many points of the sample are at home
        self.copies: list[int] = []  # and how many are in its halo
        self.boxes: list[NDArray[np.float64]] = []  # and the lowest and the highest of them along each axis

    @property
    def cells(self) -> int:
        """How many cells there are, numbered from 0."""
        return len(self.homes)

    @classmethod
    def of_sample(cls, sample: Axes, reach: list[float], most: float, wanted: float) -> Cut:
        """Cuts until no cell has more than `wanted` points of the sample, halo included, as far as that
        costs little; and until none has more than `most`, as far as that helps at all."""
        cut = cls()
        everything: Rows = np.arange(len(sample[0]))
        waiting: list[tuple[int, Rows, Rows]] = [(0, everything, everything[:0])]
        while waiting:
            node, home, halo = waiting.pop()
            size = len(home) + len(halo)
            share = _MOST_IN_HALOS if size > most else _MOST_IN_HALOS_OF_SMALL
            found = None
            if size > wanted:
                found = _find_plane([axis[home] for axis in sample], reach, share)
            if found is None:
                cut.child[node] = cut.cells
                cut.homes.append(len(home))
                cut.copies.append(len(halo))
                cut.boxes.append(_box_of(sample, home))
                continue
            waiting += cut._split(node, found, sample, reach, home, halo)
        return cut

    def _split(
        self, node: int, found: tuple[int, float], sample: Axes, reach: list[float], home: Rows, halo: Rows
    ) -> list[tuple[int, Rows, Rows]]:
        axis, plane = found
        left = len(self.axis)
        self.axis[node], self.plane[node], self.child[node] = axis, plane, left
        self.low[node], self.high[node] = plane - reach[axis], plane + reach[axis]
        for column in (self.plane, self.low, self.high):
            column += [0.0, 0.0]
        self.axis += [_LEAF, _LEAF]
        self.child += [0, 0]
        sides = self._sides(node, sample[axis], home)
        of_halo = self._sides(node, sample[axis], halo)
        return [
            (left + side, sides[side][0], np.concatenate([sides[side][1], *of_halo[side]]))
            for side in (0, 1)
        ]

    def _sides(self, node: int, along: NDArray[np.float64], rows: Rows) -> list[tuple[Rows, Rows]]:
        """Of each side of a plane: who is on it, and who is on the other one within reach."""
        at = along[rows]
        right = at >= self.plane[node]
        near = (at >= self.low[node]) & (at <= self.high[node])
        return [(rows[~right], rows[near & right]), (rows[right], rows[near & ~right])]

    def distribute(self, axes: Axes) -> Iterator[tuple[int, Rows, Rows]]:
        """Of each cell that gets any of the points: the rows at home, and those in its halo."""
        rows: Rows = np.arange(len(axes[0]))
        waiting: list[tuple[int, Rows, Rows]] = [(0, rows, rows[:0])]
        while waiting:
            node, home, halo = waiting.pop()
            if not len(home) and not len(halo):
                continue
            if self.axis[node] == _LEAF:
                yield self.child[node], home, halo
                continue
            along = axes[self.axis[node]]
            sides = self._sides(node, along, home)
            of_halo = self._sides(node, along, halo)
            for side in (0, 1):
                own, near = sides[side]
                waiting.append((self.child[node] + side, own, np.concatenate([near, *of_halo[side]])))

    def within(self, axes: Axes, radii: NDArray[np.float64]) -> Iterator[tuple[int, Rows]]:
        """Of each cell in which anything may be that is not farther than the radius along any axis: the
        rows of the points for which that holds.

        What is not above a point + its radius as real numbers is not above their rounded sum either,
        as rounding keeps order; so if it is not below a plane, nor is the sum.
        """
        rows: Rows = np.arange(len(radii))
        waiting: list[tuple[int, Rows]] = [(0, rows)]
        while waiting:
            node, some = waiting.pop()
            if not len(some):
                continue
            if self.axis[node] == _LEAF:
                yield self.child[node], some
                continue
            at, plane = axes[self.axis[node]][some], self.plane[node]
            left = self.child[node]
            waiting.append((left, some[at - radii[some] <= plane]))
            waiting.append((left + 1, some[at + radii[some] >= plane]))

    def touching(self, low: Axes, high: Axes) -> Iterator[tuple[int, Rows]]:
        """Of each cell: the rows of the boxes that come within reach of anything at home in it."""
        rows: Rows = np.arange(len(low[0]))
        waiting: list[tuple[int, Rows]] = [(0, rows)]
        while waiting:
            node, some = waiting.pop()
            if not len(some):
                continue
            if self.axis[node] == _LEAF:
                yield self.child[node], some
                continue
            axis, left = self.axis[node], self.child[node]
            waiting.append((left, some[low[axis][some] <= self.high[node]]))
            waiting.append((left + 1, some[high[axis][some] >= self.low[node]]))

    def bounds(self, axes: Axes, count: int) -> NDArray[np.float64]:
        """How far from each point so many points of the sample are at most; infinity where it has fewer."""
        bounds = np.full(len(axes[0]), np.inf)
        if sum(self.homes) < count:
            return bounds
        boxes = np.array(self.boxes)
        homes = np.array(self.homes)
        at_once = max(_DISTANCES_AT_ONCE // len(homes), 1)
        for begin in range(0, len(bounds), at_once):
            squares = np.zeros((len(bounds[begin : begin + at_once]), len(homes)))
            for axis, along in enumerate(axes):
                at = along[begin : begin + at_once, None]
                far = np.maximum(np.abs(at - boxes[:, 0, axis]), np.abs(boxes[:, 1, axis] - at))
                squares += far * far
            order = np.argsort(squares, axis=1, kind="stable")
            enough = (np.cumsum(homes[order], axis=1) >= count).argmax(axis=1)
            last = order[np.arange(len(order)), enough]
            bounds[begin : begin + at_once] = np.sqrt(squares[np.arange(len(order)), last])
        return bounds * (1 + 2.0**-40)


def _box_of(sample: Axes, rows: Rows) -> NDArray[np.float64]:
    some = [axis[rows] for axis in sample]
    if not len(rows):
        return np.zeros((2, len(sample)))
    return np.array([[each.min() for each in some], [each.max() for each in some]])


def _find_plane(axes: Axes, reach: list[float], share: int) -> tuple[int, float] | None:
    """Across the axis along which the points reach farthest, or else the next one: where few points are
    within reach of the plane, near their middle."""
    if len(axes[0]) < 2:
        return None
    widths: list[tuple[float, int]] = [
        ((float(along.min()) - float(along.max())) / reach[axis], axis) for axis, along in enumerate(axes)
    ]
    for _, axis in sorted(widths):
        plane = _find_value(np.sort(axes[axis]), reach[axis], share)
        if plane is not None:
            return axis, plane
    return None


def _find_value(along: NDArray[np.float64], reach: float, share: int) -> float | None:
    count = len(along)
    aside = count // _FEWEST_ASIDE
    lowest = int(np.count_nonzero(along == along[0]))
    at = np.arange(max(aside, lowest), count - aside)
    if not len(at):
        return None
    first = np.searchsorted(along, along[at] - reach, "left")
    last = np.searchsorted(along, along[at] + reach, "right")
    halo = last - first
    weight = np.where(
        halo > count // share, count * 2, halo + np.abs(at - count // 2) // _OFF_THE_MIDDLE
    )
    best = int(weight.argmin())
    return float(along[at[best]]) if weight[best] < count * 2 else None
