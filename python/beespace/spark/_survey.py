"""One pass over the data before the long work: is all of it usable, and how does it lie in space?"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from beespace._errors import BeespaceError
from beespace.spark._blocks import Columns, in_metres, integers, reals
from beespace.spark._sample import CellSize, Sampler
from beespace.spark._workers import arrow, partition_of_task

SURVEY_SCHEMA = (
    "part int, rows long, bad long, bad_row long, bad_id long, bad_column string, bad_value string, "
    "runs binary, below binary, keys binary, sample binary"
)
IDS_SCHEMA = "part int, bucket int, ids binary"
TWICE_SCHEMA = "twice long, id long"

# A partition tells of at most so many stretches in which ids ascend: Spark puts small files together.
_RUNS = 256
# Positions that can be searched: metres, and degrees with heights.
SMALLEST, LARGEST = 2.0**-400, 2.0**400
LIMITS = {"lon": (-360.0, 360.0), "lat": (-90.0, 90.0), "height": (-12_000.0, 1_000_000.0)}


class Survey(NamedTuple):
    """What the pass found."""

    rows: int
    partitions: int
    in_order: bool  # ids ascend in stretches that do not overlap, so each is there once
    rate: float  # the share of the points that is in the sample
    sample: list[NDArray[np.float64]]


def mixed(ids: NDArray[np.int64]) -> NDArray[np.uint64]:
    """Numbers that look random, of ids: the finishing steps of SplitMix64."""
    bits = ids.view(np.uint64) + np.uint64(0x9E3779B97F4A7C15)
    bits = (bits ^ (bits >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    bits = (bits ^ (bits >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return bits ^ (bits >> np.uint64(31))


class Surveyor:
    """A row for each partition: a function for `mapInArrow`, which goes to workers."""

    def __init__(self, columns: Columns, size: CellSize) -> None:
        self.columns = columns
        self.size = size

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        pyarrow = arrow()

        rows = bad = 0
        first_bad: tuple[int, int | None, str, str] | None = None
        runs: NDArray[np.int64] | None = np.empty((0, 2), np.int64)
        sampler = Sampler(self.size, partition_of_task(), len(self.columns.names))
        for batch in batches:
            if not batch.num_rows:
                continue
            usable, told = self._check(batch)
            if told is not None:
                bad += int((~usable).sum())
                row, column, value = told
                if first_bad is None:
                    one = batch.column(0)[row]
                    first_bad = (rows + row, one.as_py(), column, value)
            rows += batch.num_rows
            if bad:
                continue
            ids = integers(batch.column(0))
            runs = None if runs is None else _with_runs(runs, ids)
            given = np.column_stack(
                [reals(batch.column(1 + at), name) for at, name in enumerate(self.columns.names)]
            )
            sampler.add(mixed(ids), given)
        keys, sample = sampler.take()
        row, id, column, value = first_bad or (None, None, None, None)
        facts: list[Any] = [partition_of_task(), rows, bad, row, id, column, value]
        facts += [None if runs is None else runs.tobytes(), np.uint64(sampler.below).tobytes()]
        facts += [keys.tobytes(), np.ascontiguousarray(sample).tobytes()]
        types = ["int32", *["int64"] * 4, "string", "string", *["binary"] * 4]
        arrays = [pyarrow.array([each], type=kind) for each, kind in zip(facts, types)]
        names = [each.split()[0] for each in SURVEY_SCHEMA.split(", ")]
        yield pyarrow.RecordBatch.from_arrays(arrays, names)

    def _check(self, batch: Any) -> tuple[NDArray[np.bool_], tuple[int, str, str] | None]:
        """Which rows can be used; and of the first that cannot its row, column and value."""
        usable = np.ones(batch.num_rows, bool)
        told: tuple[int, str, str] | None = None
        for at, name in enumerate(("id", *self.columns.names)):
            column = batch.column(at)
            good = np.asarray(column.is_valid().to_numpy(zero_copy_only=False), bool)
            if at:
                good &= self._is_possible(name, reals(column, name))
            if not good.all():
                row = int(good.argmin())
                if told is None or row < told[0]:
                    value = column[row].as_py()
                    told = (row, name, "null" if value is None else str(value))
                usable &= good
        return usable, told

    def _is_possible(self, name: str, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        if self.columns.degrees and not (self.columns.apart and name == "height"):
            low, high = LIMITS[name]
            return (values >= low) & (values <= high)
        size = np.abs(values)
        return (values == 0) | ((size >= SMALLEST) & (size <= LARGEST))


def _with_runs(runs: NDArray[np.int64], ids: NDArray[np.int64]) -> NDArray[np.int64] | None:
    """The first and the last id of each stretch in which ids ascend, with those of the ids that follow."""
    ends = np.flatnonzero(ids[1:] <= ids[:-1])
    if len(runs) + len(ends) >= _RUNS:
        return None
    new = np.column_stack([ids[np.append(0, ends + 1)], ids[np.append(ends, len(ids) - 1)]])
    if len(runs) and runs[-1, 1] < new[0, 0]:
        new[0, 0] = runs[-1, 0]
        runs = runs[:-1]
    return np.concatenate([runs, new])


def survey_of(rows: list[Any], columns: Columns, names: list[str]) -> Survey:
    """What the rows of all partitions say together. Raises what is wrong with the data."""
    rows = sorted(rows, key=lambda row: row["part"])
    count = sum(row["rows"] for row in rows)
    bad = sum(row["bad"] for row in rows)
    if bad:
        first = next(row for row in rows if row["bad"])
        place = first["bad_column"]
        name = names[("id", *columns.names).index(place)]
        of = "" if first["bad_id"] is None else f", of the id {first['bad_id']}"
        code = "not_finite" if first["bad_value"] in ("nan", "inf", "-inf", "null") else "outside_domain"
        raise BeespaceError(
            f"{bad:,} of {count:,} rows cannot be used; in the first, row {first['bad_row']} of partition "
            f"{first['part']}{of}, the column {name!r} is {first['bad_value']}: correct such rows, or "
            "leave them out knowingly, with DataFrame.where",
            code,
            place,
        )
    full = [row for row in rows if row["rows"]]
    in_order = all(row["runs"] is not None for row in full) and _are_apart(
        np.frombuffer(b"".join(row["runs"] for row in full), np.int64).reshape(-1, 2)
    )
    keys = [np.frombuffer(row["keys"], np.uint64) for row in full]
    width = len(columns.names)
    samples = [np.frombuffer(row["sample"]).reshape(-1, width) for row in full]
    # The lowest share that a partition gave is that of all.
    below = min((np.frombuffer(row["below"], np.uint64)[0] for row in full), default=np.uint64(0))
    kept = [sample[key <= below] for key, sample in zip(keys, samples)]
    points = np.concatenate(kept) if kept else np.empty((0, width))
    axes = in_metres([np.ascontiguousarray(axis) for axis in points.T], columns) if len(points) else []
    return Survey(count, len(rows), in_order, len(points) / max(count, 1), axes[: columns.searched])


def _are_apart(runs: NDArray[np.int64]) -> bool:
    runs = runs[np.argsort(runs[:, 0])]
    return bool((runs[1:, 0] > runs[:-1, 1]).all())


class IdBuckets:
    """Ids into buckets, each id into one: a function for `mapInArrow`."""

    def __init__(self, parts: list[int]) -> None:
        self.parts = parts

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        pyarrow = arrow()

        for batch in batches:
            ids = integers(batch.column(0))
            buckets = (mixed(ids) >> np.uint64(32)) % np.uint64(len(self.parts))
            order = np.argsort(buckets, kind="stable")
            ids, buckets = ids[order], buckets[order].astype(np.int32)
            begins = np.flatnonzero(np.diff(buckets, prepend=-1))
            pieces = [each.tobytes() for each in np.split(ids, begins[1:])] if len(ids) else []
            yield pyarrow.RecordBatch.from_arrays(
                [
                    pyarrow.array(np.array(self.parts, np.int32)[buckets[begins]]),
                    pyarrow.array(buckets[begins]),
                    pyarrow.array(pieces, type="binary"),
                ],
                ["part", "bucket", "ids"],
            )


def find_twice(batches: Iterator[Any]) -> Iterator[Any]:
    """How many ids of the partition are there more than once, and the lowest of them."""
    pyarrow = arrow()

    found = 0
    lowest: int | None = None
    current = -1
    pieces: list[NDArray[np.int64]] = []

    def finish() -> None:
        nonlocal found, lowest
        if not pieces:
            return
        ids = np.sort(np.concatenate(pieces))
        twice = np.unique(ids[1:][ids[1:] == ids[:-1]])
        if len(twice):
            found += len(twice)
            lowest = int(twice[0]) if lowest is None else min(lowest, int(twice[0]))
        pieces.clear()

    for batch in batches:
        for bucket, ids in zip(batch.column(1).to_pylist(), batch.column(2).to_pylist()):
            if bucket != current:
                finish()
                current = bucket
            pieces.append(np.frombuffer(ids, np.int64))
    finish()
    arrays = [pyarrow.array([found], type="int64"), pyarrow.array([lowest], type="int64")]
    yield pyarrow.RecordBatch.from_arrays(arrays, ["twice", "id"])
