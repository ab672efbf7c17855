"""The questions about recordings in a data frame of Spark."""

from __future__ import annotations

import importlib
import math
from typing import Any

from beespace._calls import seconds, whole
from beespace._checks import gap_of
from beespace._errors import BeespaceError, invalid
from beespace.spark._parts import keys_of_parts
from beespace.spark._search import (
    DataFrame,
    Places,
    check_columns,
    check_workers,
    places_of,
    processors_of,
    quoted,
    reach_of,
)
from beespace.spark._windows import ConflictsOf, Windows, join_conflicts

_WINDOW_FIXES = 1_000_000
_WORTH_A_WINDOW = 20_000
_WINDOWS_A_PROCESSOR = 3
_IDS = ("string", "byte", "short", "integer", "long")
_TIMES = ("timestamp", "float", "double", "byte", "short", "integer", "long")
_REALS = ("float", "double", "byte", "short", "integer", "long")


def conflicts(
    df: DataFrame,
    threshold: float,
    *,
    id: str = "id",
    time: str = "time",
    x: str = "x",
    y: str = "y",
    z: str | None = "z",
    lon: str | None = None,
    lat: str | None = None,
    height: str | None = None,
    max_gap: float | None = None,
    vertical: float | None = None,
    inclusive: bool = False,
    window_fixes: int = _WINDOW_FIXES,
) -> DataFrame:
    """Which agents came closer than the threshold to each other, when, and how close?

    The answers of `Recording.conflicts`. Time is cut into windows with equally many fixes, and a window
    is searched by one task, which has all agents of that time in memory.

    Parameters
    ----------
    df : pyspark.sql.DataFrame
        A row for each fix, in any order.
    threshold, x, y, z, lon, lat, height, vertical, inclusive
        As of `at_risk`.
    id : str
        The column of agents: texts or whole numbers.
    time : str
        The column of times: numbers of seconds, or timestamps, which count from 1970. Those of one agent
        must differ.
    max_gap : float, optional
        The longest time between two fixes of an agent, in seconds, that is bridged by a straight line;
        without it all are. In a longer one it is unknown where the agent is: `gaps` names them. No
        conflicts and no gaps are an all-clear, no conflicts alone are not.
    window_fixes : int
        About how many fixes a task has in memory at a time.

    Returns
    -------
    pyspark.sql.DataFrame
        `first`, `second` (in the type of the ids, the lower one first), `begin`, `end`, `closest_time` in
        seconds, `closest_distance` in metres. A pair may be in conflict several times.

    Examples
    --------
    >>> import beespace.spark
    >>> rows = [("ann", 0.0, 0.0, 0.0), ("bob", 0.0, 100.0, 3.0)]
    >>> rows += [("ann", 10.0, 100.0, 0.0), ("bob", 10.0, 0.0, 3.0)]
    >>> fixes = session.createDataFrame(rows, "id string, time double, x double, y double")
    >>> found = beespace.spark.conflicts(fixes, 5, z=None)
    >>> found.select("first", "second", "closest_time", "closest_distance").collect()
    [Row(first='ann', second='bob', closest_time=5.0, closest_distance=3.0)]
    """
    places = places_of(id, x, y, z, lon, lat, height)
    reach_of(threshold, vertical, places)
    longest = gap_of(max_gap)
    most = whole(window_fixes, "window_fixes")
    if most < 1:
        raise invalid("a window has at least one fix", "window_fixes")
    fixes, kind = _fixes_of(df, places, time)
    session = df.sparkSession
    check_workers(session)
    at_once = processors_of(session) * _WINDOWS_A_PROCESSOR
    borders = _borders_of(fixes, places, most, at_once)
    number = len(borders) + 1
    parts = keys_of_parts(min(number, max(at_once, number // 4)))
    windows = Windows(
        borders, [parts[window % len(parts)] for window in range(number)], places.columns, longest
    )
    arguments: dict[str, Any] = {"threshold": float(threshold), "inclusive": bool(inclusive)}
    if vertical is not None:
        arguments["vertical"] = float(vertical)
    axes = 3 if places.columns.degrees else places.columns.axes
    found = "begin double, end double, closest_time double, closest_distance double"
    return (
        fixes.repartition(at_once, "id")
        .sortWithinPartitions("id", "time")
        .mapInArrow(windows, f"part int, window int, id {kind}, first double, fixes binary")
        .repartition(len(parts), "part")
        .sortWithinPartitions("window", "id", "first")
        .mapInArrow(
            ConflictsOf(axes, longest, arguments),
            f"first {kind}, second {kind}, window int, {found}",
        )
        .repartition(at_once, "first", "second")
        .sortWithinPartitions("first", "second", "window", "begin", "end")
        .mapInArrow(join_conflicts, f"first {kind}, second {kind}, {found}")
    )


def gaps(df: DataFrame, max_gap: float, *, id: str = "id", time: str = "time") -> DataFrame:
    """Between which fixes is it unknown where an agent was?

    Parameters
    ----------
    df, max_gap, id, time
        As of `conflicts`.

    Returns
    -------
    pyspark.sql.DataFrame
        `id`, and `begin` and `end` in seconds, the times of the fixes before and after each gap.

    Examples
    --------
    >>> import beespace.spark
    >>> fixes = session.createDataFrame([(1, 0.0), (1, 10.0), (1, 11.0)], "id long, time double")
    >>> beespace.spark.gaps(fixes, 2).collect()
    [Row(id=1, begin=0.0, end=10.0)]
    """
    functions: Any = importlib.import_module("pyspark.sql.functions")
    window: Any = importlib.import_module("pyspark.sql.window").Window
    if not seconds(max_gap, "max_gap") > 0:
        raise invalid("the longest gap is a time above zero", "max_gap")
    check_columns(df, [("id", id, _IDS), ("time", time, _TIMES)])
    of_agent = window.partitionBy("id").orderBy("begin")
    return (
        df.select(
            functions.col(quoted(id)).alias("id"),
            functions.col(quoted(time)).cast("double").alias("begin"),
        )
        .withColumn("end", functions.lead("begin").over(of_agent))
        .where(functions.col("end") - functions.col("begin") > float(max_gap))
    )


def _fixes_of(df: DataFrame, places: Places, time: str) -> tuple[DataFrame, str]:
    """The columns that matter, by their roles; and the type of ids."""
    functions: Any = importlib.import_module("pyspark.sql.functions")
    check_columns(
        df,
        [
            ("id", places.id, _IDS),
            ("time", time, _TIMES),
            *((role, name, _REALS) for role, name in zip(places.columns.names, places.names)),
        ],
    )
    texts = df.schema[places.id].dataType.typeName() == "string"
    kind = "string" if texts else "long"
    columns = [
        functions.col(quoted(places.id)).cast(kind).alias("id"),
        functions.col(quoted(time)).cast("double").alias("time"),
    ]
    for name, role in zip(places.names, places.columns.names):
        columns.append(functions.col(quoted(name)).alias(role))
    return df.select(*columns), kind


def _borders_of(fixes: DataFrame, places: Places, most: int, at_once: int) -> list[float]:
    """Looks at all fixes once. Borders between windows, ascending."""
    functions: Any = importlib.import_module("pyspark.sql.functions")
    bad = functions.col("id").isNull()
    for name in ("time", *places.columns.names):
        value = functions.col(name).cast("double")
        bad = bad | value.isNull() | functions.isnan(value) | (functions.abs(value) == math.inf)
    shares = [at / 1024 for at in range(1, 1024)]
    row = fixes.agg(
        functions.count(functions.lit(1)).alias("rows"),
        functions.count(functions.when(bad, 1)).alias("bad"),
        functions.max("time").alias("last"),
        functions.percentile_approx("time", shares, 10_000).alias("times"),
    ).first()
    if row["bad"]:
        first = fixes.where(bad).first()
        told = ", ".join(f"{name} {first[name]}" for name in fixes.columns)
        raise BeespaceError(
            f"{row['bad']:,} of {row['rows']:,} fixes cannot be used; one of them: {told}. Correct such rows, or "
            "leave them out knowingly, with DataFrame.where",
            "not_finite",
        )
    size = min(most, max(row["rows"] / at_once, _WORTH_A_WINDOW if most > _WORTH_A_WINDOW else 1))
    number = min(math.ceil(row["rows"] / size) if row["rows"] else 1, 1024)
    times: list[float] = row["times"] or []
    chosen = {times[at * 1024 // number - 1] for at in range(1, number)}
    return sorted(each for each in chosen if each < row["last"])
