"""The nearest points of each point in a data frame of Spark, however far."""

from __future__ import annotations

import importlib
import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from beespace._answers import ClosestPair
from beespace._calls import whole
from beespace._engine import Engine
from beespace._errors import invalid
from beespace._searches import Searches
from beespace.spark._blocks import Cell, Columns, cells_of
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
from beespace.spark._search import (
    DataFrame,
    Prepared,
    check_limits,
    cut_space,
    look,
    names_of_answer,
    places_of,
    prepare,
    quoted,
)
from beespace.spark._survey import Survey
from beespace.spark._workers import arrow, threads_of_task

_CELL_POINTS = 1_000_000
# Halos are as wide as the nearest ones are far, of at most this share of all points: the first of these
# with which cells have no more than so many times their points.
_SHARES = (0.9, 0.5, 0.1, 0.01)
_MOST_IN_HALOS = 1.3
# So many nearest ones take about the memory that a point takes.
_LIKE_A_POINT = 8
_SMALLEST_REACH = 2.0**-400
_OPEN_IN_BUCKET = 50_000
_once = Searches()


def nearest(
    df: DataFrame,
    k: int = 1,
    *,
    id: str = "id",
    x: str = "x",
    y: str = "y",
    z: str | None = "z",
    lon: str | None = None,
    lat: str | None = None,
    height: str | None = None,
    cell_points: int = _CELL_POINTS,
    tasks: int | None = None,
    check_ids: bool = True,
) -> DataFrame:
    """Which are the k nearest other points of each point, however far?

    Lazy but for the checks, as `at_risk`. Each cell finds the nearest points among its own and those around
    it. Points whose nearest ones may lie farther ask other cells, in a second round.

    Parameters
    ----------
    df, id, x, y, z, lon, lat, height, cell_points, tasks, check_ids
        As of `at_risk`. Distances are straight lines in space, of degrees too.
    k : int
        How many to find for each point.

    Returns
    -------
    pyspark.sql.DataFrame
        For each point and each of its nearest ones a row: the id of the point, in a column of that name;
        `rank`, 1 for the nearest; `nearest`, the id of the other one; `distance` in metres. Of equally near
        ones the lowest ids come first. Where there are fewer than k other points, so are rows. In no
        particular order.

    Examples
    --------
    >>> import beespace.spark
    >>> rows = [(7, 0.0, 0.0), (8, 3.0, 4.0), (9, 6.0, 9.0)]
    >>> drones = session.createDataFrame(rows, "bee long, x double, y double")
    >>> beespace.spark.nearest(drones, id="bee", z=None).orderBy("bee").show()
    +---+----+-------+-----------------+
    |bee|rank|nearest|         distance|
    +---+----+-------+-----------------+
    |  7|   1|      8|              5.0|
    |  8|   1|      7|              5.0|
    |  9|   1|      8|5.830951894845301|
    +---+----+-------+-----------------+
    <BLANKLINE>
    """
    names_of_answer(id, "rank", "nearest", "distance")
    places = places_of(id, x, y, z, lon, lat, height)
    number = whole(k, "k")
    if not 0 < number < 2**31:
        raise invalid("this is at least one neighbour, and at most 2**31 - 1", "k")
    most = max(check_limits(cell_points, tasks) * _LIKE_A_POINT // (_LIKE_A_POINT + number), 1)
    found = look(df, places, check_ids, most, tasks)
    reach = _reach_of_nearest(found, number, places.columns, most)
    prepared = prepare(df, places, found, [reach] * places.columns.searched, most, tasks)
    buckets = max(len(prepared.keys), math.ceil(found.rows * (1 + number) / _OPEN_IN_BUCKET / 16))
    keys = prepared.keys
    plan = Plan(
        places.columns,
        number,
        reach,
        prepared.cut,
        prepared.parts,
        [keys[bucket % len(keys)] for bucket in range(buckets)],
        prepared.block,
    )
    return _rounds(df.sparkSession, prepared, plan, id)


def _rounds(session: Any, prepared: Prepared, plan: Plan, id: str) -> DataFrame:
    functions: Any = importlib.import_module("pyspark.sql.functions")
    number = len(prepared.keys)
    names = [id, "rank", "nearest", "distance"]
    schema = f"{quoted(id)} long, rank int, nearest long, distance double"
    first = prepared.blocks.mapInArrow(FirstRound(plan), ROUND_SCHEMA).repartition(number, "part")
    asks = first.where(_after_the_shuffle(_of_kind(ASKS)))
    home = prepared.blocks.where(_after_the_shuffle("home")).selectExpr(
        "part", f"{HOME} AS kind", "cell", "first", "points AS data"
    )
    if str(session.conf.get("spark.sql.adaptive.enabled")).lower() == "true":
        # Spark knows what was asked before it moves home points: mostly nothing. Otherwise it would wait for
        # that as for a broadcast, which must not take long.
        asked = asks.select("cell").distinct()
        home = home.join(functions.broadcast(asked), "cell", "left_semi").select(*asks.columns)
    second = (
        home.union(asks)
        .repartition(number, "part")
        .sortWithinPartitions("cell", "kind", "first")
        .mapInArrow(SecondRound(plan), ROUND_SCHEMA)
    )
    last = (
        first.where(_after_the_shuffle(_of_kind(TOLD)))
        .union(second)
        .repartition(number, "part")
        .sortWithinPartitions("cell")
        .mapInArrow(LastRound(plan, names), schema)
    )
    return first.mapInArrow(Answers(plan, names), schema).union(last)


def _of_kind(kind: int) -> str:
    """Names all columns, so that Spark shuffles none of them apart from the others."""
    return f"kind = {kind} AND part + first IS NOT NULL AND data IS NOT NULL"


def _after_the_shuffle(condition: str) -> str:
    """A condition that Spark does not move to before the shuffle, which several read; then it shuffles once."""
    return f"CASE WHEN spark_partition_id() >= 0 THEN {condition} END"


def _reach_of_nearest(found: Survey, count: int, columns: Columns, most: int) -> float:
    """How wide halos are: as the nearest ones of a usual point are far, if that costs little; else less."""
    if not found.sample or len(found.sample[0]) < 2:
        return _SMALLEST_REACH
    # Of the nearest ones of all, so many are in the sample; distances go with the root.
    among = count * found.rate
    whole_ones = min(math.ceil(among), len(found.sample[0]) - 1)
    distances = _once.nearest(np.column_stack(found.sample), whole_ones).distances[:, -1]
    shrunk = min(among / whole_ones, 1.0) ** (1 / columns.axes if not columns.degrees else 1 / 3)
    reach = _SMALLEST_REACH
    for share in _SHARES:
        reach = max(_SMALLEST_REACH, float(np.quantile(distances, share)) * shrunk)
        cut = cut_space(found, [reach] * columns.searched, most, most)
        in_cells = [home + copy for home, copy in zip(cut.homes, cut.copies)]
        if sum(in_cells) <= _MOST_IN_HALOS * sum(cut.homes) and max(in_cells) <= 1.25 * most * found.rate:
            break
    return reach


def closest_pair(
    df: DataFrame,
    *,
    id: str = "id",
    x: str = "x",
    y: str = "y",
    z: str | None = "z",
    lon: str | None = None,
    lat: str | None = None,
    height: str | None = None,
    cell_points: int = _CELL_POINTS,
    tasks: int | None = None,
    check_ids: bool = True,
) -> ClosestPair | None:
    """Which two points are closest to each other? Searches at once, as the answer is no data frame.

    Parameters
    ----------
    df, id, x, y, z, lon, lat, height, cell_points, tasks, check_ids
        As of `nearest`.

    Returns
    -------
    beespace.ClosestPair or None
        `i`, `j` and `distance`; of equally close pairs the lowest. None where there are too few points.

    Examples
    --------
    >>> import beespace.spark
    >>> rows = [(7, 0.0, 0.0), (8, 3.0, 4.0), (9, 6.0, 9.0)]
    >>> drones = session.createDataFrame(rows, "id long, x double, y double")
    >>> beespace.spark.closest_pair(drones, z=None)
    ClosestPair(i=7, j=8, distance=5.0)
    """
    places = places_of(id, x, y, z, lon, lat, height)
    most = check_limits(cell_points, tasks)
    found = look(df, places, check_ids, most, tasks)
    if found.rows < 2:
        return None
    closest = _once.closest_pair(np.column_stack(found.sample)) if found.sample else None
    # No two that are closest are farther apart than those of the sample, whose distance is rounded a few times.
    reach = max(_SMALLEST_REACH, closest.distance * (1 + 2.0**-40)) if closest else np.inf
    prepared = prepare(df, places, found, [reach] * places.columns.searched, most, tasks)
    rows = prepared.blocks.mapInArrow(ClosestOf(places.columns), "points binary").collect()
    width = 1 + places.columns.searched
    told = b"".join(bytes(row["points"]) for row in rows)
    table = np.unique(np.frombuffer(told, np.int64).reshape(-1, width), axis=0)
    best = _once.closest_pair(np.ascontiguousarray(table[:, 1:]).view(np.float64))
    assert best is not None
    return ClosestPair(int(table[best.i, 0]), int(table[best.j, 0]), best.distance)


class ClosestOf:
    """The closest pair of each cell: a function for `mapInArrow`. That of all points is in the cells that are
    home of one of the two."""

    def __init__(self, columns: Columns) -> None:
        self.columns = columns

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        threads = threads_of_task()
        engine = Engine()
        for cell in cells_of(batches, self.columns):
            yield from self._ask(engine, cell, threads)

    def _ask(self, engine: Engine, cell: Cell, threads: int) -> Iterator[Any]:
        pyarrow = arrow()

        closest = engine.closest_pair(cell.points, threads=threads)
        if closest is None:
            return
        two = [closest.i, closest.j]
        places = np.ascontiguousarray(cell.points[two]).view(np.int64)
        data = np.column_stack([cell.ids[two], places]).tobytes()
        yield pyarrow.RecordBatch.from_arrays([pyarrow.array([data], type="binary")], ["points"])


__all__ = ["closest_pair", "nearest"]
