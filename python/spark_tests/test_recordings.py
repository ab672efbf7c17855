"""Conflicts of recordings are those of one machine bit for bit, however time is cut."""

from __future__ import annotations

import beespace
import beespace.spark
import numpy as np
import pandas
import pytest

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

def test_every_border_that_there_can_be(session):
    """Without Spark between: windows that end at each time there is, and in between."""
    import pyarrow
    from beespace.spark import _windows
    from beespace.spark._blocks import Columns
    from beespace.spark._windows import ConflictsOf, Windows, join_conflicts

    for seed in range(8):
        ids, times, places = flight(seed, 14, 30, regular=seed % 2 == 0)
        order = np.lexsort((times, ids))
        arrays = [ids, times, *places.T]
        table = pyarrow.table([each[order] for each in arrays], ["id", "time", "x", "y", "z"])
        instants = np.unique(times)
        between = (instants[1:] + instants[:-1]) / 2
        for borders in (instants[:-1], between, np.union1d(instants[:-1], between), instants[3:4]):
            for gap in (np.inf, 1.0):
                windows = Windows(borders.tolist(), list(range(len(borders) + 1)), Columns(3, False), gap)

                # What is carried from one piece of work to the next counts, too.
                kept, _windows._FIXES_AT_ONCE = _windows._FIXES_AT_ONCE, 3
                try:
                    pieces = list(windows(iter(table.to_batches(max_chunksize=2))))
                finally:
                    _windows._FIXES_AT_ONCE = kept
                rows = pyarrow.Table.from_batches(pieces)
                rows = rows.sort_by([("window", "ascending"), ("id", "ascending"), ("first", "ascending")])
                ask = ConflictsOf(3, gap, {"threshold": 2.5})
                found = list(ask(iter(rows.combine_chunks().to_batches())))
                wanted = beespace.Recording(ids, times, places).conflicts(
                    2.5, max_gap=None if gap == np.inf else gap
                )
                joined = []
                if found:
                    keys = ("first", "second", "window", "begin", "end")
                    parts = pyarrow.Table.from_batches(found).sort_by([(key, "ascending") for key in keys])
                    joined = list(join_conflicts(iter(parts.combine_chunks().to_batches(max_chunksize=3))))
                got = pyarrow.Table.from_batches(joined) if joined else None
                assert (0 if got is None else got.num_rows) == len(wanted)
                if got is not None:
                    for name, other in (("first", "i"), ("second", "j"), ("begin", "begin"), ("end", "end"),
                                        ("closest_time", "closest_time"), ("closest_distance", "closest_distance")):
                        np.testing.assert_array_equal(got.column(name).to_numpy(), getattr(wanted, other))

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

def test_fixes_that_cannot_be_used_are_counted(session):
    rows = [(1, 0.0, 0.0), (2, float("nan"), 5.0), (3, 2.0, None)]
    frame = session.createDataFrame(rows, "id long, time double, x double").selectExpr("*", "x AS y")
    with pytest.raises(beespace.BeespaceError, match="2 of 3 fixes cannot be used"):
        beespace.spark.conflicts(frame, 5, z=None)
