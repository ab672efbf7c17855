"""Units and masks that arrays carry along, and NumPy drops: what is not in the unit that is taken is
refused, as its numbers would be taken for metres; so is what is masked."""

from __future__ import annotations

from typing import Any

import numpy as np

from beespace._errors import invalid

# What each is called: the first to people, the others by astropy, pint, unyt, xarray (CF).
METRES = ("m", "meter", "meters", "metre", "metres")
SPEEDS = ("m/s", "m / s", "meter / second", "meters/second", "metres/second", "m s-1", "m s^-1", "m s**-1")
SECONDS = ("s", "sec", "second", "seconds")
DEGREES = (
    "deg", "degree", "degrees", "degrees_east", "degrees_north", "degree_east", "degree_north",
    "degrees_E", "degrees_N", "degree_E", "degree_N", "°",
)

_masked: Any = np.ma  # of whose types NumPy says little
_none = ("", "1", "dimensionless")


def plain(given: Any, place: str, units: tuple[str, ...] | None) -> Any:
    """The same without its unit and its mask; an array that says that it is in another unit is refused
    (None: any unit will do), and one of which values are masked."""
    if isinstance(given, _masked.MaskedArray):
        if _masked.is_masked(given):
            raise invalid("some values are masked: leave them out", place)
        given = _masked.getdata(given)
    unit = _unit_of(given)
    if unit is None:
        return given
    if units is not None and unit not in units and unit not in _none:
        raise invalid(
            f"this says that it is in {unit}, where {units[0]} are taken: convert it first, as by "
            f'.to("{units[0]}") of astropy or pint',
            place,
        )
    return given.magnitude if hasattr(given, "m_as") else given


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
