"""Numbers that lie in a range. The library would refuse others, too, but names its structure, not the
argument."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace._errors import BeespaceError, invalid

# What the library takes of all that moves.
LEAST, MOST = 2.0**-100, 2.0**100


def zero_or_more(value: float, place: str, endless: bool = False) -> float:
    """A finite number that is not negative; `endless`: or infinity, for no limit."""
    if not 0.0 <= value < math.inf and not (endless and value == math.inf):
        raise invalid(f"this is {value:g}; give {_kind(endless)}, zero or more{_end(endless)}", place)
    return value


def above_zero(value: float, place: str, endless: bool = False) -> float:
    """A finite number above zero; `endless`: or infinity, for no limit."""
    if not 0.0 < value < math.inf and not (endless and value == math.inf):
        raise invalid(f"this is {value:g}; give {_kind(endless)} above zero{_end(endless)}", place)
    return value


def time_above_zero(value: float, place: str) -> float:
    """A length of time that the library takes."""
    if not LEAST <= value <= MOST:
        raise invalid(
            f"this is {value:g} s; give a finite time above zero ({LEAST:.2g} s to {MOST:.2g} s)", place
        )
    return value


def moment(value: float, place: str) -> float:
    """A time that the library takes."""
    if not abs(value) < MOST:
        raise BeespaceError(
            f"this is {value:g}; give a finite number of seconds, below {MOST:.2g}", "not_finite", place
        )
    return value


def check_each(numbers: NDArray[np.float64], place: str, check: Any, endless: bool = False) -> None:
    """Refuses the first of many that is out of its range."""
    lowest, highest = float(numbers.min(initial=math.inf)), float(numbers.max(initial=-math.inf))
    # Of none that is no number, the extremes tell.
    if 0.0 < lowest and highest < math.inf:
        return
    for row, value in enumerate(numbers.ravel().tolist()):
        try:
            check(value, place, endless)
        except BeespaceError as error:
            message = str(error).removeprefix(f"{place}: ")
            record = row if numbers.ndim else None
            raise BeespaceError(message, error.code, place, record) from None


def _kind(endless: bool) -> str:
    return "one" if endless else "a finite number"


def _end(endless: bool) -> str:
    return ", or infinity for none" if endless else ""

