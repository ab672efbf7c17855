"""What workers do with points: they sort them into blocks of cells, and put cells together again.

A block is a row of Spark's with many points of one cell in one binary value: for each point its id and its
coordinates, 8 bytes each. So Spark moves some hundred points at the price of a row.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from beespace._errors import BeespaceError
from beespace._geodesy import to_ecef
from beespace.spark._cut import Cut
from beespace.spark._workers import arrow

BLOCK_SCHEMA = "part int, cell int, first long, home boolean, points binary"

# So many points are sorted at once.
_POINTS_AT_ONCE = 1 << 18
# Spark hands rows over by number, not by size: so many bytes are to be in one of its batches at most.
_BYTES_AT_ONCE = 64 << 20
_ROWS_AT_ONCE = 1 << 16


class Columns(NamedTuple):
    """Which columns of the selected ones are what: the first is the id, then come coordinates, and last
    a height, where heights are apart from positions."""

    axes: int
    degrees: bool
    apart: bool = False

    @property
    def names(self) -> tuple[str, ...]:
        """The roles of the columns of numbers."""
        roles = ("lon", "lat", "height") if self.degrees else ("x", "y", "z")
        return (*roles[: self.axes], "height") if self.apart else roles[: self.axes]

    @property
    def searched(self) -> int:
        """How many axes positions have where they are searched."""
        return 3 if self.degrees else self.axes

    @property
    def width(self) -> int:
        """How many numbers each point has where it is searched, its height apart included."""
        return self.searched + self.apart


def points_in_block(max_records: int) -> int:
    """How many points a block has, where Spark hands over so many blocks at a time."""
    records = max_records if max_records > 0 else 10_000
    return min(max(_BYTES_AT_ONCE // records // 32, 16), 4096)


def integers(column: Any) -> NDArray[np.int64]:
    """A column of Arrow without nulls."""
    return np.asarray(column.to_numpy(zero_copy_only=False)).astype(np.int64, copy=False)


def reals(column: Any, name: str) -> NDArray[np.float64]:
    """A column of Arrow as doubles, nulls as NaN; integers that are no doubles are an error."""
    values = np.asarray(column.to_numpy(zero_copy_only=False))
    numbers = values.astype(np.float64)
    if values.dtype.kind in "iu" and values.dtype.itemsize == 8 and bool((np.abs(numbers) >= 2.0**53).any()):
        raise BeespaceError(
            "not all integers beyond 2**53 are doubles: cast the column to double first",
            "invalid_argument",
            name,
        )
    return numbers


def in_metres(given: list[NDArray[np.float64]], columns: Columns) -> list[NDArray[np.float64]]:
    """Positions as they are searched; and heights that are apart, as they are."""
    if not columns.degrees:
        return given
    height = given[2] if columns.axes == 3 else 0.0
    axes = list(np.ascontiguousarray(to_ecef(given[0], given[1], height).T))
    return [*axes, given[-1]] if columns.apart else axes


class Distribution:
    """Points into blocks: a function for `mapInArrow`, which goes to workers."""

    def __init__(self, cut: Cut, parts: list[int], columns: Columns, block: int) -> None:
        self.cut = cut
        self.parts = parts
        self.columns = columns
        self.block = block

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        waiting: list[Any] = []
        rows = 0
        for batch in batches:
            waiting.append(batch)
            rows += batch.num_rows
            if rows >= _POINTS_AT_ONCE:
                yield from self._blocks(waiting)
                waiting, rows = [], 0
        if rows:
            yield from self._blocks(waiting)

    def _blocks(self, batches: list[Any]) -> Iterator[Any]:
        pyarrow = arrow()

        for batch in batches:
            if any(column.null_count for column in batch.columns):
                raise BeespaceError(
                    "a row has a null where there was none when the call was checked: the data frame must "
                    "give the same rows each time",
                    "not_a_number",
                )
        ids = np.concatenate([integers(batch.column(0)) for batch in batches])
        given = [
            np.concatenate([reals(batch.column(1 + at), name) for batch in batches])
            for at, name in enumerate(self.columns.names)
        ]
        axes = in_metres(given, self.columns)
        if not all(bool(np.isfinite(axis).all()) for axis in axes):
            raise BeespaceError(
                "a coordinate is not finite, which it was when the call was checked: the data frame must "
                "give the same rows each time",
                "not_finite",
            )
        table = np.empty((len(ids), 1 + len(axes)), np.int64)
        table[:, 0] = ids
        for at, axis in enumerate(axes):
            table[:, 1 + at] = axis.view(np.int64)
        data: list[NDArray[np.int64]] = []
        told: list[tuple[int, bool, int]] = []
        for cell, home, halo in self.cut.distribute(axes[: self.columns.searched]):
            for rows, is_home in ((home, True), (halo, False)):
                if len(rows):
                    data.append(table[rows])
                    told.append((cell, is_home, len(rows)))
        lengths = [
            np.diff(np.append(np.arange(0, count, self.block), count)) for _, _, count in told
        ]
        repeats = [len(each) for each in lengths]
        points = np.concatenate(data)
        ends = np.cumsum(np.concatenate(lengths))
        begins = np.append(0, ends[:-1])
        cells = np.repeat(np.array([cell for cell, _, _ in told], np.int32), repeats)
        homes = np.repeat(np.array([home for _, home, _ in told]), repeats)
        offsets = (np.append(0, ends) * points.itemsize * points.shape[1]).astype(np.int32)
        binary = pyarrow.Array.from_buffers(
            pyarrow.binary(), len(ends), [None, pyarrow.py_buffer(offsets), pyarrow.py_buffer(points)]
        )
        parts = np.array(self.parts, np.int32)[cells]
        arrays = [
            *(pyarrow.array(column) for column in (parts, cells, points[begins, 0], homes)),
            binary,
        ]
        yield pyarrow.RecordBatch.from_arrays(arrays, ["part", "cell", "first", "home", "points"])


class Cell(NamedTuple):
    """The points of a cell and of its halo, ascending by id."""

    number: int
    ids: NDArray[np.int64]
    points: NDArray[np.float64]
    heights: NDArray[np.float64] | None  # where they are apart
    home: NDArray[np.bool_]


def cells_of(batches: Iterator[Any], columns: Columns) -> Iterator[Cell]:
    """Cells that have points at home, one after the other, of blocks that are sorted by cell."""
    pieces: list[tuple[NDArray[np.int64], NDArray[np.bool_]]] = []
    current = -1
    done: set[int] = set()
    for batch in batches:
        cells = integers(batch.column(1))
        homes = np.asarray(batch.column(3).to_numpy(zero_copy_only=False), bool)
        ends = np.append(np.flatnonzero(np.diff(cells)) + 1, len(cells))
        begin = 0
        for end in ends.tolist():
            if end == begin:
                continue
            cell = int(cells[begin])
            if cell != current:
                yield from _put_together(current, pieces, columns)
                pieces = []
                done.add(current)
                current = cell
                if cell in done:
                    # An answer without the rest of the cell would be a false all-clear.
                    raise RuntimeError("beespace: the blocks of a cell did not come together")
            pieces.append(_points_of(batch.column(4), begin, end, homes[begin:end], 1 + columns.width))
            begin = end
    yield from _put_together(current, pieces, columns)


def _points_of(
    column: Any, begin: int, end: int, homes: NDArray[np.bool_], width: int
) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    pyarrow = arrow()

    wide = pyarrow.types.is_large_binary(column.type)
    _, offsets, data = column.buffers()
    all_offsets = np.frombuffer(offsets, np.int64 if wide else np.int32)
    some = all_offsets[column.offset + begin : column.offset + end + 1].astype(np.int64)
    points = np.frombuffer(data, np.uint8)[some[0] : some[-1]].view(np.int64).reshape(-1, width)
    return points, np.repeat(homes, np.diff(some) // (8 * width))


def _put_together(
    number: int, pieces: list[tuple[NDArray[np.int64], NDArray[np.bool_]]], columns: Columns
) -> Iterator[Cell]:
    if not any(bool(home.any()) for _, home in pieces):
        return
    table = np.concatenate([points for points, _ in pieces])
    order = np.argsort(table[:, 0], kind="stable")
    table = table[order]
    ids = np.ascontiguousarray(table[:, 0])
    twice = np.flatnonzero(ids[1:] == ids[:-1])
    if len(twice):
        raise BeespaceError(
            f"the id {ids[twice[0]]} is that of several points: each must have an id of its own",
            "invalid_argument",
            "id",
        )
    home = np.concatenate([home for _, home in pieces])[order]
    numbers = table[:, 1:].view(np.float64)
    apart = numbers[:, -1] if columns.apart else None
    yield Cell(number, ids, numbers[:, : columns.searched], apart, home)


def batches_of(names: list[str], columns: list[NDArray[Any]]) -> Iterator[Any]:
    """Columns of one length as batches of Arrow, none of which is large."""
    pyarrow = arrow()

    for begin in range(0, len(columns[0]), _ROWS_AT_ONCE):
        yield pyarrow.RecordBatch.from_arrays(
            [pyarrow.array(column[begin : begin + _ROWS_AT_ONCE]) for column in columns], names
        )
