"""What a verification along curves found."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from beespace._coverage import Coverage
from beespace._tables import Table
from beespace._verdict import Breaches, ClearanceLosses, Losses


class FlightLosses(Losses):
    """Losses of separation along curves: two agents that came closer than the threshold.

    Attributes
    ----------
    i, j : ndarray, shape (m,)
        The agents, by id; that of `i` comes first in the recording.
    begin, end : ndarray of float64, shape (m,)
        From when to when they may be closer than the threshold, in seconds.
    distance : ndarray of float64, shape (m,)
        How close they came, in metres.
    at : ndarray of float64, shape (m,)
        When, in seconds.

    Examples
    --------
    >>> import beespace
    >>> show = beespace.read_recording("../examples/data/show.skyc")
    >>> len(beespace.verify(show, threshold=0.5).losses)
    0
    """

    __slots__ = ("at",)

    def __init__(
        self,
        i: NDArray[Any],
        j: NDArray[Any],
        begin: NDArray[np.float64],
        end: NDArray[np.float64],
        distance: NDArray[np.float64],
        at: NDArray[np.float64],
    ) -> None:
        super().__init__(i, j, begin, end, distance)
        self.at = at

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> show = beespace.read_recording("../examples/data/show.skyc")
        >>> list(beespace.verify(show).losses.columns())
        ['i', 'j', 'begin', 'end', 'distance', 'at']
        """
        return {**super().columns(), "at": self.at}


class FlightBreaches(Breaches):
    """Breaches of limits along curves: stretches of pieces in each of which one is exceeded.

    Attributes
    ----------
    id : ndarray, shape (m,)
        The agent, by id.
    kind : ndarray of str, shape (m,)
        "speed", "horizontal", "climb", "descent", "acceleration" or "height".
    begin, end : ndarray of float64, shape (m,)
        From when to when, in seconds.
    value, limit : ndarray of float64, shape (m,)
        The greatest value and the limit, in metres, per second or per second squared.
    at : ndarray of float64, shape (m,)
        When that value is reached, in seconds.

    Examples
    --------
    >>> import beespace
    >>> show = beespace.read_recording("../examples/data/show.skyc")
    >>> len(beespace.verify(show, max_speed=100).breaches)
    0
    """

    __slots__ = ("at", "limit")

    def __init__(
        self,
        id: NDArray[Any],
        kind: NDArray[np.str_],
        begin: NDArray[np.float64],
        end: NDArray[np.float64],
        value: NDArray[np.float64],
        limit: NDArray[np.float64],
        at: NDArray[np.float64],
    ) -> None:
        super().__init__(id, kind, begin, end, value)
        self.limit = limit
        self.at = at

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> show = beespace.read_recording("../examples/data/show.skyc")
        >>> list(beespace.verify(show).breaches.columns())
        ['id', 'kind', 'begin', 'end', 'value', 'limit', 'at']
        """
        return {**super().columns(), "limit": self.limit, "at": self.at}


class Peak(NamedTuple):
    """The greatest value of something, of all agents.

    Attributes
    ----------
    value : float
        Never less than it is, and a billionth more at most.
    id : str
        Whose.
    at : float
        When, in seconds.

    Examples
    --------
    >>> import beespace
    >>> show = beespace.read_recording("../examples/data/show.skyc")
    >>> beespace.verify(show).greatest["height"].value > 0
    True
    """

    value: float
    id: str
    at: float


class FlightVerdict:
    """Whether the agents of a recording kept apart, clear of obstacles and within their limits along
    their curves; and what was found. As a condition it is what it `holds`.

    Attributes
    ----------
    holds : bool
        Whether nothing was found, and nothing that is not known may hide it: there is no gap, no record
        is missing, no agent jumps or is in the air before its first fix or after its last one while
        others fly; some two were compared, or one agent alone with limits or obstacles; and no limit
        is `undecided`.
    motion : str
        "show": along its curves; "velocities": along curves that have the velocities of both fixes;
        "straight": in straight lines from fix to fix.
    threshold : float
        What was taken for too close, in metres.
    losses : FlightLosses
    clearance_losses : ClearanceLosses
    breaches : FlightBreaches
        What was found, all of it.
    limits : dict of str to float
        The limits that were checked, by the names that `FlightBreaches.kind` has.
    declared : tuple of str
        Those of them that the show declares.
    greatest : dict of str to Peak
        The greatest speed, ..., height of all, by the same names.
    not_looked_at : tuple of str
        The limits that the show declares beside these and that were not looked at, as "minNavAltitude".
    undecided : tuple of str
        Those of them that were not to be skipped (`skip_limits`): they keep it from holding.
    closest : tuple of two ids, or None
        The two that came closest; None where no two are there at the same time.
    closest_distance, closest_at : float or None
        How close they came, in metres, and when, in seconds.
    gap_count : int
        In how many gaps between fixes it is unknown where an agent was.
    missing_count : int
        As `FileRecording.missing_count`.
    ignored_count, takeoff_unknown_count : int
        How many losses of separation `ignore_below` left out; and of how many agents it is not known
        where they took off.
    coverage : Coverage
        Of how much of the recording it is known where its agents were: what the verdict is about.

    Examples
    --------
    >>> import beespace
    >>> show = beespace.read_recording("../examples/data/show.skyc")
    >>> beespace.verify(show).motion
    'show'
    """

    __slots__ = (
        "breaches",
        "clearance_losses",
        "closest",
        "closest_at",
        "closest_distance",
        "coverage",
        "declared",
        "gap_count",
        "greatest",
        "holds",
        "ignored_count",
        "limits",
        "losses",
        "missing_count",
        "motion",
        "not_looked_at",
        "takeoff_unknown_count",
        "threshold",
        "undecided",
    )

    holds: bool
    motion: str
    threshold: float
    losses: FlightLosses
    clearance_losses: ClearanceLosses
    breaches: FlightBreaches
    limits: dict[str, float]
    declared: tuple[str, ...]
    greatest: dict[str, Peak]
    not_looked_at: tuple[str, ...]
    undecided: tuple[str, ...]
    closest: tuple[str, str] | None
    closest_distance: float | None
    closest_at: float | None
    gap_count: int
    missing_count: int
    ignored_count: int
    takeoff_unknown_count: int
    coverage: Coverage

    def __bool__(self) -> bool:
        return self.holds

    def __repr__(self) -> str:
        told = [self._in_words(), f"threshold {self.threshold:.6g} m"]
        if self.ignored_count:
            told.append(f"{self.ignored_count:,} left out")
        if self.closest is not None:
            first, second = self.closest
            told.append(
                f"closest {first} and {second}: {self.closest_distance:.6g} m at {self.closest_at:.6g} s"
            )
        return f"<FlightVerdict: {'; '.join(told)}>"

    def _in_words(self) -> str:
        if self.holds:
            return "holds" if self.closest is not None else "holds, without any pair to compare"
        tables: tuple[tuple[Table, str], ...] = (
            (self.losses, "of separation"),
            (self.clearance_losses, "of clearance"),
        )
        found = [
            f"{len(table):,} {'loss' if len(table) == 1 else 'losses'} {what}"  # type: ignore[arg-type]
            for table, what in tables
            if len(table)  # type: ignore[arg-type]
        ]
        if len(self.breaches):
            count = len(self.breaches)
            found.append(f"{count:,} {'breach' if count == 1 else 'breaches'} of limits")
        if found:
            return "does not hold, " + ", ".join(found)
        if self.coverage.may_hide_conflicts:
            return "not seen as a whole: " + self.coverage.unknown
        if self.undecided:
            return f"not looked at as a whole: skip_limits={list(self.undecided)} leaves that out"
        return "nothing to compare: no two agents are there at the same time"
