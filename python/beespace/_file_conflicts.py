"""Conflicts of a recording of a file, as the command `beespace replay` finds them."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from beespace import _io_library, _library
from beespace._calls import length, run_of, whole
from beespace._checks import gap_of
from beespace._conflicts import Encounter, Gaps, RecordedConflicts
from beespace._coverage import Coverage
from beespace._errors import BeespaceError
from beespace._file_columns import array_of
from beespace._ranges import above_zero

if TYPE_CHECKING:
    from beespace._file_recording import FileRecording


class FileConflicts(RecordedConflicts):
    """Conflicts of a recording of a file, and what keeps the answer from being an all-clear: what the
    command `beespace replay` says.

    Attributes
    ----------
    i, j : ndarray of str objects, shape (m,)
        The ids of both agents; that of `i` comes first in the file.
    begin, end, closest_time, closest_distance
        As of `RecordedConflicts`.
    certain : ndarray of bool, shape (m,)
        Whether each is one for sure. Others are possible: along curves with the given velocities, or
        as close to the threshold as the curves of a show are followed.
    gaps : Gaps
        Where fixes of an agent are farther apart in time than `max_gap`.
    risky : bool
        False is an all-clear. True where there is a conflict, where what is unknown may hide one, or
        where nothing could be compared: where `replay --fail-on-risk` ends with 1.
    threshold : float
        What was taken for too close, in metres.
    coverage : Coverage
        Of how much of the recording it is known where its agents were.
    closest : Encounter
        The two that came closest, in conflict or not; with a vertical threshold those of a conflict.
        Its ids are None where there are none.
    standing_count : int
        How many conflicts are with a drone of a show that stands on the ground.
    ignored_count : int
        How many conflicts `ignore_below` left out; the closest two may be of one of them.
    takeoff_unknown_count : int
        With it: of how many agents it is not known where they took off; none of theirs is left out.
    too_far : bool
        Whether velocities lead too far away from straight lines to be followed, so that they may hide
        a conflict.

    Examples
    --------
    >>> import beespace
    >>> cage = beespace.read_recording("../examples/data/cage.csv")
    >>> found = cage.conflicts(0.01)
    >>> found
    <FileConflicts: 0 conflicts of 10 agents; 1 bee unknown for 4 s in all>
    >>> found.risky, found.gaps
    (True, <Gaps: 1 gap of 1 agent, 4 s in all, of which nothing is known>)
    >>> cage.conflicts(0.01, max_gap=5)
    <FileConflicts: 0 conflicts of 10 agents; what is known is an all-clear>
    """

    __slots__ = (
        "certain",
        "closest",
        "compared",
        "coverage",
        "ignored_count",
        "risky",
        "standing_count",
        "takeoff_unknown_count",
        "threshold",
        "too_far",
    )

    certain: NDArray[np.bool_]
    closest: Encounter
    compared: bool
    coverage: Coverage
    ignored_count: int
    risky: bool
    standing_count: int
    takeoff_unknown_count: int
    threshold: float
    too_far: bool

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> cage = beespace.read_recording("../examples/data/cage.csv")
        >>> list(cage.conflicts(0.02).columns())
        ['i', 'j', 'begin', 'end', 'closest_time', 'closest_distance', 'certain']
        """
        return {**super().columns(), "certain": self.certain}

    def __repr__(self) -> str:
        told = [self._told("agent")]
        possible = int(np.count_nonzero(~self.certain))
        if possible:
            told.append(f"{possible:,} of them possible only")
        if self.ignored_count:
            told.append(f"{self.ignored_count:,} left out")
        if not self.compared:
            told.append("no two agents are there at the same time")
        if self.too_far:
            told.append("the velocities lead too far away from straight lines to be followed")
        if self.coverage.unknown:
            told.append(self.coverage.unknown)
        if not self.risky:
            told.append("what is known is an all-clear")
        return f"<FileConflicts: {'; '.join(told)}>"


def conflicts_of(
    recording: FileRecording,
    threshold: Any,
    vertical: Any,
    inclusive: bool,
    max_gap: Any,
    straight: bool,
    ignore_below: Any,
    max_results: Any,
    threads: Any,
) -> FileConflicts:
    """As `FileRecording.conflicts`."""
    options = _io_library.CConflictOptions(ctypes.sizeof(_io_library.CConflictOptions))
    if threshold is not None:
        options.threshold_m = length(threshold, "threshold")
        if not options.threshold_m > 0:
            raise BeespaceError("a threshold is above zero", "invalid_threshold", "threshold")
    if inclusive:
        options.flags |= _library.INCLUSIVE
    if straight:
        options.flags |= _io_library.ALONG_LINES
    if vertical is not None:
        text = vertical if isinstance(vertical, str) else repr(length(vertical, "vertical"))
        options.vertical = _io_library.encoded(text)
    options.max_gap_s = 0.0 if max_gap is None else gap_of(max_gap)
    if ignore_below is not None:
        options.ignore_below_m = above_zero(length(ignore_below, "ignore_below"), "ignore_below")
    if max_results is not None:
        options.limited, options.max_results = 1, whole(max_results, "max_results")
    run = run_of(threads, len(recording), moving=True)
    if run is not None:
        options.run = ctypes.pointer(run)
    io = _io_library.load()
    handle = io.handles["conflicts"]()
    error = _io_library.new_error()
    code = io.unlocked.beespace_io_find_conflicts(
        recording.handle, ctypes.byref(options), ctypes.byref(handle), ctypes.byref(error)
    )
    if error.place == b"options":
        error.place = b"vertical"  # all others have been looked at
    _io_library.check(code, error)
    return _found_in(handle, recording.ids)


def _found_in(handle: ctypes.c_void_p, ids: NDArray[Any]) -> FileConflicts:
    at_once = _io_library.load().at_once
    facts = _io_library.CConflictFacts(ctypes.sizeof(_io_library.CConflictFacts))
    error = _io_library.new_error()
    code = at_once.beespace_io_conflicts_facts_of(handle, ctypes.byref(facts), ctypes.byref(error))
    _io_library.check(code, error)
    size = int(at_once.beespace_io_conflicts_size(handle))
    gap_count = int(at_once.beespace_io_conflicts_gaps(handle))

    def column(name: str, count: int, dtype: Any) -> NDArray[Any]:
        get = getattr(at_once, f"beespace_io_conflicts_{name}")
        return array_of(handle, get(handle), (count,), dtype)

    gaps = Gaps(
        ids[column("gap_agent", gap_count, np.int64)],
        column("gap_begins_s", gap_count, np.float64),
        column("gap_ends_s", gap_count, np.float64),
    )
    found = FileConflicts(
        ids[column("first", size, np.int64)],
        ids[column("second", size, np.int64)],
        column("begins_s", size, np.float64),
        column("ends_s", size, np.float64),
        column("closest_s", size, np.float64),
        column("closest_m", size, np.float64),
        len(ids),
        gaps,
    )
    found.certain = column("certain", size, np.uint8).astype(np.bool_)
    found.risky, found.compared = bool(facts.risky), bool(facts.compared)
    found.too_far = bool(facts.too_far)
    found.threshold = float(facts.threshold_m)
    found.standing_count = int(facts.with_standing)
    found.ignored_count = int(facts.ignored)
    found.takeoff_unknown_count = int(facts.takeoff_unknown)
    found.coverage = Coverage(at_once.beespace_io_conflicts_coverage, handle)
    found.closest = Encounter(None, None, None, None, gaps)
    if facts.closest_first >= 0:
        found.closest = Encounter(
            str(ids[facts.closest_first]),
            str(ids[facts.closest_second]),
            float(facts.closest_s),
            float(facts.closest_m),
            gaps,
        )
    return found
