"""Live swarms: events are those of fractions, whenever they are asked for; silence is not absence; what
cannot be is named, and all else counts."""

from __future__ import annotations

import math
import threading
from fractions import Fraction

import live_oracle
import motion_oracle
import numpy as np
import pytest
import recording_oracle

import beespace


def lattice(random: np.random.Generator, agents: int):
    """Reports in the order of their times: small whole numbers, some silences, some heard of once."""
    rows = []
    for agent in range(agents):
        time = int(random.integers(0, 5))
        place = random.integers(-5, 6, 3)
        for _ in range(int(random.integers(1, 14))):
            rows.append((time, 10 * agent - 20, *place))
            place = place + random.integers(-3, 4, 3)
            time += int(random.choice([1, 1, 1, 2, 2, 3, 6]))
            if time > 12:
                break
    return np.array(sorted(rows), float)


def replayed(swarm: beespace.Swarm, rows, random, now: float):
    """All events, asked for at random times."""
    told = []
    for time in np.unique(rows[:, 0]):
        these = rows[rows[:, 0] == time]
        random.shuffle(these)
        swarm.update(these[:, 1].astype(int), time, these[:, 2:])
        if random.random() < 0.5:
            told += list(swarm.advance(time))
    return told + list(swarm.finish(now))


@pytest.mark.parametrize("vertical", [None, 2.0])
@pytest.mark.parametrize("leave_factor", [1.5, 2.0])
def test_events_are_those_of_fractions(vertical, leave_factor):
    random = np.random.default_rng(21)
    seen, count = set(), 0
    for threshold in (2.0, 3.0, math.nextafter(3.0, 4), math.sqrt(5)):
        for later in (0.0, 1.0, 20.0):
            rows = lattice(random, 9)
            now = rows[-1, 0] + later
            swarm = beespace.Swarm(
                threshold, vertical=vertical, leave_factor=leave_factor, max_age=2.5, horizon=0
            )
            events = replayed(swarm, rows, random, now)
            tracks = recording_oracle.tracks_of(rows[:, 1].astype(int), rows[:, 0], rows[:, 2:])
            expected, closest = live_oracle.encounters(
                tracks, threshold, leave_factor, 2.5, now, vertical
            )
            pairs = [event for event in events if event.kind in _of_pairs]
            found = sorted(((e.kind, e.i, e.j, e.time) for e in pairs), key=_order)
            expected.sort(key=_order)
            assert [each[1:3] for each in found] == [each[1:3] for each in expected]
            assert all(each[0] in right[0].split(" or ") for each, right in zip(found, expected))
            assert np.allclose([e[3] for e in found], [e[3] for e in expected], atol=1e-7)
            silent = [(e.kind, e.i, e.j, e.time) for e in events if e.kind in ("stale", "heard")]
            assert sorted(silent) == sorted(live_oracle.silences(tracks, 2.5, now))
            for i, j, (begin, end, distance) in closest:
                passed = [
                    e.distance
                    for e in events
                    if (e.kind, e.i, e.j) == ("closest_passed", i, j) and begin <= e.time <= end
                ]
                has_left = any(
                    (e.kind, e.i, e.j) == ("left", i, j) and abs(e.time - end) < 1e-6 for e in events
                )
                assert passed or not has_left
                assert not passed or abs(min(passed) - distance) < 1e-7
                count += bool(passed)
            seen |= {event.kind for event in events}
    assert count >= 3
    assert seen == {"entered", "closest_passed", "left", "lost", "ended", "stale", "heard"}


_of_pairs = ("entered", "left", "lost", "ended")


def _order(told):
    """By pair and time; of one instant, what begins last."""
    return (told[1], told[2], round(told[3], 6), told[0] == "entered")


@pytest.mark.parametrize("vertical", [None, 2.0])
def test_what_is_predicted_is_what_fractions_predict(vertical):
    random = np.random.default_rng(22)
    predicted = 0
    for _ in range(8):
        places, speeds = random.integers(-9, 10, (2, 14, 3)).astype(float)
        swarm = beespace.Swarm(2, vertical=vertical, horizon=3)
        swarm.update(np.arange(14), 0, places, speeds)
        events = swarm.advance(0)
        now, ahead = set(), set()
        for i in range(14):
            for j in range(i + 1, 14):
                apart = tuple(map(Fraction, places[j] - places[i]))
                speed = tuple(map(Fraction, speeds[j] - speeds[i]))
                for until, into in ((Fraction(0), now), (Fraction(3), ahead)):
                    if motion_oracle.in_conflict(
                        apart, speed, (Fraction(0), until), 2, vertical, False
                    ):
                        into.add((i, j))
        found = {kind: set() for kind in ("entered", "predicted")}
        for event in events:
            found[event.kind].add((event.i, event.j))
        assert found == {"entered": now, "predicted": ahead - now}
        predicted += len(ahead - now)
    assert predicted > 10


def test_a_silent_agent_is_said_to_be_possibly_anywhere_it_can_be():
    for max_speed, expected in ((None, []), (1.0, []), (6.0, ["possible"])):
        swarm = beespace.Swarm(5, max_age=2, horizon=0, max_speed=max_speed)
        swarm.update([1, 2], 0, [[0, 0], [40, 0]])
        for time in range(1, 6):
            swarm.update([2], time, [[40, 0]])
        told = [event for event in swarm.advance(5) if event.kind != "stale"]
        assert [event.kind for event in told] == expected
        assert all((event.i, event.j, event.since) == (1, 2, 0) for event in told)
    known = swarm.movers(5)
    assert known.stale.tolist() == [True, False]
    assert known.moves.tolist() == [False, True]
    assert known.heard.tolist() == [0, 5]
    assert known.unknown.tolist() == [5, 0]
    assert "1 stale" in repr(known) and "a stale one" in repr(swarm)


def test_reports_that_are_left_out_are_counted():
    swarm = beespace.Swarm(5, max_agents=2)
    swarm.update([1, 1, 1, 1, 2], [0, 2, 2, 1, 0], [[0, 0], [1, 0], [1, 0], [9, 9], [50, 0]])
    swarm.update([1], [2], [[7, 7]])
    with pytest.raises(beespace.BeespaceError) as caught:
        swarm.update([3, 1, 4], 3, [[0, 0], [2, 0], [0, 1]])
    assert (caught.value.code, caught.value.place, caught.value.record) == (
        "too_many_points",
        "ids",
        0,
    )
    assert "2 of 3 reports were refused, the others count" in str(caught.value)
    counts = swarm.counts
    assert counts[:5] == (4, 1, 1, 1, 2)
    overloaded = [event for event in swarm.advance(3) if event.kind == "overloaded"]
    assert [(e.bound, e.i, e.left_out) for e in overloaded] == [("agents", 3, 2)]


@pytest.mark.parametrize(
    ("change", "code", "place", "record"),
    [
        ({"ids": [1, 2, 2**63]}, "invalid_argument", "ids", None),
        ({"ids": ["a", "b", "c"]}, "invalid_argument", "ids", None),
        ({"ids": [1, 2]}, "invalid_argument", "ids", None),
        ({"ids": [1.0, 2.0, 3.0]}, "invalid_argument", "ids", None),
        ({"times": [0, math.nan, 0]}, "not_finite", "times", 1),
        ({"times": math.inf}, "not_finite", "times", 0),
        ({"times": [0, 1]}, "invalid_argument", "times", None),
        ({"times": "now"}, "invalid_argument", "times", None),
        ({"positions": [[0, 0], [0, 0], [0, 1e31]]}, "outside_domain", "positions", 2),
        ({"positions": [[0], [0], [0]]}, "invalid_argument", "positions", None),
        ({"velocities": [[0, 0]]}, "invalid_argument", "velocities", None),
        ({"velocities": [[0, 0], [math.nan, 0], [0, 0]]}, "not_finite", "velocities", 1),
        ({"heights": [0, 1, 2]}, "invalid_argument", "heights", None),
        ({"climbs": [0, 1, 2]}, "invalid_argument", "climbs", None),
    ],
)
def test_reports_that_cannot_be_are_named_and_the_others_count(change, code, place, record):
    swarm = beespace.Swarm(5)
    given = {"ids": [1, 2, 3], "times": 0, "positions": [[0, 0], [20, 0], [40, 0]]}
    with pytest.raises(beespace.BeespaceError) as caught:
        swarm.update(**{**given, **change})
    assert (caught.value.code, caught.value.place, caught.value.record) == (code, place, record)
    refused = 3 if record is None or change.get("times") == math.inf else 1
    assert swarm.counts.taken == 3 - refused


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ({"threshold": 0}, "invalid_threshold"),
        ({"threshold": math.nan}, "invalid_threshold"),
        ({"threshold": None}, "invalid_threshold"),
        ({"vertical": -1}, "invalid_threshold"),
        ({"leave_factor": 0.9}, "invalid_argument"),
        ({"leave_factor": 0}, "invalid_argument"),
        ({"max_age": 0}, "invalid_argument"),
        ({"max_age": "long"}, "invalid_argument"),
        ({"horizon": -1}, "invalid_argument"),
        ({"height_unit": 0}, "invalid_argument"),
        ({"max_speed": math.inf}, "invalid_argument"),
        ({"max_agents": 0}, "invalid_argument"),
        ({"max_pairs": -1}, "invalid_argument"),
        ({"threads": 1.5}, "invalid_argument"),
        ({"heights_apart": True}, "invalid_argument"),
    ],
)
def test_options_that_make_no_sense_are_refused(options, code):
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.Swarm(**{"threshold": 5, **options})
    assert caught.value.code == code


def test_time_never_goes_back():
    swarm = beespace.Swarm(5)
    swarm.advance(3)
    for now, code in ((2, "time_order"), (math.nan, "not_finite"), ("late", "invalid_argument")):
        with pytest.raises(beespace.BeespaceError) as caught:
            swarm.advance(now)
        assert caught.value.code == code
    with pytest.raises(beespace.BeespaceError) as caught:
        swarm.movers(math.inf)
    assert caught.value.code == "not_finite"
    assert len(swarm.advance(3)) == 0


def test_heights_apart_are_compared_as_they_are():
    swarm = beespace.Swarm(5, vertical=300, heights_apart=True, height_unit=0.3048, horizon=20)
    ids, places = [1, 2], [[6378137, 0, 0], [6378137, 3, 0]]
    with pytest.raises(beespace.BeespaceError, match="heights"):
        swarm.update(ids, 0, places)
    swarm.update(ids, 0, places, np.zeros((2, 3)), heights=[1000, 2000], climbs=[50, 0])
    (ahead,) = swarm.advance(0)
    assert (ahead.kind, ahead.time, ahead.closest_time) == ("predicted", 14, 20)
    swarm.update(ids, 4, places, heights=[1800, 2000])
    entered = swarm.advance(4)
    assert entered.kind.tolist() == ["entered"] and math.isclose(entered.time[0], 3.5)


def test_any_layout_is_read_and_any_number_of_threads_says_the_same():
    random = np.random.default_rng(23)
    ids = np.arange(200)[::-1]
    places = random.uniform(0, 60, (200, 3)).astype(np.float32)
    speeds = random.uniform(-3, 3, (200, 3)).astype(np.float32)
    expected = None
    for threads, place, speed, id in (
        (1, places.astype(float), speeds.astype(float), ids),
        (2, places, tuple(speeds.T), ids.astype(np.int16)),
        (0, tuple(places.T), speeds, ids.tolist()),
    ):
        swarm = beespace.Swarm(4, threads=threads)
        swarm.update(id, np.zeros(200), place, speed)
        events = swarm.advance(0)
        expected = expected or events
        for name, column in events.columns().items():
            assert np.array_equal(column, getattr(expected, name), equal_nan=column.dtype == float)
        known = swarm.movers(1)
        assert known.id.tolist() == list(range(200))
        assert np.allclose(known.position, (places + speeds)[::-1], atol=1e-5)
    assert len(expected) > 50
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"id": ids} | dict(zip("xyz", places.T)))
    swarm = beespace.Swarm(4)
    swarm.update(frame["id"], 0, frame[["x", "y", "z"]])
    assert swarm.counts.taken == 200
    assert len(expected.to_pandas()) == len(expected)
    assert known.to_pandas()["x"].tolist() == known.position[:, 0].tolist()


def test_velocities_that_are_nan_are_not_known():
    swarm = beespace.Swarm(5)
    unknown = [math.nan] * 3
    swarm.update([1, 2], 0, [[0, 0, 0], [9, 0, 0]], [unknown, [1, 0, 0]])
    assert swarm.movers(2).moves.tolist() == [False, True]
    swarm.update([1], 1, [[0, 3, 0]], [unknown])
    assert swarm.movers(2).velocity[0].tolist() == [0, 3, 0]


def test_many_threads_may_use_one_swarm():
    swarm = beespace.Swarm(2, horizon=0)

    def report(mine):
        for time in range(200):
            swarm.update([mine], time, [[mine, time * 0.01]])
            assert swarm.counts.taken > 0 and len(swarm.movers(time)) > 0

    threads = [threading.Thread(target=report, args=(mine,)) for mine in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert swarm.counts.taken == 1600
    events = swarm.finish(199)
    assert events.kind.tolist().count("entered") == 7
    assert swarm.counts.agents == 0


def test_arrays_outlive_the_swarm():
    swarm = beespace.Swarm(5)
    swarm.update([1, 2], 0, [[0, 0], [3, 0]], np.zeros((2, 2)))
    events, known = swarm.advance(0), swarm.movers(0)
    time, place = events.time, known.position
    del swarm, events, known
    assert time.tolist() == [0] and place.tolist() == [[0, 0, 0], [3, 0, 0]]
