"""What questions about movers answer."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from beespace._tables import Table, plural


class Conflicts(Table):
    """Pairs of movers that come closer than the threshold, in ascending order of `i`, `j`, `begin`.

    Attributes
    ----------
    i : ndarray, shape (m,)
        The first mover of each pair.
    j : ndarray, shape (m,)
        The second mover of each pair; above `i`.
    begin : ndarray of float64, shape (m,)
        When they come closer than the threshold, in seconds.
    end : ndarray of float64, shape (m,)
        When they are apart again, in seconds.
    closest_time : ndarray of float64, shape (m,)
        When they are closest between `begin` and `end`, in seconds.
    closest_distance : ndarray of float64, shape (m,)
        Their straight-line distance then, in metres.

    Examples
    --------
    >>> import beespace
    >>> conflicts = beespace.predict([[0, 0], [100, 0]], [[5, 0], [-5, 0]], 20, within=60)
    >>> conflicts
    <Conflicts: 1 conflict of 2 movers, from 8 to 12 s, closest 0 and 1: 0 m at 10 s>
    >>> len(conflicts), conflicts.closest_time
    (1, array([10.]))
    """

    __slots__ = ("_count", "begin", "closest_distance", "closest_time", "end", "i", "j")

    def __init__(
        self,
        i: NDArray[Any],
        j: NDArray[Any],
        begin: NDArray[np.float64],
        end: NDArray[np.float64],
        closest_time: NDArray[np.float64],
        closest_distance: NDArray[np.float64],
        count: int,
    ) -> None:
        self.i = i
        self.j = j
        self.begin = begin
        self.end = end
        self.closest_time = closest_time
        self.closest_distance = closest_distance
        self._count = count

    def __len__(self) -> int:
        return len(self.i)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self._told('mover')}>"

    def _told(self, mover: str) -> str:
        told = f"{plural(len(self), 'conflict')} of {plural(self._count, mover)}"
        if not len(self):
            return told
        worst = int(self.closest_distance.argmin())
        return (
            f"{told}, from {self.begin.min():.6g} to {self.end.max():.6g} s, closest "
            f"{self.i[worst]} and {self.j[worst]}: {self.closest_distance[worst]:.6g} m at "
            f"{self.closest_time[worst]:.6g} s"
        )

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> conflicts = beespace.predict([[0, 0], [100, 0]], [[5, 0], [-5, 0]], 20, within=60)
        >>> list(conflicts.columns())
        ['i', 'j', 'begin', 'end', 'closest_time', 'closest_distance']
        """
        return {
            "i": self.i,
            "j": self.j,
            "begin": self.begin,
            "end": self.end,
            "closest_time": self.closest_time,
            "closest_distance": self.closest_distance,
        }


class Gaps(Table):
    """Times between two fixes in which it is unknown where an agent is, in ascending order.

    Attributes
    ----------
    id : ndarray, shape (g,)
        The agent of each gap.
    begin, end : ndarray of float64, shape (g,)
        The times of the fixes before and after it, in seconds.
    unknown : str
        What else of a recording of a file is not known, or was not looked at, in words; empty where
        there is nothing.

    Examples
    --------
    >>> import beespace
    >>> found = beespace.Recording([1, 1], [0, 10], [[0, 0], [100, 0]]).conflicts(5, max_gap=2)
    >>> found.gaps
    <Gaps: 1 gap of 1 agent, 10 s in all, of which nothing is known>
    >>> found.gaps.begin, found.gaps.end
    (array([0.]), array([10.]))
    """

    __slots__ = ("begin", "end", "id", "unknown")

    def __init__(
        self,
        id: NDArray[Any],
        begin: NDArray[np.float64],
        end: NDArray[np.float64],
        unknown: str = "",
    ) -> None:
        self.id = id
        self.begin = begin
        self.end = end
        self.unknown = unknown

    def __len__(self) -> int:
        return len(self.id)

    def __repr__(self) -> str:
        return f"<Gaps: {_told_of(self)}>"

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> found = beespace.Recording([1, 1], [0, 10], [[0, 0], [100, 0]]).conflicts(5, max_gap=2)
        >>> gaps = found.gaps
        >>> list(gaps.columns())
        ['id', 'begin', 'end']
        """
        return {"id": self.id, "begin": self.begin, "end": self.end}


def _told_of(gaps: Gaps) -> str:
    beside = f"; {gaps.unknown}" if gaps.unknown else ""
    if not len(gaps):
        return "no gaps" + beside
    agents = plural(len(np.unique(gaps.id)), "agent")
    lasting = (gaps.end - gaps.begin).sum()
    return (
        f"{plural(len(gaps), 'gap')} of {agents}, {lasting:.6g} s in all, of which nothing is known"
        f"{beside}"
    )


class RecordedConflicts(Conflicts):
    """Conflicts of a recording, and the times of which it says nothing.

    Without conflicts, agents kept their distance, but for what may have been in the gaps, and in what
    else of a file is `unknown`: ``gaps.unknown``.

    Attributes
    ----------
    i, j : ndarray, shape (m,)
        The ids of both agents, as they were given; ``i < j``.
    begin, end, closest_time, closest_distance
        As of `Conflicts`; a pair may be in conflict several times.
    gaps : Gaps
        Where fixes of an agent are farther apart in time than `max_gap`.

    Examples
    --------
    >>> import beespace
    >>> recording = beespace.Recording(
    ...     ["a", "b", "a", "b"], [0, 0, 10, 10], [[0, 0], [100, 3], [100, 0], [0, 3]]
    ... )
    >>> found = recording.conflicts(5)
    >>> found.i, found.j, found.begin, found.end
    (array(['a'], dtype='<U1'), array(['b'], dtype='<U1'), array([4.8]), array([5.2]))
    """

    __slots__ = ("gaps",)

    def __init__(
        self,
        i: NDArray[Any],
        j: NDArray[Any],
        begin: NDArray[np.float64],
        end: NDArray[np.float64],
        closest_time: NDArray[np.float64],
        closest_distance: NDArray[np.float64],
        count: int,
        gaps: Gaps,
    ) -> None:
        super().__init__(i, j, begin, end, closest_time, closest_distance, count)
        self.gaps = gaps

    def __repr__(self) -> str:
        return f"<RecordedConflicts: {self._told('agent')}; {_told_of(self.gaps)}>"


class Encounter(NamedTuple):
    """The two agents that came closest to each other.

    Where no two are known to have been there at the same time, all but the gaps is None.

    Attributes
    ----------
    i, j : int, str or None
        Their ids, as they were given; ``i < j``.
    time : float or None
        When they were closest, in seconds.
    distance : float or None
        Their straight-line distance then, in metres.
    gaps : Gaps
        Times in which agents may have been closer.

    Examples
    --------
    >>> import beespace
    >>> recording = beespace.Recording(
    ...     [7, 9, 7, 9], [0, 0, 10, 10], [[0, 0], [10, 3], [10, 0], [0, 3]]
    ... )
    >>> encounter = recording.closest()
    >>> encounter.i, encounter.j, encounter.time, encounter.distance
    (7, 9, 5.0, 3.0)
    """

    i: Any
    j: Any
    time: float | None
    distance: float | None
    gaps: Gaps

    def __repr__(self) -> str:
        if self.time is None or self.distance is None:
            return f"<Encounter: no two agents are known at the same time; {_told_of(self.gaps)}>"
        return (
            f"<Encounter: {self.i} and {self.j}, {self.distance:.6g} m at {self.time:.6g} s; "
            f"{_told_of(self.gaps)}>"
        )


class Approaches(Table):
    """When movers are closest, two by two.

    Attributes
    ----------
    closest_time : ndarray of float64, shape (n,)
        When the two are closest, in seconds from now; of several such instants the first.
    closest_distance : ndarray of float64, shape (n,)
        Their straight-line distance then, in metres.
    begin, end : ndarray of float64, shape (n,), or None
        From when to when they are closer than the threshold, in seconds; NaN where they never are.
        None without a threshold.

    Examples
    --------
    >>> import beespace
    >>> found = beespace.closest_approach([0, 0], [5, 0], [[100, 30], [0, 9]], [-5, 0])
    >>> found.closest_time, found.closest_distance
    (array([10.,  0.]), array([30.,  9.]))
    """

    __slots__ = ("begin", "closest_distance", "closest_time", "end")

    def __init__(
        self,
        closest_time: NDArray[np.float64],
        closest_distance: NDArray[np.float64],
        begin: NDArray[np.float64] | None,
        end: NDArray[np.float64] | None,
    ) -> None:
        self.closest_time = closest_time
        self.closest_distance = closest_distance
        self.begin = begin
        self.end = end

    def __len__(self) -> int:
        return len(self.closest_time)

    def __repr__(self) -> str:
        told = f"{len(self):,} approach{'' if len(self) == 1 else 'es'}"
        if self.begin is not None:
            told += f", {np.count_nonzero(~np.isnan(self.begin)):,} in conflict"
        if len(self):
            worst = int(self.closest_distance.argmin())
            told += (
                f", closest {self.closest_distance[worst]:.6g} m at {self.closest_time[worst]:.6g} s"
            )
        return f"<Approaches: {told}>"

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> found = beespace.closest_approach([0, 0], [5, 0], [100, 30], [-5, 0])
        >>> list(found.columns())
        ['closest_time', 'closest_distance']
        """
        columns = {"closest_time": self.closest_time, "closest_distance": self.closest_distance}
        if self.begin is not None and self.end is not None:
            columns |= {"begin": self.begin, "end": self.end}
        return columns
