"""Questions to an index about one place: most of the time of such a call is its own preparation."""

from __future__ import annotations

import ctypes

import numpy as np
from numpy.typing import NDArray

from beespace import _library
from beespace._index import Index
from beespace._library import CPoints, CSearch, at_once, library
from beespace._points import PointsLike

# A result that has had more ids is not kept: its memory is.
_MOST_KEPT = 10_000


class _Structures:
    """What one call needs. Prepared once, and used by one thread at a time."""

    __slots__ = ("_error", "_points", "_search", "error", "place", "points", "result", "search")

    def __init__(self) -> None:
        self.place = (ctypes.c_double * 3)()
        at = ctypes.addressof(self.place)
        self._points = CPoints(
            ctypes.sizeof(CPoints), _library.FLOAT64, 0, 1, at, at + 8, at + 16, 24, 24, 24
        )
        self._search = CSearch(ctypes.sizeof(CSearch), _library.INCLUSIVE)
        self._error = _library.new_error()
        self.points = ctypes.byref(self._points)
        self.search = ctypes.byref(self._search)
        self.error = ctypes.byref(self._error)
        self.result = at_once.beespace_result_create()
        if not self.result:
            raise MemoryError("beespace: no memory for a result")

    def set_radius(self, radius: float) -> None:
        self._search.threshold_m = radius


class PlaceIndex(Index):
    """An index that is also asked about one place at a time, given as two or three floats.

    What the library refuses is answered by None: ask in the general way for the error.
    """

    __slots__ = ("_kept",)

    def __init__(self, points: PointsLike) -> None:
        super().__init__(points)
        self._kept: list[_Structures] = []

    def nearest_of_one(self, place: list[float]) -> tuple[int, float] | None:
        """The nearest point, and its distance."""
        with_ = self._take(place)
        code = library.beespace_index_nearest(
            self._handle, with_.points, 1, None, with_.result, with_.error
        )
        found = None
        if code == _library.OK and at_once.beespace_result_size(with_.result) == 1:
            id = ctypes.c_int64.from_address(at_once.beespace_result_ids(with_.result))
            distance = ctypes.c_double.from_address(
                at_once.beespace_result_distances_m(with_.result)
            )
            found = (id.value, distance.value)
        self._kept.append(with_)
        return found

    def k_nearest_of_one(
        self, place: list[float], k: int
    ) -> tuple[NDArray[np.int64], NDArray[np.float64]] | None:
        """The k nearest points, and their distances; None also where there are fewer."""
        with_ = self._take(place)
        code = library.beespace_index_nearest(
            self._handle, with_.points, k, None, with_.result, with_.error
        )
        found = None
        if code == _library.OK and at_once.beespace_result_size(with_.result) == k:
            ids = ctypes.string_at(at_once.beespace_result_ids(with_.result), 8 * k)
            distances = ctypes.string_at(at_once.beespace_result_distances_m(with_.result), 8 * k)
            # Of a bytearray, arrays can be written.
            found = (
                np.frombuffer(bytearray(ids), np.int64),
                np.frombuffer(bytearray(distances), np.float64),
            )
        if k <= _MOST_KEPT:
            self._kept.append(with_)
        return found

    def around_one(self, place: list[float], radius: float) -> list[int] | None:
        """The points within a radius, exactly as far ones included, ascending."""
        with_ = self._take(place)
        with_.set_radius(radius)
        code = library.beespace_index_around(
            self._handle, with_.points, with_.search, None, with_.result, with_.error
        )
        if code != _library.OK:
            self._kept.append(with_)
            return None
        size = at_once.beespace_result_size(with_.result)
        found: list[int] = []
        if size:
            raw = ctypes.string_at(at_once.beespace_result_ids(with_.result), 8 * size)
            found = memoryview(raw).cast("q").tolist()
        if size <= _MOST_KEPT:
            self._kept.append(with_)
        return found

    def _take(self, place: list[float]) -> _Structures:
        try:
            with_ = self._kept.pop()
        except IndexError:
            with_ = _Structures()
        with_.place[: len(place)] = place
        return with_
