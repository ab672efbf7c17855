"""What workers do to find the nearest points: functions for `mapInArrow`.

First round: each cell, with its halo, finds the nearest ones of its home points. Those that are within
the reach of halos are the answer: a point that is not in the cell is farther than that, as a real number. So are
those that no other cell comes nearer than. The other points are open.

Second round: an open point asks each cell in which a nearer one may be, and the cell tells the nearest ones
of its home points. At least as many points as are wanted are known to be within some distance of an open point,
and no cell beyond that is asked.

At last, what cells told of an open point comes together in a bucket, where the engine finds the nearest ones
among all candidates of the bucket: all of these are points, and the nearest ones of all points are among them.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace._engine import Engine
from beespace._index import Index
from beespace.spark._blocks import Cell, Columns, cells_of, integers
from beespace.spark._cut import Cut
from beespace.spark._survey import mixed
from beespace.spark._workers import arrow, threads_of_task

# Of a row what it is: an answer, home points, open points that ask a cell, candidates of open points.
ANSWER, HOME, ASKS, TOLD = range(4)
ROUND_SCHEMA = "part int, kind int, cell int, first long, data binary"

# Distances and differences are rounded a few times: by less than this, relatively.
_ALLOWANCE = 2.0**-40
_POINTS_AT_ONCE = 65_536


class Plan:
    """What all rounds know."""

    def __init__(
        self,
        columns: Columns,
        length: int,
        reach: float,
        cut: Cut,
        parts: list[int],
        bucket_parts: list[int],
        block: int,
    ) -> None:
        self.columns = columns
        self.length = length  # how many nearest ones are wanted
        self.reach = reach
        self.cut = cut
        self.parts = parts  # of cells
        self.bucket_parts = bucket_parts
        self.block = block

    @property
    def place_width(self) -> int:
        """Numbers of a point: its id and its coordinates."""
        return 1 + self.columns.searched


def _rows(part: Any, kind: int, cell: Any, first: Any, data: list[bytes]) -> Any:
    pyarrow = arrow()

    count = len(data)
    arrays = [
        pyarrow.array(np.broadcast_to(np.asarray(part, np.int32), count)),
        pyarrow.array(np.full(count, kind, np.int32)),
        pyarrow.array(np.broadcast_to(np.asarray(cell, np.int32), count)),
        pyarrow.array(np.broadcast_to(np.asarray(first, np.int64), count)),
        pyarrow.array(data, type="binary"),
    ]
    names = [each.split()[0] for each in ROUND_SCHEMA.split(", ")]
    return pyarrow.RecordBatch.from_arrays(arrays, names)


def _blocks(
    part: int, kind: int, cell: int, table: NDArray[np.int64], block: int
) -> Iterator[Any]:
    """A table of integers of 64 bits as rows with so many of its rows each."""
    begins = range(0, len(table), block)
    data = [table[begin : begin + block].tobytes() for begin in begins]
    if data:
        yield _rows(part, kind, cell, table[:: block, 0], data)


def _bits(numbers: NDArray[np.float64]) -> NDArray[np.int64]:
    return np.ascontiguousarray(numbers).view(np.int64)


class FirstRound:
    """Blocks of cells to answers, open points for other cells, and what their own cell knows."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        threads = threads_of_task()
        engine = Engine()
        for cell in cells_of(batches, self.plan.columns):
            yield from self._ask(engine, cell, threads)

    def _ask(self, engine: Engine, cell: Cell, threads: int) -> Iterator[Any]:
        plan = self.plan
        length = min(plan.length, len(cell.ids) - 1)
        if length:
            found = engine.nearest(cell.points, length, threads=threads)
            near, distances = found.ids, found.distances
        else:
            near, distances = np.empty((len(cell.ids), 0), np.int64), np.empty((len(cell.ids), 0))
        home = np.flatnonzero(cell.home)
        bound = np.full(len(home), np.inf)
        if length == plan.length:
            bound = distances[home, -1]
        settled = bound <= plan.reach * (1 - _ALLOWANCE)
        for begin in range(0, len(home), _POINTS_AT_ONCE):
            open_ones = np.flatnonzero(~settled[begin : begin + _POINTS_AT_ONCE]) + begin
            if not len(open_ones):
                continue
            asks = list(self._asks(cell, home[open_ones], bound[open_ones]))
            waits = np.zeros(len(open_ones), bool)
            for _, some in asks:
                waits[some] = True
            # Who has no other cell to ask has all that is nearer in its own.
            settled[open_ones] = ~waits if length == plan.length else False
            places = np.column_stack([cell.ids, _bits(cell.points)])
            rows = home[open_ones[~settled[open_ones]]]
            if len(rows):
                yield _told(plan, places[rows], places[near[rows]])
            for asked, some in asks:
                block = places[home[open_ones[some]]]
                yield from _blocks(plan.parts[asked], ASKS, asked, block, plan.block)
        some = home[settled]
        if len(some):
            answers = np.column_stack([cell.ids[some], cell.ids[near[some]], _bits(distances[some])])
            most = max(plan.block // (1 + plan.length), 1)
            yield from _blocks(plan.parts[cell.number], ANSWER, -1, answers, most)

    def _asks(
        self, cell: Cell, rows: NDArray[np.int64], bound: NDArray[np.float64]
    ) -> Iterator[tuple[int, NDArray[np.int64]]]:
        """Of each other cell in which nearer points may be: which of these rows ask it."""
        cut = self.plan.cut
        axes = list(np.ascontiguousarray(cell.points[rows].T))
        unbounded = np.flatnonzero(np.isinf(bound))
        # One more, as the point may be in the sample itself.
        bound[unbounded] = cut.bounds([axis[unbounded] for axis in axes], self.plan.length + 1)
        for asked, some in cut.within(axes, bound * (1 + _ALLOWANCE)):
            if asked != cell.number:
                yield asked, some


def _told(plan: Plan, asked: NDArray[np.int64], near: NDArray[np.int64]) -> Any:
    """Open points and candidates of each, into buckets."""
    count = len(asked)
    records = np.concatenate([asked, near.reshape(count, near.shape[1] * near.shape[2])], axis=1)
    buckets = (mixed(np.ascontiguousarray(asked[:, 0])) >> np.uint64(32)) % np.uint64(
        len(plan.bucket_parts)
    )
    order = np.argsort(buckets, kind="stable")
    records, buckets = records[order], buckets[order].astype(np.int64)
    begins = np.flatnonzero(np.diff(buckets, prepend=-1))
    data: list[bytes] = []
    of: list[int] = []
    for begin, end in zip(begins.tolist(), [*begins[1:].tolist(), count]):
        most = max(plan.block // (1 + plan.length), 1)
        for at in range(begin, end, most):
            piece = records[at : min(at + most, end)]
            # How many candidates each of the points has comes first.
            data.append(np.int64(near.shape[1]).tobytes() + piece.tobytes())
            of.append(int(buckets[begin]))
    return _rows(np.array(plan.bucket_parts, np.int32)[of], TOLD, of, 0, data)


class SecondRound:
    """Home points and open points, sorted by cell, home points first, to candidates."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        current = -1
        done: set[int] = set()
        points: list[bytes] = []
        home: NDArray[np.int64] = np.empty((0, 0), np.int64)
        index: Index | None = None
        for batch in batches:
            kinds, cells = integers(batch.column(1)), integers(batch.column(2))
            for kind, cell, data in zip(kinds.tolist(), cells.tolist(), batch.column(4).to_pylist()):
                if cell != current:
                    done.add(current)
                    points, index, current = [], None, cell
                    if cell in done:
                        # An answer without the rest of the cell would not be that of all points.
                        raise RuntimeError("beespace: what a cell is asked did not come together")
                if kind == HOME:
                    points.append(data)
                elif points:
                    if index is None:
                        home = self._places(b"".join(points))
                        home = home[np.argsort(home[:, 0], kind="stable")]
                        index = Index(_numbers(home))
                    yield from self._ask(index, home, self._places(data))

    def _places(self, data: bytes) -> NDArray[np.int64]:
        return np.frombuffer(data, np.int64).reshape(-1, self.plan.place_width)

    def _ask(
        self, index: Index, home: NDArray[np.int64], asked: NDArray[np.int64]
    ) -> Iterator[Any]:
        found = index.nearest(_numbers(asked), min(self.plan.length, len(home)))
        yield _told(self.plan, asked, home[found.ids])


def _numbers(places: NDArray[np.int64]) -> NDArray[np.float64]:
    """Positions, of ids and positions."""
    return np.ascontiguousarray(places[:, 1:]).view(np.float64)


class LastRound:
    """Candidates, sorted by bucket, to answers."""

    def __init__(self, plan: Plan, names: list[str]) -> None:
        self.plan = plan
        self.names = names

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        current = -1
        done: set[int] = set()
        pieces: list[bytes] = []
        for batch in batches:
            cells = integers(batch.column(2))
            for bucket, data in zip(cells.tolist(), batch.column(4).to_pylist()):
                if bucket != current:
                    yield from self._ask(pieces)
                    done.add(current)
                    pieces, current = [], bucket
                    if bucket in done:
                        raise RuntimeError("beespace: the candidates of a bucket did not come together")
                pieces.append(data)
        yield from self._ask(pieces)

    def _ask(self, pieces: list[bytes]) -> Iterator[Any]:
        if not pieces:
            return
        width = self.plan.place_width
        asked: list[NDArray[np.int64]] = []
        all_places: list[NDArray[np.int64]] = []
        for piece in pieces:
            numbers = np.frombuffer(piece, np.int64)
            records = numbers[1:].reshape(-1, width * (1 + int(numbers[0])))
            asked.append(records[:, 0])
            all_places.append(records.reshape(-1, width))
        places = np.concatenate(all_places)
        ids, first = np.unique(places[:, 0], return_index=True)
        points = _numbers(places[first])
        own = np.unique(np.concatenate(asked))
        rows = np.searchsorted(ids, own)
        length = min(self.plan.length, len(ids) - 1)
        if not length:
            return
        # One more, as a point is among its candidates itself, but for where others at its place come first.
        found = Index(points).nearest(points[rows], length + 1)
        itself = found.ids == rows[:, None]
        itself[~itself.any(axis=1), -1] = True
        shape = (len(own), length)
        near, distances = ids[found.ids[~itself].reshape(shape)], found.distances[~itself].reshape(shape)
        yield from _answers(self.names, own, near, distances)


class Answers:
    """Rows of the first round to answers."""

    def __init__(self, plan: Plan, names: list[str]) -> None:
        self.plan = plan
        self.names = names

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        for batch in batches:
            kinds = integers(batch.column(1)).tolist()
            blocks = [data for kind, data in zip(kinds, batch.column(4)) if kind == ANSWER]
            if not blocks:
                continue
            pieces = [np.frombuffer(data.as_buffer(), np.int64) for data in blocks]
            table = np.concatenate(pieces).reshape(-1, 1 + 2 * self.plan.length)
            near = table[:, 1 : 1 + self.plan.length]
            distances = np.ascontiguousarray(table[:, 1 + self.plan.length :]).view(np.float64)
            yield from _answers(self.names, table[:, 0], near, distances)


def _answers(
    names: list[str],
    ids: NDArray[np.int64],
    near: NDArray[np.int64],
    distances: NDArray[np.float64],
) -> Iterator[Any]:
    """A row for each point and each of its nearest ones."""
    pyarrow = arrow()

    length = near.shape[1]
    at_once = max(_POINTS_AT_ONCE // max(length, 1), 1)
    for begin in range(0, len(ids), at_once):
        some = slice(begin, begin + at_once)
        count = len(ids[some])
        ranks = np.tile(np.arange(1, length + 1, dtype=np.int32), count)
        columns = [np.repeat(ids[some], length), ranks, near[some].ravel(), distances[some].ravel()]
        yield pyarrow.RecordBatch.from_arrays([pyarrow.array(column) for column in columns], names)
