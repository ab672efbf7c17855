"""What a verification found."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace._tables import Table, plural


class Losses(Table):
    """Losses of separation: two agents that came closer than the threshold in one step.

    Attributes
    ----------
    i, j : ndarray, shape (m,)
        The agents, by index or id; ``i < j``.
    begin, end : ndarray of float64, shape (m,)
        The times of the step, in seconds.
    distance : ndarray of float64, shape (m,)
        How close they came at least, in metres.

    Examples
    --------
    >>> import beespace
    >>> flown = [[0, 0], [9, 1]], [[9, 0], [0, 1]]
    >>> verdict = beespace.verify([1, 2, 1, 2], [0, 0, 3, 3], [*flown[0], *flown[1]], 5)
    >>> verdict.losses
    <Losses: 1 loss of separation, closest 1 and 2: 1 m between 0 and 3 s>
    """

    __slots__ = ("begin", "distance", "end", "i", "j")

    def __init__(
        self,
        i: NDArray[Any],
        j: NDArray[Any],
        begin: NDArray[np.float64],
        end: NDArray[np.float64],
        distance: NDArray[np.float64],
    ) -> None:
        self.i = i
        self.j = j
        self.begin = begin
        self.end = end
        self.distance = distance

    def __len__(self) -> int:
        return len(self.i)

    def __repr__(self) -> str:
        if not len(self):
            return "<Losses: none>"
        worst = int(self.distance.argmin())
        losses = "1 loss" if len(self) == 1 else f"{len(self):,} losses"
        return (
            f"<Losses: {losses} of separation, closest {self.i[worst]} and {self.j[worst]}: "
            f"{self.distance[worst]:.6g} m between {self.begin[worst]:.6g} and "
            f"{self.end[worst]:.6g} s>"
        )

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> list(beespace.Verifier(5).verdict().losses.columns())
        ['i', 'j', 'begin', 'end', 'distance']
        """
        return {
            "i": self.i,
            "j": self.j,
            "begin": self.begin,
            "end": self.end,
            "distance": self.distance,
        }


class ClearanceLosses(Table):
    """Losses of clearance: an agent that came too close to an obstacle in one step.

    Attributes
    ----------
    id : ndarray, shape (m,)
        The agent, by index or id.
    obstacle : ndarray of int64, shape (m,)
        The index of the first obstacle to which it came too close.
    begin, end : ndarray of float64, shape (m,)
        The times of the step, in seconds.
    distance : ndarray of float64, shape (m,)
        The least distance seen to any obstacle, in metres; below zero inside.

    Examples
    --------
    >>> import beespace
    >>> mast = beespace.Obstacles([beespace.Cylinder(5, 0, 1)])
    >>> verdict = beespace.verify(
    ...     [1, 1], [0, 3], [[0, 0], [9, 0]], 5, obstacles=mast, clearance=2
    ... )
    >>> verdict.clearance_losses
    <ClearanceLosses: 1 loss of clearance, closest 1 to obstacle 0: -0.938 m between 0 and 3 s>
    """

    __slots__ = ("begin", "distance", "end", "id", "obstacle")

    def __init__(
        self,
        id: NDArray[Any],
        obstacle: NDArray[np.int64],
        begin: NDArray[np.float64],
        end: NDArray[np.float64],
        distance: NDArray[np.float64],
    ) -> None:
        self.id = id
        self.obstacle = obstacle
        self.begin = begin
        self.end = end
        self.distance = distance

    def __len__(self) -> int:
        return len(self.id)

    def __repr__(self) -> str:
        if not len(self):
            return "<ClearanceLosses: none>"
        worst = int(self.distance.argmin())
        losses = "1 loss" if len(self) == 1 else f"{len(self):,} losses"
        return (
            f"<ClearanceLosses: {losses} of clearance, closest {self.id[worst]} to obstacle "
            f"{self.obstacle[worst]}: {self.distance[worst]:.3g} m between "
            f"{self.begin[worst]:.6g} and {self.end[worst]:.6g} s>"
        )

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> list(beespace.Verifier(5).verdict().clearance_losses.columns())
        ['id', 'obstacle', 'begin', 'end', 'distance']
        """
        return {
            "id": self.id,
            "obstacle": self.obstacle,
            "begin": self.begin,
            "end": self.end,
            "distance": self.distance,
        }


class Breaches(Table):
    """Breaches of limits: an agent that exceeded one in one step.

    Attributes
    ----------
    id : ndarray, shape (m,)
        The agent, by index or id.
    kind : ndarray of str, shape (m,)
        "speed" or "acceleration".
    begin, end : ndarray of float64, shape (m,)
        The times of the step, in seconds.
    value : ndarray of float64, shape (m,)
        The greatest value, in metres per second, or per second squared.

    Examples
    --------
    >>> import beespace
    >>> beespace.verify([1, 1], [0, 3], [[0, 0], [9, 0]], 5, max_speed=2).breaches
    <Breaches: 1 breach of limits, 1 of speed>
    """

    __slots__ = ("begin", "end", "id", "kind", "value")

    def __init__(
        self,
        id: NDArray[Any],
        kind: NDArray[np.str_],
        begin: NDArray[np.float64],
        end: NDArray[np.float64],
        value: NDArray[np.float64],
    ) -> None:
        self.id = id
        self.kind = kind
        self.begin = begin
        self.end = end
        self.value = value

    def __len__(self) -> int:
        return len(self.id)

    def __repr__(self) -> str:
        if not len(self):
            return "<Breaches: none>"
        kinds, numbers = np.unique(self.kind, return_counts=True)
        told = ", ".join(f"{number:,} of {kind}" for kind, number in zip(kinds, numbers))
        breaches = "1 breach" if len(self) == 1 else f"{len(self):,} breaches"
        return f"<Breaches: {breaches} of limits, {told}>"

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> list(beespace.Verifier(5).verdict().breaches.columns())
        ['id', 'kind', 'begin', 'end', 'value']
        """
        return {
            "id": self.id,
            "kind": self.kind,
            "begin": self.begin,
            "end": self.end,
            "value": self.value,
        }


class Verdict:
    """Whether agents kept apart, clear of obstacles and within their limits; and what was found.

    As a condition it is what it `holds`.

    Attributes
    ----------
    holds : bool
        Whether a step was checked, nothing was found, and nothing was left unseen.
    moments : int
        How many times were taken. A `Verifier.add` that Ctrl-C ended has taken its own, or not: one more
        than before says that it has.
    steps : int
        How many steps were checked.
    unseen : int
        How many steps were not seen: those that were skipped, or longer than `max_gap`.
    unknown : str
        What else of a recording of a file is not known, in words, and may hide something.
    losses : Losses
    clearance_losses : ClearanceLosses
    breaches : Breaches
        What was found; of each the first 1000.
    loss_count, clearance_loss_count, breach_count : int
        How many there were: pairs or agents, counted anew in each step.
    closest : tuple of two agents, or None
        The two that came closest, where that was less than twice the threshold.
    closest_distance : float or None
        How close they came, in metres; to a millionth of the threshold, never more than it was.
    closest_begin : float or None
        When the step began in which they did, in seconds.
    peak_speed : float
        In metres per second.
    peak_acceleration : float or None
        In metres per second squared; None of straight lines.

    Examples
    --------
    >>> import beespace
    >>> verdict = beespace.verify([1, 2, 1, 2], [0, 0, 3, 3], [[0, 0], [9, 9], [9, 0], [0, 9]], 5)
    >>> verdict
    <Verdict: holds; 1 step, closest 1 and 2: 9 m>
    >>> verdict.holds, verdict.peak_speed
    (True, 3.0)
    """

    __slots__ = (
        "breach_count",
        "breaches",
        "clearance_loss_count",
        "clearance_losses",
        "closest",
        "closest_begin",
        "closest_distance",
        "holds",
        "loss_count",
        "losses",
        "moments",
        "peak_acceleration",
        "peak_speed",
        "steps",
        "unknown",
        "unseen",
    )

    holds: bool
    moments: int
    steps: int
    unseen: int
    unknown: str
    losses: Losses
    clearance_losses: ClearanceLosses
    breaches: Breaches
    loss_count: int
    clearance_loss_count: int
    breach_count: int
    closest: tuple[Any, Any] | None
    closest_distance: float | None
    closest_begin: float | None
    peak_speed: float
    peak_acceleration: float | None

    def __bool__(self) -> bool:
        return self.holds

    def __repr__(self) -> str:
        told = [plural(self.steps, "step")]
        if self.unseen:
            told.append(f"{self.unseen:,} unseen")
        if self.closest is not None:
            first, second = self.closest
            told.append(f"closest {first} and {second}: {self.closest_distance:.6g} m")
        return f"<Verdict: {self._in_words()}; {', '.join(told)}>"

    def _in_words(self) -> str:
        if self.holds:
            return "holds"
        found = [
            f"{count:,} {one if count == 1 else several}"
            for count, one, several in (
                (self.loss_count, "loss of separation", "losses of separation"),
                (self.clearance_loss_count, "loss of clearance", "losses of clearance"),
                (self.breach_count, "breach of limits", "breaches of limits"),
            )
            if count
        ]
        if found:
            return "does not hold, " + ", ".join(found)
        if self.unknown:
            return f"not seen as a whole: {self.unknown}"
        return "not seen as a whole" if self.unseen else "nothing was checked"
