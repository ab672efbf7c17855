"""Advice: which velocity should each agent take next, so that all keep the threshold?"""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace import _advice_library as _c
from beespace import _library
from beespace._advice_answers import Advice, advice_of
from beespace._advice_arguments import (
    PLANAR,
    ArrayReader,
    Limits,
    address_of,
    check_fences,
    check_shape,
    clearance_of,
    shape_of,
    time_above_zero,
)
from beespace._calls import check, length, number_of, run_of, whole
from beespace._errors import invalid
from beespace._library import at_once, library
from beespace._motion import movers_of, rows_of, spread
from beespace._obstacles import Obstacles, check_frame_of_obstacles, handle_of_obstacles
from beespace._points import Points, PointsLike
from beespace._ranges import zero_or_more
from beespace._turns import InTurn
from beespace._units import METRES, SPEEDS

_methods = {"certified": 0, "orca": 1, "mvp": 2}


class Adviser(InTurn):
    """Advises agents step after step, so that none come closer than the threshold.

    An agent that is certified keeps the threshold from all others that are advised, for ever, as long
    as all do as advised: each can always brake to a stop clear of the others. What an agent prefers
    decides where it goes, never whether it is safe. The next call begins where the advice leads, as
    in the example: not at positions that were measured anew.

    It keeps memory and threads from call to call. One call at a time: a thread waits until the call
    of another has ended.

    Examples
    --------
    Two drones fly towards each other, and past each other:

    >>> import numpy as np, beespace
    >>> adviser = beespace.Adviser()
    >>> place, speed = np.array([[0.0, 0, 30], [60, 0, 30]]), np.zeros((2, 3))
    >>> goals, limits = place[::-1].copy(), {"max_speed": 6, "max_acceleration": 4}
    >>> closest = np.inf
    >>> for step in range(200):
    ...     preferred = beespace.velocity_to_goal(place, goals, step=0.1, **limits)
    ...     advice = adviser.advise(place, speed, preferred, 2, step=0.1, **limits)
    ...     place = place + (speed + advice.velocities) / 2 * 0.1
    ...     speed = advice.velocities
    ...     closest = min(closest, float(np.linalg.norm(place[0] - place[1])))
    >>> advice
    <Advice: 2 agents, 2 certified; 2 as preferred>
    >>> bool(closest > 2), bool(np.abs(place - goals).max() < 0.1)
    (True, True)
    """

    __slots__ = ("_remembers",)

    def __init__(self) -> None:
        self._remembers = False
        self._begin()

    def _begin(self) -> None:
        handle = library.beespace_adviser_create()
        if not handle:
            raise MemoryError("beespace: no memory for an adviser")
        self._take_turns(handle, threaded=False)

    def _lose(self) -> None:
        if self._remembers:
            super()._lose()
        else:
            self._begin()  # it has nothing but memory

    def __repr__(self) -> str:
        return f"<beespace.Adviser{': a call now' if not self._is_lost and self._is_asked() else ''}>"

    def advise(
        self,
        positions: PointsLike,
        velocities: PointsLike,
        preferred: PointsLike,
        threshold: float,
        *,
        max_speed: ArrayLike,
        max_acceleration: ArrayLike | None = None,
        step: float = 0.1,
        vertical: float | None = None,
        vertical_factor: float | None = None,
        planar: bool = False,
        uncertainty: float = 0.0,
        clearance: float | None = None,
        obstacles: Obstacles | None = None,
        fence_directions: PointsLike | None = None,
        fence_offsets: ArrayLike | None = None,
        intruder_positions: PointsLike | None = None,
        intruder_velocities: PointsLike | None = None,
        intruder_margins: ArrayLike | None = None,
        intruder_horizon: float = 10.0,
        unknown_centers: PointsLike | None = None,
        unknown_radii: ArrayLike | None = None,
        unknown_growths: ArrayLike | None = None,
        unknown_agents: ArrayLike | None = None,
        unknown_horizon: float = 10.0,
        radii: ArrayLike | None = None,
        tubes: ArrayLike | None = None,
        claim_places: PointsLike | None = None,
        claim_indptr: ArrayLike | None = None,
        holds: ArrayLike | None = None,
        remember: bool = False,
        method: str = "certified",
        threads: int = 1,
        copy: bool = False,
    ) -> Advice:
        """Which velocity should each agent take in the next step?

        A state that cannot be used (a NaN, for example) is no error of the call: that agent gets no
        advice and is in `Advice.refused`. As it may be anywhere, no other is certified.

        Parameters
        ----------
        positions : array of shape (n, 3) or (n, 2), tuple of arrays, or data frame
            Where the agents are, in metres. With two axes they move in a plane.
        velocities : as positions
            How fast they fly, in metres per second.
        preferred : as positions
            The velocities that they prefer; see `velocity_to_goal`.
        threshold : float
            No two agents shall come closer than this, in metres.
        max_speed : float, or one for each agent
            The greatest speed, in metres per second.
        max_acceleration : float, or one for each agent, optional
            The greatest acceleration, in metres per second squared. Without it velocities change at
            once.
        step : float
            The time until the next advice, in seconds.
        vertical : float, optional
            Agents keep `threshold` horizontally, or this vertically: half of the height of the
            cylinder that stays free around each.
        vertical_factor : float, optional
            What stays free is an ellipsoid, so many times as high as wide: about 3 keeps small
            quadrotors out of each other's rotor wash.
        planar : bool
            Whether all move in one horizontal plane. An agent at another height is refused.
        uncertainty : float
            How far at most an agent is from where it should be, in metres, if it does as advised.
        clearance : float, optional
            How far to stay from obstacles and fences, in metres. Must be given with them.
        obstacles : Obstacles, optional
            What stands in the way.
        fence_directions, fence_offsets : arrays of shape (m, 3) and (m,), optional
            Half-spaces that no agent leaves: inside are the places p with ``direction @ p >= offset``.
            Directions are of length 1.
        intruder_positions, intruder_velocities : as positions, optional
            Agents that do not do as advised. All others give way, as if these flew straight on.
            Nothing is promised about them.
        intruder_margins : array of shape (m,), optional
            How much more than the threshold is kept from each intruder, in metres.
        intruder_horizon, unknown_horizon : float
            How far to look ahead, in seconds.
        unknown_centers, unknown_radii, unknown_growths : arrays, optional
            Agents of which only a ball is known: its centre, its radius in metres now, and by how many
            metres per second it grows, the greatest speed of the agent.
        unknown_agents : array of ints, optional
            Which of the agents each of them is, -1 where none. Its position is then ignored, and it
            gets no advice.
        radii : array of shape (n,), optional
            The agents' own radii in metres: what stays free between two is the threshold, or the sum
            of both where that is more.
        tubes : array of shape (n,), optional
            How far each agent may be from its nominal place, in metres.
        claim_places, claim_indptr : arrays of shape (m, 3) and (n + 1,), optional
            Where each agent may be from now on if nothing more is told to it: the places of agent i
            are ``claim_places[claim_indptr[i]:claim_indptr[i + 1]]``.
        holds : array of bool, shape (n,), optional
            Which agents get no new advice, and stay within their claims.
        remember : bool
            Whether the planes between agents are remembered from call to call, as they should be with
            claims. Agents must keep their indices; see `forget`.
        method : str
            "certified"; or, to be compared with, "orca" and "mvp", which certify no agent.
        threads : int
            How many threads may work; 0 for one per processor. The answer is always the same.
        copy : bool
            Whether arrays are copied first, because another thread changes them meanwhile.

        Returns
        -------
        Advice
            For each agent a velocity, what is certified, and lists of what could not be.

        Examples
        --------
        >>> import beespace
        >>> adviser = beespace.Adviser()
        >>> advice = adviser.advise([[0, 0], [7, 0]], [[3, 0], [0, 0]], [[3, 0], [0, 0]], 4,
        ...                         max_speed=5, max_acceleration=2)
        >>> advice
        <Advice: 2 agents, 2 certified; 1 as preferred, 1 deflected>
        >>> advice.kind.tolist()
        ['as_preferred', 'deflected']
        """
        places, speeds = movers_of(positions, velocities, "positions", "velocities", copy)
        wanted = Points(preferred, "preferred", copy)
        if wanted.count != places.count:
            raise invalid(
                f"there are {wanted.count:,} preferred velocities for {places.count:,} agents",
                "preferred",
            )
        wanted.check_alike(places, "preferred", "positions")
        limits = Limits(max_speed, max_acceleration, places.count)
        flat = places.count > 0 and places.struct.z is None
        options = _c.CAdviseOptions(
            ctypes.sizeof(_c.CAdviseOptions),
            (PLANAR if planar or flat else 0) | (_c.REMEMBER if remember else 0),
            0,
            length(threshold, "threshold"),
            time_above_zero(step, "step"),
        )
        if method not in _methods:
            raise invalid(f"there is no method {method!r}: {', '.join(_methods)}", "method")
        options.method = _methods[method]
        options.shape, options.vertical_factor, options.vertical_m = shape_of(
            vertical, vertical_factor
        )
        options.uncertainty_m = zero_or_more(
            number_of(uncertainty, "uncertainty", METRES), "uncertainty"
        )
        options.obstacles = handle_of_obstacles(obstacles)
        check_fences(fence_directions, fence_offsets)
        read = ArrayReader(copy, places)
        options.fence_directions = read.points(fence_directions, "fence_directions")
        count = read.count
        options.fence_offsets_m = read.numbers(fence_offsets, "fence_offsets", count, METRES)
        options.intruder_positions = read.points(intruder_positions, "intruder_positions")
        count = read.count
        options.intruder_velocities = read.points(intruder_velocities, "intruder_velocities")
        options.intruder_margins_m = read.numbers(
            intruder_margins, "intruder_margins", count, METRES, zero_or_more
        )
        options.intruder_horizon_s = time_above_zero(intruder_horizon, "intruder_horizon")
        options.unknown_centers = read.points(unknown_centers, "unknown_centers")
        count = read.count
        options.unknown_radii_m = read.numbers(unknown_radii, "unknown_radii", count, METRES)
        options.unknown_growths_mps = read.numbers(
            unknown_growths, "unknown_growths", count, SPEEDS
        )
        options.unknown_agents = read.integers(unknown_agents, "unknown_agents", count)
        options.unknown_horizon_s = time_above_zero(unknown_horizon, "unknown_horizon")
        options.radii_m = read.numbers(radii, "radii", places.count, METRES)
        options.tubes_m = read.numbers(tubes, "tubes", places.count, METRES)
        options.claim_places = read.points(claim_places, "claim_places")
        options.claim_offsets = read.integers(claim_indptr, "claim_indptr", places.count + 1)
        options.holds = read.flags(holds, "holds", places.count)
        options.clearance_m = clearance_of(clearance, obstacles, fence_directions)
        check_shape(read.known, vertical, vertical_factor, planar)
        check_frame_of_obstacles(obstacles, read.known)
        into = _new_advice()
        error = _library.new_error()
        run = run_of(threads, places.count)
        with self._lock:
            self._threaded = self._threaded or threads != 1
            self._remembers = self._remembers or remember
            code = library.beespace_advise(
                self._handle,
                ctypes.byref(places.struct),
                ctypes.byref(speeds.struct),
                ctypes.byref(wanted.struct),
                ctypes.byref(limits.struct),
                ctypes.byref(options),
                None if run is None else ctypes.byref(run),
                into,
                ctypes.byref(error),
            )
        check(code, error)
        return advice_of(into, 2 if flat else 3)

    def forget(self, agent: int) -> None:
        """Forgets the planes of one agent: its index is another one's from now on.

        Examples
        --------
        >>> import beespace
        >>> adviser = beespace.Adviser()
        >>> adviser.forget(3)
        >>> adviser
        <beespace.Adviser>
        """
        index = whole(agent, "agent")
        with self._lock:
            at_once.beespace_adviser_forget(self._handle, index)


def velocity_to_goal(
    positions: PointsLike,
    goals: PointsLike,
    *,
    max_speed: ArrayLike,
    max_acceleration: ArrayLike | None = None,
    step: float = 0.1,
) -> NDArray[np.float64]:
    """The velocity of the fastest flight straight to a goal that stops there.

    The preferred velocity of an agent with a destination. Zero within a nanometre of it.

    Parameters
    ----------
    positions : array of shape (n, 3) or (n, 2), tuple of arrays, data frame, or one position
        Where the agents are, in metres.
    goals : as positions
        Where they shall go. One goal serves for all.
    max_speed, max_acceleration, step
        As of `Adviser.advise`.

    Returns
    -------
    ndarray of float64
        A velocity for each agent in metres per second, with as many axes as positions.

    Examples
    --------
    >>> import beespace
    >>> beespace.velocity_to_goal([[0, 0, 0], [0, 0, 1]], [30, 40, 0], max_speed=5)[0]
    array([3., 4., 0.])
    """
    places = Points(rows_of(positions), "positions")
    ends = Points(rows_of(goals), "goals")
    ends.check_alike(places, "goals", "positions")
    count = spread([(places, "positions"), (ends, "goals")])
    limits = Limits(max_speed, max_acceleration, count, each=True)
    velocities = np.empty((count, 3))
    error = _library.new_error()
    code = library.beespace_velocity_to_goal(
        ctypes.byref(places.struct),
        ctypes.byref(ends.struct),
        ctypes.byref(limits.struct),
        time_above_zero(step, "step"),
        address_of(velocities),
        ctypes.byref(error),
    )
    check(code, error)
    return velocities[:, :2].copy() if count and places.struct.z is None else velocities


def _new_advice() -> Any:
    into = library.beespace_advice_create()
    if not into:
        raise MemoryError("beespace: no memory for advice")
    return into
