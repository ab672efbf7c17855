"""The questions that workers ask the engine, cell by cell: functions for `mapInArrow`."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace._answers import Pairs
from beespace._engine import Engine
from beespace._errors import BeespaceError
from beespace._out_of_core import OutOfCore
from beespace.spark._blocks import Cell, Columns, batches_of, cells_of
from beespace.spark._workers import threads_of_task

# More pairs of a cell than this are found in pieces, so that the memory of a task is bounded.
_PAIRS_AT_ONCE = 4_000_000
# What `OutOfCore` takes to search so many points at a time, and at least.
_BYTES_A_POINT = 512
_LEAST_BYTES = 16 << 20


class Question:
    """What all questions have in common."""

    def __init__(self, columns: Columns, id: str, unit: float, arguments: dict[str, Any]) -> None:
        self.columns = columns
        self.id = id
        self.unit = unit  # of heights apart, in metres
        self.arguments = arguments  # of the methods of Engine and OutOfCore

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        threads = threads_of_task()
        engine = Engine()
        for cell in cells_of(batches, self.columns):
            if cell.heights is not None:
                yield from self.ask_apart(self._search_of(cell, threads), cell)
            else:
                yield from self.ask(engine, cell, {**self.arguments, "threads": threads})

    def ask(self, engine: Engine, cell: Cell, arguments: dict[str, Any]) -> Iterator[Any]:
        """The answer of one cell: what belongs to its home points."""
        raise NotImplementedError

    def ask_apart(self, search: OutOfCore, cell: Cell) -> Iterator[Any]:
        """The same of points with heights apart, which only this search compares."""
        raise NotImplementedError

    def _search_of(self, cell: Cell, threads: int) -> OutOfCore:
        memory = max(_BYTES_A_POINT * len(cell.ids), _LEAST_BYTES * threads)
        folder = os.environ.get("SPARK_LOCAL_DIRS", "").split(",")[0] or tempfile.gettempdir()
        search = OutOfCore(memory, folder, threads=threads, height_unit=self.unit)
        search.refer(cell.points, heights=cell.heights)
        return search


class AtRisk(Question):
    """The ids of points at risk."""

    def ask(self, engine: Engine, cell: Cell, arguments: dict[str, Any]) -> Iterator[Any]:
        """See `Question`."""
        return self._told(cell, engine.at_risk(cell.points, mask=True, **arguments))

    def ask_apart(self, search: OutOfCore, cell: Cell) -> Iterator[Any]:
        """See `Question`."""
        flags = np.zeros(len(cell.ids), bool)
        flags[search.at_risk(**self.arguments)] = True
        return self._told(cell, flags)

    def _told(self, cell: Cell, flags: NDArray[np.bool_]) -> Iterator[Any]:
        return batches_of([self.id], [cell.ids[flags & cell.home]])


class Counts(Question):
    """How many neighbours each point has."""

    def ask(self, engine: Engine, cell: Cell, arguments: dict[str, Any]) -> Iterator[Any]:
        """See `Question`."""
        return self._told(cell, engine.count(cell.points, **arguments))

    def ask_apart(self, search: OutOfCore, cell: Cell) -> Iterator[Any]:
        """See `Question`."""
        return self._told(cell, search.count(**self.arguments))

    def _told(self, cell: Cell, counts: NDArray[np.int64]) -> Iterator[Any]:
        return batches_of([self.id, "count"], [cell.ids[cell.home], counts[cell.home]])


class PairsOf(Question):
    """Pairs, each from the home of its lower id."""

    def ask(self, engine: Engine, cell: Cell, arguments: dict[str, Any]) -> Iterator[Any]:
        """See `Question`."""
        try:
            pieces = iter([engine.pairs(cell.points, max_results=_PAIRS_AT_ONCE, **arguments)])
        except BeespaceError as error:
            if error.code != "too_many_results":
                raise
            pieces = engine.iter_pairs(cell.points, **arguments)
        return self._told(cell, pieces)

    def ask_apart(self, search: OutOfCore, cell: Cell) -> Iterator[Any]:
        """See `Question`."""
        return self._told(cell, search.iter_pairs(**self.arguments))

    def _told(self, cell: Cell, pieces: Iterator[Pairs]) -> Iterator[Any]:
        for piece in pieces:
            own = cell.home[piece.i]
            assert piece.distance is not None
            yield from batches_of(
                ["first", "second", "distance"],
                [cell.ids[piece.i[own]], cell.ids[piece.j[own]], piece.distance[own]],
            )
