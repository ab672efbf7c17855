"""Units and masks that arrays carry along, and NumPy drops: what is not in the unit that is taken is
refused, as its numbers would be taken for metres; so is what is masked."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any

import numpy as np

from beespace._errors import invalid

# What each is called: the first to people, the others by astropy, pint, unyt, xarray (CF).
METRES = ("m", "meter", "meters", "metre", "metres")
SPEEDS = ("m/s", "m / s", "meter / second", "meters/second", "metres/second", "m s-1", "m s^-1", "m s**-1")
ACCELERATIONS = (
    "m/s2", "m / s2", "m/s**2", "m/s^2", "m s-2", "m s^-2", "m s**-2", "meter / second ** 2",
    "meters/second**2",
)
SECONDS = ("s", "sec", "second", "seconds")
NO_UNIT = ("",)
DEGREES = (
    "deg", "degree", "degrees", "degrees_east", "degrees_north", "degree_east", "degree_north",
    "degrees_E", "degrees_N", "degree_E", "degree_N", "°",
)

_masked: Any = np.ma  # of whose types NumPy says little
_LISTS: Any = (list, tuple)
_ARRAY: Any = np.ndarray
_none = ("", "1", "dimensionless")
_bare = {float, int, bool, str, bytes, type(None), np.float64, np.float32, np.int64, np.int32}


def plain(given: Any, place: str, units: tuple[str, ...] | None) -> Any:
    """The same without its unit and its mask; an array that says that it is in another unit is refused
    (None: any unit will do), and one of which values are masked. So are those in lists."""
    if type(given) in _bare:
        return given
    if isinstance(given, _LISTS):
        return _plain_list(given, place, units)
    if isinstance(given, _masked.MaskedArray):
        if _masked.is_masked(given):
            raise invalid("some values are masked: leave them out", place)
        given = _masked.getdata(given)
    unit = _unit_of(given)
    if unit is None:
        return given
    if units is not None and unit not in units and unit not in _none:
        raise invalid(_refusal(unit, units), place)
    if hasattr(given, "m_as"):
        return given.magnitude
    return np.asarray(given) if isinstance(given, _ARRAY) else given


def _plain_list(given: Sequence[Any], place: str, units: tuple[str, ...] | None) -> Any:
    kinds = set(map(type, given))
    # Rows of numbers, which are many, are looked through at once.
    if kinds and kinds <= {list, tuple}:
        kinds = set(map(type, chain.from_iterable(given)))
    if kinds <= _bare:
        return given
    return [plain(each, place, units) for each in given]


def _refusal(unit: str, units: tuple[str, ...]) -> str:
    if units == NO_UNIT:
        return f"this says that it is in {unit}, where a number without a unit is taken"
    return (
        f"this says that it is in {unit}, where {units[0]} are taken: convert it first, as by "
        f'.to("{units[0]}") of astropy or pint'
    )


def is_date(given: Any) -> bool:
    """Whether this is a date, or a length of time, of whatever library."""
    kind = getattr(getattr(given, "dtype", None), "kind", "")
    return kind in ("m", "M") or hasattr(given, "year") or hasattr(given, "total_seconds")


NO_DATES = (
    'times are numbers of seconds, not dates: subtract a moment and divide by numpy.timedelta64(1, "s")'
)


def _unit_of(given: Any) -> str | None:
    unit: Any = None
    if hasattr(given, "to_value"):  # astropy, unyt
        unit = getattr(given, "unit", getattr(given, "units", None))
    elif hasattr(given, "m_as"):  # pint
        unit = given.units
    elif hasattr(given, "dtype"):
        unit = getattr(given.dtype, "units", None)  # pandas with pint
        attributes: Any = getattr(given, "attrs", None)
        if unit is None and hasattr(attributes, "get"):  # xarray, pandas
            unit = attributes.get("units")
    return None if unit is None else str(unit)
