"""Columns of a result of the library as arrays, without a copy."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace._library import at_once


class Columns:
    """What the library answers into. It lives as long as an array that is made of it."""

    __slots__ = ("handle",)

    def __init__(self, create: Any) -> None:
        self.handle = create()
        if not self.handle:
            raise MemoryError("beespace: no memory for a result")

    def array(self, getter: Any, size: int, code: str) -> NDArray[Any]:
        """The column of a getter, of so many numbers of a type as NumPy calls it."""
        return column(self, getter(self.handle), size, code)


class Result(Columns):
    """A result of the library."""

    __slots__ = ()

    def __init__(self) -> None:
        super().__init__(at_once.beespace_result_create)

    def ids(self) -> NDArray[np.int64]:
        return self._integers(at_once.beespace_result_ids, self._size())

    def first(self) -> NDArray[np.int64]:
        return self._integers(at_once.beespace_result_first, self._size())

    def second(self) -> NDArray[np.int64]:
        return self._integers(at_once.beespace_result_second, self._size())

    def counts(self) -> NDArray[np.int64]:
        return self._integers(at_once.beespace_result_counts, self._size())

    def offsets(self) -> NDArray[np.int64]:
        rows = at_once.beespace_result_rows(self.handle)
        return self._integers(at_once.beespace_result_offsets, rows + 1)

    def distances(self) -> NDArray[np.float64]:
        return self._reals(at_once.beespace_result_distances_m)

    def begins(self) -> NDArray[np.float64]:
        return self._reals(at_once.beespace_result_begins_s)

    def closest_times(self) -> NDArray[np.float64]:
        return self._reals(at_once.beespace_result_closest_s)

    def ends(self) -> NDArray[np.float64]:
        return self._reals(at_once.beespace_result_ends_s)

    def gap_agents(self) -> NDArray[np.int64]:
        return self._integers(at_once.beespace_result_gap_agents, self._gaps())

    def gap_begins(self) -> NDArray[np.float64]:
        return self.array(at_once.beespace_result_gap_begins_s, self._gaps(), "<f8")

    def gap_ends(self) -> NDArray[np.float64]:
        return self.array(at_once.beespace_result_gap_ends_s, self._gaps(), "<f8")

    def _gaps(self) -> int:
        return int(at_once.beespace_result_gaps(self.handle))

    def _size(self) -> int:
        return int(at_once.beespace_result_size(self.handle))

    def _reals(self, getter: Any) -> NDArray[np.float64]:
        return self.array(getter, self._size(), "<f8")

    def _integers(self, getter: Any, size: int) -> NDArray[np.int64]:
        return self.array(getter, size, "<i8")


def column(owner: object, address: int | None, size: int, code: str) -> NDArray[Any]:
    """An array of what stands there; `owner` lives as long as it."""
    if address is None:
        return np.empty(0, code)
    return np.asarray(_Column(owner, address, size, code))


class _Column:
    """What NumPy makes an array of: it keeps this, and this keeps the owner of the memory."""

    __slots__ = ("__array_interface__", "owner")

    def __init__(self, owner: object, address: int, size: int, code: str) -> None:
        self.owner = owner
        self.__array_interface__ = {
            "shape": (size,),
            "typestr": code,
            "data": (address, False),
            "version": 3,
        }
