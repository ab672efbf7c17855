"""Guides a fleet whose positions are not exact, and whose messages are late or lost."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace import _fleet_library as _c
from beespace import _library
from beespace._advice_arguments import ArrayReader, above_zero, check_shape
from beespace._calls import number_of, run_of
from beespace._errors import invalid
from beespace._fleet import FleetFigures, LinkFigures, Tube, check_fleet, integer, tube_from
from beespace._guidance import Guidance, JoinAnswer
from beespace._guide_calls import GuideCalls
from beespace._library import at_once, library
from beespace._messages import (
    Acknowledgement,
    AgentReport,
    StoredBranch,
    c_acknowledgement,
    c_report,
    c_stored,
    three,
)
from beespace._motion import movers_of
from beespace._obstacles import Obstacles, check_frame_of_obstacles
from beespace._points import PointsLike
from beespace._ranges import zero_or_more
from beespace._units import ACCELERATIONS, METRES, SPEEDS


class Guide(GuideCalls):
    """Guides a fleet that is not exact, tick after tick.

    It plans on nominal states, which it knows exactly; keeps all branches on which an agent can still
    be, and claims the hull of them. True agents are in tubes around their paths. As long as the
    figures are true, true positions keep the threshold, whatever messages are lost, late, doubled or
    put out of order. An agent whose figures do not hold is named (docs/prevention.md).

    Agents are known by any integers of 64 bits. One call at a time: a thread waits until the call of
    another has ended. An error of a call changes nothing, but for three: while intruders are refused none
    is clear of them, a report of a branch never sent names its agent, a stopped `step` has had its tick.

    Parameters
    ----------
    threshold : float
        No two agents shall come closer than this, in metres.
    max_speed, max_acceleration : float
        What each agent can do that has no limits of its own, in metres and seconds.
    figures : FleetFigures, optional
        Of each agent that has none of its own; without them the fleet is perfect.
    link : LinkFigures, optional
        The tick, and how messages go.
    vertical, vertical_factor, planar : optional
        As of `Adviser.advise`.
    clearance, obstacles, fence_directions, fence_offsets, intruder_horizon : optional
        As of `Adviser.advise`.
    epoch : int
        Greater than that of every planner that guided this fleet before.
    threads : int
        How many threads may work; 0 for one per processor.

    Examples
    --------
    Two drones fly past each other; each command and reply arrives at once here:

    >>> import numpy as np, beespace
    >>> guide, flying = beespace.Guide(3, max_speed=6, max_acceleration=4), {}
    >>> for agent, (place, goal) in enumerate([([0, 0, 30], [60, 0, 30]), ([60, 0, 30], [0, 0, 30])]):
    ...     assert guide.join(agent, place).joined
    ...     guide.set_goal(agent, goal)
    ...     flying[agent] = beespace.Follower(agent, 6, 4, 0.1)
    >>> closest = np.inf
    >>> for tick in range(1, 250):
    ...     guidance = guide.step(tick)
    ...     for agent, follower in flying.items():
    ...         follower.advance(tick)
    ...         for command in guidance.commands:
    ...             if command.agent == agent:
    ...                 guide.take(follower.receive(command))
    ...     where = np.array([follower.setpoint().position for follower in flying.values()])
    ...     for agent, follower in flying.items():
    ...         guide.take(beespace.AgentReport(agent, follower.held, tick, where[agent]))
    ...     closest = min(closest, float(np.linalg.norm(where[0] - where[1])))
    >>> guide
    <beespace.Guide: 2 agents, threshold 3 m>
    >>> bool(guidance.certified.all() and closest > 3), (where.round(1) + 0).tolist()
    (True, [[60.0, 0.0, 30.0], [0.0, 0.0, 30.0]])
    """

    __slots__ = ()

    def __init__(
        self,
        threshold: float,
        *,
        max_speed: float,
        max_acceleration: float,
        figures: FleetFigures | None = None,
        link: LinkFigures | None = None,
        vertical: float | None = None,
        vertical_factor: float | None = None,
        planar: bool = False,
        clearance: float | None = None,
        obstacles: Obstacles | None = None,
        fence_directions: PointsLike | None = None,
        fence_offsets: ArrayLike | None = None,
        intruder_horizon: float = 10.0,
        epoch: int = 1,
        threads: int = 1,
    ) -> None:
        super().__init__(
            threshold,
            (
                zero_or_more(number_of(max_speed, "max_speed", SPEEDS), "max_speed"),
                above_zero(max_acceleration, "max_acceleration", ACCELERATIONS),
            ),
            figures or FleetFigures(),
            link or LinkFigures(),
            (vertical, vertical_factor),
            planar,
            clearance,
            obstacles,
            (fence_directions, fence_offsets),
            intruder_horizon,
            epoch,
            threads,
        )

    def __len__(self) -> int:
        with self._lock:
            return int(at_once.beespace_guide_size(self._handle))

    def __repr__(self) -> str:
        if self._is_lost:
            return "<beespace.Guide: in the process that this one was forked from>"
        count = len(self)
        agents = "1 agent" if count == 1 else f"{count:,} agents"
        return f"<beespace.Guide: {agents}, threshold {self._threshold:.6g} m>"

    def join(
        self,
        agent: int,
        position: Sequence[float] | NDArray[Any],
        *,
        radius: float = 0.0,
        figures: FleetFigures | None = None,
        max_speed: float | None = None,
        max_acceleration: float | None = None,
        promised: int = 0,
    ) -> JoinAnswer:
        """Says whether an agent may join that stands there; and if so, it has joined.

        Its place is reserved, and the next steps have a command for it until one is acknowledged.

        Parameters
        ----------
        agent : int
            Its number.
        position : three floats
            Where it stands, in metres.
        radius : float
            Its own radius in metres.
        figures, max_speed, max_acceleration : optional
            Its own, where they differ from those of the fleet.
        promised : int
            What its follower has promised (`StoredBranch.promised`).

        Returns
        -------
        JoinAnswer
            Whether it has joined, and if not whom it is too close to.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> guide.join(7, [0, 0, 30]).joined, guide.join(8, [1, 0, 30]).touches
        (True, (7,))
        """
        request = self._request(agent, position, radius, figures, max_speed, max_acceleration)
        request.promised = integer(promised, "promised", 0, 2**32 - 1)
        return self._ask_to_join(at_once.beespace_guide_join, request)

    def may_join(
        self,
        agent: int,
        position: Sequence[float] | NDArray[Any],
        *,
        radius: float = 0.0,
        figures: FleetFigures | None = None,
        max_speed: float | None = None,
        max_acceleration: float | None = None,
    ) -> bool:
        """Says whether an agent may join, as `join`, and it does not.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> guide.may_join(7, [0, 0, 30]), len(guide)
        (True, 0)
        """
        request = self._request(agent, position, radius, figures, max_speed, max_acceleration)
        answer = self._ask_to_join(at_once.beespace_guide_may_join, request)
        return not (answer.touches or answer.obstacles or answer.fences)

    def adopt(
        self,
        agent: int,
        stored: StoredBranch,
        *,
        radius: float = 0.0,
        figures: FleetFigures | None = None,
        max_speed: float | None = None,
        max_acceleration: float | None = None,
    ) -> None:
        """Takes over an agent of another planner, which has promised this epoch.

        Parameters
        ----------
        agent : int
            Its number.
        stored : StoredBranch
            What its follower says after `Follower.promise`.
        radius, figures, max_speed, max_acceleration
            As of `join`.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> joined, follower = guide.join(7, [0, 0, 30]), beespace.Follower(7, 6, 4, 0.1)
        >>> follower.advance(1)
        >>> reply = follower.receive(guide.step(1).commands[0])
        >>> other = beespace.Guide(3, max_speed=6, max_acceleration=4, epoch=2)
        >>> follower.promise(2)
        True
        >>> other.adopt(7, follower.stored())
        >>> len(other)
        1
        """
        request = self._request(agent, (0, 0, 0), radius, figures, max_speed, max_acceleration)
        given = c_stored(stored)
        self._tell(
            at_once.beespace_guide_adopt, ctypes.byref(request), ctypes.byref(given)
        )

    def expect(self, agents: Iterable[int]) -> None:
        """Says that agents exist of which nothing is known yet: until all are adopted, or leave, no
        agent is certified.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> joined = guide.join(7, [0, 0, 30])
        >>> guide.expect([8])
        >>> guide.step(1).certified
        array([False])
        """
        try:
            given = list(agents)
        except TypeError:
            raise invalid(f"these are numbers of agents, and not {agents!r}", "agents") from None
        numbers = [integer(agent, "agents") for agent in given]
        array = (ctypes.c_int64 * len(numbers))(*numbers)
        self._tell(at_once.beespace_guide_expect, array, len(numbers))

    def leave(self, agent: int) -> None:
        """Removes an agent: it has landed, or was found. Its place is free.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> joined = guide.join(7, [0, 0, 30])
        >>> guide.leave(7)
        >>> len(guide)
        0
        """
        self._tell(at_once.beespace_guide_leave, integer(agent, "agent"))

    def set_goal(self, agent: int, goal: Sequence[float] | NDArray[Any]) -> None:
        """Says where an agent shall go, and stop.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> joined = guide.join(7, [0, 0, 30])
        >>> guide.set_goal(7, [60, 0, 30])
        >>> guide.set_goal(8, [60, 0, 30])
        Traceback (most recent call last):
        ...
        beespace._errors.BeespaceError: agents[8]: agent 8 is not in the fleet; ...
        """
        self._tell(
            at_once.beespace_guide_set_goal, integer(agent, "agent"), self._place(goal, "goal")
        )

    def set_preferred(self, agent: int, velocity: Sequence[float] | NDArray[Any]) -> None:
        """Says which velocity an agent prefers, in metres per second, instead of a goal.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> guide.set_preferred(7, [1, 0, 0])
        Traceback (most recent call last):
        ...
        beespace._errors.BeespaceError: agents[7]: agent 7 is not in the fleet; ...
        """
        self._tell(
            at_once.beespace_guide_set_preferred,
            integer(agent, "agent"),
            three(velocity, "velocity", SPEEDS),
        )

    def take(self, message: AgentReport | Acknowledgement) -> None:
        """Takes a report or an acknowledgement: in any order, any number of times.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> joined = guide.join(7, [0, 0, 30])
        >>> number = guide.step(1).commands[0].number
        >>> guide.take(beespace.Acknowledgement(7, number, "taken", held=number, tick=1))
        >>> guide.take(beespace.AgentReport(7, number, 1, (0, 0, 30)))
        >>> guide.step(2)
        <Guidance: tick 2, 1 agent, 1 certified>
        """
        if isinstance(message, AgentReport):
            report = c_report(message)
            self._tell(at_once.beespace_guide_take_report, ctypes.byref(report))
        else:
            said = c_acknowledgement(message)
            self._tell(at_once.beespace_guide_take_acknowledgement, ctypes.byref(said))

    def set_intruders(
        self,
        positions: PointsLike,
        velocities: PointsLike,
        *,
        radii: ArrayLike | None = None,
        position_errors: ArrayLike | None = None,
        speed_errors: ArrayLike | None = None,
    ) -> None:
        """Says which intruders there are from now on: they are taken to fly straight on.

        Parameters
        ----------
        positions, velocities : arrays of shape (m, 3)
            Where they are, in metres, and how fast they fly, in metres per second.
        radii, position_errors, speed_errors : arrays of shape (m,), optional
            The radius of each, how far it may be from there, and how far its velocity may be off.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> joined = guide.join(7, [0, 0, 30])
        >>> guide.set_intruders([[-30, 0, 30]], [[20, 0, 0]])
        >>> guide.step(1).clear_of_intruders
        array([False])
        """
        places, speeds = movers_of(positions, velocities, "positions", "velocities", False)
        places.check_alike(self._known, "positions", "fleet")
        check_shape(places, *self._shape)
        check_frame_of_obstacles(self._obstacles, places)
        read = ArrayReader(False, places)
        self._tell(
            at_once.beespace_guide_set_intruders,
            ctypes.byref(places.struct),
            ctypes.byref(speeds.struct),
            read.numbers(radii, "radii", places.count, METRES, zero_or_more),
            read.numbers(position_errors, "position_errors", places.count, METRES, zero_or_more),
            read.numbers(speed_errors, "speed_errors", places.count, SPEEDS, zero_or_more),
            places={"intruders": "positions"},
        )
        self._known.take(places)

    def step(self, now: int) -> Guidance:
        """Guides the fleet for one tick: at its begin, after the messages that came until then.

        No agent is certified in the step after it joined, as nothing says yet that it has a branch.

        Parameters
        ----------
        now : int
            The tick; after that of the call before.

        Returns
        -------
        Guidance
            What to send, and what is known.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> joined = guide.join(7, [0, 0, 30])
        >>> guide.step(1)
        <Guidance: tick 1, 1 agent, 0 certified; 1 command>
        """
        into = at_once.beespace_guidance_create()
        if not into:
            raise MemoryError("beespace: no memory for guidance")
        error = _library.new_error()
        tick = integer(now, "now")
        with self._lock:
            run = run_of(1, int(at_once.beespace_guide_size(self._handle)))
            code = library.beespace_guide_step(
                self._handle,
                tick,
                None if run is None else ctypes.byref(run),
                into,
                ctypes.byref(error),
            )
        check_fleet(code, error, {"": "now"})
        return Guidance(into)

    def tube(self, agent: int) -> Tube:
        """The tube of an agent.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> joined = guide.join(7, [0, 0, 30])
        >>> guide.tube(7).planned_speed
        6.0
        """
        into = _c.CTube(ctypes.sizeof(_c.CTube))
        self._tell(at_once.beespace_guide_tube, integer(agent, "agent"), ctypes.byref(into))
        return tube_from(into)

    def claim(self, agent: int) -> NDArray[np.float64]:
        """The claim of an agent: the places whose convex hull it is, of shape (m, 3).

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> joined = guide.join(7, [0, 0, 30])
        >>> guide.claim(7)[0]
        array([ 0.,  0., 30.])
        """
        return self._claim_of(integer(agent, "agent"))
