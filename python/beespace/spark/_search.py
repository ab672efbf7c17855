"""From a data frame of Spark to the blocks of its cells."""

from __future__ import annotations

import importlib
import logging
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from beespace._calls import length, whole
from beespace._errors import BeespaceError, invalid
from beespace._library import version
from beespace.spark._blocks import BLOCK_SCHEMA, Columns, Distribution, points_in_block
from beespace.spark._cut import Cut
from beespace.spark._parts import keys_of_parts, pack
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
# Tasks for each of the processors, so that a slow one does not keep the others waiting for long.
_TASKS_A_PROCESSOR = 3
# A cell is not cut for the sake of other processors below this.
_WORTH_A_CELL = 200_000
_IDS_IN_BUCKET = 2_000_000
# Applications of Spark whose workers were found to have the package.
_checked: set[str] = set()


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
    axes: int


class Places(NamedTuple):
    """Where the columns are."""

    id: str
    names: tuple[str, ...]
    columns: Columns


def places_of(
    id: str, x: str, y: str, z: str | None, lon: str | None, lat: str | None, height: str | None
) -> Places:
    """Which columns are meant."""
    if lon is None and lat is None and height is None:
        names = (x, y) if z is None else (x, y, z)
        return Places(id, names, Columns(len(names), False))
    if lon is None or lat is None:
        raise invalid("positions in degrees need both lon and lat; height is that above the ellipsoid")
    names = (lon, lat) if height is None else (lon, lat, height)
    return Places(id, names, Columns(len(names), True))


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


def quoted(name: str) -> str:
    """The name of a column, whatever is in it."""
    return "`" + name.replace("`", "``") + "`"


def check_workers(session: Any) -> None:
    """A tiny job, once for each application of Spark: do workers have the package, and is it this one?"""
    expected = version()
    application = application_of(session)
    if application in _checked:
        return

    # Defined here, it is sent as it is: workers without the package can run it.
    def probe(batches: Any) -> Any:
        import importlib
        import socket

        for _ in batches:
            pass
        try:
            importlib.import_module("beespace.spark._questions")
            there = importlib.import_module("beespace").__version__
        except ImportError as error:
            told = f"{error}"
        else:
            told = "" if there == expected else f"its version is {there}"
        batch: Any = importlib.import_module("pyarrow").RecordBatch
        yield batch.from_arrays([[socket.gethostname()], [told]], ["host", "told"])

    tasks = processors_of(session)
    rows = session.range(0, tasks, 1, tasks).mapInArrow(probe, "host string, told string").collect()
    wrong = sorted({(row["host"], row["told"]) for row in rows if row["told"]})
    if wrong:
        host, told = wrong[0]
        raise BeespaceError(
            f"the workers of Spark do not have beespace {expected}, as this program has: on {host}: {told}. "
            "Install it there for the Python of spark.pyspark.python, or ship it with --archives",
            "invalid_argument",
        )
    if application:
        _checked.add(application)


def application_of(session: Any) -> str | None:
    """What Spark calls this application, where it says so."""
    try:
        return str(session.sparkContext.applicationId)
    except Exception:  # Spark Connect has no context, and says so in ways of its own
        return None


def processors_of(session: Any) -> int:
    """How many tasks run at a time, about."""
    try:
        return max(int(session.sparkContext.defaultParallelism), 1)
    except Exception:  # Spark Connect has no context, and says so in ways of its own
        return max(int(session.conf.get("spark.sql.shuffle.partitions")), 1)


def survey(df: DataFrame, places: Places, check_ids: bool) -> Survey:
    """Looks at all rows once."""
    selected = select(df, places)
    rows = selected.mapInArrow(Surveyor(places.columns), SURVEY_SCHEMA).collect()
    found = survey_of(rows, places.columns, [places.id, *places.names])
    if check_ids and not found.in_order:
        _check_ids(selected, found.rows, places.id)
    return found


def _check_ids(selected: DataFrame, rows: int, name: str) -> None:
    tasks = processors_of(selected.sparkSession) * _TASKS_A_PROCESSOR
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


def prepare(
    df: DataFrame,
    places: Places,
    reach: list[float],
    cell_points: int,
    tasks: int | None,
    check_ids: bool,
) -> Prepared:
    """Checks and surveys the data, cuts space, and says how blocks come together by cell."""
    check_columns(
        df,
        [
            ("id", places.id, _WHOLE),
            *((role, name, _REAL) for role, name in zip(places.columns.names, places.names)),
        ],
    )
    most = whole(cell_points, "cell_points")
    if most < 1:
        raise invalid("a cell has at least one point", "cell_points")
    if tasks is not None and whole(tasks, "tasks") < 1:
        raise invalid("there is at least one task", "tasks")
    session = df.sparkSession
    check_workers(session)
    found = survey(df, places, check_ids)
    at_once = processors_of(session)
    wanted = min(most, max(found.rows / (_TASKS_A_PROCESSOR * (tasks or at_once)), _WORTH_A_CELL))
    if len(reach) > len(found.sample) and found.sample:
        # Positions in degrees without a height have three axes in metres all the same.
        raise AssertionError("each axis has a reach")
    if found.sample:
        cut = Cut.of_sample(found.sample, reach, most * found.rate, wanted * found.rate)
    else:
        cut = Cut()
        cut.homes, cut.copies = [0], [0]
    sizes = [(home + copy) / max(found.rate, 1e-30) for home, copy in zip(cut.homes, cut.copies)]
    in_all = sum(sizes)
    number = tasks or min(cut.cells, max(_TASKS_A_PROCESSOR * at_once, math.ceil(in_all / most)))
    number = max(min(number, cut.cells), 1)
    keys = keys_of_parts(number)
    parts = [keys[part] for part in pack(sizes, number)]
    facts = CutFacts(
        found.rows,
        cut.cells,
        number,
        round(max(sizes)),
        sum(size > 1.25 * most for size in sizes),
        in_all / found.rows if found.rows else 1.0,
    )
    _tell(facts, most, wanted)
    records = int(session.conf.get("spark.sql.execution.arrow.maxRecordsPerBatch"))
    distribution = Distribution(cut, parts, places.columns, points_in_block(records))
    blocks = (
        select(df, places)
        .mapInArrow(distribution, BLOCK_SCHEMA)
        .repartition(number, "part")
        .sortWithinPartitions("cell", "first")
    )
    return Prepared(blocks, facts, 3 if places.columns.degrees else places.columns.axes)


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


def reach_of(threshold: Any, vertical: Any, places: Places) -> list[float]:
    """How far apart two points in conflict can be along each axis."""
    along = _positive(threshold, "threshold")
    if vertical is None:
        return [along] * (3 if places.columns.degrees else places.columns.axes)
    if places.columns.degrees:
        raise invalid(
            "a vertical threshold needs x, y and z with z as the height; of degrees, the third axis is "
            "not the height",
            "vertical",
        )
    if places.columns.axes == 2:
        raise invalid("a vertical threshold needs z", "vertical")
    return [along, along, _positive(vertical, "vertical")]


def _positive(value: Any, place: str) -> float:
    number = length(value, place)
    if not (number > 0 and math.isfinite(number)):
        raise BeespaceError(
            f"a threshold is a number of metres above zero, not {number!r}", "invalid_threshold", place
        )
    return number
