"""Pairs in pieces: a search on a thread of its own, which goes on as pieces are taken."""

from __future__ import annotations

import atexit
import ctypes
import os
import queue
import threading
import weakref
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace import _library
from beespace._answers import Pairs
from beespace._errors import BeespaceError
from beespace._library import CRun, library

# What shows pairs to a visitor: called with the run, the visitor, its data and the error.
Ask = Callable[[Any, Any, None, Any], int]


# For so many pairs there is room at first; a piece that has more grows.
_FIRST = 1 << 20


class _Piece:
    """Room for a number of pairs."""

    def __init__(self, size: int, distances: bool) -> None:
        self.size = size
        self.filled = 0
        kinds = (np.int64, np.int64, np.float64)[: 3 if distances else 2]
        self.columns: list[NDArray[Any]] = [np.empty(min(size, _FIRST), kind) for kind in kinds]

    def take(self, addresses: list[int], begin: int, count: int) -> int:
        """Copies as many pairs as fit, from the one at `begin` on; says how many."""
        taken = min(count - begin, self.size - self.filled)
        needed, there = self.filled + taken, len(self.columns[0])
        if needed > there:
            room = min(self.size, max(needed, 2 * there))
            self.columns = [np.concatenate([c, np.empty(room - there, c.dtype)]) for c in self.columns]
        for column, address in zip(self.columns, addresses):
            into = column.__array_interface__["data"][0] + 8 * self.filled
            ctypes.memmove(into, address + 8 * begin, 8 * taken)
        self.filled += taken
        return taken

    def pairs(self, points: int) -> Pairs:
        i, j, *distance = (column[: self.filled] for column in self.columns)
        return Pairs(i, j, distance[0] if distance else None, (points, points), False)


# Those whose pieces are being taken, and their threads.
_running: weakref.WeakKeyDictionary[Visit, threading.Thread] = weakref.WeakKeyDictionary()


def _end_all() -> None:
    """At the end of the interpreter, which ends threads where they come back to it: in the midst of a
    search, through which no such end passes."""
    for visit, worker in list(_running.items()):
        visit._end()  # pyright: ignore[reportPrivateUsage]
        worker.join()


atexit.register(_end_all)


class Visit:
    """One search whose pairs come in pieces of at most `chunk`."""

    def __init__(self, ask: Ask, points: int, distances: bool, threads: int, chunk: int) -> None:
        self._ask = ask
        self._points = points
        self._threads = threads
        self._chunk = chunk
        self._distances = distances
        self._ended = threading.Event()
        self._stop = library.beespace_stop_create()
        if not self._stop:
            raise MemoryError("beespace: no memory for a search")
        # One piece is read while one waits and one is filled.
        self._pieces: queue.Queue[Pairs | BaseException | None] = queue.Queue(maxsize=1)
        self._piece = _Piece(chunk, self._distances)
        self._problem: BaseException | None = None

    def pieces(self) -> Iterator[Pairs]:
        """The pieces. Who does not take them all ends the search."""
        worker = threading.Thread(target=self._run, name="beespace.iter_pairs", daemon=True)
        worker.start()
        _running[self] = worker
        process = os.getpid()
        try:
            while True:
                if os.getpid() != process:
                    raise BeespaceError(
                        "these pairs are found by a thread of the process that this one was forked from: "
                        "ask anew",
                        "invalid_argument",
                    )
                piece = self._pieces.get()
                if piece is None:
                    return
                if isinstance(piece, BaseException):
                    raise piece
                yield piece
        finally:
            if os.getpid() == process:
                self._end()
                worker.join()

    def _end(self) -> None:
        self._ended.set()
        library.beespace_stop_request(self._stop)

    def _run(self) -> None:
        self._put(self._search_all())

    def _search_all(self) -> BaseException | None:
        error = _library.new_error()
        run = CRun(ctypes.sizeof(CRun), self._threads, 0, self._stop.value)
        try:
            code = self._ask(
                ctypes.byref(run), _library.VISITOR(self._see), None, ctypes.byref(error)
            )
            if code != _library.OK and not self._ended.is_set():
                _library.raise_error(error)
            if self._problem is not None:
                return self._problem
            if self._piece.filled:
                self._put(self._piece.pairs(self._points))
        except BaseException as problem:
            return problem
        return None

    def _see(
        self, _data: int | None, first: int, second: int, distances: int | None, count: int
    ) -> int:
        # What is raised here would be lost, and the search would look complete.
        try:
            addresses = [first, second] if distances is None else [first, second, distances]
            return 1 if self._take(addresses, count) else 0
        except BaseException as problem:
            self._problem = problem
            return 0

    def _take(self, addresses: list[int], count: int) -> bool:
        seen = 0
        while seen < count:
            seen += self._piece.take(addresses, seen, count)
            if self._piece.filled == self._chunk:
                if not self._put(self._piece.pairs(self._points)):
                    return False
                self._piece = _Piece(self._chunk, self._distances)
        return not self._ended.is_set()

    def _put(self, piece: Pairs | BaseException | None) -> bool:
        """Waits until there is room; false where none is wanted any more."""
        while not self._ended.is_set():
            try:
                self._pieces.put(piece, timeout=0.05)
                return True
            except queue.Full:
                continue
        return False
