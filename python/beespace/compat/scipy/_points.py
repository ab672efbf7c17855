"""The points of a tree, and what beespace says about them: inclusive, as SciPy's radii are."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import beespace
from beespace import BeespaceError, Neighbors, Pairs
from beespace._one_place import PlaceIndex
from beespace.compat.scipy._handing import HandOver

# An index is asked place by place; a search of its own sorts all points first, and is faster from about
# this part of the number of points on.
_PART = 8

_domain = {
    "not_finite": "coordinates that are not finite",
    "outside_domain": "coordinates or a radius beyond 2^400 or 2^-400",
    "invalid_threshold": "coordinates or a radius beyond 2^400 or 2^-400",
    "too_many_points": "more points than beespace takes",
}


class handing_over_what_is_outside:
    """Hands over what SciPy may take and beespace does not. Other errors stay errors."""

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        if isinstance(error, BeespaceError) and error.code in _domain:
            raise HandOver(_domain[error.code]) from None


class TreePoints:
    """The points of one tree, two or three coordinates each, all finite."""

    def __init__(self, data: NDArray[np.float64]) -> None:
        self.data = data
        self._index: PlaceIndex | None = None

    def __len__(self) -> int:
        return len(self.data)

    @property
    def index(self) -> PlaceIndex:
        if self._index is None:
            self._index = PlaceIndex(self.data)
        return self._index

    def index_or_none(self) -> PlaceIndex | None:
        """The index; None where there can be none of these points."""
        try:
            return self.index
        except BeespaceError:
            return None

    def nearest(
        self, places: NDArray[Any], k: int, threads: int
    ) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
        """The k nearest points of each place; k is at most their number."""
        if k == 1 and self._asked_by_many(places):
            return beespace.nearest(places, 1, others=self.data, threads=threads)
        return self.index.nearest(places, k, threads=threads)

    def most_within(self, places: NDArray[Any], radius: float, k: int, threads: int) -> int:
        """How many of the k nearest points any place has within a radius, or k."""
        if radius == 0.0:
            return 0
        try:
            rows = self.index.around(
                places, radius, inclusive=True, max_results=k * len(places), threads=threads
            )
        except BeespaceError as error:
            if error.code == "too_many_results":
                return k
            raise
        return min(k, int(np.diff(rows.indptr).max(initial=0)))

    def around(
        self, places: NDArray[Any], radius: float | NDArray[np.float64], threads: int = 1
    ) -> Neighbors:
        """The points within a radius of each place."""
        if isinstance(radius, float) and radius and self._asked_by_many(places):
            return beespace.neighbors(
                places, radius, others=self.data, distances=False, inclusive=True, threads=threads
            )
        return self.index.around(places, radius, inclusive=True, threads=threads)

    def count_around(
        self, places: NDArray[Any], radius: float | NDArray[np.float64], threads: int = 1
    ) -> NDArray[np.int64]:
        """How many points are within a radius of each place."""
        if isinstance(radius, float) and radius and self._asked_by_many(places):
            return beespace.count(places, radius, others=self.data, inclusive=True, threads=threads)
        return np.diff(self.around(places, radius, threads).indptr)

    def pairs(self, radius: float) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Pairs of its points, each once."""
        if radius == 0.0:
            i, j, _ = self.between(self, 0.0, False)
            once = i < j
            return i[once], j[once]
        found = beespace.pairs(self.data, radius, distances=False, inclusive=True)
        return found.i, found.j

    def between(
        self, other: TreePoints, radius: float, distances: bool
    ) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float64]]:
        """Pairs of a point of its own and a point of another tree, or of itself."""
        if radius != 0.0 and other.data is not self.data:
            found: Pairs = beespace.pairs(
                self.data, radius, others=other.data, distances=distances, inclusive=True
            )
            return found.i, found.j, _or_none(found.distance)
        rows = self.rows(other, radius, distances)
        return (
            np.repeat(np.arange(len(rows)), np.diff(rows.indptr)),
            rows.indices,
            _or_none(rows.distances),
        )

    def rows(self, other: TreePoints, radius: float, distances: bool = False) -> Neighbors:
        """For each of its points those of another tree, or of itself, within a radius."""
        if radius == 0.0:
            rows = other.index.around(self.data, 0.0, inclusive=True)
            rows.distances = np.zeros(len(rows.indices)) if distances else None
            return rows
        itself = other.data is self.data
        return beespace.neighbors(
            self.data,
            radius,
            others=None if itself else other.data,
            include_self=itself,
            distances=distances,
            inclusive=True,
        )

    def count_between(self, other: TreePoints, radius: float) -> int:
        """How many pairs `between` would give."""
        if radius == 0.0:
            return len(self.rows(other, 0.0).indices)
        itself = other.data is self.data
        return int(
            beespace.count(
                self.data,
                radius,
                others=None if itself else other.data,
                include_self=itself,
                inclusive=True,
            ).sum()
        )

    def _asked_by_many(self, places: NDArray[Any]) -> bool:
        return len(places) * _PART >= len(self.data)


def _or_none(distances: NDArray[np.float64] | None) -> NDArray[np.float64]:
    return np.empty(0) if distances is None else distances


def in_lists(rows: Neighbors) -> list[list[int]]:
    """Rows as lists of Python's integers."""
    ids = rows.indices.tolist()
    ends = rows.indptr.tolist()
    return [ids[begin:end] for begin, end in zip(ends, ends[1:])]
