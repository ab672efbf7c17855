"""Ids that ascend in stretches are known to be different without a pass of their own."""

from __future__ import annotations

import numpy as np
import pyarrow
import pytest
from beespace.spark._blocks import Columns
from beespace.spark._survey import Surveyor, survey_of


def surveyed(partitions, batch=3):
    """What the survey says of partitions of ids, which come in batches."""
    rows = []
    for part, ids in enumerate(partitions):
        ids = np.array(ids, np.int64)
        batches = [
            pyarrow.RecordBatch.from_arrays(
                [pyarrow.array(ids[at : at + batch]), pyarrow.array(np.zeros(len(ids[at : at + batch])))],
                ["id", "x"],
            )
            for at in range(0, len(ids), batch)
        ]
        (row,) = Surveyor(Columns(1, False))(iter(batches))
        rows.append({**row.to_pylist()[0], "part": part})
    return survey_of(rows, Columns(1, False), ["id", "x"])


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
