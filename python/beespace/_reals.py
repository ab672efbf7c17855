"""Real numbers as the doubles that they are: what no double is would be rounded, and is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace._errors import BeespaceError, invalid
from beespace._units import is_date, plain

# All integers up to here are doubles.
_MOST = 2.0**53

_PLAIN = {float, int}
_OTHERS = (str, bytes, bool, complex, np.complexfloating)
_LISTS: Any = (list, tuple)
_INTEGERS: Any = (int, np.integer)


def real_of(
    number: Any, place: str, units: tuple[str, ...] | None, code: str = "invalid_argument"
) -> float | None:
    """As a double, where it is a number: a text may have a unit, and so has a length of time."""
    if type(number) in _PLAIN and -_MOST <= number <= _MOST:
        return float(number)
    number = plain(number, place, units)
    if is_date(number) or getattr(number, "ndim", 0):
        return None
    number = _bare(number)
    if isinstance(number, _OTHERS):
        return None
    value, exact = 0.0, False
    try:
        value = float(number)
        exact = bool(value == number or value != value)
    except (TypeError, ValueError):
        return None
    except OverflowError:
        pass
    if not exact:
        raise BeespaceError(
            f"{_told(number)} is not a double, to which it would be rounded: give float(...) of it, if "
            "the nearest one will do",
            code,
            place,
        )
    return value


def _told(number: Any) -> str:
    try:
        return f"{number!r}"[:60]
    except ValueError:  # more digits than Python writes
        return "this"


def is_flag(number: Any) -> bool:
    """Whether this is true or false, which Python takes for 1 or 0."""
    return isinstance(_bare(number), bool)


def check_integers(numbers: NDArray[Any], place: str, hint: str = "convert them first") -> None:
    """Refuses integers of 64 bits that may be no doubles."""
    if numbers.dtype.kind not in "iu" or numbers.dtype.itemsize < 8 or not numbers.size:
        return
    if bool((np.abs(numbers.astype(np.float64)) >= _MOST).any()):
        raise invalid(f"not all integers beyond 2**53 are doubles: {hint}", place)


def check_numbers(given: Any, numbers: NDArray[Any], place: str) -> None:
    """Refuses an array, made of what was given, in which there is anything but doubles."""
    if numbers.dtype.kind not in "iuf" or (numbers.dtype.kind == "f" and numbers.dtype.itemsize > 8):
        raise invalid(f"these are numbers, and not {numbers.dtype}", place)
    check_integers(numbers, place)
    check_list(given, numbers, place)


def check_list(given: Any, numbers: NDArray[Any], place: str) -> None:
    """Refuses integers of a list that NumPy has rounded, as it does where they stand beside floats."""
    if not isinstance(given, _LISTS) or numbers.dtype.kind != "f" or not numbers.size:
        return
    if not bool((np.abs(numbers) >= _MOST).any()):
        return
    for each in np.asarray(given, object).ravel().tolist():
        if isinstance(each, _INTEGERS) and abs(int(each)) >= _MOST:
            raise invalid("not all integers beyond 2**53 are doubles: convert them first", place)


def _bare(number: Any) -> Any:
    """One number of an array library as one of Python's, where there is one as exact."""
    if not hasattr(number, "dtype") or getattr(number, "ndim", 0):
        return number
    if not hasattr(number, "item"):
        number = np.asarray(number)
    return number if np.ndim(number) else number.item()
