"""Which agent, and when: columns beside positions, as the library reads them."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace._calls import number_of
from beespace._errors import BeespaceError, invalid
from beespace._library import CFixes
from beespace._reals import check_integers, check_list, check_numbers
from beespace._units import METRES, NO_DATES, SECONDS, is_date, plain


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


def integers_of(ids: Any, count: int, place: str = "ids") -> NDArray[np.int64]:
    """Integers, one for each."""
    given = _column(ids, count, place)
    if not count:
        return np.empty(0, np.int64)
    if given.dtype.kind not in "iu":
        is_text = given.dtype.kind in "SUT" or isinstance(given[0], str)
        hint = "; number the agents, as by a dict" if is_text and place == "ids" else ""
        what = "texts" if is_text else given.dtype
        raise invalid(f"{place} are integers, not {what}{hint}", place)
    if not _fits(given):
        raise invalid(f"{place} are integers of 64 bits with a sign: below 2**63", place)
    return np.ascontiguousarray(given, np.int64)


def agents_of(ids: Any, count: int) -> tuple[NDArray[np.int64], NDArray[Any] | None]:
    """The agent of each fix as a number; and what the numbers mean, where they are not ids."""
    given = _column(ids, count, "ids")
    if not count:
        return np.empty(0, np.int64), None
    if given.dtype.kind in "iu":
        if _fits(given):
            return np.ascontiguousarray(given, np.int64), None
    elif given.dtype.kind not in "USOT":
        raise invalid(f"ids of agents are integers or texts, not {given.dtype}", "ids")
    labels, numbers = np.unique(given, return_inverse=True)
    return np.ascontiguousarray(numbers, np.int64), labels


def seconds_of(times: Any, count: int) -> NDArray[np.float64]:
    """A time for each."""
    given = np.asarray(plain(times, "times", SECONDS))
    if is_date(given) or (given.dtype.kind == "O" and any(map(is_date, given.flat))):
        raise invalid(NO_DATES, "times")
    check_integers(given, "times", "are these nanoseconds?")
    check_list(times, given, "times")
    return numbers_of(given, count, "times", SECONDS)


def numbers_of(
    numbers: Any, count: int, place: str, units: tuple[str, ...] | None
) -> NDArray[np.float64]:
    """A number for each."""
    bare = plain(numbers, place, units)
    given = _one_each(_array_of(bare, place), count, place)
    if not count:
        return np.empty(0)
    check_numbers(bare, given, place)
    return np.ascontiguousarray(given, np.float64)


def unit_of_heights(height_unit: Any, apart: bool) -> float:
    """The length of one unit of heights that are apart from positions; of z there is no other."""
    unit = number_of(height_unit, "height_unit", METRES)
    if not apart and unit != 1.0:
        raise invalid("there are no heights apart from the positions, and z is in metres", "height_unit")
    if not 2.0**-100 <= unit <= 2.0**100:
        raise invalid(
            f"the unit is {unit:g} m; give how many metres one is, above zero: 0.3048 for feet",
            "height_unit",
        )
    return unit


def flags_of(flags: Any, count: int, place: str) -> NDArray[np.bool_]:
    """True or false for each."""
    given = _one_each(_array_of(plain(flags, place, None), place), count, place)
    if count and given.dtype.kind != "b":
        raise invalid(f"{place} are true or false, not {given.dtype}", place)
    return np.ascontiguousarray(given, np.bool_)


def ids_of(ids: Any) -> Any:
    """One id or several, as a sequence."""
    given = plain(ids, "ids", None)
    is_one = isinstance(given, (str, bytes)) or not hasattr(given, "__len__")
    return [given] if is_one or getattr(given, "ndim", 1) == 0 else given


def _array_of(given: Any, place: str) -> NDArray[Any]:
    try:
        return np.asarray(given)
    except (TypeError, ValueError, OverflowError) as error:
        raise invalid(f"this is no array of numbers: {error}", place) from error


def _one_each(given: NDArray[Any], count: int, place: str) -> NDArray[Any]:
    if given.ndim != 1 or len(given) != count:
        raise invalid(f"these are of the shape {given.shape}, and not ({count},): one for each", place)
    return given


def _column(ids: Any, count: int, place: str) -> NDArray[Any]:
    """Ids, of which no two that differ have become the same."""
    given = plain(ids, place, None)
    if isinstance(given, _LISTS):
        # Looked at one by one: NumPy would make texts of numbers that stand beside texts, integers of
        # what is true, and drop zero bytes at the end of a text.
        array = np.empty(len(given), object)
        array[:] = given
    else:
        array = _one_each(_array_of(given, place), count, place)
    if array.dtype.kind != "O":
        return array
    return _alike(_one_each(array, count, place), place)


_LISTS: Any = (list, tuple)


def _alike(ids: NDArray[Any], place: str) -> NDArray[Any]:
    """Objects that are all integers, all texts, or all bytes, as an array of these."""
    if not len(ids):
        return ids
    each: list[Any] = ids.tolist()
    samples: dict[Any, Any] = {id.__class__: id for id in each}
    kinds = {_kind_of(id) for id in samples.values()}
    first = _kind_of(each[0])
    if kinds == {None} and len(samples) == 1:
        name = each[0].__class__.__name__
        raise invalid(f"{place} are integers or texts, not {name}", place)
    if len(kinds) > 1 or first is None:
        for row, id in enumerate(each):
            kind = _kind_of(id)
            if kind is None or kind is not first:
                message = f"this id is {id!r}; ids are integers, or all of them texts"
                raise BeespaceError(message, "invalid_argument", place, row)
    if first is int:
        try:
            return ids.astype(np.int64)
        except OverflowError:
            message = f"{place} are integers of 64 bits with a sign: below 2**63"
            raise invalid(message, place) from None
    is_cut = any(text[-1:] in ("\0", b"\0") for text in each)
    return ids if is_cut else np.array(each)


def _kind_of(id: Any) -> type | None:
    if isinstance(id, (bool, np.bool_)):
        return None
    if isinstance(id, (int, np.integer)):
        return int
    return next((kind for kind in (str, bytes) if isinstance(id, kind)), None)


def _fits(given: NDArray[Any]) -> bool:
    return given.dtype.kind == "i" or given.dtype.itemsize < 8 or bool(given.max() < 2**63)
