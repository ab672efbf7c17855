"""The questions that workers ask the engine, cell by cell: functions for `mapInArrow`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from beespace._engine import Engine
from beespace._errors import BeespaceError
from beespace.spark._blocks import Cell, batches_of, cells_of
from beespace.spark._workers import threads_of_task

# More pairs of a cell than this are found in pieces, so that the memory of a task is bounded.
_PAIRS_AT_ONCE = 4_000_000


class Question:
    """What all questions have in common."""

    def __init__(self, axes: int, id: str, arguments: dict[str, Any]) -> None:
        self.axes = axes
        self.id = id
        self.arguments = arguments  # of the methods of Engine

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        threads = threads_of_task()
        engine = Engine()
        for cell in cells_of(batches, self.axes):
            yield from self.ask(engine, cell, {**self.arguments, "threads": threads})

    def ask(self, engine: Engine, cell: Cell, arguments: dict[str, Any]) -> Iterator[Any]:
        """The answer of one cell: what belongs to its home points."""
        raise NotImplementedError


class AtRisk(Question):
    """The ids of points at risk."""

    def ask(self, engine: Engine, cell: Cell, arguments: dict[str, Any]) -> Iterator[Any]:
        flags = engine.at_risk(cell.points, mask=True, **arguments)
        yield from batches_of([self.id], [cell.ids[flags & cell.home]])


class Counts(Question):
    """How many neighbours each point has."""

    def ask(self, engine: Engine, cell: Cell, arguments: dict[str, Any]) -> Iterator[Any]:
        counts = engine.count(cell.points, **arguments)
        yield from batches_of([self.id, "count"], [cell.ids[cell.home], counts[cell.home]])


class PairsOf(Question):
    """Pairs, each from the home of its lower id."""

    def ask(self, engine: Engine, cell: Cell, arguments: dict[str, Any]) -> Iterator[Any]:
        try:
            pieces = iter([engine.pairs(cell.points, max_results=_PAIRS_AT_ONCE, **arguments)])
        except BeespaceError as error:
            if error.code != "too_many_results":
                raise
            pieces = engine.iter_pairs(cell.points, **arguments)
        for piece in pieces:
            own = cell.home[piece.i]
            assert piece.distance is not None
            yield from batches_of(
                ["first", "second", "distance"],
                [cell.ids[piece.i[own]], cell.ids[piece.j[own]], piece.distance[own]],
            )
