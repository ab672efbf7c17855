"""Recordings: conflicts and gaps are those of fractions; what cannot be is named."""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import recording_oracle

import beespace


def lattice(random: np.random.Generator, agents: int):
    """Small whole numbers of places and times, rows by time: what can be at an edge is."""
    rows = []
    for agent in range(agents):
        time = int(random.integers(0, 4))
        for _ in range(int(random.integers(1, 7))):
            rows.append((time, 7 * agent - 20, *random.integers(-4, 5, 2), random.integers(-2, 3)))
            time += int(random.integers(1, 5))
    rows.sort(key=lambda row: row[0])
    table = np.array(rows, float)
    return table[:, 1].astype(np.int64), table[:, 0], table[:, 2:]


@pytest.mark.parametrize("max_gap", [None, 3.0, 1.5])
@pytest.mark.parametrize("vertical", [None, 2.0])
@pytest.mark.parametrize("inclusive", [False, True])
def test_conflicts_are_those_of_fractions(max_gap, vertical, inclusive):
    random = np.random.default_rng(11)
    edges = 0
    for threshold in (1.0, 2.0, math.nextafter(2.0, 0), math.nextafter(2.0, 3), math.sqrt(5)):
        for _ in range(3):
            ids, times, positions = lattice(random, 10)
            recording = beespace.Recording(ids, times, positions)
            found = recording.conflicts(
                threshold, max_gap=max_gap, vertical=vertical, inclusive=inclusive
            )
            tracks = recording_oracle.tracks_of(ids, times, positions)
            limit = math.inf if max_gap is None else max_gap
            expected = recording_oracle.conflicts(tracks, threshold, limit, vertical, inclusive)
            assert list(zip(found.i, found.j)) == [(i, j) for i, j, _ in expected]
            columns = [found.begin, found.end, found.closest_time, found.closest_distance]
            values = np.array([row for _, _, row in expected]).reshape(-1, 4)
            # Of passes one ulp inside the threshold, times are roots of some roundings: 1e-8.
            near = np.isclose(np.array(columns).T, values, rtol=1e-12, atol=1e-7)
            # Of several instants at which they are equally close, any is right.
            assert near[:, [0, 1, 3]].all()
            assert list(zip(found.gaps.id, found.gaps.begin, found.gaps.end)) == (
                recording_oracle.gaps(tracks, limit)
            )
            edges += len(expected) != len(
                recording_oracle.conflicts(tracks, threshold, limit, vertical, not inclusive)
            )
    assert edges  # or the lattice would show nothing about passes at exactly the threshold


@pytest.mark.parametrize("max_gap", [None, 2.0])
def test_the_closest_two_are_as_close_as_fractions_say(max_gap):
    random = np.random.default_rng(12)
    for agents in (2, 3, 6):
        for _ in range(6):
            ids, times, positions = lattice(random, agents)
            positions += random.uniform(-1, 1, positions.shape)
            tracks = recording_oracle.tracks_of(ids, times, positions)
            limit = math.inf if max_gap is None else max_gap
            least = recording_oracle.least_squared_distance(tracks, limit)
            found = beespace.Recording(ids, times, positions).closest(max_gap=max_gap)
            gaps = list(zip(found.gaps.id, found.gaps.begin, found.gaps.end))
            assert gaps == recording_oracle.gaps(tracks, limit)
            assert (found.distance is None) == (least is None)
            if found.distance is None:
                assert found[:4] == (None,) * 4
                continue
            assert math.isclose(found.distance, math.sqrt(least), rel_tol=1e-12, abs_tol=1e-12)
            assert found.i < found.j


def test_a_pass_between_two_fixes_at_the_threshold_and_one_ulp_beside_it():
    recording = beespace.Recording([1, 2, 1, 2], [0, 0, 10, 10], [[0, 0], [9, 3], [9, 0], [0, 3]])
    for threshold, inclusive, expected in [
        (3, False, 0),
        (3, True, 1),
        (math.nextafter(3, 0), True, 0),
        (math.nextafter(3, 4), False, 1),
    ]:
        assert len(recording.conflicts(threshold, inclusive=inclusive)) == expected


def test_many_threads_may_ask_one_recording():
    recording = beespace.Recording(*lattice(np.random.default_rng(14), 40))
    expected = recording.conflicts(2)
    assert len(expected)
    with ThreadPoolExecutor(8) as threads:
        for found in threads.map(lambda _: recording.conflicts(2), range(80)):
            assert np.array_equal(found.i, expected.i)
            assert np.array_equal(found.begin, expected.begin)


def test_a_gap_is_unknown_and_the_answer_says_so():
    recording = beespace.Recording([1, 2, 1, 2], [0, 0, 10, 10], [[0, 0], [9, 3], [9, 0], [0, 3]])
    bridged = recording.conflicts(5, max_gap=10)
    assert len(bridged) == 1 and len(bridged.gaps) == 0
    unknown = recording.conflicts(5, max_gap=math.nextafter(10, 0))
    assert len(unknown) == 0
    assert unknown.gaps.id.tolist() == [1, 2]
    assert (unknown.gaps.begin.tolist(), unknown.gaps.end.tolist()) == ([0, 0], [10, 10])
    assert "nothing is known" in repr(unknown)
    assert "no gaps" in repr(bridged)


def test_where_no_two_are_known_together_the_gaps_say_why():
    recording = beespace.Recording([1, 2, 1, 2], [0, 1, 10, 9], [[0, 0], [9, 3], [9, 0], [0, 3]])
    closest = recording.closest(max_gap=2)
    assert closest[:4] == (None,) * 4
    assert (closest.gaps.id.tolist(), closest.gaps.begin.tolist()) == ([1, 2], [0, 1])
    assert "2 gaps of 2 agents, 18 s in all, of which nothing is known" in repr(closest)


@pytest.mark.parametrize("unit", [1.0, 0.3048])
def test_heights_apart_are_compared_as_they_are(unit):
    # Two fly side by side, 3 m apart; in height they come within 2 of each other and pass.
    ids, times = [1, 2, 1, 2], [0, 0, 10, 10]
    positions = [[6378137, 0, 0], [6378137, 3, 0], [6378137, 900, 70], [6378137, 903, 70]]
    recording = beespace.Recording(
        ids, times, positions, heights=[0, 10, 20, 10], height_unit=unit
    )
    found = recording.conflicts(5, vertical=2)
    assert np.allclose([found.begin, found.end, found.closest_time], [[4], [6], [5]])
    assert np.allclose(found.closest_distance, 3)
    assert len(recording.conflicts(3, vertical=2)) == 0
    frame = {"who": ids, "t": times, "h": [0, 10, 20, 10]}
    frame |= dict(zip("xyz", np.array(positions, float).T))
    names = {"id": "who", "time": "t", "x": "x", "y": "y", "z": "z", "height": "h"}
    again = beespace.Recording.from_frame(frame, **names, height_unit=unit).conflicts(5, vertical=2)
    assert np.array_equal(again.begin, found.begin)
    for ask in (lambda: recording.conflicts(5), recording.closest):
        with pytest.raises(beespace.BeespaceError) as caught:
            ask()
        assert caught.value.code == "invalid_argument" and "heights" in str(caught.value)


@pytest.mark.parametrize(
    ("heights", "unit", "code", "record"),
    [
        ([0, 1, math.nan, 3], 1.0, "not_finite", 2),
        ([0, 1, 2, 1e31], 1.0, "outside_domain", 3),
        ([0, 1, 2], 1.0, "invalid_argument", None),
        (["a", "b", "c", "d"], 1.0, "invalid_argument", None),
    ],
)
def test_heights_that_cannot_be_are_named(heights, unit, code, record):
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.Recording([1, 2, 1, 2], [0, 0, 1, 1], [[0, 0]] * 4, heights=heights, height_unit=unit)
    assert (caught.value.code, caught.value.place, caught.value.record) == (code, "heights", record)


def _recorded(unit, heights):
    return beespace.Recording([1, 2], [0, 0], [[0, 0, 0], [3, 4, 500]], heights=heights, height_unit=unit)


def _reported(unit, heights):
    swarm = beespace.Swarm(5, vertical=1, heights_apart=heights is not None, height_unit=unit)
    swarm.update([1, 2], 0, [[0, 0, 0], [3, 4, 500]], heights=heights)


def _added(unit, heights):
    search = beespace.OutOfCore("100 MB", height_unit=unit)
    search.add([[0, 0, 0], [3, 4, 500]], heights=heights)
    search.at_risk(5, vertical=1)


@pytest.mark.parametrize("give", [_recorded, _reported, _added])
def test_a_unit_is_one_of_heights_that_are_apart(give):
    for unit in (0, -1, math.nan, math.inf, 1e40):
        with pytest.raises(beespace.BeespaceError) as caught:
            give(unit, [0, 500])
        assert (caught.value.code, caught.value.place) == ("invalid_argument", "height_unit")
    # z is in metres: a unit would be passed over.
    with pytest.raises(beespace.BeespaceError, match="no heights apart") as caught:
        give(1000, None)
    assert (caught.value.code, caught.value.place) == ("invalid_argument", "height_unit")
    give(1.0, None)
    give(1000, [0, 500])


def test_ids_are_those_that_were_given():
    times, positions = [0, 0, 0, 5, 5, 5], [[0, 0], [9, 0], [1, 0]] * 2
    for ids, expected in [
        ([3, 7, -1], (-1, 3)),
        (["c", "b", "a"], ("a", "c")),
        (np.array([3, 7, 1], np.uint8), (1, 3)),
        (np.array([2**64 - 1, 7, 2**63], np.uint64), (2**63, 2**64 - 1)),
        (np.array(["x", "y", "a long one"], object), ("a long one", "x")),
    ]:
        recording = beespace.Recording(np.tile(np.asarray(ids), 2), times, positions)
        found = recording.conflicts(2)
        assert (found.i.tolist(), found.j.tolist()) == ([expected[0]], [expected[1]])
        closest = recording.closest()
        assert (closest.i, closest.j, closest.distance) == (*expected, 1)


def test_any_layout_is_read():
    random = np.random.default_rng(13)
    ids, times, positions = lattice(random, 12)
    expected = beespace.Recording(ids, times, positions).conflicts(2)
    assert len(expected)
    table = np.column_stack([ids, times, positions])
    for given in [
        (ids.tolist(), times.tolist(), positions.tolist()),
        (ids.astype(np.int32), times.astype(np.float32), positions.astype(np.float32)),
        (ids, table[:, 1], table[:, 2:]),
        (ids, times.astype(int), tuple(positions.T)),
    ]:
        found = beespace.Recording(*given).conflicts(2, threads=2)
        assert np.array_equal(found.i, expected.i) and np.array_equal(found.begin, expected.begin)


def test_rows_that_cannot_be_are_named():
    ids, times, positions = [1, 2, 1, 2], [0.0, 0.0, 1.0, 1.0], np.arange(12.0).reshape(4, 3)
    bad = positions.copy()
    bad[2, 1] = np.nan
    dates = np.array([0, 0, 1, 1], "datetime64[s]")
    make = beespace.Recording
    for call, code, place, record in [
        (lambda: make(ids, [0, 0, 0, 1], positions), "time_order", "times", 2),
        (lambda: make(ids, [0, 2, 1, 1], positions), "time_order", "times", 3),
        (lambda: make(ids, [0, 0, np.nan, 1], positions), "not_finite", "times", 2),
        (lambda: make(ids, times, bad), "not_finite", "positions", 2),
        (lambda: make(ids, times, bad * 1e40), "outside_domain", "positions", 0),
        (lambda: make(ids[:3], times, positions), "invalid_argument", "ids", None),
        (lambda: make(ids, times[:3], positions), "invalid_argument", "times", None),
        (lambda: make([1.0, 2, 1, 2], times, positions), "invalid_argument", "ids", 0),
        (lambda: make([1.0] * 4, times, positions), "invalid_argument", "ids", None),
        (lambda: make(["a", None, "a", "b"], times, positions), "invalid_argument", "ids", 1),
        (lambda: make(ids, dates, positions), "invalid_argument", "times", None),
        (lambda: make(ids, np.array([1, 1, 2, 2]) * 2**60, positions), "invalid_argument", "times", None),
        (lambda: make(ids, times, positions).conflicts(0), "invalid_threshold", "threshold", None),
        (lambda: make(ids, times, positions).conflicts(1, max_gap=0), "invalid_argument", "max_gap", None),
        (lambda: make(ids, times, positions).conflicts(99, max_results=0), "too_many_results", "max_results", None),
        (lambda: make(ids, times, positions).closest(max_gap="no"), "invalid_argument", "max_gap", None),
    ]:  # fmt: skip
        with pytest.raises(beespace.BeespaceError) as caught:
            call()
        error = caught.value
        assert (error.code, error.place, error.record) == (code, place, record), str(error)


frame = {"id": ["a", "b", "a"], "t": [0, 0, 1], "x": [0, 3, 0], "y": [0, 4, 0], "alt": [5, 5, 5]}


def test_columns_of_a_frame_are_named_and_none_is_guessed():
    make = beespace.Recording.from_frame
    recording = make(frame, id="id", time="t", x="x", y="y", z="alt")
    assert repr(recording) == "<beespace.Recording: 3 fixes of 2 agents, 0 to 1 s>"
    assert len(recording) == 3
    assert recording.closest().distance == 5
    with pytest.raises(TypeError):
        make(frame)
    with pytest.raises(beespace.BeespaceError, match="it has: id, t, x, y, alt") as caught:
        make(frame, id="id", time="time", x="x", y="y")
    assert (caught.value.code, caught.value.place) == ("missing_column", "time")


@pytest.mark.parametrize("library", ["pandas", "polars"])
def test_frames_of_libraries_are_read(library):
    module = pytest.importorskip(library)
    given = module.DataFrame(frame)
    recording = beespace.Recording.from_frame(given, id="id", time="t", x="x", y="y", z="alt")
    found = recording.conflicts(6, max_gap=0.5)
    assert (found.i.tolist(), found.j.tolist()) == (["a"], ["b"])
    assert len(getattr(found, f"to_{library}")()) == 1
    assert len(getattr(found.gaps, f"to_{library}")()) == 1


def test_answers_tell_what_is_in_them():
    assert repr(beespace.Recording([], [], [])) == "<beespace.Recording: 0 fixes of 0 agents>"
    assert repr(beespace.Recording([], [], []).closest()) == (
        "<Encounter: no two agents are known at the same time; no gaps>"
    )
    assert len(beespace.Recording([], [], []).conflicts(5)) == 0
    one = beespace.Recording(["a"], [3], [[0, 0]])
    assert repr(one) == "<beespace.Recording: 1 fix of 1 agent, at 3 s>"
    assert repr(one.conflicts(5)) == "<RecordedConflicts: 0 conflicts of 1 agent; no gaps>"
    two = beespace.Recording(["a", "b"], [3, 3], [[0, 0], [0, 4]])
    assert repr(two.conflicts(5)) == (
        "<RecordedConflicts: 1 conflict of 2 agents, from 3 to 3 s, closest a and b: 4 m at 3 s; "
        "no gaps>"
    )
    assert repr(two.closest()) == "<Encounter: a and b, 4 m at 3 s; no gaps>"
