"""Did agents keep apart, clear of obstacles and within their limits?"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace._checks import Check, gap_of
from beespace._errors import BeespaceError, invalid
from beespace._file_recording import FileRecording
from beespace._fixes import agents_of, seconds_of
from beespace._flight_verdict import FlightVerdict
from beespace._obstacles import Obstacles, check_frame_of_obstacles
from beespace._points import Points, PointsLike
from beespace._verdict import Verdict


class Verifier:
    """Checks what is flown, step after step, so that it need not be kept.

    In a step an agent flies on the cubic curve that has its positions and velocities at both ends,
    which is how it flies where it accelerates evenly; or, with `straight`, in a straight line. All of
    the time in between is looked at, not samples of it. What rounding cannot exclude counts as found; of speeds and
    accelerations, what it may explain does not count: with times from 1970 and fixes 0.02 s apart, a
    tenth of a metre per second squared. Let times begin with the flight.

    One call at a time: a thread waits until the call of another has ended.

    Parameters
    ----------
    threshold : float
        How close is too close, in metres.
    max_speed, max_acceleration : float, optional
        The limits of each agent, in metres per second and per second squared.
    obstacles : Obstacles, optional
        Static obstacles.
    clearance : float, optional
        With these: how close to one is too close, in metres.
    straight : bool
        Whether agents fly in straight lines; no accelerations are known then.
    threads : int
        How many threads may work; 0: one for each processor. The verdict is always the same.

    Examples
    --------
    >>> import beespace
    >>> verifier = beespace.Verifier(5, max_acceleration=2)
    >>> verifier.add(0, [[0, 0], [9, 9]], [[3, 0], [-3, 0]])
    >>> verifier.add(3, [[9, 0], [0, 9]], [[3, 0], [-3, 0]])
    >>> verifier.verdict()
    <Verdict: holds; 1 step, closest 0 and 1: 9 m>
    """

    __slots__ = ("_check",)

    def __init__(
        self,
        threshold: float,
        *,
        max_speed: float | None = None,
        max_acceleration: float | None = None,
        obstacles: Obstacles | None = None,
        clearance: float | None = None,
        straight: bool = False,
        threads: int = 1,
    ) -> None:
        self._check = Check(
            threshold, max_speed, max_acceleration, obstacles, clearance, straight, threads
        )

    def add(self, time: float, positions: PointsLike, velocities: PointsLike | None = None) -> None:
        """Takes where all agents are at a time, and how fast: the end of the step that the call
        before began.

        Parameters
        ----------
        time : float
            In seconds; after that of the call before.
        positions : array of shape (n, 3) or (n, 2), tuple of arrays, or data frame
            In metres; as many agents each time, in the same order.
        velocities : as positions
            In metres per second; with `straight` not needed, and not read.

        Raises
        ------
        BeespaceError
            "time_order", "not_finite" or "outside_domain" with the agent as `record`. The verifier is
            then as before.

        Examples
        --------
        >>> import beespace
        >>> verifier = beespace.Verifier(5, straight=True)
        >>> verifier.add(0, [[0, 0], [9, 0]])
        >>> verifier.add(1, [[0, 0], [4, 0]])
        >>> verifier.verdict().losses.distance.round(6)
        array([4.])
        """
        speeds = None if velocities is None else Points(velocities, "velocities")
        self._check.add(time, Points(positions, "positions"), speeds)

    def __reduce__(self) -> Any:
        """Refused, as by all that the library keeps and that changes."""
        return self._check.__reduce__()

    def skip(self) -> None:
        """Says that it was not seen what agents did from the last time on until the next one.

        No step is checked in between, and the verdict does not hold. There may be other agents then.

        Examples
        --------
        >>> import beespace
        >>> verifier = beespace.Verifier(5, straight=True)
        >>> for time in (0, 1, 60, 61):
        ...     if time == 60:
        ...         verifier.skip()
        ...     verifier.add(time, [[time, 0], [time, 9]])
        >>> verifier.verdict()
        <Verdict: not seen as a whole; 2 steps, 1 unseen, closest 0 and 1: 9 m>
        """
        self._check.skip()

    def verdict(self) -> Verdict:
        """What was found so far. Agents are indices.

        Returns
        -------
        Verdict

        Examples
        --------
        >>> import beespace
        >>> beespace.Verifier(5).verdict()
        <Verdict: nothing was checked; 0 steps>
        """
        return self._check.verdict(None)


@overload
def verify(
    ids: FileRecording,
    *,
    threshold: float | None = None,
    max_speed: float | None = None,
    max_horizontal: float | None = None,
    max_climb: float | None = None,
    max_descent: float | None = None,
    max_acceleration: float | None = None,
    max_height: float | None = None,
    obstacles: Obstacles | None = None,
    clearance: float | None = None,
    skip_limits: Iterable[str] = (),
    ignore_below: float | None = None,
    max_gap: float | None = None,
    threads: int = 1,
) -> FlightVerdict: ...


@overload
def verify(
    ids: ArrayLike,
    times: ArrayLike,
    positions: PointsLike,
    threshold: float,
    *,
    velocities: PointsLike | None = None,
    max_speed: float | None = None,
    max_acceleration: float | None = None,
    obstacles: Obstacles | None = None,
    clearance: float | None = None,
    max_gap: float | None = None,
    threads: int = 1,
) -> Verdict: ...


def verify(
    ids: Any,
    times: Any = None,
    positions: Any = None,
    threshold: float | None = None,
    *,
    velocities: Any = None,
    max_speed: float | None = None,
    max_horizontal: float | None = None,
    max_climb: float | None = None,
    max_descent: float | None = None,
    max_acceleration: float | None = None,
    max_height: float | None = None,
    obstacles: Obstacles | None = None,
    clearance: float | None = None,
    skip_limits: Iterable[str] = (),
    ignore_below: float | None = None,
    max_gap: float | None = None,
    threads: int = 1,
) -> Verdict | FlightVerdict:
    """Did agents that all have fixes at the same times keep apart, and within their limits?

    Between two fixes an agent flies on the cubic curve that has its positions and velocities at both,
    which is how it flies where it accelerates evenly; without velocities in a straight line. All of
    the time in between is looked at, not samples of it. What rounding cannot exclude counts as found; of speeds and
    accelerations, what it may explain does not count: with times from 1970 and fixes 0.02 s apart, a
    tenth of a metre per second squared. Let times begin with the flight.
    For agents with times of their own there is `Recording.conflicts`.

    Given a recording that `read_recording` has read, ``verify(show, threshold=2)``, it is
    `FileRecording.verify` of that: drone shows along their curves, with the limits that they declare.

    Parameters
    ----------
    ids : array of shape (n,), or FileRecording
        The agent of each fix: integers or texts. Rows may stand in any order.
    times : array of shape (n,)
        The time of each fix, in seconds. Each agent must have one at each time.
    positions : array of shape (n, 3) or (n, 2), tuple of arrays, or data frame
        The position of each fix, in metres.
    threshold : float
        How close is too close, in metres.
    velocities : as positions, optional
        The velocity of each fix, in metres per second.
    max_speed, max_acceleration, obstacles, clearance, threads
        As of `Verifier`; `max_acceleration` needs velocities.
    max_horizontal, max_climb, max_descent, max_height : float, optional
    skip_limits : names of limits
    ignore_below : float, optional
        Of a `FileRecording` only: as of `FileRecording.verify`.
    max_gap : float, optional
        The longest step that was seen, in seconds; without it all were. What happens in a longer one
        is unknown: the verdict counts it as `unseen`, and does not hold.

    Returns
    -------
    Verdict, or FlightVerdict of a FileRecording
        Its agents are ids as they were given.

    Examples
    --------
    >>> import beespace
    >>> verdict = beespace.verify(
    ...     ids=["ann", "bob"] * 2,
    ...     times=[0, 0, 10, 10],
    ...     positions=[[0, 0], [90, 3], [90, 0], [0, 3]],
    ...     threshold=5,
    ...     max_speed=10,
    ... )
    >>> verdict
    <Verdict: does not hold, 1 loss of separation; 1 step, closest ann and bob: 3 m>
    >>> verdict.losses.i, verdict.breaches
    (array(['ann'], dtype='<U3'), <Breaches: none>)
    """
    upright = {
        "max_horizontal": max_horizontal,
        "max_climb": max_climb,
        "max_descent": max_descent,
        "max_height": max_height,
    }
    common: dict[str, Any] = {
        "max_speed": max_speed,
        "max_acceleration": max_acceleration,
        "obstacles": obstacles,
        "clearance": clearance,
        "max_gap": max_gap,
        "threads": threads,
    }
    if isinstance(ids, FileRecording):
        for name, given in (("times", times), ("positions", positions), ("velocities", velocities)):
            if given is not None:
                raise invalid(
                    "a recording of a file has its own: give the threshold as threshold=", name
                )
        return ids.verify(
            threshold, skip_limits=skip_limits, ignore_below=ignore_below, **upright, **common
        )
    if skip_limits:
        raise invalid("this is for recordings that read_recording has read", "skip_limits")
    for name, given in {**upright, "ignore_below": ignore_below}.items():
        if given is not None:
            raise invalid("this is for recordings that read_recording has read", name)
    for name, given in (("times", times), ("positions", positions), ("threshold", threshold)):
        if given is None:
            raise TypeError(f"verify() needs {name} beside the ids")
    return _verify_columns(ids, times, positions, threshold, velocities=velocities, **common)


def _verify_columns(
    ids: ArrayLike,
    times: ArrayLike,
    positions: PointsLike,
    threshold: Any,
    *,
    velocities: PointsLike | None = None,
    max_speed: float | None = None,
    max_acceleration: float | None = None,
    obstacles: Obstacles | None = None,
    clearance: float | None = None,
    max_gap: float | None = None,
    threads: int = 1,
) -> Verdict:
    """As `verify`, of columns."""
    known = Points(positions, "positions")
    places = _rows_of(known)
    speeds = None
    if velocities is not None:
        flown = Points(velocities, "velocities")
        flown.check_alike(known, "velocities", "positions")
        speeds = _rows_of(flown)
    if speeds is not None and speeds.shape != places.shape:
        raise invalid(f"of shape {speeds.shape}, beside positions of {places.shape}", "velocities")
    agents, labels = agents_of(ids, len(places))
    clock = seconds_of(times, len(places))
    order, names, moments = _in_common(agents, clock)
    if labels is not None:
        names = labels
    check = Check(
        threshold, max_speed, max_acceleration, obstacles, clearance, speeds is None, threads
    )
    check_frame_of_obstacles(obstacles, known)
    longest = gap_of(max_gap)
    for row, time in enumerate(moments):
        if row and not time - moments[row - 1] <= longest:
            check.skip()
        fixes = order[row]
        try:
            check.add(
                time,
                Points(places[fixes], "positions"),
                None if speeds is None else Points(speeds[fixes], "velocities"),
            )
        except BeespaceError as error:
            if error.record is None:
                raise
            # Of which row it is, where it was of which agent.
            message = str(error).partition(": ")[2]
            raise BeespaceError(
                message, error.code, error.place, int(fixes[error.record])
            ) from None
    return check.verdict(names)


def _rows_of(points: Points) -> NDArray[np.float64]:
    """As an array of rows, which can be put into another order."""
    kept: Any = points.keep
    rows: Any = kept if hasattr(kept, "shape") else np.column_stack(kept)
    return np.asarray(rows, np.float64)


def _in_common(
    agents: NDArray[np.int64], clock: NDArray[np.float64]
) -> tuple[NDArray[np.intp], NDArray[np.int64], list[float]]:
    """The row of each agent at each time, the agents, and the times."""
    bad = np.flatnonzero(~np.isfinite(clock))
    if len(bad):
        raise BeespaceError("this is no finite number", "not_finite", "times", int(bad[0]))
    order = np.lexsort((agents, clock))
    names, moments = np.unique(agents), np.unique(clock)
    sorted_agents, sorted_clock = agents[order], clock[order]
    twice = (sorted_agents[1:] == sorted_agents[:-1]) & (sorted_clock[1:] == sorted_clock[:-1])
    if twice.any():
        row = int(order[1:][twice].min())
        raise BeespaceError("the agent has two fixes at this time", "time_order", "times", row)
    if len(order) != len(names) * len(moments):
        times, counts = np.unique(clock, return_counts=True)
        lacking = float(times[counts < len(names)][0])
        raise invalid(
            f"not all of {len(names):,} agents have a fix at {lacking:.17g} s: ask for the conflicts "
            "of a Recording, which needs no common times",
            "times",
        )
    return order.reshape(len(moments), len(names)), names, moments.tolist()
