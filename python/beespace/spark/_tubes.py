"""Windows of a recording with more agents than a task has memory for, cut into cells.

A tube is what a window has of an agent: all its fixes there. Along each axis a short tube reaches at most S from its
first fix, which says in which cell it is at home. Two agents in conflict are, at some instant, within reach X of each
other along each axis, so the first fixes of two short tubes are within X + 2 S, and each is near the home of the
other (see `Cut`). The few that go farther are in each cell that they come within X + 2 S of, and all of them in a cell
of their own. A pair of short ones belongs to the home of its lower agent, a short one and one that goes far to the
home of the short one, two that go far to their own cell. So each pair that can be in conflict is together in exactly
one cell that tells it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from beespace.spark._blocks import Columns, integers
from beespace.spark._cut import Cut
from beespace.spark._survey import mixed
from beespace.spark._windows import FAR, HOME, NEAR, WINDOW_COLUMNS, Windows
from beespace.spark._workers import arrow

TUBES_SCHEMA = "window int, fixes long, tubes long, keys binary, sample binary"

# The most tubes of the sample that a partition gives, of all windows, and of each at least.
_SAMPLE = 16_384
_LEAST_OF_WINDOW = 64
# Shares of tubes that may be taken for such as go far along an axis: what serves best is chosen.
_FAR = (0.0, 0.01, 0.05, 0.2)


class WindowCut(NamedTuple):
    """How a window is cut."""

    cut: Cut
    short: NDArray[np.float64]  # how far short tubes reach along each axis


class Tubes(NamedTuple):
    """Rows of windows, and the tubes that they make up."""

    rows: Any  # of pyarrow
    begins: NDArray[np.int64]  # of each tube its first row, and the number of rows
    windows: NDArray[np.int64]
    fixes: NDArray[np.int64]  # how many
    first: NDArray[np.float64]  # time and place of the first fix
    low: NDArray[np.float64]
    high: NDArray[np.float64]

    @property
    def reach(self) -> NDArray[np.float64]:
        """How far each reaches along each axis, rounded up."""
        return np.nextafter(self.high - self.low, np.inf)


def tubes_of(windows: Windows, batches: Iterator[Any], columns: Columns) -> Iterator[Tubes]:
    """Whole tubes, of fixes that are sorted by agent and time."""
    pyarrow = arrow()

    # Rows of the agent that the next fixes may be of.
    waiting: Any = None
    for batch in windows(batches):
        table = pyarrow.Table.from_batches([batch])
        if waiting is not None:
            table = pyarrow.concat_tables([waiting, table])
        waiting, whole = _last_agent(table, windows.borders, columns)
        if whole.num_rows:
            yield _tubes(whole, columns)
    if waiting is not None and waiting.num_rows:
        yield _tubes(waiting, columns)


def _last_agent(table: Any, borders: NDArray[np.float64], columns: Columns) -> tuple[Any, Any]:
    """The rows to which others may come: those of the last agent that its last fix leads on from; and the
    others."""
    pyarrow = arrow()
    ids = table.column("id").to_pylist()
    last = max(ids)
    is_last = np.fromiter((id == last for id in ids), bool, len(ids))
    numbers, ends = _numbers_of(table, columns)
    latest = numbers[ends[1:] - 1, 0][is_last].max()
    window = integers(table.column("window").combine_chunks())
    leads_on = int(np.searchsorted(borders, float(latest), "left"))
    open_ones = is_last & (window >= leads_on)
    return table.filter(pyarrow.array(open_ones)), table.filter(pyarrow.array(~open_ones))


def _numbers_of(table: Any, columns: Columns) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """The fixes of all rows, and where those of each begin and the last ends."""
    data: list[bytes] = table.column("fixes").to_pylist()
    each = 1 + columns.width
    numbers = np.frombuffer(b"".join(data)).reshape(-1, each)
    lengths = np.fromiter(map(len, data), np.int64, len(data)) // (8 * each)
    return numbers, np.append(0, np.cumsum(lengths))


def _tubes(table: Any, columns: Columns) -> Tubes:
    table = table.sort_by([(key, "ascending") for key in ("window", "id", "first")])
    windows = np.asarray(table.column("window").to_numpy()).astype(np.int64)
    ids = table.column("id").to_pylist()
    same = np.fromiter((a == b for a, b in zip(ids[1:], ids)), bool, len(ids) - 1)
    new = np.append(True, ~same | (windows[1:] != windows[:-1]))
    begins = np.flatnonzero(new)
    numbers, ends = _numbers_of(table, columns)
    starts = ends[begins]
    places = numbers[:, 1 : 1 + columns.searched]
    return Tubes(
        table,
        np.append(begins, len(ids)),
        windows[begins],
        np.diff(np.append(starts, len(numbers))),
        numbers[starts, : 1 + columns.searched],
        np.minimum.reduceat(places, starts, axis=0),
        np.maximum.reduceat(places, starts, axis=0),
    )


class TubeSurveyor:
    """How many tubes and fixes each window has, and a sample of them: for `mapInArrow`."""

    def __init__(self, windows: Windows, columns: Columns) -> None:
        self.windows = windows
        self.columns = columns

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        pyarrow = arrow()

        most = max(_SAMPLE // (len(self.windows.borders) + 1), _LEAST_OF_WINDOW)
        fixes: dict[int, int] = {}
        count: dict[int, int] = {}
        samples: dict[int, tuple[NDArray[np.uint64], NDArray[np.float64]]] = {}
        for tubes in tubes_of(self.windows, batches, self.columns):
            told = np.concatenate([tubes.first[:, 1:], tubes.reach], axis=1)
            keys = _keys_of(tubes.first)
            for window in np.unique(tubes.windows).tolist():
                some = np.flatnonzero(tubes.windows == window)
                fixes[window] = fixes.get(window, 0) + int(tubes.fixes[some].sum())
                count[window] = count.get(window, 0) + len(some)
                both = keys[some], told[some]
                if window in samples:
                    kept = samples[window]
                    both = np.concatenate([kept[0], both[0]]), np.concatenate([kept[1], both[1]])
                order = np.argsort(both[0], kind="stable")[:most]
                samples[window] = both[0][order], both[1][order]
        numbers = sorted(samples)
        arrays = [
            pyarrow.array(numbers, type="int32"),
            pyarrow.array([fixes[window] for window in numbers], type="int64"),
            pyarrow.array([count[window] for window in numbers], type="int64"),
            pyarrow.array([samples[window][0].tobytes() for window in numbers], type="binary"),
            pyarrow.array([samples[window][1].tobytes() for window in numbers], type="binary"),
        ]
        names = [each.split()[0] for each in TUBES_SCHEMA.split(", ")]
        yield pyarrow.RecordBatch.from_arrays(arrays, names)


def _keys_of(first: NDArray[np.float64]) -> NDArray[np.uint64]:
    keys = np.zeros(len(first), np.uint64)
    for column in range(first.shape[1]):
        bits = np.ascontiguousarray(first[:, column]).view(np.uint64)
        keys = mixed((keys ^ bits).view(np.int64))
    return keys


class WindowFacts(NamedTuple):
    """How a window is cut, and about how many fixes each of its cells has; the last one that of those
    which go far."""

    cut: WindowCut | None
    sizes: list[float]


def facts_of(rows: list[Any], reach: list[float], most: int) -> WindowFacts:
    """How to cut a window, of what all partitions tell of it, so that cells have so many fixes at most."""
    axes = len(reach)
    fixes = sum(row["fixes"] for row in rows)
    if fixes <= most:
        return WindowFacts(None, [float(fixes)])
    keys = [np.frombuffer(row["keys"], np.uint64) for row in rows]
    samples = [np.frombuffer(row["sample"]).reshape(-1, 2 * axes) for row in rows]
    # A partition that gives all its tubes does not limit the others.
    below = min(
        (int(key.max()) for key, row in zip(keys, rows) if row["tubes"] > len(key)), default=2**64 - 1
    )
    sample = np.concatenate([each[key <= np.uint64(below)] for key, each in zip(keys, samples)])
    fixes_each = fixes / len(sample)  # that one of the sample stands for
    tried = [_facts_with(sample, share, reach, most / fixes_each) for share in _FAR]
    best = min(tried, key=lambda facts: max(facts.sizes))
    return WindowFacts(best.cut, [size * fixes_each for size in best.sizes])


def _facts_with(
    sample: NDArray[np.float64], far: float, reach: list[float], limit: float
) -> WindowFacts:
    """A cut where this share of tubes goes far along each axis, and how many of the sample its cells have."""
    axes = len(reach)
    first, reaching = sample[:, :axes], sample[:, axes:]
    short = np.quantile(reaching, 1 - far, axis=0, method="higher")
    is_short = (reaching <= short).all(axis=1)
    wide = [
        float(np.nextafter(along + np.nextafter(2 * own, np.inf), np.inf))
        for along, own in zip(reach, short.tolist())
    ]
    cut = Cut.of_sample(list(np.ascontiguousarray(first[is_short].T)), wide, limit, limit)
    sizes = [float(home + near) for home, near in zip(cut.homes, cut.copies)]
    low = list(np.ascontiguousarray((first - reaching)[~is_short].T))
    high = list(np.ascontiguousarray((first + reaching)[~is_short].T))
    for cell, touching in cut.touching(low, high):
        sizes[cell] += len(touching)
    return WindowFacts(WindowCut(cut, short), [*sizes, float((~is_short).sum())])


class IntoCells:
    """Fixes, sorted by agent and time, into rows of an agent in a cell of a window: for `mapInArrow`."""

    def __init__(self, windows: Windows, columns: Columns, cuts: dict[int, WindowCut]) -> None:
        self.windows = windows
        self.columns = columns
        self.cuts = cuts

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        for tubes in tubes_of(self.windows, batches, self.columns):
            for window in np.unique(tubes.windows).tolist():
                some = np.flatnonzero(tubes.windows == window)
                for cell, role, whom in self._cells(tubes, window, some):
                    if len(whom):
                        yield from self._rows(tubes, window, cell, role, whom)

    def _cells(
        self, tubes: Tubes, window: int, some: NDArray[np.int64]
    ) -> Iterator[tuple[int, int, NDArray[np.int64]]]:
        """Of each cell the tubes that are in it, and as what."""
        if window not in self.cuts:
            yield 0, HOME, some
            return
        cut, short = self.cuts[window]
        is_short = (tubes.reach[some] <= short).all(axis=1)
        near, far = some[is_short], some[~is_short]
        places = [np.ascontiguousarray(axis) for axis in tubes.first[near, 1:].T]
        for cell, home, halo in cut.distribute(places):
            yield cell, HOME, near[home]
            yield cell, NEAR, near[halo]
        yield cut.cells, HOME, far
        low = [np.ascontiguousarray(axis) for axis in tubes.low[far].T]
        high = [np.ascontiguousarray(axis) for axis in tubes.high[far].T]
        for cell, touching in cut.touching(low, high):
            yield cell, FAR, far[touching]

    def _rows(
        self, tubes: Tubes, window: int, cell: int, role: int, whom: NDArray[np.int64]
    ) -> Iterator[Any]:
        pyarrow = arrow()

        lengths = tubes.begins[whom + 1] - tubes.begins[whom]
        behind = np.arange(int(lengths.sum())) - np.repeat(np.cumsum(lengths) - lengths, lengths)
        rows: NDArray[np.int64] = np.repeat(tubes.begins[whom], lengths) + behind
        table = tubes.rows.take(pyarrow.array(rows)).combine_chunks()
        told = [self.windows.parts[window][cell], window, cell, role]
        arrays = [pyarrow.array(np.full(len(rows), each, np.int32)) for each in told]
        kept = [table.column(name).combine_chunks() for name in ("id", "first", "fixes")]
        kept = [each.chunk(0) if hasattr(each, "chunk") else each for each in kept]
        yield pyarrow.RecordBatch.from_arrays([*arrays, *kept], WINDOW_COLUMNS)


def windows_of(fixes: int, at_once: int, most: int, worth: int, together: float) -> int:
    """Into how many windows time is cut, of so many fixes, where about so many agents are there together.

    Each agent has some fixes in a window that other windows have too, so there are at least as many others.
    """
    size = min(most, max(fixes / at_once, worth if most > worth else 1))
    return math.ceil(fixes / max(size, 2 * together)) if fixes else 1
