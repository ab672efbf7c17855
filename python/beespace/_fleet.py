"""What is known about a fleet, and how far from its path an agent can be."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from beespace import _fleet_library as _c
from beespace import _library
from beespace._calls import check, integer_of, number_of
from beespace._errors import invalid
from beespace._library import at_once
from beespace._units import ACCELERATIONS, METRES, SECONDS, SPEEDS


@dataclass(frozen=True)
class FleetFigures:
    """The figures of a fleet, or of one agent: all of them bounds, none a mean. 0 is perfect.

    Attributes
    ----------
    loop : str
        Where the loop that keeps an agent on its path is closed: "onboard", or on the "ground", by
        reports and commands.
    report_error : float
        How far at most a reported position is from the true one, in metres.
    report_age : float
        How old at most the newest report is when it is used, in seconds.
    sensing_error, loop_period, loop_delay : float
        On board: how far at most what the agent takes for its position is from the true one, in
        metres; the period of its loop, and how old at most a measurement is when it begins to act, in
        seconds.
    deviation : float
        How fast at most all things together carry it off its path (wind, drift), in metres per second.
    clock_error : float
        How far at most its clock is off, in seconds.
    correction_acceleration, correction_speed : float
        How much of the greatest acceleration and speed is kept for corrections.

    Examples
    --------
    >>> import beespace
    >>> show = beespace.FleetFigures(report_error=0.1, report_age=0.3, sensing_error=0.1,
    ...     loop_period=0.02, loop_delay=0.1, deviation=0.3, clock_error=0.01,
    ...     correction_acceleration=1, correction_speed=1)
    >>> link = beespace.LinkFigures(command_delay=4, longest_loss=8)
    >>> round(beespace.tube_of(show, link, max_speed=6, max_acceleration=4).radius, 2)
    0.58
    """

    loop: str = "onboard"
    report_error: float = 0.0
    report_age: float = 0.0
    sensing_error: float = 0.0
    loop_period: float = 0.0
    loop_delay: float = 0.0
    deviation: float = 0.0
    clock_error: float = 0.0
    correction_acceleration: float = 0.0
    correction_speed: float = 0.0


@dataclass(frozen=True)
class LinkFigures:
    """How the planner talks with a fleet.

    Attributes
    ----------
    period : float
        A tick, in seconds.
    command_delay : int
        After how many ticks a command takes effect, 1 to 32.
    longest_loss : int
        How many messages of an agent, one after the other, are lost at most.

    Examples
    --------
    >>> import beespace
    >>> beespace.LinkFigures(period=0.2, command_delay=3)
    LinkFigures(period=0.2, command_delay=3, longest_loss=0)
    """

    period: float = 0.1
    command_delay: int = 1
    longest_loss: int = 0


@dataclass(frozen=True)
class Tube:
    """The tube around the path of an agent, and the loop that keeps it there.

    Attributes
    ----------
    radius : float
        The agent is never farther from its nominal place, in metres.
    clock : float
        What of this is for its clock, in metres.
    error : float
        The error that its loop works with, delays included, in metres.
    gain : float
        Deviations shrink as exp(-gain t); 0: nothing is to be corrected.
    correction_acceleration, correction_speed : float
        The greatest that the loop asks for.
    planned_speed, planned_acceleration : float
        What is left for the plan: a `Follower` is made with these.

    Examples
    --------
    >>> import beespace
    >>> beespace.tube_of(beespace.FleetFigures(), max_speed=6, max_acceleration=4).planned_speed
    6.0
    """

    radius: float
    clock: float
    error: float
    gain: float
    correction_acceleration: float
    correction_speed: float
    planned_speed: float
    planned_acceleration: float


def tube_of(
    figures: FleetFigures,
    link: LinkFigures | None = None,
    *,
    max_speed: float,
    max_acceleration: float,
) -> Tube:
    """How far from its path can an agent be? The smallest tube that the figures allow.

    Parameters
    ----------
    figures : FleetFigures
        What is known of the agent.
    link : LinkFigures, optional
        How the planner talks with it.
    max_speed, max_acceleration : float
        What it can do, in metres per second and metres per second squared.

    Returns
    -------
    Tube
        The tube. Figures that contradict each other are a `BeespaceError` that says which.

    Examples
    --------
    >>> import beespace
    >>> weak = beespace.FleetFigures(deviation=2, correction_speed=1, correction_acceleration=1)
    >>> beespace.tube_of(weak, max_speed=6, max_acceleration=4)
    Traceback (most recent call last):
    ...
    beespace._errors.BeespaceError: deviation 2 needs correction_speed of at least 2, ...
    """
    into = _c.CTube(ctypes.sizeof(_c.CTube))
    error = _library.new_error()
    code = at_once.beespace_tube_of(
        ctypes.byref(c_figures(figures)),
        ctypes.byref(c_link(link or LinkFigures())),
        number_of(max_speed, "max_speed", SPEEDS),
        number_of(max_acceleration, "max_acceleration", ACCELERATIONS),
        ctypes.byref(into),
        ctypes.byref(error),
    )
    check_fleet(code, error)
    return tube_from(into)


def check_fleet(
    code: int, error: _library.CError, places: Mapping[str, str] | None = None
) -> None:
    """Raises the error of a call about a fleet: of an agent, which has any number, or of figures."""
    if code in (_library.OK, _library.STOPPED):
        check(code, error)
        return
    error.message = _field.sub(lambda name: _names.get(name[0], name[0]), error.message)
    if error.place == b"agents":
        raise _library.error_of(error, of_agent=True)
    figure = _figure.match(error.message)
    if figure and not error.place:
        error.place = figure[1]
        error.message = b"this is " + error.message[figure.end() :]
    check(code, error, places)


# A message that says which figure it is about.
_figure = re.compile(rb"(\w+) is (?=[-0-9]|nan|inf)")

# What C calls otherwise.
_field = re.compile(rb"\b[a-z_]+_(?:mps2|mps|m|s)\b")
_names = {b"correction_mps2": b"correction_acceleration", b"correction_mps": b"correction_speed"}
for _name in (
    b"report_error_m", b"report_age_s", b"sensing_error_m", b"loop_period_s", b"loop_delay_s",
    b"deviation_mps", b"clock_error_s", b"max_speed_mps", b"max_acceleration_mps2", b"period_s",
):  # fmt: skip
    _names[_name] = _name.rpartition(b"_")[0]


def integer(number: Any, place: str, low: int = -(2**63), high: int = 2**63 - 1) -> int:
    """A whole number that C has room for."""
    value = integer_of(number, place)
    if not low <= value <= high:
        raise invalid(f"this is beyond {low} to {high}: {value}", place)
    return value


# The figures that are numbers, in the order of C.
_units = {
    "report_error": METRES,
    "report_age": SECONDS,
    "sensing_error": METRES,
    "loop_period": SECONDS,
    "loop_delay": SECONDS,
    "deviation": SPEEDS,
    "clock_error": SECONDS,
    "correction_acceleration": ACCELERATIONS,
    "correction_speed": SPEEDS,
}


def c_figures(figures: FleetFigures) -> _c.CFleetFigures:
    if not isinstance(figures, FleetFigures):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise invalid(f"these are FleetFigures, and not {figures!r}", "figures")
    if figures.loop not in _c.LOOPS:
        raise invalid(f'loop is "onboard" or "ground", not {figures.loop!r}', "loop")
    return _c.CFleetFigures(
        ctypes.sizeof(_c.CFleetFigures),
        _c.LOOPS[figures.loop],
        0,
        *(number_of(getattr(figures, name), name, units) for name, units in _units.items()),
    )


def c_link(link: LinkFigures) -> _c.CLinkFigures:
    if not isinstance(link, LinkFigures):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise invalid(f"these are LinkFigures, and not {link!r}", "link")
    period = number_of(link.period, "period", SECONDS)
    delay = integer(link.command_delay, "command_delay", 0, 2**31 - 1)
    if period == 0.0 or delay == 0:  # which stand for the defaults in C
        raise invalid("a period and a command delay are above zero", "link")
    loss = integer(link.longest_loss, "longest_loss", 0, 2**31 - 1)
    return _c.CLinkFigures(ctypes.sizeof(_c.CLinkFigures), 0, period, delay, loss)


def tube_from(tube: _c.CTube) -> Tube:
    return Tube(
        tube.radius_m,
        tube.clock_m,
        tube.error_m,
        tube.gain_per_s,
        tube.correction_mps2,
        tube.correction_mps,
        tube.planned_speed_mps,
        tube.planned_acceleration_mps2,
    )
