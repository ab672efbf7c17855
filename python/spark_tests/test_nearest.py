"""Nearest points and the closest pair are those of one machine, bit for bit."""

from __future__ import annotations

import beespace
import beespace.spark
import numpy as np
import pyarrow
import pytest
import scenes
from beespace.spark._blocks import Columns, Distribution
from beespace.spark._cut import Cut
from beespace.spark._nearest import ClosestOf
from beespace.spark._nearest_rounds import (
    ASKS,
    HOME,
    ROUND_SCHEMA,
    TOLD,
    Answers,
    FirstRound,
    LastRound,
    Plan,
    SecondRound,
)
from test_points import frame_of

NAMES = ["id", "rank", "nearest", "distance"]
ROUND_NAMES = [each.split()[0] for each in ROUND_SCHEMA.split(", ")]


def _batches(table, *keys):
    """As Spark hands them over: sorted, in batches that end anywhere."""
    if table is None or not table.num_rows:
        return iter([])
    if keys:
        table = table.sort_by([(key, "ascending") for key in keys])
    return iter(table.combine_chunks().to_batches(max_chunksize=7))


def _table(batches):
    batches = [batch for batch in batches if batch.num_rows]
    return pyarrow.Table.from_batches(batches) if batches else None


def _joined(*tables):
    tables = [table for table in tables if table is not None]
    return pyarrow.concat_tables(tables) if tables else None


def _blocks_of(ids, points, reach, most):
    """The blocks of all cells; and how space is cut."""
    axes = list(np.ascontiguousarray(points.T))
    some = np.random.default_rng(1).random(len(ids)) < 0.2
    sample = [axis[some] for axis in axes]
    cut = Cut.of_sample(sample, [reach] * len(axes), most / 5, most / 5)
    columns = Columns(len(axes), False)
    distribution = Distribution(cut, [0] * cut.cells, columns, 50)
    table = pyarrow.table([ids, *axes], ["id", *columns.names])
    return _table(distribution(iter(table.to_batches()))), cut, columns


def nearest_without_spark(ids, points, k, reach, most):
    """All rounds; and how many rows asked."""
    blocks, cut, columns = _blocks_of(ids, points, reach, most)
    plan = Plan(columns, k, reach, cut, [0] * cut.cells, [0] * 5, 50)
    first = _table(FirstRound(plan)(_batches(blocks, "cell", "first")))
    kinds = first.column("kind").to_numpy()
    asks, told = first.filter(kinds == ASKS), first.filter(kinds == TOLD)
    home = blocks.filter(blocks.column("home"))
    kind = pyarrow.array(np.full(home.num_rows, HOME, np.int32))
    columns = [home.column("part"), kind, home.column("cell"), home.column("first"), home.column("points")]
    home = pyarrow.table(columns, ROUND_NAMES)
    second = _table(SecondRound(plan)(_batches(_joined(home, asks), "cell", "kind", "first")))
    last = _table(LastRound(plan, NAMES)(_batches(_joined(told, second), "cell")))
    answer = _joined(_table(Answers(plan, NAMES)(_batches(first))), last)
    return answer, asks.num_rows, cut.cells


def compare(answer, ids, points, k):
    order = np.argsort(ids)
    wanted = beespace.nearest(points[order], k)
    there = wanted.ids >= 0
    names = ids[order]
    found = answer.sort_values(["id", "rank"])
    of, rank = np.nonzero(there)
    np.testing.assert_array_equal(found["id"], names[of])
    np.testing.assert_array_equal(found["rank"], rank + 1)
    np.testing.assert_array_equal(found["nearest"], names[wanted.ids[there]])
    np.testing.assert_array_equal(found["distance"], wanted.distances[there])


@pytest.mark.parametrize("name", sorted(scenes.ALL))
def test_rounds_find_what_one_machine_finds(name):
    ids, points = scenes.swarm(name)
    asked = []
    for k, reach in ((1, 1.0), (4, 2.0), (3, 2.0**-400), (1, 0.05)):
        answer, asks, cells = nearest_without_spark(ids, points, k, reach, 700)
        compare(answer.to_pandas(), ids, points, k)
        asked.append(asks)
        assert cells > 3 or name == "one_place"
    assert name == "one_place" or max(asked) > 0


def test_cells_with_fewer_points_than_are_wanted():
    ids, points = scenes.swarm("clusters")
    ids, points = ids[::60], points[::60]
    for k in (30, 119, 150, 500):
        answer, asks, cells = nearest_without_spark(ids, points, k, 1.0, 25)
        assert cells > 4 and asks > 0
        compare(answer.to_pandas(), ids, points, k)


def test_ties_and_rounded_ties_across_cells():
    """Distances that are the same as doubles and not as real numbers, and such that are the same."""
    rng = np.random.default_rng(12)
    centres = np.arange(200.0)[:, None] * [64.0, 0, 0]
    turned = rng.normal(size=(200, 6, 3))
    turned *= 8 / np.linalg.norm(turned, axis=2, keepdims=True)
    around = (centres[:, None, :] + turned).reshape(-1, 3)
    mirrored = (centres[:, None, :] - turned).reshape(-1, 3)
    points = np.concatenate([centres, around, mirrored])
    ids = rng.permutation(len(points)).astype(np.int64) * 5 - 4_000
    for reach in (0.5, 9.0):
        answer, asks, _ = nearest_without_spark(ids, points, 5, reach, 100)
        compare(answer.to_pandas(), ids, points, 5)
    assert asks > 0


@pytest.mark.parametrize("name", sorted(scenes.ALL))
def test_the_closest_pair_without_spark(name):
    ids, points = scenes.swarm(name)
    order = np.argsort(ids)
    wanted = beespace.closest_pair(points[order])
    reach = max(wanted.distance * 1.5, 2.0**-400)
    blocks, _, columns = _blocks_of(ids, points, reach, 700)
    told = _table(ClosestOf(columns)(_batches(blocks, "cell", "first")))
    data = b"".join(told.column("points").to_pylist())
    table = np.unique(np.frombuffer(data, np.int64).reshape(-1, 4), axis=0)
    best = beespace.closest_pair(np.ascontiguousarray(table[:, 1:]).view(np.float64))
    names = ids[order]
    assert (table[best.i, 0], table[best.j, 0]) == (names[wanted.i], names[wanted.j])
    assert best.distance == wanted.distance


@pytest.mark.parametrize(("name", "k"), [("dense_cell", 3), ("lattice", 1)])
def test_nearest_points_are_those_of_one_machine(session, name, k):
    ids, points = scenes.swarm(name)
    frame = frame_of(session, ids, points)
    compare(beespace.spark.nearest(frame, k, cell_points=1_500).toPandas(), ids, points, k)
    order = np.argsort(ids)
    wanted = beespace.closest_pair(points[order])
    found = beespace.spark.closest_pair(frame, cell_points=1_500)
    assert found == (ids[order][wanted.i], ids[order][wanted.j], wanted.distance)


@pytest.mark.parametrize("count", [0, 1, 2])
def test_nearly_no_points(session, count):
    frame = frame_of(session, np.arange(count) + 5, np.zeros((count, 3)))
    rows = beespace.spark.nearest(frame, 4).orderBy("id").collect()
    assert [tuple(row) for row in rows] == ([(5, 1, 6, 0.0), (6, 1, 5, 0.0)] if count == 2 else [])
    assert beespace.spark.closest_pair(frame) == ((5, 6, 0.0) if count == 2 else None)


def test_points_are_cut_once(session, tmp_path):
    """The rounds read one shuffle of points and one of the first round, though they are named several times."""
    folder = str(tmp_path)

    def counted(batches):
        import os
        import uuid

        yield from batches
        open(os.path.join(folder, uuid.uuid4().hex), "x").close()

    ids, points = scenes.swarm("dense_cell")
    frame = frame_of(session, ids, points, parts=4)
    frame = frame.coalesce(4).mapInArrow(counted, frame.schema)
    found = beespace.spark.nearest(frame, cell_points=1_500, check_ids=False)
    before = len(list(tmp_path.iterdir()))
    assert before == 4  # by the survey
    compare(found.toPandas(), ids, points, 1)
    assert len(list(tmp_path.iterdir())) - before == 4
    plan = found._jdf.queryExecution().executedPlan().toString().split("Initial Plan")[0]
    assert plan.count("MapInArrow FirstRound") == plan.count("MapInArrow Distribution") == 1
