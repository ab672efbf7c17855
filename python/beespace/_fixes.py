"""Which agent, and when: columns beside positions, as the library reads them."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace._errors import BeespaceError, invalid
from beespace._library import CFixes
from beespace._units import SECONDS, plain


class Fixes:
    """The C structure of ids and times, and what must stay alive as long as it."""

    __slots__ = ("keep", "struct")

    def __init__(self, agents: NDArray[np.int64], times: NDArray[np.float64]) -> None:
        self.keep: list[NDArray[Any]] = [agents, times]
        self.struct = CFixes(
            ctypes.sizeof(CFixes),
            0,
            _address(agents),
            _address(times),
            agents.strides[0],
            times.strides[0],
        )

    def set_heights(
        self, heights: NDArray[np.float64], climbs: NDArray[np.float64] | None = None
    ) -> None:
        """Heights that are apart from positions, and climb rates."""
        self.keep.append(heights)
        self.struct.heights_m = _address(heights)
        self.struct.heights_stride = heights.strides[0]
        if climbs is None:
            return
        self.keep.append(climbs)
        self.struct.climbs_mps = _address(climbs)
        self.struct.climbs_stride = climbs.strides[0]


def _address(array: NDArray[Any]) -> int:
    return int(array.__array_interface__["data"][0])


def integers_of(ids: Any, count: int) -> NDArray[np.int64]:
    """Ids that are integers."""
    given = _one_each(ids, count, "ids")
    if not count:
        return np.empty(0, np.int64)
    if given.dtype.kind not in "iu":
        raise invalid(f"ids are integers, not {given.dtype}", "ids")
    if not _fits(given):
        raise invalid("ids are integers of 64 bits with a sign: below 2**63", "ids")
    return np.ascontiguousarray(given, np.int64)


def agents_of(ids: Any, count: int) -> tuple[NDArray[np.int64], NDArray[Any] | None]:
    """The agent of each fix as a number; and what the numbers mean, where they are not ids."""
    given = _one_each(ids, count, "ids")
    if not count:
        return np.empty(0, np.int64), None
    if given.dtype.kind in "iu":
        if _fits(given):
            return np.ascontiguousarray(given, np.int64), None
    elif given.dtype.kind == "O" or given.dtype.kind == "T":
        _check_texts(given)
    elif given.dtype.kind not in "US":
        raise invalid(f"ids of agents are integers or texts, not {given.dtype}", "ids")
    labels, numbers = np.unique(given, return_inverse=True)
    return np.ascontiguousarray(numbers, np.int64), labels


def seconds_of(times: Any, count: int) -> NDArray[np.float64]:
    """A time for each."""
    given = np.asarray(plain(times, "times", SECONDS))
    if given.dtype.kind in "mM":
        raise invalid(
            "times are numbers of seconds, not dates: subtract a moment and divide by "
            'numpy.timedelta64(1, "s")',
            "times",
        )
    clock = numbers_of(given, count, "times")
    if given.dtype.kind in "iu" and count and bool((np.abs(clock) >= 2.0**53).any()):
        raise invalid("not all integers beyond 2**53 are doubles: are these nanoseconds?", "times")
    return clock


def numbers_of(
    numbers: Any, count: int, place: str, units: tuple[str, ...] | None = None
) -> NDArray[np.float64]:
    """A number for each."""
    given = np.asarray(plain(numbers, place, units))
    if given.dtype.kind not in "iuf" or (given.dtype.kind == "f" and given.dtype.itemsize > 8):
        raise invalid(f"{place} are numbers, not {given.dtype}", place)
    return np.ascontiguousarray(_one_each(given, count, place), np.float64)


def _one_each(column: Any, count: int, place: str) -> NDArray[Any]:
    given = np.asarray(plain(column, place, None))
    if given.ndim != 1 or len(given) != count:
        raise invalid(f"there are {given.shape} {place} for {count:,} positions", place)
    return given


def _fits(given: NDArray[Any]) -> bool:
    return given.dtype.kind == "i" or given.dtype.itemsize < 8 or bool(given.max() < 2**63)


def _check_texts(ids: NDArray[Any]) -> None:
    for row, id in enumerate(ids):
        if not isinstance(id, str):
            message = f"this id is {id!r}; ids are integers, or all of them texts"
            raise BeespaceError(message, "invalid_argument", "ids", row)
