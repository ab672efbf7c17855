"""Conflicts of recordings are those of one machine bit for bit, however time is cut."""

from __future__ import annotations

import beespace
import beespace.spark
import numpy as np
import pandas
import pyarrow
import pyarrow.compute
import pytest
from beespace.spark import _windows
from beespace.spark._blocks import Columns
from beespace.spark._tubes import IntoCells, TubeSurveyor, facts_of
from beespace.spark._windows import ConflictsOf, Windows, join_conflicts

def flight(seed, agents=60, fixes=80, regular=False):
    """Agents that cross each other's ways again and again; some with pauses, some with one fix."""
    rng = np.random.default_rng(seed)
    ids, times, places = [], [], []
    for agent in range(agents):
        if regular:
            clock = np.arange(fixes, dtype=np.float64)
        else:
            count = int(rng.integers(1, fixes))
            clock = np.cumsum(rng.choice([0.5, 1.0, 1.0, 7.0], count)) + rng.integers(0, 20)
        ids.append(np.full(len(clock), agent * 7 + 100))
        times.append(clock)
        places.append(np.cumsum(rng.integers(-3, 4, (len(clock), 3)), axis=0) + rng.integers(0, 30, 3))
    return np.concatenate(ids), np.concatenate(times), np.concatenate(places).astype(np.float64)

def frame_of(session, ids, times, places, kind="long"):
    order = np.random.default_rng(0).permutation(len(ids))
    columns = {"id": ids, "time": times, "x": places[:, 0], "y": places[:, 1], "z": places[:, 2]}
    frame = pandas.DataFrame(columns).iloc[order]
    return session.createDataFrame(frame, f"id {kind}, time double, x double, y double, z double").repartition(3)

def compare(found, wanted):
    got = found.toPandas().sort_values(["first", "second", "begin", "end"], kind="stable")
    named = {"first": "i", "second": "j"}
    assert len(got) == len(wanted)
    for name in got.columns:
        np.testing.assert_array_equal(got[name].to_numpy(), getattr(wanted, named.get(name, name)))

@pytest.mark.parametrize("max_gap", [None, 1.0, 5.0])
@pytest.mark.parametrize("regular", [False, True])
def test_conflicts_are_those_of_one_machine(session, max_gap, regular):
    ids, times, places = flight(7, regular=regular)
    wanted = beespace.Recording(ids, times, places).conflicts(2.5, max_gap=max_gap)
    assert len(wanted) > 20
    frame = frame_of(session, ids, times, places)
    compare(beespace.spark.conflicts(frame, 2.5, max_gap=max_gap, window_fixes=100), wanted)
    compare(beespace.spark.conflicts(frame, 2.5, max_gap=max_gap), wanted)
    if max_gap is not None:
        gaps = beespace.spark.gaps(frame, max_gap).toPandas().sort_values(["id", "begin"])
        np.testing.assert_array_equal(gaps["id"], wanted.gaps.id)
        np.testing.assert_array_equal(gaps["begin"], wanted.gaps.begin)
        np.testing.assert_array_equal(gaps["end"], wanted.gaps.end)

def _sorted(batches, *keys):
    table = pyarrow.Table.from_batches([batch for batch in batches if batch.num_rows])
    return table.sort_by([(key, "ascending") for key in keys]).combine_chunks()

class _Counting(ConflictsOf):
    """How many fixes each cell of a window has."""

    def __call__(self, batches):
        batches = list(batches)
        table = pyarrow.Table.from_batches(batches)
        lengths = pyarrow.compute.binary_length(table.column("fixes"))
        table = table.select(["window", "cell"]).append_column("bytes", lengths)
        sums = table.group_by(["window", "cell"]).aggregate([("bytes", "sum")])
        self.fixes = sums.column("bytes_sum").to_numpy() // (8 * (1 + self.columns.width))
        yield from super().__call__(iter(batches))

def conflicts_without_spark(recorded, borders, gap, most, columns=Columns(3, False), unit=1.0, **arguments):
    """In windows that end at any borders, cut into cells with about so many fixes (None: not cut)."""
    ids, times, places = recorded
    order = np.lexsort((times, ids))
    table = pyarrow.table([each[order] for each in (ids, times, *places.T)], ["id", "time", *columns.names])
    windows = Windows(borders.tolist(), columns, gap)
    given = lambda: iter(table.to_batches(max_chunksize=2))
    cells = 0
    into = windows
    if most is not None:
        rows = pyarrow.Table.from_batches(list(TubeSurveyor(windows, columns)(given()))).to_pylist()
        reach = [arguments["threshold"]] * columns.searched
        facts = [
            facts_of([row for row in rows if row["window"] == at], reach, most) for at in range(len(borders) + 1)
        ]
        windows.parts = [[0] * len(each.sizes) for each in facts]
        cells = max(len(each.sizes) for each in facts)
        into = IntoCells(windows, columns, {at: each.cut for at, each in enumerate(facts) if each.cut})
    rows = _sorted(into(given()), "window", "cell", "id", "first")
    ask = _Counting(columns, unit, gap, arguments)
    found = list(ask(iter(rows.to_batches(max_chunksize=5))))
    if not found:
        return None, cells, ask.fixes
    parts = _sorted(found, "first", "second", "window", "begin", "end")
    return pyarrow.Table.from_batches(list(join_conflicts(iter(parts.to_batches(max_chunksize=3))))), cells, ask.fixes

def check_without_spark(recorded, borders, gap, most, **more):
    ids, times, places = recorded
    recording = beespace.Recording(ids, times, places)
    wanted = recording.conflicts(2.5, max_gap=None if gap == np.inf else gap)
    got, cells, fixes = conflicts_without_spark(recorded, borders, gap, most, threshold=2.5, **more)
    same_conflicts(got, wanted)
    return cells, fixes, len(wanted)

def same_conflicts(got, wanted):
    assert (0 if got is None else got.num_rows) == len(wanted)
    if got is not None:
        for name, other in (("first", "i"), ("second", "j"), ("begin", "begin"), ("end", "end"),
                            ("closest_time", "closest_time"), ("closest_distance", "closest_distance")):
            np.testing.assert_array_equal(got.column(name).to_numpy(), getattr(wanted, other))

@pytest.fixture
def little_at_once(monkeypatch):
    # What is carried from one piece of work to the next counts, too.
    monkeypatch.setattr(_windows, "_FIXES_AT_ONCE", 3)

def spread(seed, agents, regular=True, far=0):
    """Agents that cross each other's ways here and there in a wide plane, some of which go far."""
    ids, times, places = flight(seed, agents, 12, regular)
    rng = np.random.default_rng(seed)
    places = places + rng.integers(0, 24, (ids.max() + 1, 3))[ids] * [12, 12, 0]
    goes_far = ids < np.unique(ids)[far]
    places[goes_far] += rng.integers(-90, 90, (int(goes_far.sum()), 3)) * [1, 1, 0]
    return ids, times, places

@pytest.mark.parametrize("most", [None, 60])
def test_every_border_that_there_can_be(little_at_once, most):
    """Without Spark between: windows that end at each time there is, and in between; cut into cells, too."""
    most_cells = 0
    for seed in range(8 if most is None else 2):
        regular = seed % 2 == 0
        recorded = flight(seed, 14, 30, regular) if most is None else spread(seed, 60, regular, far=2)
        instants = np.unique(recorded[1])
        between = (instants[1:] + instants[:-1]) / 2
        for borders in (instants[:-1], between, np.union1d(instants[:-1], between), instants[3:4]):
            for gap in (np.inf, 1.0) if len(borders) < 60 else (1.0,):
                cells, _, _ = check_without_spark(recorded, borders, gap, most)
                most_cells = max(most_cells, cells)
    assert most_cells > 2 or most is None

@pytest.mark.parametrize("far", [0, 40])
def test_windows_with_more_agents_than_fit_are_cut_into_cells(far):
    recorded = spread(11, 900, far=far)
    cells, fixes, found = check_without_spark(recorded, np.array([5.0]), np.inf, 800)
    assert found > 100 and cells > 8
    assert fixes.max() <= 1.6 * 800, fixes
    # Nothing is lost where all tubes but one are longer than those of the sample.
    check_without_spark(spread(12, 200, regular=False, far=199), np.array([5.0, 9.5]), 1.0, 300)

@pytest.mark.parametrize("most", [None, 300])
def test_heights_apart_in_feet(most):
    ids, times, places = spread(21, 300)
    recorded = ids, times, places * [1, 1, 500]
    columns = Columns(2, False, True)
    apart = {"threshold": 3.0, "vertical": 1_000.0, "inclusive": True}
    got, cells, _ = conflicts_without_spark(
        recorded, np.array([3.0, 6.5]), np.inf, most, columns, 0.3048, **apart
    )
    recording = beespace.Recording(ids, times, places[:, :2], heights=places[:, 2] * 500, height_unit=0.3048)
    wanted = recording.conflicts(3.0, vertical=1_000.0, inclusive=True)
    assert 20 < len(wanted) < len(recording.conflicts(3.0, vertical=1e9))
    assert most is None or cells > 4
    same_conflicts(got, wanted)

def test_cells_and_feet_on_a_cluster(session, caplog):
    ids, times, places = spread(11, 500, far=10)
    frame = frame_of(session, ids, times, places)
    frame = frame.selectExpr("id", "time", "8 + x / 1e5 AS lon", "47 + y / 1e5 AS lat", "z * 500 AS feet")
    found = beespace.spark.conflicts(
        frame, 4, lon="lon", lat="lat", height="feet", vertical=1_000, height_unit=0.3048, window_fixes=500
    )
    ground = beespace.to_ecef(8 + places[:, 0] / 1e5, 47 + places[:, 1] / 1e5, 0.0)
    recording = beespace.Recording(ids, times, ground, heights=places[:, 2] * 500, height_unit=0.3048)
    wanted = recording.conflicts(4, vertical=1_000)
    assert len(wanted) > 50
    compare(found, wanted)

def test_agents_too_close_to_cut_space_are_searched_whole_and_that_is_said(session, caplog):
    recorded = flight(7, regular=True)
    wanted = beespace.Recording(*recorded).conflicts(30)
    compare(beespace.spark.conflicts(frame_of(session, *recorded), 30, window_fixes=60), wanted)
    assert any("is too large beside them" in record.message for record in caplog.records)

def test_texts_as_ids_and_timestamps(session):
    rows = [("zoë", 0, 0.0, 0.0), ("bob", 0, 100.0, 3.0), ("zoë", 10, 100.0, 0.0), ("bob", 10, 0.0, 3.0)]
    frame = session.createDataFrame(rows, "id string, s long, x double, y double")
    frame = frame.selectExpr("id", "timestamp_seconds(s) AS at", "x", "y")
    (row,) = beespace.spark.conflicts(frame, 5, time="at", z=None).collect()
    seconds, x, y = (np.array(each, np.float64) for each in zip(*[row[1:] for row in rows]))
    wanted = beespace.Recording([row[0] for row in rows], seconds, (x, y)).conflicts(5)
    assert (row["first"], row["second"]) == ("bob", "zoë") == (wanted.i[0], wanted.j[0])
    told = [row[name] for name in ("begin", "end", "closest_time", "closest_distance")]
    assert told == [wanted.begin[0], wanted.end[0], wanted.closest_time[0], wanted.closest_distance[0]]

def test_two_fixes_of_an_agent_at_one_time(session):
    rows = [(1, 0.0, 0.0, 0.0), (1, 0.0, 5.0, 0.0), (1, 2.0, 9.0, 0.0)]
    frame = session.createDataFrame(rows, "id long, time double, x double, y double")
    with pytest.raises(Exception, match="the agent 1 has two fixes at 0.0 s"):
        beespace.spark.conflicts(frame, 5, z=None).collect()

@pytest.mark.parametrize(
    ("arguments", "code", "place"),
    [
        ({"time": "when"}, "missing_column", "time"),
        ({"id": "x"}, "invalid_argument", "id"),
        ({"y": "text"}, "invalid_argument", "y"),
        ({"threshold": -1}, "invalid_threshold", "threshold"),
        ({"max_gap": 0}, "invalid_argument", "max_gap"),
        ({"window_fixes": 0}, "invalid_argument", "window_fixes"),
        ({"height": "time"}, "invalid_argument", "height"),
        ({"height_unit": 0.3048}, "invalid_argument", "height_unit"),
    ],
)
def test_columns_of_recordings_are_checked_without_a_job(session, arguments, code, place):
    frame = session.range(1).selectExpr(
        "id", "cast(raise_error('read') AS double) AS time", "1.5D AS x", "2.5D AS y", "'a' AS text"
    )
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.spark.conflicts(frame, **{"threshold": 5, "z": None, **arguments})
    assert caught.value.code == code and caught.value.place == place

def test_fixes_that_cannot_be_used_are_counted(session):
    rows = [(1, 0.0, 0.0), (2, float("nan"), 5.0), (3, 2.0, None)]
    frame = session.createDataFrame(rows, "id long, time double, x double").selectExpr("*", "x AS y")
    with pytest.raises(beespace.BeespaceError, match="2 of 3 fixes cannot be used"):
        beespace.spark.conflicts(frame, 5, z=None)

@pytest.mark.parametrize(
    ("columns", "value"),
    [
        ({"lon": "x", "lat": "y", "height": "z"}, -91.0),
        ({"lon": "x", "lat": "y", "height": "z", "vertical": 10}, 91.0),
        ({"z": None, "height": "z", "vertical": 10}, 1e200),
        ({}, 1e-200),
    ],
)
def test_fixes_that_are_nowhere_are_counted(session, columns, value):
    rows = [(1, 0.0, 8.0, 47.0, 0.0), (2, 1.0, 8.0, value, 0.0), (3, 2.0, 8.0, 47.0, -0.0)]
    frame = session.createDataFrame(rows, "id long, time double, x double, y double, z double")
    with pytest.raises(beespace.BeespaceError, match="1 of 3 fixes cannot be used; one of them: id 2") as caught:
        beespace.spark.conflicts(frame, 5, **columns)
    assert caught.value.code == "outside_domain"
