"""The answers of a cluster are those of brute force, and of one machine bit for bit."""

from __future__ import annotations

import beespace
import beespace.spark
import numpy as np
import pytest
import scenes

SMALL = {"cell_points": 700}


def frame_of(session, ids, points, names=("id", "x", "y", "z"), parts=5):
    columns = dict(zip(names, [ids, *points.T]))
    types = ", ".join(f"`{name}` {'long' if at == 0 else 'double'}" for at, name in enumerate(names))
    import pandas

    if not len(ids):
        return session.createDataFrame([], types)
    return session.createDataFrame(pandas.DataFrame(columns), types).repartition(parts)


def columns_of(frame):
    rows = frame.toPandas()
    rows = rows.sort_values(list(rows.columns[: 2 if "second" in rows.columns else 1]))
    return [rows[name].to_numpy() for name in rows.columns]


def expected(ids, points, **arguments):
    """As one machine says, of the points in the order of their ids."""
    order = np.argsort(ids)
    ids, points = ids[order], points[order]
    pairs = beespace.pairs(points, scenes.THRESHOLD, **arguments)
    return {
        "pairs": [ids[pairs.i], ids[pairs.j], pairs.distance],
        "at_risk": [ids[beespace.at_risk(points, scenes.THRESHOLD, **arguments)]],
        "counts": [ids, beespace.count(points, scenes.THRESHOLD, **arguments)],
    }


def same(found, wanted):
    assert len(found) == len(wanted)
    for one, other in zip(found, wanted):
        assert one.dtype == other.dtype
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("name", sorted(scenes.ALL))
def test_answers_are_those_of_one_machine(session, name):
    ids, points = scenes.swarm(name)
    frame = frame_of(session, ids, points)
    wanted = expected(ids, points)
    for question in ("pairs", "at_risk", "counts"):
        same(columns_of(getattr(beespace.spark, question)(frame, scenes.THRESHOLD, **SMALL)), wanted[question])


def test_cells_are_many_where_answers_are_compared(session):
    ids, points = scenes.swarm("uniform")
    facts = beespace.spark.facts(frame_of(session, ids, points), scenes.THRESHOLD, **SMALL)
    assert facts.cells > 12 and facts.tasks >= 6 and facts.points == len(ids)
    assert 1.1 < facts.halo_factor < 4


@pytest.mark.parametrize("arguments", [{"inclusive": True}, {"vertical": 2.0}, {"vertical": 0.4, "inclusive": True}])
def test_thresholds_of_other_kinds(session, arguments):
    ids, points = scenes.swarm("lattice")
    found = beespace.spark.pairs(frame_of(session, ids, points), scenes.THRESHOLD, **arguments, **SMALL)
    same(columns_of(found), expected(ids, points, **arguments)["pairs"])


def test_two_axes_other_names_and_floats(session):
    ids, points = scenes.swarm("plane")
    points = points[:, :2].astype(np.float32).astype(np.float64)
    frame = frame_of(session, ids, points, ("bee no", "ea.st", "north"))
    frame = frame.selectExpr("`bee no`", "cast(`ea.st` AS float) AS `ea.st`", "north", "'a text' AS more")
    found = beespace.spark.counts(
        frame, scenes.THRESHOLD, id="bee no", x="ea.st", y="north", z=None, **SMALL
    )
    assert found.columns == ["bee no", "count"]
    same(columns_of(found), expected(ids, points)["counts"])


def test_degrees(session):
    rng = np.random.default_rng(4)
    lon, lat, height = 8 + rng.random(4_000) * 0.02, 47 + rng.random(4_000) * 0.02, rng.random(4_000) * 90
    ids = np.arange(4_000)
    frame = frame_of(session, ids, np.column_stack([lon, lat, height]), ("id", "lon", "lat", "h"))
    found = beespace.spark.pairs(frame, 25, lon="lon", lat="lat", height="h", **SMALL)
    pairs = beespace.pairs(beespace.to_ecef(lon, lat, height), 25)
    assert len(pairs) > 100
    same(columns_of(found), [pairs.i, pairs.j, pairs.distance])
    flat = beespace.spark.at_risk(frame, 25, lon="lon", lat="lat", **SMALL)
    same(columns_of(flat), [beespace.at_risk(beespace.to_ecef(lon, lat, 0.0), 25)])


@pytest.mark.parametrize("question", ["pairs", "at_risk", "counts"])
def test_heights_in_feet_beside_degrees(session, question):
    """5 NM over ground and 1,000 ft: positions at height 0, heights as they are."""
    rng = np.random.default_rng(14)
    count = 3_000
    lon, lat = 8 + rng.random(count) * 3, 47 + rng.random(count) * 3
    feet = rng.integers(0, 40, count) * 500.0
    ids = rng.permutation(count)
    frame = frame_of(session, ids, np.column_stack([lon, lat, feet]), ("id", "lon", "lat", "feet"))
    apart = {"vertical": 1_000, "inclusive": True}
    places = {"lon": "lon", "lat": "lat", "height": "feet", "height_unit": 0.3048}
    found = getattr(beespace.spark, question)(frame, 9_260, **places, **apart, **SMALL)
    order = np.argsort(ids)
    search = beespace.OutOfCore("64 MB", height_unit=0.3048)
    search.add(beespace.to_ecef(lon, lat, 0.0)[order], heights=feet[order])
    if question == "pairs":
        pairs = np.concatenate([np.column_stack([p.i, p.j]) for p in search.iter_pairs(9_260, **apart)])
        distances = np.concatenate([p.distance for p in search.iter_pairs(9_260, **apart)])
        sorted_ones = np.lexsort((pairs[:, 1], pairs[:, 0]))
        assert 1_000 < len(pairs) < count**2 / 100
        wanted = [*pairs[sorted_ones].T, distances[sorted_ones]]
    elif question == "counts":
        wanted = [np.arange(count), search.count(9_260, **apart)]
    else:
        wanted = [search.at_risk(9_260, **apart)]
    same(columns_of(found), wanted)


def test_heights_beside_x_and_y_decide_as_z_does(session):
    ids, points = scenes.swarm("lattice")
    frame = frame_of(session, ids, points)
    found = beespace.spark.at_risk(frame, scenes.THRESHOLD, z=None, height="z", vertical=2.0, **SMALL)
    same(columns_of(found), expected(ids, points, vertical=2.0)["at_risk"])


@pytest.mark.parametrize("count", [0, 1])
def test_nothing_to_compare(session, count):
    frame = frame_of(session, np.arange(count), np.zeros((count, 3)))
    assert beespace.spark.pairs(frame, 5).collect() == []
    assert beespace.spark.at_risk(frame, 5).collect() == []
    assert beespace.spark.counts(frame, 5).count() == count


def test_pairs_of_a_crowd_come_in_pieces(session):
    ids = np.arange(3_000)
    frame = frame_of(session, ids, np.zeros((3_000, 3)))
    found = beespace.spark.pairs(frame, 5)
    row = found.selectExpr("count(*) AS n", "sum(first) AS f", "sum(second) AS s", "max(distance) AS d").first()
    in_all = 3_000 * 2_999 // 2
    assert in_all > 4_000_000
    assert row["n"] == in_all and row["d"] == 0 and row["f"] + row["s"] == 2_999 * int(ids.sum())
    assert found.where("first >= second").limit(1).collect() == []


def test_the_threshold_is_large_beside_the_swarm_and_that_is_said(session, caplog):
    ids, points = scenes.swarm("one_place")
    facts = beespace.spark.facts(frame_of(session, ids, points), 5, cell_points=100)
    assert facts.cells == 1 and facts.crowded_cells == 1
    assert any("cannot" in record.message or "large" in record.message for record in caplog.records)


def test_answers_are_lazy_and_have_types(session):
    ids, points = scenes.swarm("plane")
    found = beespace.spark.pairs(frame_of(session, ids, points), scenes.THRESHOLD)
    assert [(f.name, f.dataType.simpleString()) for f in found.schema] == [
        ("first", "bigint"), ("second", "bigint"), ("distance", "double")
    ]
