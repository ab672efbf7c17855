"""A live swarm: position reports go in, events come out."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from beespace import _library
from beespace import _live_library as _c
from beespace._calls import length, number_of, seconds, threads_of, whole
from beespace._columns import Columns
from beespace._errors import BeespaceError, invalid
from beespace._events import Events, KnownAgents, SwarmCounts
from beespace._fixes import Fixes, ids_of, integers_of, numbers_of, seconds_of, unit_of_heights
from beespace._frames import Known, check_upright
from beespace._library import at_once, library
from beespace._points import Points, PointsLike
from beespace._ranges import above_zero, moment, zero_or_more
from beespace._turns import InTurn
from beespace._units import METRES, NO_UNIT, SECONDS, SPEEDS, plain


class Swarm(InTurn):
    """A live swarm: takes position reports, reports events.

    What has happened is derived from reports alone: between two reports that are no more than
    `max_age` apart an agent moves in the straight line through both. Where reports come in the order
    of their times, "entered", "closest_passed", "left" and "lost" are exact, as real numbers, and do
    not depend on how often `advance` is called. What is about to happen, "predicted", is derived from
    the last reports and velocities.

    Silence is not absence. An agent that is not heard of for `max_age` is stale: it is somewhere
    unknown, until it is heard of again or removed. So no event is an all-clear only while none is
    stale; see `counts`.

    One call at a time: a thread waits until the call of another has ended. A call cannot be stopped
    half-way, as the next one would not know what has been reported.

    Parameters
    ----------
    threshold : float
        How close is too close, in metres.
    vertical : float, optional
        A vertical threshold: `threshold` is then that of horizontal distances.
    heights_apart : bool
        Whether heights are given apart from positions, and not as z; see `update`.
    height_unit : float
        With that, the length in metres of one unit of heights and of `vertical`: 0.3048 for feet.
    leave_factor : float
        A pair has left when it is farther apart than the thresholds times this; 1 or more.
    horizon : float
        How far to look ahead, in seconds; 0: no predictions.
    max_age : float
        An agent that has not been heard of for longer, in seconds, is stale.
    max_speed : float, optional
        The greatest speed of all agents in metres per second, heights included: conflicts that a
        stale agent may be in are then reported as "possible".
    max_agents, max_pairs : int
        How many agents are known, and how many pairs followed, at a time. What is beyond is left out,
        and an event "overloaded" says so.
    threads : int
        How many threads may work; 0: one for each processor. Events are the same for every number.

    Examples
    --------
    >>> import beespace
    >>> swarm = beespace.Swarm(50, max_age=3)
    >>> swarm.update([1, 2], 0, [[0, 0, 80], [200, 30, 80]], [[10, 0, 0], [-10, 0, 0]])
    >>> swarm.advance(0)
    <Events: 1 event: 1 predicted>
    >>> swarm.update([1, 2], 2, [[20, 0, 80], [180, 100, 80]])
    >>> swarm.advance(10)
    <Events: 2 events: 2 stale>
    >>> swarm
    <beespace.Swarm: 0 agents and 2 stale ones, 4 reports so far>
    """

    __slots__ = ("_heights_apart", "_known", "_other_heights", "_upright")

    def __init__(
        self,
        threshold: float,
        *,
        vertical: float | None = None,
        heights_apart: bool = False,
        height_unit: float = 1.0,
        leave_factor: float = 1.1,
        horizon: float = 10.0,
        max_age: float = 5.0,
        max_speed: float | None = None,
        max_agents: int = 1_000_000,
        max_pairs: int = 500_000,
        threads: int = 1,
    ) -> None:
        options = _c.CSwarmOptions(ctypes.sizeof(_c.CSwarmOptions), _c.SWARM_HORIZON)
        options.threads = threads_of(threads)
        # Heights in another unit, of which it is not known what it is called.
        self._heights_apart = heights_apart
        unit = unit_of_heights(height_unit, heights_apart)
        self._other_heights = unit != 1.0
        options.threshold_m = length(threshold, "threshold")
        options.horizon_s = zero_or_more(seconds(horizon, "horizon"), "horizon")
        options.height_unit_m = unit
        options.leave_factor = number_of(leave_factor, "leave_factor", NO_UNIT)
        if not 1.0 <= options.leave_factor < math.inf:
            raise invalid("this is a finite number, 1 or more", "leave_factor")
        options.max_age_s = above_zero(seconds(max_age, "max_age"), "max_age")
        for name, number in (("max_agents", max_agents), ("max_pairs", max_pairs)):
            setattr(options, name, _above_zero(whole(number, name), name))
        if vertical is not None:
            options.flags |= _c.SWARM_VERTICAL
            options.vertical_m = length(vertical, "vertical", None if self._other_heights else METRES)
        elif heights_apart:
            raise invalid("give this: with heights apart, they are compared with it", "vertical")
        if heights_apart:
            options.flags |= _c.SWARM_HEIGHTS_APART
        if max_speed is not None:
            options.flags |= _c.SWARM_MAX_SPEED
            options.max_speed_mps = zero_or_more(
                number_of(max_speed, "max_speed", SPEEDS), "max_speed"
            )
        self._take_turns(_c.CSwarm(), threaded=threads != 1)
        self._known = Known()  # of all reports
        self._upright = vertical is not None and not heights_apart
        error = _library.new_error()
        code = library.beespace_swarm_create(
            ctypes.byref(options), ctypes.byref(self._handle), ctypes.byref(error)
        )
        _check(code, error)

    def update(
        self,
        ids: ArrayLike,
        times: ArrayLike,
        positions: PointsLike,
        velocities: PointsLike | None = None,
        *,
        heights: ArrayLike | None = None,
        climbs: ArrayLike | None = None,
    ) -> None:
        """Takes reports, one after the other, in any order of agents.

        Of one agent, reports that are late, repeated or contrary are left out, which is no error:
        `counts` counts them.

        Parameters
        ----------
        ids : array of shape (n,)
            The agent of each report: integers, below 2**63.
        times : array of shape (n,), or one number
            When, in seconds.
        positions : array of shape (n, 3) or (n, 2), tuple of arrays, or data frame
            Where, in metres.
        velocities : as positions, optional
            How fast, in metres per second. Where all axes of one are NaN, or without any, the last
            two reports tell.
        heights, climbs : array of shape (n,), optional
            With `heights_apart` the height of each, and its climb rate in units of height per second,
            which is used where there is a velocity; without `climbs` all fly level.

        Raises
        ------
        BeespaceError
            With `place` and, as `record`, the row of the first report that cannot be: "not_finite",
            "outside_domain"; "too_many_points" for an agent beyond `max_agents`. All other reports
            of the call have been taken. None has where an argument as a whole makes no sense, which
            leaves `record` None.

        Examples
        --------
        >>> import beespace
        >>> swarm = beespace.Swarm(5)
        >>> try:
        ...     swarm.update([1, 2], 0, [[0, 0], [float("nan"), 3]])
        ... except beespace.BeespaceError as error:
        ...     print(error.code, error.place, error.record)
        not_finite positions 1
        >>> swarm.counts.taken
        1
        """
        places = Points(positions, "positions")
        speeds = None if velocities is None else Points(velocities, "velocities")
        if speeds is not None:
            speeds.check_alike(places, "velocities", "positions")
        check_upright(places, self._upright, "vertical")
        when: Any = times
        if np.ndim(plain(times, "times", SECONDS)) == 0:
            when = np.broadcast_to(np.float64(seconds(times, "times")), (places.count,))
        fixes = Fixes(integers_of(ids, places.count), seconds_of(when, places.count))
        if heights is not None and not self._heights_apart:
            raise invalid("make the swarm with heights_apart=True, or give these as z", "heights")
        if heights is not None:
            of_heights, of_climbs = (None, None) if self._other_heights else (METRES, SPEEDS)
            fixes.set_heights(
                numbers_of(heights, places.count, "heights", of_heights),
                None if climbs is None else numbers_of(climbs, places.count, "climbs", of_climbs),
            )
        elif climbs is not None:
            raise invalid("there are climb rates without heights", "climbs")
        elif self._heights_apart:
            raise invalid("give these: the swarm has heights apart from positions", "heights")
        error = _library.new_error()
        refused = ctypes.c_int64()
        with self._lock:
            places.check_alike(self._known, "positions", "reports before")
            code = library.beespace_swarm_update(
                self._handle,
                ctypes.byref(fixes.struct),
                ctypes.byref(places.struct),
                None if speeds is None else ctypes.byref(speeds.struct),
                ctypes.byref(refused),
                ctypes.byref(error),
            )
            if 0 <= refused.value < places.count:
                self._known.take(places)
        if refused.value > 1:
            more = f"; {refused.value:,} of {places.count:,} reports were refused, the others count"
            error.message = (error.message.decode()[: 511 - len(more)] + more).encode()
        _check(code, error)

    def advance(self, now: float) -> Events:
        """What has happened since the last call, and what is predicted?

        Parameters
        ----------
        now : float
            The time in seconds, by which the age of reports is judged. It never goes back.

        Returns
        -------
        Events

        Examples
        --------
        >>> import beespace
        >>> swarm = beespace.Swarm(5)
        >>> swarm.update([1, 2], 0, [[0, 0], [10, 0]])
        >>> swarm.update([1, 2], 1, [[0, 0], [8, 0]])
        >>> swarm.advance(1)
        <Events: 1 event: 1 predicted>
        >>> swarm.update([1, 2], 2, [[0, 0], [4, 0]])
        >>> swarm.advance(2).time
        array([1.75])
        """
        return self._events(library.beespace_swarm_advance, moment(seconds(now, "now"), "now"))

    def finish(self, now: float) -> Events:
        """The last `advance`: nothing more will be heard.

        Pairs that have entered and neither left nor been lost have "ended". No agent is known
        afterwards, and times may begin anew; counts go on.

        Parameters
        ----------
        now : float
            As of `advance`.

        Returns
        -------
        Events

        Examples
        --------
        >>> import beespace
        >>> swarm = beespace.Swarm(5, horizon=0)
        >>> swarm.update([1, 2], 0, [[0, 0], [9, 0]])
        >>> swarm.update([1, 2], 1, [[0, 0], [4, 0]])
        >>> swarm.finish(1)
        <Events: 2 events: 1 entered, 1 ended>
        """
        last = moment(seconds(now, "now"), "now")
        with self._lock:
            events = self._events(library.beespace_swarm_finish, last)
            self._known.forget()
        return events

    def begin_anew(self, now: float, then: float) -> Events:
        """As `finish`, but all agents stay known: times begin anew.

        Parameters
        ----------
        now : float
            The time in seconds, as it was.
        then : float
            The same instant in seconds, as it is from now on.

        Returns
        -------
        Events

        Examples
        --------
        >>> import beespace
        >>> swarm = beespace.Swarm(5)
        >>> swarm.update([1], 86399, [[0, 0]])
        >>> swarm.begin_anew(86399.5, -0.5)
        <Events: 0 events>
        >>> swarm.update([1], 0, [[1, 0]])
        >>> swarm.counts.taken, swarm.counts.late
        (2, 0)
        """
        return self._events(
            library.beespace_swarm_begin_anew,
            moment(seconds(now, "now"), "now"),
            moment(seconds(then, "then"), "then"),
        )

    def remove(self, ids: ArrayLike) -> None:
        """Removes agents that are no longer there; pairs of them that had entered have left.

        Parameters
        ----------
        ids : array of shape (n,), or one id
            The agents; those that are unknown are passed over.

        Examples
        --------
        >>> import beespace
        >>> swarm = beespace.Swarm(5)
        >>> swarm.update([1, 2], 0, [[0, 0], [30, 40]])
        >>> swarm.remove(1)
        >>> swarm.movers(0).id
        array([2])
        """
        self._change(library.beespace_swarm_remove, ids)

    def lose(self, ids: ArrayLike) -> None:
        """Breaks the lines of agents: a clock has stepped, or reports in between cannot be used.

        They are stale from their last reports on, until they are heard of again.

        Parameters
        ----------
        ids : array of shape (n,), or one id
            The agents; those that are unknown are passed over.

        Examples
        --------
        >>> import beespace
        >>> swarm = beespace.Swarm(5)
        >>> swarm.update([1, 2], 0, [[0, 0], [30, 40]])
        >>> swarm.lose([1])
        >>> swarm.advance(0)
        <Events: 1 event: 1 stale>
        """
        self._change(library.beespace_swarm_lose, ids)

    def movers(self, time: float) -> KnownAgents:
        """Where are the agents, or where were they last heard of?

        All that have not been removed: stale ones, and those heard of once, too. Heights that are
        apart are left out.

        Parameters
        ----------
        time : float
            In seconds.

        Returns
        -------
        KnownAgents

        Examples
        --------
        >>> import beespace
        >>> swarm = beespace.Swarm(5)
        >>> swarm.update([7], 0, [[0, 0, 0]], [[1, 0, 0]])
        >>> swarm.movers(3).position
        array([[3., 0., 0.]])
        """
        when = seconds(time, "time")
        columns = Columns(at_once.beespace_movers_create)
        error = _library.new_error()
        with self._lock:
            code = library.beespace_swarm_movers(
                self._handle, when, columns.handle, ctypes.byref(error)
            )
        _check(code, error)
        return KnownAgents(columns)

    @property
    def counts(self) -> SwarmCounts:
        """What became of the reports, and how many agents are known and stale."""
        counts = _c.CCounts(ctypes.sizeof(_c.CCounts))
        error = _library.new_error()
        with self._lock:
            code = at_once.beespace_swarm_counts(
                self._handle, ctypes.byref(counts), ctypes.byref(error)
            )
        _check(code, error)
        return SwarmCounts(*(getattr(counts, field[0]) for field in _c.CCounts._fields_[1:]))

    def __repr__(self) -> str:
        if self._is_lost:
            return "<beespace.Swarm: in the process that this one was forked from>"
        counts = self.counts
        agents = "1 agent" if counts.agents == 1 else f"{counts.agents:,} agents"
        stale = "" if not counts.stale else f" and {counts.stale:,} stale ones"
        if counts.stale == 1:
            stale = " and a stale one"
        reports = "1 report" if counts.taken == 1 else f"{counts.taken:,} reports"
        return f"<beespace.Swarm: {agents}{stale}, {reports} so far>"

    def _events(self, function: Any, *times: float) -> Events:
        columns = Columns(at_once.beespace_events_create)
        error = _library.new_error()
        with self._lock:
            code = function(self._handle, *times, columns.handle, ctypes.byref(error))
        _check(code, error, {"": "now"})
        return Events(columns)

    def _change(self, function: Any, ids: Any) -> None:
        given = ids_of(ids)
        agents = integers_of(given, len(given))
        error = _library.new_error()
        with self._lock:
            code = function(
                self._handle, agents.ctypes.data, len(agents), ctypes.byref(error)
            )
        _check(code, error)


def _above_zero(number: Any, name: str) -> Any:
    # The library takes 0 for its default.
    if number == 0:
        raise BeespaceError("this is above zero", "invalid_argument", name)
    return number


def _check(code: int, error: _library.CError, places: Mapping[str, str] | None = None) -> None:
    if code != _library.OK:
        _library.raise_error(error, {"agents": "ids", **(places or {})})
