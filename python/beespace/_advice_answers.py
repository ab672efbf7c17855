"""Advice, and what could not be certified."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace import _advice_library as _c
from beespace import _library
from beespace._columns import column
from beespace._errors import BeespaceError
from beespace._library import at_once
from beespace._tables import Table, plural

_kinds = np.array(["as_preferred", "deflected", "braking", "waiting", "none"])


class Findings(Table):
    """What could not be certified: agents, and what each is too close to.

    Attributes
    ----------
    first : ndarray of int64, shape (m,)
        The agent.
    second : ndarray of int64, shape (m,)
        The other agent, or the index of the obstacle, fence, intruder or unknown agent.
    distance : ndarray of float64, shape (m,)
        The gap in metres: between ways to a stop, or from one to the object. Of intruders how close
        they come.
    time : ndarray of float64, shape (m,), or None
        When that ends, in seconds (infinite: never); of intruders when it begins; of unknown agents
        for how long the threshold is surely kept. None of obstacles and fences.

    Examples
    --------
    >>> import beespace
    >>> still = [[0, 0], [0, 0]]
    >>> advice = beespace.Adviser().advise([[0, 0], [3, 0]], still, still, 4, max_speed=5)
    >>> advice.too_close
    <Findings: 1 entry, from 3 m on>
    >>> advice.too_close.first, advice.too_close.second, advice.too_close.distance
    (array([0]), array([1]), array([3.]))
    """

    __slots__ = ("distance", "first", "second", "time")

    def __init__(
        self,
        first: NDArray[np.int64],
        second: NDArray[np.int64],
        distance: NDArray[np.float64],
        time: NDArray[np.float64] | None,
    ) -> None:
        self.first = first
        self.second = second
        self.distance = distance
        self.time = time

    def __len__(self) -> int:
        return len(self.first)

    def __repr__(self) -> str:
        least = f", from {self.distance.min():.6g} m on" if len(self) else ""
        entries = "1 entry" if len(self) == 1 else f"{len(self):,} entries"
        return f"<Findings: {entries}{least}>"

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> advice = beespace.Adviser().advise([[0, 0]], [[0, 0]], [[1, 0]], 4, max_speed=5)
        >>> list(advice.too_close.columns()), list(advice.near_obstacle.columns())
        (['first', 'second', 'distance', 'time'], ['first', 'second', 'distance'])
        """
        columns: dict[str, NDArray[Any]] = {
            "first": self.first,
            "second": self.second,
            "distance": self.distance,
        }
        if self.time is not None:
            columns["time"] = self.time
        return columns


class Advice(Table):
    """Advice for all agents, and what could not be certified.

    Attributes
    ----------
    velocities : ndarray of float64, shape (n, 3) or (n, 2)
        The velocity of each agent at the end of the step, in metres per second. Zero, and no advice,
        where the kind is "none".
    kind : ndarray of str, shape (n,)
        "as_preferred", "deflected", "braking" (there is nothing better), "waiting" (others are in its
        way), or "none": the agent is unknown, or in `refused`.
    certified : ndarray of bool, shape (n,)
        The all-clear: the three that follow together.
    keeps_apart : ndarray of bool, shape (n,)
        Proven: as long as all do as advised, it keeps the threshold from all others that are advised,
        and the clearance, for ever.
    clear_of_intruders : ndarray of bool, shape (n,)
        Predicted, not proven: no intruder comes too close within the horizon, if it flies straight on.
    clear_of_unknown : ndarray of bool, shape (n,)
        Proven: it keeps the threshold from unknown agents for the whole horizon.
    clear_of_unknown_time : ndarray of float64, shape (n,)
        For how many seconds that is proven; infinite where no ball grows.
    too_close, near_obstacle, near_fence, intruder_conflicts, near_unknown : Findings
        What could not be certified, in ascending order.
    refused : tuple of BeespaceError
        What could not be used. `place` and `record` say of which agent ("positions", "velocities",
        "limits", "preferred"), intruder ("intruders") or unknown agent ("unknown").

    Examples
    --------
    >>> import beespace
    >>> nan, still = float("nan"), [[0, 0], [0, 0], [0, 0]]
    >>> places = [[0, 0], [9, 0], [nan, 0]]
    >>> advice = beespace.Adviser().advise(places, still, still, 4, max_speed=5)
    >>> advice
    <Advice: 3 agents, 0 certified; 2 as preferred, 1 none; 1 refused>
    >>> advice.refused[0].code, advice.refused[0].place, advice.refused[0].record
    ('not_finite', 'positions', 2)
    """

    __slots__ = (
        "certified",
        "clear_of_intruders",
        "clear_of_unknown",
        "clear_of_unknown_time",
        "intruder_conflicts",
        "keeps_apart",
        "kind",
        "near_fence",
        "near_obstacle",
        "near_unknown",
        "refused",
        "too_close",
        "velocities",
    )

    def __init__(self, **columns: Any) -> None:
        self.velocities: NDArray[np.float64] = columns["velocities"]
        self.kind: NDArray[np.str_] = columns["kind"]
        self.certified: NDArray[np.bool_] = columns["certified"]
        self.keeps_apart: NDArray[np.bool_] = columns["keeps_apart"]
        self.clear_of_intruders: NDArray[np.bool_] = columns["clear_of_intruders"]
        self.clear_of_unknown: NDArray[np.bool_] = columns["clear_of_unknown"]
        self.clear_of_unknown_time: NDArray[np.float64] = columns["clear_of_unknown_time"]
        self.too_close: Findings = columns["too_close"]
        self.near_obstacle: Findings = columns["near_obstacle"]
        self.near_fence: Findings = columns["near_fence"]
        self.intruder_conflicts: Findings = columns["intruder_conflicts"]
        self.near_unknown: Findings = columns["near_unknown"]
        self.refused: tuple[BeespaceError, ...] = columns["refused"]

    def __len__(self) -> int:
        return len(self.kind)

    def __repr__(self) -> str:
        text = f"{plural(len(self), 'agent')}, {int(self.certified.sum()):,} certified"
        counts = [(int((self.kind == kind).sum()), str(kind)) for kind in _kinds]
        kinds = ", ".join(f"{count:,} {kind.replace('_', ' ')}" for count, kind in counts if count)
        parts = [text, *([kinds] if kinds else [])]
        for found, what in (
            (self.too_close, "too close"),
            (self.near_obstacle, "near obstacles"),
            (self.near_fence, "near fences"),
            (self.intruder_conflicts, "with intruders"),
            (self.near_unknown, "near unknown agents"),
            (self.refused, "refused"),
        ):
            if len(found):
                parts.append(f"{len(found):,} {what}")
        return f"<Advice: {'; '.join(parts)}>"

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array of one entry an agent by its name; velocities by axis.

        Examples
        --------
        >>> import beespace
        >>> advice = beespace.Adviser().advise([[0, 0]], [[0, 0]], [[1, 0]], 4, max_speed=5)
        >>> list(advice.columns())[:4]
        ['vx', 'vy', 'kind', 'certified']
        """
        return {
            **{f"v{axis}": speeds for axis, speeds in zip("xyz", self.velocities.T)},
            "kind": self.kind,
            "certified": self.certified,
            "keeps_apart": self.keeps_apart,
            "clear_of_intruders": self.clear_of_intruders,
            "clear_of_unknown": self.clear_of_unknown,
            "clear_of_unknown_time": self.clear_of_unknown_time,
        }


def kinds_of(numbers: NDArray[np.int32]) -> NDArray[np.str_]:
    """The names of kinds of advice."""
    return _kinds[numbers]


def findings_of(owner: Any, getter: Any, what: int) -> Findings:
    """One list of what a handle has found."""
    found = _c.CFindings(ctypes.sizeof(_c.CFindings))
    error = _library.new_error()
    if getter(owner, what, ctypes.byref(found), ctypes.byref(error)) != _library.OK:
        _library.raise_error(error)
    has_times = what not in (_c.NEAR_OBSTACLE, _c.NEAR_FENCE)
    return Findings(
        column(owner, found.first, found.count, "<i8"),
        column(owner, found.second, found.count, "<i8"),
        column(owner, found.distances_m, found.count, "<f8"),
        column(owner, found.times_s, found.count, "<f8") if has_times else None,
    )


def advice_of(handle: Any, axes: int) -> Advice:
    """What the library has advised."""
    size = int(at_once.beespace_advice_size(handle))
    flat = column(handle, at_once.beespace_advice_velocities(handle), 3 * size, "<f8")

    def flags(getter: Any) -> NDArray[np.bool_]:
        return column(handle, getter(handle), size, "|b1")

    def findings(what: int) -> Findings:
        return findings_of(handle, at_once.beespace_advice_findings, what)

    return Advice(
        velocities=flat.reshape(size, 3)[:, :axes],
        kind=kinds_of(column(handle, at_once.beespace_advice_kinds(handle), size, "<i4")),
        certified=flags(at_once.beespace_advice_certified),
        keeps_apart=flags(at_once.beespace_advice_keeps_apart),
        clear_of_intruders=flags(at_once.beespace_advice_clear_of_intruders),
        clear_of_unknown=flags(at_once.beespace_advice_clear_of_unknown),
        clear_of_unknown_time=column(
            handle, at_once.beespace_advice_clear_of_unknown_s(handle), size, "<f8"
        ),
        too_close=findings(_c.TOO_CLOSE),
        near_obstacle=findings(_c.NEAR_OBSTACLE),
        near_fence=findings(_c.NEAR_FENCE),
        intruder_conflicts=findings(_c.INTRUDER_CONFLICTS),
        near_unknown=findings(_c.NEAR_UNKNOWN),
        refused=_refused(handle),
    )


def _refused(handle: Any) -> tuple[BeespaceError, ...]:
    refused: list[BeespaceError] = []
    for index in range(int(at_once.beespace_advice_refused_count(handle))):
        error = _library.new_error()
        at_once.beespace_advice_refused(handle, index, ctypes.byref(error))
        limit = "max_speed" if b"speed" in error.message else "max_acceleration"
        refused.append(_library.error_of(error, places={"limits": limit}))
    return tuple(refused)
