"""How questions about points reach the library, and what comes back."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from typing import Any

import numpy as np

from beespace import _library
from beespace._answers import Nearest
from beespace._calls import check, run_of, whole
from beespace._columns import Result
from beespace._errors import invalid
from beespace._frames import check_upright
from beespace._points import Points


class Asking:
    """Asks functions of the library: by itself without an engine."""

    __slots__ = ()

    def _ask(
        self,
        function: Any,
        points: Points,
        others: Points | None,
        arguments: tuple[Any, ...],
        threads: int,
        two_sets: bool = True,
        places: Mapping[str, str] | None = None,
    ) -> Result:
        error = _library.new_error()
        result = Result()
        run = run_of(threads, points.count + (0 if others is None else others.count))
        sets: tuple[Any, ...] = (ctypes.byref(points.struct),)
        if two_sets:
            sets += (None if others is None else ctypes.byref(others.struct),)
        code = self._call(
            function,
            (
                *sets,
                *arguments,
                None if run is None else ctypes.byref(run),
                result.handle,
                ctypes.byref(error),
            ),
        )
        if code != _library.OK:
            check(code, error, places)
        return result

    def _call(self, function: Any, arguments: tuple[Any, ...]) -> int:
        return int(function(None, *arguments))


# There are never more points.
_MOST_POINTS = 2**32


def neighbours_of(k: Any) -> int:
    """How many neighbours are asked for."""
    number = whole(k, "k")
    if number > _MOST_POINTS:
        raise invalid(f"there are never more than {_MOST_POINTS:,} points, and this is {number:,}", "k")
    return number


def nearest_of(result: Result, rows: int, k: int) -> Nearest:
    """Rows of k entries, filled up where there are fewer."""
    ids, distances = result.ids(), result.distances()
    if len(ids) == rows * k:
        return Nearest(ids.reshape(rows, k), distances.reshape(rows, k))
    found = len(ids) // rows
    all_ids = np.full((rows, k), -1, np.int64)
    all_distances = np.full((rows, k), np.inf)
    all_ids[:, :found] = ids.reshape(rows, found)
    all_distances[:, :found] = distances.reshape(rows, found)
    return Nearest(all_ids, all_distances)


def sets_of(
    points: Any, others: Any, copy: bool, vertical: Any = None
) -> tuple[Points, Points | None]:
    first = Points(points, "points", copy)
    check_upright(first, vertical, "vertical")
    if others is None:
        return first, None
    second = Points(others, "others", copy)
    check_upright(second, vertical, "vertical")
    second.check_alike(first, "others", "points")
    return first, second


def refuse_self(include_self: bool, others: Any) -> None:
    if include_self and others is not None:
        raise invalid("a point is not among the others: leave this out", "include_self")
