"""From a data frame of Spark to the blocks of its cells."""

from __future__ import annotations

import importlib
import logging
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from beespace._calls import length, number_of, whole
from beespace._errors import BeespaceError, invalid
from beespace._units import METRES
from beespace.spark._blocks import BLOCK_SCHEMA, Columns, Distribution, points_in_block
from beespace.spark._check_workers import check_workers, processors_of
from beespace.spark._cut import Cut
from beespace.spark._parts import keys_of_parts, pack
from beespace.spark._sample import TASKS_A_PROCESSOR, CellSize
from beespace.spark._survey import (
    IDS_SCHEMA,
    SURVEY_SCHEMA,
    TWICE_SCHEMA,
    IdBuckets,
    Survey,
    Surveyor,
    find_twice,
    survey_of,
)

DataFrame = Any  # of pyspark.sql, which is imported when a function is called, not before

_log = logging.getLogger("beespace.spark")
_WHOLE = ("byte", "short", "integer", "long")
_REAL = (*_WHOLE, "float", "double")
_IDS_IN_BUCKET = 2_000_000


class CutFacts(NamedTuple):
    """How space was cut for a search on a cluster.

    Attributes
    ----------
    points : int
        The rows of the data frame.
    cells : int
        The cells that space was cut into.
    tasks : int
        The tasks that search them.
    largest_cell : int
        About how many points the fullest cell has, its halo included.
    crowded_cells : int
        Cells with about more points than `cell_points`, as they cannot be cut where the threshold is
        large beside them. Each is searched whole, by one task.
    halo_factor : float
        How many times a point is sent to a cell, about: 1 and its share in halos.

    Examples
    --------
    >>> import beespace.spark
    >>> drones = session.createDataFrame([(0, 0.0, 0.0), (1, 30.0, 40.0)], "id long, x double, y double")
    >>> beespace.spark.facts(drones, 100, z=None)
    CutFacts(points=2, cells=1, tasks=1, largest_cell=2, crowded_cells=0, halo_factor=1.0)
    """

    points: int
    cells: int
    tasks: int
    largest_cell: int
    crowded_cells: int
    halo_factor: float


class Prepared(NamedTuple):
    """Blocks by cell, and what is known of them."""

    blocks: DataFrame
    facts: CutFacts
    cut: Cut
    parts: list[int]  # of each cell
    keys: list[int]  # of each task the part that it gets
    block: int  # how many points a block has


class Places(NamedTuple):
    """Where the columns are, and what a height in them is."""

    id: str
    names: tuple[str, ...]
    columns: Columns
    unit: float  # of heights apart, in metres


class Level(NamedTuple):
    """The thresholds of a search, as they were given."""

    threshold: Any
    vertical: Any
    inclusive: Any


def places_of(
    id: str,
    x: str,
    y: str,
    z: str | None,
    lon: str | None,
    lat: str | None,
    height: str | None,
    height_unit: Any = 1.0,
    vertical: Any = None,
) -> Places:
    """Which columns are meant. With a vertical threshold, heights are kept apart from positions."""
    unit = number_of(height_unit, "height_unit", METRES)
    if not 1e-6 <= unit <= 1e6:
        raise invalid("this is a length in metres, such as 0.3048 for feet", "height_unit")
    apart = height is not None and vertical is not None
    if unit != 1 and not apart:
        raise invalid(
            "only heights that a vertical threshold compares may have a unit of their own: give `height` "
            "and `vertical`",
            "height_unit",
        )
    if lon is None and lat is None:
        if height is not None and vertical is None:
            raise invalid(
                "a height beside x and y is compared with a vertical threshold: give `vertical`, or the "
                "column as z",
                "height",
            )
        names = (x, y) if z is None else (x, y, z)
        columns = Columns(len(names), False, apart)
    elif lon is None or lat is None:
        raise invalid("positions in degrees need both lon and lat; height is that above the ellipsoid")
    else:
        if vertical is not None and height is None:
            raise invalid("a vertical threshold needs a height beside lon and lat", "vertical")
        names = (lon, lat) if height is None or apart else (lon, lat, height)
        columns = Columns(len(names), True, apart)
    return Places(id, (*names, str(height)) if apart else names, columns, unit)


def check_columns(df: DataFrame, wanted: Sequence[tuple[str, str, tuple[str, ...]]]) -> None:
    """Of each role its column and the types that it may have."""
    if not hasattr(df, "mapInArrow") or not hasattr(df, "schema"):
        raise invalid(f"this is a data frame of Spark, not {type(df).__name__}", "df")
    fields = [(field.name, field.dataType.typeName()) for field in df.schema.fields]
    for role, name, types in wanted:
        found = [kind for field, kind in fields if field == name]
        if len(found) != 1:
            problem = "has several columns" if found else "has no column"
            told = ", ".join(field for field, _ in fields)
            raise BeespaceError(
                f"the data frame {problem} {name!r} for {role}; it has: {told}", "missing_column", role
            )
        if found[0] not in types:
            raise invalid(
                f"the column {name!r} is of the type {found[0]}; {role} is one of: {', '.join(types)}. "
                "Cast it, knowing what that rounds",
                role,
            )


def names_of_answer(id: str, *others: str) -> None:
    """Refuses a name for the ids that another column of the answer has."""
    if id.lower() in others:
        raise invalid(
            f"the answer has a column {id.lower()!r} of its own: rename that of the ids, as by "
            "DataFrame.withColumnRenamed",
            "id",
        )


def quoted(name: str) -> str:
    """The name of a column, whatever is in it."""
    return "`" + name.replace("`", "``") + "`"


def survey(df: DataFrame, places: Places, check_ids: bool, size: CellSize) -> Survey:
    """Looks at all rows once."""
    selected = select(df, places)
    rows = selected.mapInArrow(Surveyor(places.columns, size), SURVEY_SCHEMA).collect()
    found = survey_of(rows, places.columns, [places.id, *places.names])
    if check_ids and not found.in_order:
        _check_ids(selected, found.rows, places.id)
    return found


def _check_ids(selected: DataFrame, rows: int, name: str) -> None:
    tasks = processors_of(selected.sparkSession) * TASKS_A_PROCESSOR
    buckets = max(tasks, math.ceil(rows / _IDS_IN_BUCKET))
    keys = keys_of_parts(tasks)
    parts = [keys[bucket % tasks] for bucket in range(buckets)]
    blocks = selected.select("id").mapInArrow(IdBuckets(parts), IDS_SCHEMA)
    told = (
        blocks.repartition(tasks, "part")
        .sortWithinPartitions("bucket")
        .mapInArrow(find_twice, TWICE_SCHEMA)
        .collect()
    )
    twice = sum(row["twice"] for row in told)
    if twice:
        lowest = min(row["id"] for row in told if row["twice"])
        raise invalid(
            f"{twice:,} ids in the column {name!r} are those of several rows, the lowest of them {lowest}: "
            "each point must have an id of its own",
            "id",
        )


def select(df: DataFrame, places: Places) -> DataFrame:
    """The columns that matter, by the names of their roles."""
    functions: Any = importlib.import_module("pyspark.sql.functions")
    columns = [functions.col(quoted(places.id)).cast("long").alias("id")]
    for name, role in zip(places.names, places.columns.names):
        columns.append(functions.col(quoted(name)).alias(role))
    return df.select(*columns)


def look(df: DataFrame, places: Places, check_ids: bool, most: int, tasks: int | None) -> Survey:
    """Checks columns, workers, and all rows; takes a sample for cells of so many points."""
    check_columns(
        df,
        [
            ("id", places.id, _WHOLE),
            *((role, name, _REAL) for role, name in zip(places.columns.names, places.names)),
        ],
    )
    check_workers(df.sparkSession)
    size = CellSize(most, tasks or processors_of(df.sparkSession))
    return survey(df, places, check_ids, size)


def check_limits(cell_points: Any, tasks: Any) -> int:
    """How many points a cell has at most."""
    most = whole(cell_points, "cell_points")
    if most < 1:
        raise invalid("a cell has at least one point", "cell_points")
    if tasks is not None and whole(tasks, "tasks") < 1:
        raise invalid("there is at least one task", "tasks")
    return most


def prepare(
    df: DataFrame,
    places: Places,
    found: Survey,
    reach: list[float],
    most: int,
    tasks: int | None,
) -> Prepared:
    """Cuts space, and says how blocks come together by cell."""
    session = df.sparkSession
    at_once = processors_of(session)
    wanted = CellSize(most, tasks or at_once).wanted(found.rows)
    cut = cut_space(found, reach, most, wanted)
    sizes = [(home + copy) / max(found.rate, 1e-30) for home, copy in zip(cut.homes, cut.copies)]
    in_all = sum(sizes)
    number = tasks or min(cut.cells, max(TASKS_A_PROCESSOR * at_once, math.ceil(in_all / most)))
    number = max(min(number, cut.cells), 1)
    keys = keys_of_parts(number)
    parts = [keys[part] for part in pack(sizes, number)]
    facts = CutFacts(
        found.rows,
        cut.cells,
        number,
        round(max(sizes)),
        sum(size > 1.25 * most for size in sizes),
        in_all / found.rows if in_all else 1.0,
    )
    _tell(facts, most, wanted)
    records = int(session.conf.get("spark.sql.execution.arrow.maxRecordsPerBatch"))
    block = points_in_block(records)
    distribution = Distribution(cut, parts, places.columns, block)
    blocks = (
        select(df, places)
        .mapInArrow(distribution, BLOCK_SCHEMA)
        .repartition(number, "part")
        .sortWithinPartitions("cell", "first")
    )
    return Prepared(blocks, facts, cut, parts, keys, block)


def cut_space(found: Survey, reach: list[float], most: float, wanted: float) -> Cut:
    """Cells, as the sample says."""
    if found.sample:
        return Cut.of_sample(found.sample, reach, most * found.rate, wanted * found.rate)
    cut = Cut()
    cut.homes, cut.copies, cut.boxes = [0], [0], [np.zeros((2, len(reach)))]
    return cut


def _tell(facts: CutFacts, most: int, wanted: float) -> None:
    if facts.crowded_cells:
        _log.warning(
            "%d of %d cells have more than %d points, the fullest about %d: the threshold is too large beside "
            "them to cut them. Each is searched whole, by one task, which needs memory for it",
            facts.crowded_cells,
            facts.cells,
            most,
            facts.largest_cell,
        )
    elif facts.largest_cell > 2 * wanted:
        _log.warning(
            "space was cut into %d cells only, the fullest with about %d points, as more would consist of "
            "halos mostly: the threshold is large, and few tasks have all the work",
            facts.cells,
            facts.largest_cell,
        )
    _log.info("%s", facts)


def reach_of(level: Level, columns: Columns) -> list[float]:
    """How far apart two points in conflict can be along each axis."""
    along = _positive(level.threshold, "threshold")
    if level.vertical is None:
        return [along] * columns.searched
    height = _positive(level.vertical, "vertical")
    if columns.apart:
        return [along] * columns.searched
    if columns.axes == 2:
        raise invalid("a vertical threshold needs z", "vertical")
    return [along, along, height]


def arguments_of(level: Level) -> dict[str, Any]:
    """The thresholds as the engine is asked."""
    arguments: dict[str, Any] = {
        "threshold": float(level.threshold), "inclusive": bool(level.inclusive)
    }
    if level.vertical is not None:
        arguments["vertical"] = float(level.vertical)
    return arguments


def _positive(value: Any, place: str) -> float:
    number = length(value, place)
    if not (number > 0 and math.isfinite(number)):
        raise BeespaceError(
            f"a threshold is a number of metres above zero, not {number!r}", "invalid_threshold", place
        )
    return number
