"""The questions about recordings in a data frame of Spark."""

from __future__ import annotations

import importlib
import logging
import math
from typing import Any

from beespace._calls import seconds, whole
from beespace._checks import gap_of
from beespace._errors import BeespaceError, invalid
from beespace.spark._check_workers import check_workers, processors_of
from beespace.spark._parts import keys_of_parts, pack
from beespace.spark._search import (
    DataFrame,
    Level,
    Places,
    arguments_of,
    check_columns,
    places_of,
    quoted,
    reach_of,
)
from beespace.spark._survey import LARGEST, LIMITS, SMALLEST
from beespace.spark._tubes import TUBES_SCHEMA, IntoCells, TubeSurveyor, WindowFacts, facts_of, windows_of
from beespace.spark._windows import WINDOW_SCHEMA, ConflictsOf, Windows, join_conflicts

_WINDOW_FIXES = 1_000_000
_WORTH_A_WINDOW = 20_000
_WINDOWS_A_PROCESSOR = 3
_MOST_WINDOWS = 1024
# An agent has so many fixes in a window at least: two of each piece, over either border. Where these are most of
# what a task may have in memory, windows are cut into cells.
_FIXES_AT_BORDERS = 4

_log = logging.getLogger("beespace.spark")
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
    height_unit: float = 1.0,
    inclusive: bool = False,
    window_fixes: int = _WINDOW_FIXES,
) -> DataFrame:
    """Which agents came closer than the threshold to each other, when, and how close?

    The answers of `Recording.conflicts`. Time is cut into windows with equally many fixes; and a window
    with more agents than a task has memory for is cut into cells of space.

    Parameters
    ----------
    df : pyspark.sql.DataFrame
        A row for each fix, in any order.
    threshold, x, y, z, lon, lat, height, vertical, height_unit, inclusive
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
    places = places_of(id, x, y, z, lon, lat, height, height_unit, vertical)
    level = Level(threshold, vertical, inclusive)
    reach = reach_of(level, places.columns)
    longest = gap_of(max_gap)
    most = whole(window_fixes, "window_fixes")
    if most < 1:
        raise invalid("a window has at least one fix", "window_fixes")
    fixes, kind = _fixes_of(df, places, time)
    session = df.sparkSession
    check_workers(session)
    at_once = processors_of(session) * _WINDOWS_A_PROCESSOR
    looked = _look(fixes, places)
    together = _together(fixes, looked) if looked["agents"] * _FIXES_AT_BORDERS > most else 0.0
    number = windows_of(looked["rows"], at_once, most, _WORTH_A_WINDOW, together)
    borders = _borders_of(looked, number)
    in_order = fixes.repartition(at_once, "id").sortWithinPartitions("id", "time")
    windows = Windows(borders, places.columns, longest)
    facts = [WindowFacts(None, [1.0])] * (len(borders) + 1)
    if together * _FIXES_AT_BORDERS > most:
        facts = _cut_windows(in_order, windows, places, reach, most)
    sizes = [size for each in facts for size in each.sizes]
    keys = keys_of_parts(min(len(sizes), max(at_once, len(sizes) // 4)))
    parts = iter([keys[part] for part in pack(sizes, len(keys))])
    windows.parts = [[next(parts) for _ in each.sizes] for each in facts]
    cuts = {window: each.cut for window, each in enumerate(facts) if each.cut is not None}
    into_rows = IntoCells(windows, places.columns, cuts) if cuts else windows
    found = "begin double, end double, closest_time double, closest_distance double"
    return (
        in_order.mapInArrow(into_rows, WINDOW_SCHEMA.format(kind=kind))
        .repartition(len(keys), "part")
        .sortWithinPartitions("window", "cell", "id", "first")
        .mapInArrow(
            ConflictsOf(places.columns, places.unit, longest, arguments_of(level)),
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


def _look(fixes: DataFrame, places: Places) -> Any:
    """Looks at all fixes once: how many there are, when, and about how many agents."""
    functions: Any = importlib.import_module("pyspark.sql.functions")
    bad = functions.col("id").isNull()
    for name in ("time", *places.columns.names):
        value = functions.col(name).cast("double")
        bad = bad | value.isNull() | functions.isnan(value) | (functions.abs(value) == math.inf)
        if places.columns.degrees and name in LIMITS and not (places.columns.apart and name == "height"):
            bad = bad | ~value.between(*LIMITS[name])
        elif name != "time":
            bad = bad | ((value != 0) & ~functions.abs(value).between(SMALLEST, LARGEST))
    shares = [at / _MOST_WINDOWS for at in range(1, _MOST_WINDOWS)]
    row = fixes.agg(
        functions.count(functions.lit(1)).alias("rows"),
        functions.count(functions.when(bad, 1)).alias("bad"),
        functions.approx_count_distinct("id").alias("agents"),
        functions.min("time").alias("begin"),
        functions.max("time").alias("last"),
        functions.percentile_approx("time", shares, 10_000).alias("times"),
    ).first()
    if row["bad"]:
        first = fixes.where(bad).first()
        told = ", ".join(f"{name} {first[name]}" for name in fixes.columns)
        is_number = all(
            first[name] is not None and math.isfinite(first[name]) for name in fixes.columns[1:]
        )
        raise BeespaceError(
            f"{row['bad']:,} of {row['rows']:,} fixes cannot be used; one of them: {told}. Correct such rows, or "
            "leave them out knowingly, with DataFrame.where",
            "outside_domain" if is_number and first["id"] is not None else "not_finite",
        )
    return row


def _together(fixes: DataFrame, looked: Any) -> float:
    """How many agents are there at a time, on average. Looks at all fixes once more."""
    functions: Any = importlib.import_module("pyspark.sql.functions")
    lasting = functions.max("time") - functions.min("time")
    spans = fixes.groupBy("id").agg(lasting.alias("lasting"))
    row = spans.agg(functions.sum("lasting").alias("lasting"), functions.count("id").alias("agents")).first()
    duration = looked["last"] - looked["begin"]
    return row["lasting"] / duration if duration > 0 else float(row["agents"])


def _borders_of(looked: Any, windows: int) -> list[float]:
    """Borders between windows, ascending."""
    number = min(windows, _MOST_WINDOWS)
    times: list[float] = looked["times"] or []
    chosen = {times[at * _MOST_WINDOWS // number - 1] for at in range(1, number)}
    return sorted(each for each in chosen if each < looked["last"])


def _cut_windows(
    in_order: DataFrame, windows: Windows, places: Places, reach: list[float], most: int
) -> list[WindowFacts]:
    """Looks at all fixes once more, for how agents are spread in each window."""
    surveyor = TubeSurveyor(windows, places.columns)
    rows: dict[int, list[Any]] = {}
    for row in in_order.mapInArrow(surveyor, TUBES_SCHEMA).collect():
        rows.setdefault(row["window"], []).append(row)
    facts = [
        facts_of(rows.get(window, []), reach, most)
        for window in range(len(windows.borders) + 1)
    ]
    fullest = max(size for each in facts for size in each.sizes)
    if fullest > 1.25 * most:
        _log.warning(
            "of the cells that windows are cut into, the fullest has about %d fixes, and not %d: the threshold, or "
            "the way of agents between two fixes, is too large beside them. Each is searched whole, by one task, "
            "which needs memory for it",
            fullest,
            most,
        )
    return facts
