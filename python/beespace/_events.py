"""What a live swarm answers."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from beespace._columns import Columns
from beespace._library import at_once
from beespace._live_library import BOUND_NAMES, EVENT_NAMES
from beespace._tables import Table, plural


_kinds = np.array(EVENT_NAMES)
_bounds = np.array(BOUND_NAMES)


class Event(NamedTuple):
    """What happened to which agents, and when: a row of `Events`, which explains the fields.

    Examples
    --------
    >>> import beespace
    >>> swarm = beespace.Swarm(5)
    >>> swarm.update([1, 2], 0, [[0, 0], [9, 0]])
    >>> swarm.update([1, 2], 1, [[0, 0], [1, 0]])
    >>> for event in swarm.advance(1):
    ...     print(event.kind, event.time, event.i, event.j)
    entered 0.5 1 2
    """

    kind: str
    time: float
    i: int
    j: int
    distance: float
    closest_time: float
    since: float
    left_out: int
    bound: str


class Events(Table):
    """Events of a live swarm, in ascending order of `time`; a column for each attribute.

    Attributes
    ----------
    kind : ndarray of str, shape (n,)
        What happened.

        - "predicted": a conflict lies ahead, or is there now;
        - "entered": two have come closer than the threshold;
        - "closest_passed": their distance grows again;
        - "left": they are far enough apart again, or one was removed;
        - "stale", "heard": an agent has not been heard of for `max_age`; it is heard of again;
        - "lost": one of two that had entered fell silent: from then on it is unknown;
        - "possible": a stale agent may be too close to another one, at `max_speed`;
        - "ended": two had entered, and nothing more was heard;
        - "overloaded": a bound was reached, and something was left out.
    time : ndarray of float64, shape (n,)
        When, in seconds. Of predicted: when the conflict begins; of stale: when the agent was last
        heard of; of lost and ended: until when both are known; of possible: since when it may be.
    i, j : ndarray of int64, shape (n,)
        The agents; ``i < j``. Of stale, heard and overloaded ``i == j``.
    distance : ndarray of float64, shape (n,)
        Of the two at that time, in metres; of predicted: when they are closest; of possible: where
        they were last heard of; of overloaded: from what distance on pairs were left out.
    closest_time : ndarray of float64, shape (n,)
        When the two are closest, in seconds: in the future of predicted, otherwise so far.
    since : ndarray of float64, shape (n,)
        Of heard, stale, lost and possible: since when the agent was silent, in seconds; else NaN.
    left_out : ndarray of int64, shape (n,)
        Of overloaded: how many were left out, at least; 0: not known.
    bound : ndarray of str, shape (n,)
        Of overloaded: "agents", "pairs", "predicted" or "possible"; else "none".

    Examples
    --------
    >>> import beespace
    >>> swarm = beespace.Swarm(5, horizon=0)
    >>> for time in range(4):
    ...     swarm.update([1, 2], time, [[10 * time, 0], [30 - 10 * time, 3]])
    >>> events = swarm.advance(3)
    >>> events
    <Events: 3 events: 1 entered, 1 closest_passed, 1 left>
    >>> events.kind, events.time
    (array(['entered', 'closest_passed', 'left'], dtype='<U14'), array([1.3       , 1.5       , 1.73048861]))
    """

    __slots__ = (
        "_bounds",
        "_kinds",
        "closest_time",
        "distance",
        "i",
        "j",
        "left_out",
        "since",
        "time",
    )

    def __init__(self, columns: Columns) -> None:
        size = int(at_once.beespace_events_size(columns.handle))

        def column(name: str, code: str) -> NDArray[Any]:
            return columns.array(getattr(at_once, sys.intern(f"beespace_events_{name}")), size, code)

        self._kinds = column("kinds", "<i4")
        self.time: NDArray[np.float64] = column("times_s", "<f8")
        self.i: NDArray[np.int64] = column("first", "<i8")
        self.j: NDArray[np.int64] = column("second", "<i8")
        self.distance: NDArray[np.float64] = column("distances_m", "<f8")
        self.closest_time: NDArray[np.float64] = column("closest_s", "<f8")
        self.since: NDArray[np.float64] = column("since_s", "<f8")
        self.left_out: NDArray[np.int64] = column("left_out", "<i8")
        self._bounds = column("bounds", "<i4")

    @property
    def kind(self) -> NDArray[np.str_]:
        return _kinds[self._kinds]

    @property
    def bound(self) -> NDArray[np.str_]:
        return _bounds[self._bounds]

    def __len__(self) -> int:
        return len(self.time)

    def __iter__(self) -> Iterator[Event]:
        """The events, one after the other."""
        return map(Event, *(column.tolist() for column in self.columns().values()))

    def __repr__(self) -> str:
        numbers = np.bincount(self._kinds, minlength=len(_kinds))
        told = ", ".join(f"{number:,} {kind}" for kind, number in zip(_kinds, numbers) if number)
        return f"<Events: {plural(len(self), 'event')}{': ' if told else ''}{told}>"

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> list(beespace.Swarm(5).advance(0).columns())
        ['kind', 'time', 'i', 'j', 'distance', 'closest_time', 'since', 'left_out', 'bound']
        """
        return {name: getattr(self, name) for name in Event._fields}


class KnownAgents(Table):
    """Where the agents of a live swarm are, or were last heard of, in ascending order of `id`.

    Attributes
    ----------
    id : ndarray of int64, shape (n,)
        The agents that have not been removed.
    position : ndarray of float64, shape (n, 3)
        Where they would be, in metres: on straight lines from their last reports, where they `move`;
        otherwise where they were last heard of, and may have left since.
    velocity : ndarray of float64, shape (n, 3)
        In metres per second; 0 where they do not `move`, which does not say that they stand.
    heard : ndarray of float64, shape (n,)
        When each was last heard of, in seconds.
    heard_at : ndarray of float64, shape (n, 3)
        Where each was last heard of, in metres.
    stale : ndarray of bool, shape (n,)
        Whether it was stale when the swarm last advanced: it is somewhere unknown.
    moves : ndarray of bool, shape (n,)
        Whether it is not stale and its velocity is known.
    unknown : ndarray of float64, shape (n,)
        For how long it has been unknown in all, in seconds.

    Examples
    --------
    >>> import beespace
    >>> swarm = beespace.Swarm(5)
    >>> swarm.update([7, 9], 0, [[0, 0, 0], [9, 0, 0]], [[1, 0, 0], [0, 2, 0]])
    >>> known = swarm.movers(2)
    >>> known
    <KnownAgents: 2 agents, none stale>
    >>> known.id, known.position
    (array([7, 9]), array([[2., 0., 0.],
           [9., 4., 0.]]))
    """

    __slots__ = ("heard", "heard_at", "id", "moves", "position", "stale", "unknown", "velocity")

    def __init__(self, columns: Columns) -> None:
        size = int(at_once.beespace_movers_size(columns.handle))

        def column(name: str, code: str, width: int = 1) -> NDArray[Any]:
            getter = getattr(at_once, sys.intern(f"beespace_movers_{name}"))
            return columns.array(getter, width * size, code)

        self.id: NDArray[np.int64] = column("ids", "<i8")
        self.position: NDArray[np.float64] = column("positions", "<f8", 3).reshape(size, 3)
        self.velocity: NDArray[np.float64] = column("velocities", "<f8", 3).reshape(size, 3)
        self.heard: NDArray[np.float64] = column("heard_s", "<f8")
        self.heard_at: NDArray[np.float64] = column("heard_at", "<f8", 3).reshape(size, 3)
        self.stale: NDArray[np.bool_] = column("stale", "|b1")
        self.moves: NDArray[np.bool_] = column("move", "|b1")
        self.unknown: NDArray[np.float64] = column("unknown_s", "<f8")

    def __len__(self) -> int:
        return len(self.id)

    def __repr__(self) -> str:
        stale = np.count_nonzero(self.stale)
        return f"<KnownAgents: {plural(len(self), 'agent')}, {f'{stale:,}' if stale else 'none'} stale>"

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each column of a data frame by its name.

        Examples
        --------
        >>> import beespace
        >>> list(beespace.Swarm(5).movers(0).columns())
        ['id', 'x', 'y', 'z', 'vx', 'vy', 'vz', 'heard', 'heard_x', 'heard_y', 'heard_z', 'stale', 'moves', 'unknown']
        """
        columns: dict[str, NDArray[Any]] = {"id": self.id}
        columns |= dict(zip(("x", "y", "z"), self.position.T))
        columns |= dict(zip(("vx", "vy", "vz"), self.velocity.T))
        columns["heard"] = self.heard
        columns |= dict(zip(("heard_x", "heard_y", "heard_z"), self.heard_at.T))
        return columns | {"stale": self.stale, "moves": self.moves, "unknown": self.unknown}


class SwarmCounts(NamedTuple):
    """What became of the reports of a live swarm.

    Attributes
    ----------
    taken : int
        Reports that were used.
    repeated, late, contrary : int
        Reports that were left out: the same again; before a report of the same agent that was used;
        the time of one of its last two again, elsewhere.
    refused : int
        Reports of agents beyond `max_agents`.
    agents, stale : int
        Agents that are known and not stale, and those that are stale, now.
    heard_once : int
        Agents that are known from one report only: where they were at that instant, no more.
    predicted : int
        Pairs of which a predicted conflict has neither begun nor been averted.
    unknown : float
        For how long agents were unknown in all, in seconds, where they have been heard of again.
    missed : float
        How far the first reports of agents, or their first after a silence, were before what was
        still known of the others, in seconds in all: what happened in these times is not found.

    Examples
    --------
    >>> import beespace
    >>> swarm = beespace.Swarm(5)
    >>> swarm.update([1, 1, 1], [0, 1, 0.5], [[0, 0], [1, 0], [2, 0]])
    >>> swarm.counts.taken, swarm.counts.late
    (2, 1)
    """

    taken: int
    repeated: int
    late: int
    contrary: int
    refused: int
    agents: int
    stale: int
    heard_once: int
    predicted: int
    unknown: float
    missed: float
