"""What cannot be searched is an error before the long work, and says where and what to do."""

from __future__ import annotations

import beespace
import beespace.spark
import pytest

TYPES = "id long, x double, y double, z double"


def _rows(count=100):
    return [(at, float(at), 0.0, 0.0) for at in range(count)]


def _error(call):
    with pytest.raises(beespace.BeespaceError) as caught:
        call()
    return caught.value


@pytest.mark.parametrize(
    ("value", "code"),
    [(float("nan"), "not_finite"), (None, "not_finite"), (float("inf"), "not_finite"), (1e200, "outside_domain")],
)
def test_rows_that_cannot_be_used_are_counted_and_the_first_is_named(session, value, code):
    rows = _rows()
    rows[40] = (40, 1.0, value, 0.0)
    rows[70] = (70, value, value, 0.0)
    error = _error(lambda: beespace.spark.at_risk(session.createDataFrame(rows, TYPES).coalesce(1), 5))
    assert error.code == code and error.place == "y"
    assert "2 of 100 rows" in str(error) and "id 40" in str(error) and "row 40 of partition 0" in str(error)


def test_an_id_that_is_null(session):
    rows = _rows()
    rows[3] = (None, 0.0, 0.0, 0.0)
    error = _error(lambda: beespace.spark.pairs(session.createDataFrame(rows, TYPES), 5))
    assert error.place == "id" and "1 of 100 rows" in str(error)


def test_ids_that_are_there_twice(session):
    rows = [*_rows(), (17, 1e6, 0.0, 0.0), (55, 2e6, 0.0, 0.0), (17, 3e6, 0.0, 0.0)]
    frame = session.createDataFrame(rows, TYPES).repartition(4)
    error = _error(lambda: beespace.spark.counts(frame, 5))
    assert error.place == "id" and "2 ids" in str(error) and "lowest of them 17" in str(error)


def test_ids_that_are_there_twice_in_a_cell_are_found_without_the_check(session):
    rows = [*_rows(), (17, 17.5, 0.0, 0.0)]
    frame = session.createDataFrame(rows, TYPES)
    with pytest.raises(Exception, match="the id 17 is that of several points"):
        beespace.spark.counts(frame, 5, check_ids=False).collect()


@pytest.mark.parametrize(
    ("arguments", "code", "place"),
    [
        ({"x": "east"}, "missing_column", "x"),
        ({"id": "no"}, "missing_column", "id"),
        ({"y": "text"}, "invalid_argument", "y"),
        ({"lon": "x"}, "invalid_argument", None),
        ({"lon": "x", "lat": "y", "vertical": 5}, "invalid_argument", "vertical"),
        ({"z": None, "vertical": 5}, "invalid_argument", "vertical"),
        ({"threshold": 0}, "invalid_threshold", "threshold"),
        ({"threshold": "5m"}, "invalid_threshold", "threshold"),
        ({"threshold": float("nan")}, "invalid_threshold", "threshold"),
        ({"z": None, "height": "z"}, "invalid_argument", "height"),
        ({"height_unit": 0.3048}, "invalid_argument", "height_unit"),
        ({"z": None, "height": "z", "vertical": 5, "height_unit": 0}, "invalid_argument", "height_unit"),
        ({"z": None, "height": "text", "vertical": 5}, "invalid_argument", "height"),
        ({"cell_points": 0}, "invalid_argument", "cell_points"),
        ({"tasks": 0}, "invalid_argument", "tasks"),
    ],
)
def test_columns_and_arguments_are_checked_without_a_job(session, arguments, code, place):
    # A row that fails wherever it is read.
    frame = session.createDataFrame(_rows(1), TYPES).selectExpr(
        "id", "x", "y", "cast(raise_error('read') AS double) AS z", "'a' AS text"
    )
    error = _error(lambda: beespace.spark.at_risk(frame, **{"threshold": 5, **arguments}))
    assert error.code == code and error.place == place


def test_what_nearest_is_asked_is_checked_without_a_job(session):
    frame = session.createDataFrame(_rows(1), TYPES).selectExpr(
        "id AS rank", "x", "y", "cast(raise_error('read') AS double) AS z", "id AS count"
    )
    for k in (0, -1, 1.5, 2**31):
        assert _error(lambda k=k: beespace.spark.nearest(frame, k, id="count")).place == "k"
    assert _error(lambda: beespace.spark.nearest(frame, id="rank")).place == "id"
    assert "rename" in str(_error(lambda: beespace.spark.counts(frame, 5, id="count")))
    assert _error(lambda: beespace.spark.closest_pair(frame, id="no")).code == "missing_column"


@pytest.mark.parametrize("value", [float("nan"), float("inf"), 1e200])
def test_a_height_apart_that_cannot_be_used(session, value):
    rows = _rows()
    rows[8] = (8, 1.0, 0.0, value)
    frame = session.createDataFrame(rows, TYPES)
    error = _error(lambda: beespace.spark.pairs(frame, 5, z=None, height="z", vertical=3))
    assert error.place == "height" and "1 of 100 rows" in str(error) and "id 8" in str(error)


def test_nearest_of_rows_that_cannot_be_used(session):
    frame = session.createDataFrame([*_rows(), (500, None, 0.0, 0.0)], TYPES)
    for ask in (beespace.spark.nearest, beespace.spark.closest_pair):
        error = _error(lambda ask=ask: ask(frame))
        assert error.place == "x" and "1 of 101 rows" in str(error) and "id 500" in str(error)


def test_a_latitude_beyond_the_pole(session):
    frame = session.createDataFrame([(1, 8.0, 91.0)], "id long, lon double, lat double")
    error = _error(lambda: beespace.spark.pairs(frame, 5, lon="lon", lat="lat"))
    assert error.place == "lat" and "91.0" in str(error)


def test_what_is_no_data_frame(session):
    assert "DataFrame" not in str(_error(lambda: beespace.spark.at_risk([[0, 0, 0]], 5)))
    assert _error(lambda: beespace.spark.at_risk([[0, 0, 0]], 5)).place == "df"


def test_other_rows_than_at_first_are_an_error(session):
    # An accumulator of calls would be shared by workers; time is, too.
    import time

    until = time.time() + 8
    frame = session.createDataFrame(_rows(), TYPES).selectExpr(
        "id", f"if(unix_micros(now()) < {int(until * 1e6)}, x, null) AS x", "y", "z"
    )
    found = beespace.spark.at_risk(frame, 5)
    time.sleep(max(0, until - time.time()) + 0.5)
    with pytest.raises(Exception, match="the same rows each time"):
        found.collect()
