"""Recordings that are larger than memory."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace import _library
from beespace import _out_of_core_library as _c
from beespace._calls import check, number_of, search_of, seconds
from beespace._columns import column
from beespace._conflicts import Gaps, RecordedConflicts
from beespace._errors import invalid
from beespace._fixes import Fixes, agents_of, numbers_of, seconds_of
from beespace._library import library
from beespace._out_of_core_store import Store, guarded
from beespace._points import Points, PointsLike
from beespace._units import METRES


class RecordingOutOfCoreFacts(NamedTuple):
    """What the last search of a `RecordingOutOfCore` went through.

    Attributes
    ----------
    windows : int
        Windows of time with fixes.
    copies : int
        How many more fixes were written than there are: those of pieces that go over a border.
    largest_window : int
        The fixes of the fullest window.
    encounters : bool
        Whether two agents are known at the same time.

    Examples
    --------
    >>> import beespace
    >>> recording = beespace.RecordingOutOfCore("16 MiB")
    >>> recording.add([1, 2], [0, 0], [[0, 0], [3, 4]])
    >>> len(recording.conflicts(6))
    1
    >>> recording.facts
    RecordingOutOfCoreFacts(windows=1, copies=0, largest_window=2, encounters=True)
    """

    windows: int
    copies: int
    largest_window: int
    encounters: bool


class RecordingOutOfCore(Store):
    """A recording that is larger than memory: which agents came closer than a threshold, and when?

    Fixes come in parts, of any agents and in any order, and wait in a temporary file. A question cuts
    time into windows that fit into the memory, and searches one after the other; answers are those of
    `Recording`, bit for bit. The file has no name: nothing is left of it, however the program ends. One
    question at a time. Ctrl-C ends a long one.

    Parameters
    ----------
    memory : str or int
        How much the search may use, besides its answers: "2GB", "500 MiB", or bytes. At least 16 MiB a
        thread. Agents that are there at one time are searched together: some 600 bytes each.
    folder : str or path, optional
        Where the temporary file goes, with room for some 60 bytes a fix, and while a question is asked
        for twice as much; by default that of the environment variable TMPDIR, or /var/tmp.
    threads : int
        How many threads may work; 0 for one per processor. The answer is always the same.
    height_unit : float
        The length in metres of one unit of `heights`, and then of `vertical`: 0.3048 for feet.
    progress : callable, optional
        Called some times a second as ``progress(phase, done, of)``, with "distributing" or
        "searching" and numbers of fixes. What it raises ends the question.

    Raises
    ------
    BeespaceError
        What makes no sense. Questions: "time_order" where an agent has two fixes at one time, with the
        second one's row among all that were added as `record`; "write_failed" where the folder has too
        little room; "corrupt" where the disk returned another thing than was written.

    Examples
    --------
    >>> import beespace
    >>> recording = beespace.RecordingOutOfCore("100 MB")
    >>> recording.add(["ann", "bob"], [10, 10], [[100, 0], [0, 3]])
    >>> recording.add(["ann", "bob"], [0, 0], [[0, 0], [100, 3]])
    >>> recording.conflicts(5)
    <RecordedConflicts: 1 conflict of 2 agents, from 4.8 to 5.2 s, closest ann and bob: 3 m at 5 s; no gaps>
    >>> recording
    <beespace.RecordingOutOfCore: 4 fixes, 100,000,000 bytes of memory>
    """

    __slots__ = ("_agents", "_height_units", "_names", "_number_of", "_unit_given")

    def __init__(
        self,
        memory: str | int,
        folder: str | os.PathLike[str] | None = None,
        *,
        threads: int = 1,
        height_unit: float = 1.0,
        progress: Callable[[str, int, int], object] | None = None,
    ) -> None:
        super().__init__(memory, folder, threads, height_unit, progress, kind="large_recording")
        # Of heights in another unit it is not known what it is called.
        self._unit_given = number_of(height_unit, "height_unit", METRES) != 1
        self._height_units: tuple[str, ...] | None = METRES
        # Texts by their numbers, which are given as they come; None where ids are integers.
        self._names: list[Any] | None = None
        self._number_of: dict[Any, int] = {}
        self._agents: set[int] = set()

    def __repr__(self) -> str:
        count = len(self)
        return (
            f"<beespace.RecordingOutOfCore: {count:,} fix{'' if count == 1 else 'es'}, "
            f"{self._memory:,} bytes of memory>"
        )

    def __reduce__(self) -> Any:
        """Refused: fixes that wait on the disk are not taken along."""
        return self._handle.__reduce__()

    @property
    def facts(self) -> RecordingOutOfCoreFacts:
        """What the last search went through.

        Examples
        --------
        >>> import beespace
        >>> beespace.RecordingOutOfCore("100 MB").facts.windows
        0
        """
        told = _c.CRecordingFacts(ctypes.sizeof(_c.CRecordingFacts))
        error = _library.new_error()
        with self._alone():
            code = library.beespace_large_recording_facts_of(
                self._handle, ctypes.byref(told), ctypes.byref(error)
            )
        check(code, error)
        return RecordingOutOfCoreFacts(
            told.windows, told.copies, told.largest_window, bool(told.encounters)
        )

    def add(
        self,
        ids: ArrayLike,
        times: ArrayLike,
        positions: PointsLike,
        *,
        heights: ArrayLike | None = None,
    ) -> None:
        """Adds fixes, which are copied to the disk.

        Parameters
        ----------
        ids : array of shape (n,)
            The agent of each fix: integers, or texts in all parts. What is known of agents, their ids,
            stays in memory.
        times : array of shape (n,)
            The time of each fix, in seconds from any moment; in any order.
        positions : array of shape (n, 3) or (n, 2), tuple of arrays, or data frame
            The position of each fix, in metres.
        heights : array of shape (n,), optional
            A height for each, apart from its position, which is then horizontal. All fixes have them,
            or none.

        Raises
        ------
        BeespaceError
            With `place` ("ids", "times", "positions" or "heights") and, as `record`, the row: what is no
            fix; none was added then. A full disk, after which nothing else is answered.

        Examples
        --------
        >>> import beespace
        >>> recording = beespace.RecordingOutOfCore("100 MB")
        >>> recording.add([1, 2], [0, 0], [[0, 0], [3, 4]], heights=[100, 105])
        >>> len(recording.conflicts(6, vertical=10))
        1
        """
        given = Points(positions, "positions")
        given.check_alike(self._known, "positions", "positions before")
        numbers, labels = agents_of(ids, given.count)
        self._check_kind(given.count, labels)
        fixes = Fixes(numbers, seconds_of(times, given.count))
        if labels is not None:
            # Numbers are given only where the fixes are taken.
            told = {name: len(self._number_of) + at for at, name in enumerate(self._new_of(labels))}
            each = np.array([self._number_of.get(n, told.get(n, -1)) for n in labels.tolist()], np.int64)
            fixes = Fixes(each[numbers], fixes.keep[1])
        if heights is not None:
            units = None if self._unit_given else METRES
            fixes.set_heights(numbers_of(heights, given.count, "heights", units))
        error = _library.new_error()
        with self._alone():
            code = library.beespace_large_recording_add(
                self._handle,
                ctypes.byref(fixes.struct),
                ctypes.byref(given.struct),
                ctypes.byref(error),
            )
        check(code, error)
        if not given.count:
            return
        self._known.take(given)
        self._upright = heights is not None
        if heights is not None and self._unit_given:
            self._height_units = None
        if labels is None:
            self._agents.update(np.unique(numbers).tolist())
        else:
            names = [] if self._names is None else self._names
            for name in self._new_of(labels):
                self._number_of[name] = len(names)
                names.append(name)
            self._names = names

    def conflicts(
        self,
        threshold: float,
        *,
        max_gap: float | None = None,
        vertical: float | None = None,
        inclusive: bool = False,
        max_results: int | None = None,
    ) -> RecordedConflicts:
        """Which agents came closer than the threshold to each other, when, and how close?

        Conflicts and gaps are held in memory, besides the limit.

        Parameters
        ----------
        threshold, max_gap, vertical, inclusive, max_results
            As of `Recording.conflicts`.

        Returns
        -------
        RecordedConflicts
            That of `Recording.conflicts`.

        Examples
        --------
        >>> import beespace
        >>> recording = beespace.RecordingOutOfCore("100 MB")
        >>> recording.add([1, 2, 1, 2], [0, 0, 10, 10], [[0, 0], [100, 3], [100, 0], [0, 3]])
        >>> recording.conflicts(5, max_gap=2)
        <RecordedConflicts: 0 conflicts of 2 agents; 2 gaps of 2 agents, 20 s in all, of which nothing is known>
        """
        self._check_vertical(vertical)
        search = search_of(
            threshold, vertical, inclusive, max_results, height_units=self._height_units
        )
        gap = np.inf if max_gap is None else seconds(max_gap, "max_gap")
        found = _Columns(6)
        unknown = _Columns(3)
        problems: list[BaseException] = []
        self._run(
            library.beespace_large_recording_conflicts,
            (ctypes.byref(search), gap),
            (
                _c.CONFLICTS_VISITOR(guarded(found.see, problems)),
                _c.GAPS_VISITOR(guarded(unknown.see, problems)),
                None,
            ),
        )
        if problems:
            raise problems[0]
        i, j, begin, closest, end, distance = found.joined(2)
        (agent, gap_begin, gap_end) = unknown.joined(1)
        if self._names is not None:
            # In the order of the texts, as in memory.
            names = _array_of(self._names)
            order = np.argsort(names, kind="stable")
            rank = np.empty(len(names), np.int64)
            rank[order] = np.arange(len(names))
            low, high = np.minimum(rank[i], rank[j]), np.maximum(rank[i], rank[j])
            rows = np.lexsort((end, begin, high, low))
            begin, closest, end, distance = (c[rows] for c in (begin, closest, end, distance))
            i, j = names[order[low[rows]]], names[order[high[rows]]]
            rows = np.lexsort((gap_begin, rank[agent]))
            agent, gap_begin, gap_end = names[agent[rows]], gap_begin[rows], gap_end[rows]
        agents = len(self._agents if self._names is None else self._names)
        gaps = Gaps(agent, gap_begin, gap_end)
        return RecordedConflicts(i, j, begin, end, closest, distance, agents, gaps)

    def _new_of(self, labels: NDArray[Any]) -> list[Any]:
        return [name for name in labels.tolist() if name not in self._number_of]

    def _check_kind(self, count: int, labels: NDArray[Any] | None) -> None:
        if not count or (self._names is None and not self._agents):
            return
        kind = None if self._names is None else self._names[0].__class__
        if (None if labels is None else labels[0].__class__) not in (kind, _of_numpy.get(kind)):
            raise invalid("ids are integers in all parts, or texts in all of them", "ids")


_of_numpy: dict[Any, Any] = {str: np.str_, bytes: np.bytes_}


def _array_of(names: list[Any]) -> NDArray[Any]:
    # NumPy drops zero bytes at the end of a text.
    is_cut = any(name[-1:] in ("\0", b"\0") for name in names)
    return np.array(names, object) if is_cut else np.array(names)


class _Columns:
    """What visitors show, part by part."""

    def __init__(self, count: int) -> None:
        self.parts: list[list[NDArray[Any]]] = [[] for _ in range(count)]

    def see(self, _data: int | None, *shown: Any) -> None:
        *addresses, count = shown
        ids = len(addresses) // 3  # two of six, one of three
        for at, (parts, address) in enumerate(zip(self.parts, addresses)):
            parts.append(column(None, address, count, "<i8" if at < ids else "<f8").copy())

    def joined(self, ids: int) -> list[NDArray[Any]]:
        """Each column as one array."""
        kinds = [np.int64 if at < ids else np.float64 for at in range(len(self.parts))]
        return [
            np.concatenate(parts) if parts else np.empty(0, kind)
            for parts, kind in zip(self.parts, kinds)
        ]
