"""The questions about points in a data frame of Spark."""

from __future__ import annotations

from typing import NamedTuple

from beespace.spark._questions import AtRisk, Counts, PairsOf, Question
from beespace.spark._search import (
    CutFacts,
    DataFrame,
    Level,
    Places,
    arguments_of,
    check_limits,
    look,
    names_of_answer,
    places_of,
    prepare,
    quoted,
    reach_of,
)

_CELL_POINTS = 1_000_000


def at_risk(
    df: DataFrame,
    threshold: float,
    *,
    id: str = "id",
    x: str = "x",
    y: str = "y",
    z: str | None = "z",
    lon: str | None = None,
    lat: str | None = None,
    height: str | None = None,
    vertical: float | None = None,
    height_unit: float = 1.0,
    inclusive: bool = False,
    cell_points: int = _CELL_POINTS,
    tasks: int | None = None,
    check_ids: bool = True,
) -> DataFrame:
    """Which points are closer than the threshold to any other point?

    Parameters
    ----------
    df : pyspark.sql.DataFrame
        A row for each point.
    threshold : float
        How close is too close, in metres. Exactly the threshold apart is not closer.
    id : str
        The column of ids: whole numbers, each of one row.
    x, y, z : str
        The columns of coordinates in metres, floats or integers; heights are 0 where `z` is None.
    lon, lat, height : str, optional
        Instead of x, y and z, the columns of WGS84 degrees and of heights above the ellipsoid in metres,
        which are converted as by `to_ecef`. With `vertical`, heights may be above whatever all are above,
        and there may be one beside x and y.
    vertical : float, optional
        A vertical threshold: two points conflict when they are closer than `threshold` in x and y, and
        closer than this in z. Where there is a `height`, it is compared instead of z, and positions are
        horizontal: those of degrees are brought to height 0.
    height_unit : float
        The length in metres of one unit of heights that `vertical` compares, and of `vertical`: 0.3048
        for feet.
    inclusive : bool
        Whether exactly the threshold apart counts as closer.
    cell_points : int
        About the most points that a task has in memory at a time.
    tasks : int, optional
        How many tasks search; by default a few for each processor.
    check_ids : bool
        Whether ids that do not ascend are checked to be different, which takes a pass of its own.

    Returns
    -------
    pyspark.sql.DataFrame
        The ids of the points at risk, in a column of that name, in no particular order.

    Raises
    ------
    BeespaceError
        Columns that are missing or of another type; rows with a null, NaN or what is no position, with
        their number and the first of them; ids that are not unique; workers without this package.

    Examples
    --------
    >>> import beespace.spark
    >>> rows = [(7, 0.0, 0.0, 50.0), (8, 80.0, 60.0, 50.0), (9, 80.0, 60.0, 99.0)]
    >>> drones = session.createDataFrame(rows, "id long, x double, y double, z double")
    >>> beespace.spark.at_risk(drones, 100).orderBy("id").collect()
    [Row(id=8), Row(id=9)]
    """
    places = places_of(id, x, y, z, lon, lat, height, height_unit, vertical)
    search = _Search(places, Level(threshold, vertical, inclusive), cell_points, tasks, check_ids)
    return search.ask(df, AtRisk, f"{quoted(id)} long")


def pairs(
    df: DataFrame,
    threshold: float,
    *,
    id: str = "id",
    x: str = "x",
    y: str = "y",
    z: str | None = "z",
    lon: str | None = None,
    lat: str | None = None,
    height: str | None = None,
    vertical: float | None = None,
    height_unit: float = 1.0,
    inclusive: bool = False,
    cell_points: int = _CELL_POINTS,
    tasks: int | None = None,
    check_ids: bool = True,
) -> DataFrame:
    """Which pairs of points are closer than the threshold?

    Parameters
    ----------
    df, threshold, id, x, y, z, lon, lat, height, vertical, height_unit, inclusive
        As of `at_risk`.
    cell_points, tasks, check_ids
        As of `at_risk`.

    Returns
    -------
    pyspark.sql.DataFrame
        `first` and `second`, the ids of each pair, once, the lower one first; `distance` in metres. In no
        particular order.

    Examples
    --------
    >>> import beespace.spark
    >>> rows = [(7, 0.0, 0.0), (8, 3.0, 4.0), (9, 6.0, 8.0)]
    >>> drones = session.createDataFrame(rows, "id long, x double, y double")
    >>> beespace.spark.pairs(drones, 6, z=None).orderBy("first").collect()
    [Row(first=7, second=8, distance=5.0), Row(first=8, second=9, distance=5.0)]
    """
    places = places_of(id, x, y, z, lon, lat, height, height_unit, vertical)
    search = _Search(places, Level(threshold, vertical, inclusive), cell_points, tasks, check_ids)
    return search.ask(df, PairsOf, "first long, second long, distance double")


def counts(
    df: DataFrame,
    threshold: float,
    *,
    id: str = "id",
    x: str = "x",
    y: str = "y",
    z: str | None = "z",
    lon: str | None = None,
    lat: str | None = None,
    height: str | None = None,
    vertical: float | None = None,
    height_unit: float = 1.0,
    inclusive: bool = False,
    cell_points: int = _CELL_POINTS,
    tasks: int | None = None,
    check_ids: bool = True,
) -> DataFrame:
    """How many points are closer than the threshold to each point?

    Parameters
    ----------
    df, threshold, id, x, y, z, lon, lat, height, vertical, height_unit, inclusive
        As of `at_risk`.
    cell_points, tasks, check_ids
        As of `at_risk`.

    Returns
    -------
    pyspark.sql.DataFrame
        A row for each point: its id, in a column of that name, and `count`. In no particular order.

    Examples
    --------
    >>> import beespace.spark
    >>> rows = [(7, 0.0, 0.0), (8, 3.0, 4.0), (9, 6.0, 8.0)]
    >>> drones = session.createDataFrame(rows, "bee long, x double, y double")
    >>> beespace.spark.counts(drones, 6, id="bee", z=None).orderBy("bee").collect()
    [Row(bee=7, count=1), Row(bee=8, count=2), Row(bee=9, count=1)]
    """
    names_of_answer(id, "count")
    places = places_of(id, x, y, z, lon, lat, height, height_unit, vertical)
    search = _Search(places, Level(threshold, vertical, inclusive), cell_points, tasks, check_ids)
    return search.ask(df, Counts, f"{quoted(id)} long, `count` long")


def facts(
    df: DataFrame,
    threshold: float,
    *,
    id: str = "id",
    x: str = "x",
    y: str = "y",
    z: str | None = "z",
    lon: str | None = None,
    lat: str | None = None,
    height: str | None = None,
    vertical: float | None = None,
    height_unit: float = 1.0,
    cell_points: int = _CELL_POINTS,
    tasks: int | None = None,
) -> CutFacts:
    """How would space be cut for a search? Checks and surveys the data, and searches nothing.

    Parameters
    ----------
    df, threshold, id, x, y, z, lon, lat, height, vertical, height_unit, cell_points, tasks
        As of `at_risk`.

    Returns
    -------
    CutFacts

    Examples
    --------
    >>> import beespace.spark
    >>> drones = session.range(1000).selectExpr("id", "1.0D * id AS x", "0.0D AS y")
    >>> beespace.spark.facts(drones, 2, z=None).points
    1000
    """
    places = places_of(id, x, y, z, lon, lat, height, height_unit, vertical)
    reach = reach_of(Level(threshold, vertical, False), places.columns)
    most = check_limits(cell_points, tasks)
    return prepare(df, places, look(df, places, True, most, tasks), reach, most, tasks).facts


class _Search(NamedTuple):
    """What a question is asked with."""

    places: Places
    level: Level
    cell_points: int
    tasks: int | None
    check_ids: bool

    def ask(self, df: DataFrame, question: type[Question], schema: str) -> DataFrame:
        """The answers of all cells."""
        columns = self.places.columns
        reach = reach_of(self.level, columns)
        asked = question(columns, self.places.id, self.places.unit, arguments_of(self.level))
        most = check_limits(self.cell_points, self.tasks)
        found = look(df, self.places, self.check_ids, most, self.tasks)
        prepared = prepare(df, self.places, found, reach, most, self.tasks)
        return prepared.blocks.mapInArrow(asked, schema)


__all__ = ["at_risk", "counts", "facts", "pairs"]
