"""Advice: which velocity should each agent take next, so that all keep the threshold?"""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace import _advice_library as _c
from beespace import _library, _ranges
from beespace._advice_answers import Advice, advice_of
from beespace._calls import check, length, number_of, run_of, whole
from beespace._errors import invalid
from beespace._frames import Described, Known, check_upright
from beespace._fixes import flags_of, integers_of, numbers_of
from beespace._library import at_once, library
from beespace._motion import movers_of, rows_of, spread
from beespace._obstacles import Obstacles, check_frame_of_obstacles, handle_of_obstacles
from beespace._points import Points, PointsLike
from beespace._ranges import zero_or_more
from beespace._turns import InTurn
from beespace._units import ACCELERATIONS, METRES, NO_UNIT, SECONDS, SPEEDS

PLANAR = _c.PLANAR

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


class Limits:
    """The C structure of what agents can do, and what must stay alive as long as it."""

    __slots__ = ("keep", "struct")

    def __init__(
        self,
        max_speed: ArrayLike,
        max_acceleration: ArrayLike | None,
        count: int,
        each: bool = False,
    ) -> None:
        """`each`: whether one agent whose limits cannot be is an error of the call."""
        speeds = _for_each(max_speed, "max_speed", count, SPEEDS)
        if each or speeds.ndim == 0:
            _ranges.check_each(speeds, "max_speed", zero_or_more)
        self.struct = _c.CLimits(ctypes.sizeof(_c.CLimits))
        self.struct.max_speeds_mps, self.struct.max_speeds_stride = _address(speeds)
        self.keep: object = speeds
        if max_acceleration is not None:
            accelerations = _for_each(
                max_acceleration, "max_acceleration", count, ACCELERATIONS
            )
            if each or accelerations.ndim == 0:
                _ranges.check_each(accelerations, "max_acceleration", _ranges.above_zero, True)
            self.struct.max_accelerations_mps2, self.struct.max_accelerations_stride = _address(
                accelerations
            )
            self.keep = (speeds, accelerations)


def shape_of(vertical: Any, vertical_factor: Any) -> tuple[int, float, float]:
    """What stays free around an agent: the shape, its factor, half of its height."""
    if vertical is not None and vertical_factor is not None:
        raise invalid("what stays free is a cylinder or an ellipsoid: leave one out", "vertical")
    if vertical is not None:
        return _c.FREE_CYLINDER, 0.0, above_zero(vertical, "vertical", METRES)
    if vertical_factor is not None:
        return _c.FREE_ELLIPSOID, above_zero(vertical_factor, "vertical_factor", NO_UNIT), 0.0
    return _c.FREE_SPHERE, 0.0, 0.0


def check_shape(given: Described, vertical: Any, vertical_factor: Any, planar: bool) -> None:
    """Refuses what stays free upright around an agent, or in a plane, of positions without heights."""
    check_upright(given, vertical, "vertical")
    check_upright(given, vertical_factor, "vertical_factor")
    check_upright(given, planar, "planar")


def above_zero(number: Any, place: str, units: tuple[str, ...]) -> float:
    """A number that must not be zero, which stands for a default in C."""
    return _ranges.above_zero(number_of(number, place, units), place)


def time_above_zero(number: Any, place: str) -> float:
    return _ranges.time_above_zero(number_of(number, place, SECONDS), place)


def check_fences(directions: Any, offsets: Any) -> None:
    """Refuses one without the other."""
    if (directions is None) != (offsets is None):
        missing = "fence_directions" if directions is None else "fence_offsets"
        raise invalid("a fence has a direction and an offset: give both", missing)


def clearance_of(clearance: Any, obstacles: Any, fences: Any) -> float:
    """How far to stay from obstacles and fences; 0 stands for none where there are neither."""
    if clearance is not None:
        return above_zero(clearance, "clearance", METRES)
    for what, given in (("obstacles", obstacles), ("fences", fences)):
        if given is not None:
            raise invalid(
                f"there are {what}: say in metres how close to them is too close", "clearance"
            )
    return 0.0


class ArrayReader:
    """Reads arrays of options, and keeps them alive as long as itself. Positions among them have as
    many axes as those of agents, and are in their frame."""

    __slots__ = ("_copy", "_kept", "count", "known")

    def __init__(self, copy: bool, like: Described) -> None:
        self._kept: list[object] = []
        self._copy = copy
        self.known = Known(like.axes, like.frame)  # of all positions
        self.count = 0

    def points(self, given: Any, place: str) -> Any:
        self.count = 0
        if given is None:
            return None
        points = Points(given, place, self._copy)
        points.check_alike(self.known, place, "positions")
        self.known.take(points)
        self.count = points.count
        self._kept.append(points)
        return ctypes.pointer(points.struct)

    def numbers(
        self, given: Any, place: str, count: int, units: tuple[str, ...], check: Any = None
    ) -> int | None:
        if given is None:
            return None
        numbers = numbers_of(given, count, place, units)
        if check is not None:
            _ranges.check_each(numbers, place, check)
        return self._kept_at(numbers)

    def integers(self, given: Any, place: str, count: int) -> int | None:
        return None if given is None else self._kept_at(integers_of(given, count, place))

    def flags(self, given: Any, place: str, count: int) -> int | None:
        return None if given is None else self._kept_at(flags_of(given, count, place))

    def _kept_at(self, array: NDArray[Any]) -> int:
        kept = array.copy() if self._copy else array
        self._kept.append(kept)
        return address_of(kept)


def address_of(array: NDArray[Any]) -> int:
    """Where its numbers begin."""
    return int(array.__array_interface__["data"][0])


def _for_each(
    given: Any, place: str, count: int, units: tuple[str, ...]
) -> NDArray[np.float64]:
    is_one = not hasattr(given, "__len__") or getattr(given, "ndim", 1) == 0
    if is_one:
        return np.array(number_of(given, place, units))
    return numbers_of(given, count, place, units)


def _address(array: NDArray[np.float64]) -> tuple[int, int]:
    return address_of(array), 0 if array.ndim == 0 else array.itemsize


def _new_advice() -> Any:
    into = library.beespace_advice_create()
    if not into:
        raise MemoryError("beespace: no memory for advice")
    return into
