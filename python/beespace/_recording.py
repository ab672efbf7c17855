"""Recordings: where agents were and when, and which came too close."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace import _library
from beespace._calls import check, run_of, search_of
from beespace._checks import Check, gap_of
from beespace._columns import Result
from beespace._conflicts import Encounter, Gaps, RecordedConflicts
from beespace._errors import invalid
from beespace._file_recording import FileRecording
from beespace._fixes import Fixes, agents_of, numbers_of, seconds_of, unit_of_heights
from beespace._frame_columns import column_of
from beespace._frames import Known, check_upright
from beespace._library import library
from beespace._obstacles import Obstacles
from beespace._points import Points, PointsLike
from beespace._units import METRES
from beespace._verdict import Verdict


class Recording:
    """Where agents were and when: which came closer than a threshold, and when?

    Between two of its fixes an agent moves in the straight line through both, at constant velocity;
    before the first and after the last it is absent. So a pass between two fixes is found, too.
    Fixes need neither be at common times nor regular. Any number of threads may ask at once.

    Parameters
    ----------
    ids : array of shape (n,)
        The agent of each fix: integers or texts. Rows of agents may stand in any order.
    times : array of shape (n,)
        The time of each fix, in seconds from any moment. Those of one agent must ascend: sort rows
        by time first.
    positions : array of shape (n, 3) or (n, 2), tuple of arrays, or data frame
        The position of each fix, in metres; copied.
    heights : array of shape (n,), optional
        The height of each fix, kept apart from its position, which is then horizontal: for a
        vertical threshold between agents whose third axis is not the height, as those of `to_ecef`
        (of positions at height 0). `conflicts` must then be asked with `vertical`.
    height_unit : float
        The length in metres of one unit of these heights, and of `vertical`: 0.3048 for feet.

    Raises
    ------
    BeespaceError
        With `place` ("ids", "times", "positions" or "heights") and, as `record`, the row: "time_order" where a
        time does not come after the one before it of the same agent, also where it is the same;
        "not_finite", "outside_domain".

    Examples
    --------
    >>> import beespace
    >>> recording = beespace.Recording(
    ...     ids=["ann", "bob", "ann", "bob"],
    ...     times=[0, 0, 10, 10],
    ...     positions=[[0, 0], [100, 3], [100, 0], [0, 3]],
    ... )
    >>> recording
    <beespace.Recording: 4 fixes of 2 agents, 0 to 10 s>
    >>> recording.conflicts(5)
    <RecordedConflicts: 1 conflict of 2 agents, from 4.8 to 5.2 s, closest ann and bob: 3 m at 5 s; no gaps>
    """

    __slots__ = (
        "_agents",
        "_file",
        "_fixes",
        "_handle",
        "_has_heights",
        "_height_units",
        "_ids",
        "_known",
        "_labels",
        "_span",
    )

    def __init__(
        self,
        ids: ArrayLike,
        times: ArrayLike,
        positions: PointsLike,
        *,
        heights: ArrayLike | None = None,
        height_unit: float = 1.0,
    ) -> None:
        self._handle = _library.CRecording()
        self._file: FileRecording | None = None
        given = Points(positions, "positions")
        self._known = Known(given.axes, given.frame)
        agents, self._labels = agents_of(ids, given.count)
        clock = seconds_of(times, given.count)
        fixes = Fixes(agents, clock)
        # Of heights in another unit it is not known what it is called.
        unit = unit_of_heights(height_unit, heights is not None)
        self._has_heights = heights is not None
        self._height_units = METRES if unit == 1.0 else None
        if heights is not None:
            fixes.set_heights(numbers_of(heights, given.count, "heights", self._height_units))
            fixes.struct.height_unit_m = unit
        error = _library.new_error()
        run = run_of(1, given.count)
        code = library.beespace_recording_create(
            ctypes.byref(fixes.struct),
            ctypes.byref(given.struct),
            None if run is None else ctypes.byref(run),
            ctypes.byref(self._handle),
            ctypes.byref(error),
        )
        check(code, error)
        self._fixes = given.count
        self._ids = np.unique(agents) if self._labels is None else self._labels
        self._agents = int(library.beespace_recording_agents(self._handle))
        self._span = (float(clock.min()), float(clock.max())) if given.count else (0.0, 0.0)

    @classmethod
    def from_frame(
        cls,
        frame: Any,
        *,
        id: str,
        time: str,
        x: str,
        y: str,
        z: str | None = None,
        height: str | None = None,
        height_unit: float = 1.0,
    ) -> Recording:
        """A recording of the rows of a data frame: of pandas, Polars, or anything with columns by name.

        Parameters
        ----------
        frame : data frame, table of Arrow, dataset of xarray, structured array, or dict of columns
            A row for each fix. Columns of float64 or float32 are read without a conversion.
        id, time, x, y, z : str
            The names of the columns: agent, time in seconds, coordinates in metres; without `z`,
            heights are 0. None is guessed.
        height : str, optional
            The name of the column of heights that are kept apart from positions.
        height_unit : float
            As of `Recording`.

        Returns
        -------
        Recording

        Examples
        --------
        >>> import beespace
        >>> frame = {"callsign": ["A1", "B2"], "t": [0, 0], "east": [0, 3], "north": [0, 4]}
        >>> beespace.Recording.from_frame(frame, id="callsign", time="t", x="east", y="north")
        <beespace.Recording: 2 fixes of 2 agents, at 0 s>
        """
        names = {"id": id, "time": time, "x": x, "y": y}
        names |= {role: name for role, name in (("z", z), ("height", height)) if name is not None}
        columns = {role: column_of(frame, name, role) for role, name in names.items()}
        axes = tuple(columns[axis] for axis in ("x", "y", "z") if axis in columns)
        return cls(
            columns["id"],
            columns["time"],
            axes,
            heights=columns.get("height"),
            height_unit=height_unit,
        )

    @classmethod
    def from_file(cls, recording: FileRecording) -> Recording:
        """A recording of what `read_recording` gave. It knows the frame of the file, which its bare
        `positions` do not: `vertical` is refused of degrees.

        Where `max_gap` is not given, that of the file counts, as of `FileRecording.coverage`: five times
        the typical interval. What else of the file is not known, or not looked at along straight lines
        (velocities; curves of a show, and its drones on the ground), is in ``gaps.unknown`` of each
        answer, and a `verify` of what is not known does not hold. `FileRecording.conflicts` looks at all
        of it.

        Parameters
        ----------
        recording : FileRecording
            All fixes of the file.

        Returns
        -------
        Recording
            Its agents are the ids of the file.

        Examples
        --------
        >>> import beespace
        >>> cage = beespace.read_recording("../examples/data/cage.csv")
        >>> beespace.Recording.from_file(cage).closest()
        <Encounter: b02 and b05, 0.0157202 m at 9.25137 s; 1 gap of 1 agent, 4 s in all, of which nothing is known>
        """
        if not isinstance(recording, FileRecording):  # pyright: ignore[reportUnnecessaryIsInstance]
            raise invalid(f"this is what read_recording gives, and not {recording!r}", "recording")
        made = cls(recording.ids[recording.agents], recording.times, recording.positions)
        made._known.frame = recording.frame
        made._file = recording
        return made

    def __len__(self) -> int:
        """How many fixes there are."""
        return self._fixes

    def __repr__(self) -> str:
        told = f"{self._fixes:,} fix{'' if self._fixes == 1 else 'es'} of {self._agents:,} agent"
        told += "" if self._agents == 1 else "s"
        begins, ends = self._span
        if self._fixes:
            told += f", at {begins:.6g} s" if begins == ends else f", {begins:.6g} to {ends:.6g} s"
        return f"<beespace.Recording: {told}>"

    def conflicts(
        self,
        threshold: float,
        *,
        max_gap: float | None = None,
        vertical: float | None = None,
        inclusive: bool = False,
        max_results: int | None = None,
        threads: int = 1,
    ) -> RecordedConflicts:
        """Which agents came closer than the threshold to each other, when, and how close?

        Whether two did at some instant is decided as real numbers; times and distances are rounded,
        for reading.

        Parameters
        ----------
        threshold, vertical, inclusive, threads
            As `at_risk` says.
        max_gap : float, optional
            The longest time between two fixes of an agent, in seconds, that is bridged by a straight
            line; without it all are, but for those of a file (see `from_file`). In a longer one it is unknown where the agent is: it is
            compared with none, and the gap is among the `gaps` of the answer.
        max_results : int, optional
            More conflicts than this are an error, "too_many_results". An answer is never cut.

        Returns
        -------
        RecordedConflicts
            `i` and `j` are ids of agents as they were given. A pair may be in conflict several times.

        Examples
        --------
        >>> import beespace
        >>> recording = beespace.Recording(
        ...     [1, 2, 1, 2], [0, 0, 10, 10], [[0, 0], [100, 3], [100, 0], [0, 3]]
        ... )
        >>> recording.conflicts(5, max_gap=2)
        <RecordedConflicts: 0 conflicts of 2 agents; 2 gaps of 2 agents, 20 s in all, of which nothing is known>
        """
        if not self._has_heights:
            check_upright(self._known, vertical, "vertical")
        elif vertical is None:
            raise invalid("give this: the heights are apart from the positions", "vertical")
        search = search_of(
            threshold, vertical, inclusive, max_results, height_units=self._height_units
        )
        result = self._ask(
            library.beespace_recording_conflicts, (ctypes.byref(search),), max_gap, threads
        )
        return RecordedConflicts(
            self._named(result.first()),
            self._named(result.second()),
            result.begins(),
            result.ends(),
            result.closest_times(),
            result.distances(),
            self._agents,
            self._gaps_of(result, max_gap),
        )

    def closest(self, *, max_gap: float | None = None, threads: int = 1) -> Encounter:
        """Which two agents came closest to each other, when, and how close?

        Parameters
        ----------
        max_gap
            As of `conflicts`.
        threads
            As `at_risk` says.

        Returns
        -------
        Encounter
            With the gaps in which others may have been closer. Its `i`, `j`, `time` and `distance`
            are None where no two agents are known to be there at the same time.

        Examples
        --------
        >>> import beespace
        >>> recording = beespace.Recording(
        ...     [1, 2, 1, 2], [0, 0, 10, 10], [[0, 0], [100, 3], [100, 0], [0, 3]]
        ... )
        >>> recording.closest()
        <Encounter: 1 and 2, 3 m at 5 s; no gaps>
        """
        result = self._ask(library.beespace_recording_closest, (), max_gap, threads)
        i = self._named(result.first())
        gaps = self._gaps_of(result, max_gap)
        if not len(i):
            return Encounter(None, None, None, None, gaps)
        return Encounter(
            i.tolist()[0],
            self._named(result.second()).tolist()[0],
            float(result.closest_times()[0]),
            float(result.distances()[0]),
            gaps,
        )

    def verify(
        self,
        threshold: float,
        *,
        max_gap: float | None = None,
        max_speed: float | None = None,
        obstacles: Obstacles | None = None,
        clearance: float | None = None,
        threads: int = 1,
    ) -> Verdict:
        """Did agents that all have fixes at the same times keep apart, and within their limits?

        As the function `verify`, in straight lines.

        Parameters
        ----------
        threshold, max_gap, max_speed, obstacles, clearance, threads
            As of `verify`.

        Returns
        -------
        Verdict
            Its agents are ids as they were given.

        Examples
        --------
        >>> import beespace
        >>> recording = beespace.Recording(
        ...     [1, 2, 1, 2], [0, 0, 10, 10], [[0, 0], [100, 3], [100, 0], [0, 3]]
        ... )
        >>> recording.verify(2, max_speed=20)
        <Verdict: holds; 1 step, closest 1 and 2: 3 m>
        """
        checked = Check(threshold, max_speed, None, obstacles, clearance, True, threads)
        checked.add_recording(self._handle, self._fixes, self._known, self._gap(max_gap))
        verdict = checked.verdict(self._ids)
        if self._file is not None:
            known = self._file.coverage(max_gap=max_gap)
            verdict.unknown = known.beside_gaps
            verdict.holds = verdict.holds and not known.may_hide_conflicts
        return verdict

    def _ask(self, function: Any, search: tuple[Any, ...], max_gap: Any, threads: int) -> Result:
        error = _library.new_error()
        result = Result()
        run = run_of(threads, self._fixes, moving=True)
        code = function(
            self._handle,
            *search,
            self._gap(max_gap),
            None if run is None else ctypes.byref(run),
            result.handle,
            ctypes.byref(error),
        )
        check(code, error)
        return result

    def _gap(self, max_gap: Any) -> float:
        if max_gap is None and self._file is not None:
            return self._file.coverage().max_gap
        return gap_of(max_gap)

    def _gaps_of(self, result: Result, max_gap: Any) -> Gaps:
        return Gaps(
            self._named(result.gap_agents()),
            result.gap_begins(),
            result.gap_ends(),
            "" if self._file is None else _unknown_in(self._file, max_gap),
        )

    def _named(self, ids: NDArray[np.int64]) -> NDArray[Any]:
        return ids if self._labels is None else self._labels[ids]


def _unknown_in(file: FileRecording, max_gap: Any) -> str:
    """What straight lines from fix to fix do not say of a file."""
    coverage = file.coverage(max_gap=max_gap)
    told = [coverage.beside_gaps]
    if not file.is_show and not _meet(file, coverage.max_gap):
        told.append("no two agents are there at the same time")
    if file.is_show:
        told.append("curves of the show and drones on the ground are not looked at")
    elif file.velocities is not None:
        told.append("velocities are not looked at")
    return ", ".join(filter(None, told))


def _meet(file: FileRecording, max_gap: float) -> bool:
    """Whether some two agents are there at the same time."""
    times = file.times
    if not len(times):
        return False
    begins = np.zeros(len(times), bool)
    begins[file.indptr[:-1][np.diff(file.indptr) > 0]] = True
    begins[1:] |= np.diff(times) > max_gap
    first = np.flatnonzero(begins)
    last = np.append(first[1:], len(times)) - 1
    order = np.argsort(times[first], kind="stable")
    # Times of one agent do not overlap: what does is of two.
    until = np.maximum.accumulate(times[last][order])
    return bool((times[first][order][1:] <= until[:-1]).any())
