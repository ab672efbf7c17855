"""Ids that ascend in stretches are known to be different without a pass of their own."""

from __future__ import annotations

import numpy as np
import pyarrow
import pytest
from beespace.spark._blocks import Columns
from beespace.spark import _survey
from beespace.spark._sample import LEAST, POINTS_A_CELL, CellSize
from beespace.spark._survey import Surveyor, mixed, survey_of


def rows_of(partitions, batch=3, size=CellSize(1000, 2), number=None):
    """What partitions of ids, which come in batches, tell of themselves. Each point is where its id says."""
    rows = []
    for part, ids in enumerate(partitions):
        ids = np.array(ids, np.int64)
        batches = [
            pyarrow.RecordBatch.from_arrays(
                [pyarrow.array(some), pyarrow.array(some.astype(np.float64))], ["id", "x"]
            )
            for some in (ids[at : at + batch] for at in range(0, len(ids), batch))
        ]
        if number is not None:
            number.at = part
        (row,) = Surveyor(Columns(1, False), size)(iter(batches))
        rows.append({**row.to_pylist()[0], "part": part})
    return rows


def surveyed(partitions, batch=3):
    return survey_of(rows_of(partitions, batch), Columns(1, False), ["id", "x"])


@pytest.fixture
def number(monkeypatch):
    """The number of the partition that is looked at."""

    class Number:
        at = 0

    monkeypatch.setattr(_survey, "partition_of_task", lambda: Number.at)
    return Number


@pytest.mark.parametrize("batch", [1, 2, 3, 100])
@pytest.mark.parametrize(
    ("partitions", "in_order"),
    [
        ([[0, 1, 2, 3, 4, 5, 6]], True),
        ([[4, 5, 6, 0, 1, 2]], True),
        ([[4, 5, 6, 0, 1, 2], [], [3], [-9, -8, 7]], False),  # a stretch reaches over others
        ([[4, 5, 6, 0, 1, 2], [], [3], [-9, -8], [7]], True),
        ([[0, 1, 1, 2]], False),
        ([[0, 1, 2], [2, 3]], False),
        ([[0, 1, 2, 7, 8], [3, 4, 9]], False),
        ([[5, 5]], False),
        ([[1, 2, 1]], False),
        ([[]], True),
    ],
)
def test_stretches(partitions, in_order, batch):
    assert surveyed(partitions, batch).in_order is in_order


def test_ids_that_are_there_twice_are_never_in_order():
    random = np.random.default_rng(5)
    for _ in range(300):
        ids = np.arange(random.integers(2, 30))
        ids = np.append(ids, random.choice(ids))
        pieces = np.array_split(ids, np.sort(random.integers(0, len(ids), random.integers(1, 5))))
        random.shuffle(pieces := list(pieces))
        whole = np.concatenate(pieces)
        parts = np.array_split(whole, random.integers(1, 4))
        assert not surveyed(parts, int(random.integers(1, 9))).in_order


def test_too_many_stretches_are_left_to_the_pass_of_its_own():
    assert surveyed([np.arange(255)[::-1]], 100).in_order
    assert not surveyed([np.arange(300)[::-1]], 100).in_order


@pytest.mark.parametrize("sizes", [[200_000] * 8, [300_000, 5, 0, 90_000, 400_000], [3] * 50, [0, 0, 250_000]])
@pytest.mark.parametrize("most", [1_000, 20_000, 10**6])
def test_the_sample_is_that_of_the_lowest_keys_and_enough_for_each_cell(number, sizes, most):
    size = CellSize(most, 2)
    ids = np.split(np.random.default_rng(1).permutation(sum(sizes)), np.cumsum(sizes)[:-1])
    rows = rows_of(ids, 10_000, size, number)
    found = survey_of(rows, Columns(1, False), ["id", "x"])
    taken = np.sort(found.sample[0].astype(np.int64))
    keys = mixed(np.arange(sum(sizes)))
    lowest = np.argsort(keys)[: len(taken)]
    np.testing.assert_array_equal(taken, np.sort(lowest))
    assert found.rate == len(taken) / sum(sizes)
    # Enough to cut by, as far as there are points: but for chance.
    assert len(taken) >= 0.8 * min(sum(sizes), POINTS_A_CELL * sum(sizes) / most)
    # What is collected: see `_sample`.
    sent = sum(len(row["keys"]) // 8 for row in rows)
    besides = (LEAST + 2 * POINTS_A_CELL * 3 * 2) * (1 + np.log(len(sizes))) + 16 * len(sizes)
    assert sent <= 1.1 * (POINTS_A_CELL * sum(sizes) / most + besides)
    assert sum(len(row["sample"]) for row in rows) == 8 * sent


@pytest.mark.parametrize(("rows", "partitions"), [(10**11, 10**5), (10**11, 800), (10**9, 10**4), (10**7, 100)])
def test_the_driver_gets_what_cells_need(rows, partitions):
    """Points of 32 bytes in cells of a million, searched by 1,600 processors, as shares say."""
    size = CellSize(1_000_000, 1_600)
    each = rows // partitions
    sent = sum(each * size.share(at, each) for at in range(partitions))
    cells = max(rows / 1_000_000, 1)
    besides = (LEAST + 2 * POINTS_A_CELL * 3 * 1_600) * (1 + np.log(partitions)) + 16 * partitions
    assert sent <= POINTS_A_CELL * cells + besides
    assert rows * size.share(partitions - 1, each) >= POINTS_A_CELL * cells
    # Below what Spark lets a driver collect, unless told otherwise.
    assert 32 * sent < 2**30


def test_ids_that_come_again_and_again_do_not_fill_the_sample(number):
    (row,) = rows_of([np.zeros(500_000)], 10_000, CellSize(10**6, 2), number)
    assert len(row["keys"]) // 8 < 3 * LEAST
