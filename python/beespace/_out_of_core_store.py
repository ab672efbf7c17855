"""What an `OutOfCore` holds, and how it is asked."""

from __future__ import annotations

import ctypes
import os
import re
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace import _library
from beespace import _out_of_core_library as _c
from beespace._calls import check, run_of, search_of, threads_of, whole
from beespace._columns import column
from beespace._errors import invalid
from beespace._fixes import numbers_of, unit_of_heights
from beespace._frames import Known, check_upright
from beespace._library import CRun, CSearch, library
from beespace._points import Points
from beespace._units import METRES

_units = {"": 1, "K": 10**3, "M": 10**6, "G": 10**9, "T": 10**12}
_binary_units = {"K": 2**10, "M": 2**20, "G": 2**30, "T": 2**40}
_size = re.compile(r"\s*(\d+(?:\.\d*)?)\s*([KMGT]?)(I?)B?\s*")
_phases = ("distributing", "searching")


class Store:
    """The C search, its options, and what it refers to."""

    __slots__ = (
        "_handle",
        "_kept",
        "_known",
        "_lock",
        "_memory",
        "_progress",
        "_size_of",
        "_threads",
        "_unit",
        "_upright",
    )

    def __init__(
        self,
        memory: Any,
        folder: str | os.PathLike[str] | None,
        threads: Any,
        height_unit: Any,
        progress: Callable[[str, int, int], object] | None,
        *,
        kind: str = "out_of_core",
    ) -> None:
        self._handle = _c.COutOfCore() if kind == "out_of_core" else _c.CLargeRecording()
        self._size_of = library[f"beespace_{kind}_size"]
        self._kept: list[object] = []
        self._known = Known()  # of all points
        self._lock = threading.Lock()
        self._memory = _bytes_of(memory)
        self._threads = threads_of(threads)
        self._upright = False
        self._progress = _Progress(progress)
        path: str = os.fspath(folder) if folder is not None else os.environ.get("TMPDIR") or "/var/tmp"
        if not os.path.isdir(path):
            raise invalid(f"there is no folder {path!r} for a temporary file", "folder")
        unit = unit_of_heights(height_unit, apart=True)
        if not 1e-6 <= unit <= 1e6:
            raise invalid("this is a length in metres, such as 0.3048 for feet", "height_unit")
        self._unit = unit
        options = _c.COptions(
            ctypes.sizeof(_c.COptions), self._memory, os.fsencode(path), unit, self._progress.called
        )
        error = _library.new_error()
        code = library[f"beespace_{kind}_create"](
            ctypes.byref(options), ctypes.byref(self._handle), ctypes.byref(error)
        )
        error.message = error.message.replace(b"memory_bytes", b"this")
        check(code, error, {"options": "memory"})

    def __len__(self) -> int:
        return int(self._size_of(self._handle))

    def _take(self, function: Any, points: Any, heights: Any) -> object:
        given = Points(points, "points")
        given.check_alike(self._known, "points", "points before")
        each = None if heights is None else numbers_of(heights, given.count, "heights", METRES)
        error = _library.new_error()
        with self._alone():
            code = function(
                self._handle,
                ctypes.byref(given.struct),
                None if each is None else each.ctypes.data,
                ctypes.byref(error),
            )
        check(code, error, {"": "heights"})
        if given.count:
            self._known.take(given)
            self._upright = each is not None
        return (given.keep, each)

    def _check_vertical(self, vertical: Any) -> None:
        if self._upright:
            return
        check_upright(self._known, vertical, "vertical")
        if vertical is not None:
            unit_of_heights(self._unit, apart=False)

    def _search_of(
        self, threshold: Any, vertical: Any, inclusive: bool, distances: bool
    ) -> CSearch:
        self._check_vertical(vertical)
        return search_of(threshold, vertical, inclusive, distances=distances)

    def _at_risk(self, threshold: Any, vertical: Any, inclusive: bool) -> list[NDArray[np.int64]]:
        pieces: list[NDArray[np.int64]] = []

        def see(_data: int | None, ids: int, count: int) -> None:
            pieces.append(column(None, ids, count, "<i8").copy())

        search = self._search_of(threshold, vertical, inclusive, False)
        self._call(
            library.beespace_out_of_core_at_risk, (ctypes.byref(search),), _c.IDS_VISITOR, see
        )
        return pieces

    def _call(
        self, function: Any, arguments: tuple[Any, ...], visitor: Any, see: Callable[..., None]
    ) -> None:
        """Asks a question whose answer a visitor sees."""
        problems: list[BaseException] = []
        self._run(function, arguments, (visitor(guarded(see, problems)), None))
        if problems:
            raise problems[0]

    def _run(self, function: Any, before: tuple[Any, ...], after: tuple[Any, ...]) -> None:
        run = run_of(self._threads, len(self)) or CRun(ctypes.sizeof(CRun))
        run.threads = self._threads
        stop = library.beespace_stop_create()
        if not stop:
            raise MemoryError("beespace: no memory for a search")
        run.stop = stop.value
        error = _library.new_error()
        problem = self._new_problem(stop)
        code = self._ask(
            function, *before, ctypes.byref(run), *after, ctypes.byref(error), problem=problem
        )
        if problem.raised is not None:
            raise problem.raised
        check(code, error)

    def _ask(self, function: Any, *arguments: Any, problem: Problem | None = None) -> int:
        with self._alone():
            self._progress.problem = problem
            return int(function(self._handle, *arguments))

    def _alone(self) -> _Alone:
        return _Alone(self._lock)

    @staticmethod
    def _new_problem(stop: Any) -> Problem:
        return Problem(stop)


def guarded(see: Callable[..., None], problems: list[BaseException]) -> Callable[..., int]:
    """A visitor: what is raised in it would be lost, and the search would look complete."""

    def called(*shown: Any) -> int:
        try:
            see(*shown)
            return 1
        except BaseException as problem:
            problems.append(problem)
            return 0

    return called


class Problem:
    """What the progress raised, and the stop that then ends the question."""

    def __init__(self, stop: Any) -> None:
        self.stop = stop
        self.raised: BaseException | None = None


class _Progress:
    """What the library calls; it does not know the store, which would never be freed then."""

    def __init__(self, tell: Callable[[str, int, int], object] | None) -> None:
        self.problem: Problem | None = None
        self._tell = tell
        self.called = _c.PROGRESS() if tell is None else _c.PROGRESS(self.see)

    def see(self, _data: int | None, phase: int, done: int, of: int) -> None:
        problem = self.problem
        if self._tell is None or problem is None or problem.raised is not None:
            return
        try:
            self._tell(_phases[phase], done, of)
        except BaseException as raised:
            problem.raised = raised
            library.beespace_stop_request(problem.stop)


class _Alone:
    """One question at a time; a second one would wait for ever where an iterator is held."""

    def __init__(self, lock: threading.Lock) -> None:
        self._lock = lock

    def __enter__(self) -> None:
        if not self._lock.acquire(blocking=False):
            raise invalid("another question is being answered: take all its pieces, or close it")

    def __exit__(self, *_what: object) -> None:
        self._lock.release()


def _bytes_of(memory: Any) -> int:
    if not isinstance(memory, str):
        return whole(memory, "memory")
    read = _size.fullmatch(memory.upper())
    if read is None or (read[3] and not read[2]):
        raise invalid(f"this is a size such as '2GB' or '500 MiB', not {memory!r}", "memory")
    unit = (_binary_units if read[3] else _units)[read[2]]
    return int(float(read[1]) * unit)
