"""How a question is asked: options, Ctrl-C, errors."""

from __future__ import annotations

import ctypes
import operator
import signal
import threading
from collections.abc import Mapping
from typing import Any

from beespace import _library
from beespace._errors import BeespaceError, invalid
from beespace._library import CRun, CSearch
from beespace._reals import is_flag, real_of
from beespace._units import METRES, NO_DATES, SECONDS, is_date

# With fewer points a call is over before Ctrl-C matters, and a thread would cost more than it.
_MANY = 5_000
# Of what moves each pair may have to be looked at, for some microseconds.
_MANY_MOVING = 500

try:
    # Whether SIGINT has come, as the interpreter's own code asks: no Python code runs in the call, in
    # which an exception could be lost.
    _interrupted: Any = _library.POLL(
        ctypes.PYFUNCTYPE(ctypes.c_int, ctypes.c_void_p)(
            ("PyOS_InterruptOccurred", ctypes.pythonapi)
        )
    )
except AttributeError:  # an interpreter that is not CPython
    _interrupted = None

_search_size = ctypes.sizeof(CSearch)
_run_size = ctypes.sizeof(CRun)
_main_thread = threading.main_thread


def search_of(
    threshold: Any,
    vertical: Any = None,
    inclusive: bool = False,
    max_results: Any = None,
    distances: bool = False,
    with_self: bool = False,
    height_units: tuple[str, ...] | None = METRES,
    place: str = "threshold",
) -> CSearch:
    """The C structure of a search within a threshold; heights may be in another unit, and the threshold
    may be called otherwise."""
    flags = 0
    if inclusive:
        flags |= _library.INCLUSIVE
    if distances:
        flags |= _library.DISTANCES
    if with_self:
        flags |= _library.WITH_SELF
    height = 0.0
    if vertical is not None:
        flags |= _library.VERTICAL
        height = length(vertical, "vertical", height_units)
    most = 0
    if max_results is not None:
        flags |= _library.MAX_RESULTS
        most = whole(max_results, "max_results")
    return CSearch(_search_size, flags, 0, length(threshold, place), height, most)


def run_of(threads: Any, points: int, moving: bool = False) -> CRun | None:
    """The C structure of a run: its threads, and that Ctrl-C ends it."""
    watched = (
        points >= (_MANY_MOVING if moving else _MANY)
        and _interrupted is not None
        and threading.current_thread() is _main_thread()
    )
    if threads == 1 and not watched:
        return None
    run = CRun(_run_size, threads_of(threads))
    if watched:
        run.poll = _interrupted
    return run


def check(code: int, error: _library.CError, places: Mapping[str, str] | None = None) -> None:
    """Raises the error of a call, if it has one; after Ctrl-C, what the handler of SIGINT raises.

    `places` says what arguments of C are called in this call; "" stands for no name.
    """
    if code == _library.OK:
        return
    if code == _library.STOPPED:
        after_ctrl_c()
    _library.raise_error(error, places)


def after_ctrl_c() -> None:
    """The poll has taken the signal away: gives it back to the handler, which runs here."""
    signal.raise_signal(signal.SIGINT)


def whole(number: Any, place: str) -> int:
    """A number of something."""
    value = integer_of(number, place)
    if not 0 <= value < 2**63:
        raise invalid(f"this is zero or more, not {value}", place)
    return value


def integer_of(number: Any, place: str) -> int:
    """Any integer; what is true or false is none."""
    try:
        if not is_flag(number):
            return int(operator.index(number))
    except TypeError:
        pass
    raise invalid(f"this is a whole number, not {number!r}", place)


def seconds(number: Any, place: str) -> float:
    """A length of time."""
    value = real_of(number, place, SECONDS)
    if value is None:
        told = NO_DATES if is_date(number) else f"this is a number of seconds, not {number!r}"
        raise invalid(told, place)
    return value


def length(number: Any, place: str, units: tuple[str, ...] | None = METRES) -> float:
    """A threshold."""
    value = real_of(number, place, units, "invalid_threshold")
    if value is None:
        raise BeespaceError(
            "a threshold is one number for all points, in metres", "invalid_threshold", place
        )
    return value


def number_of(number: Any, place: str, units: tuple[str, ...] | None) -> float:
    """Any other number, in one of the units."""
    value = real_of(number, place, units)
    if value is None:
        raise invalid(f"this is a number, not {number!r}", place)
    return value


def threads_of(threads: Any) -> int:
    """A number of threads as the library counts them."""
    number = whole(threads, "threads")
    return _library.ALL_PROCESSORS if number == 0 else min(number, 256)


__all__ = [
    "after_ctrl_c",
    "check",
    "integer_of",
    "length",
    "number_of",
    "run_of",
    "search_of",
    "seconds",
    "threads_of",
    "whole",
]
