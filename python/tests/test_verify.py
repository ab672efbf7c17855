"""Verification: what is found is what dense samples of the curves show, and no less; what was not seen
does not hold; what cannot be is named."""

from __future__ import annotations

import math
import threading

import numpy as np
import pytest
import verify_oracle

import beespace

_obstacles = (
    beespace.Sphere((5, 5, 6), 1.5),
    beespace.Box((0, 8, 2), (3, 9, 6)),
    beespace.Ground(1),
    beespace.Cylinder(10, 10, 1, high=5),
    beespace.Prism([(8, 1), (12, 1), (12, 4), (11, 2), (8, 4)], low=3, high=7),
)


def flight(random: np.random.Generator, agents: int, moments: int, even: bool):
    """Positions and velocities at the moments 0, 0.5, 1, ...: of even acceleration, or of none."""
    positions = [random.uniform(0, 12, (agents, 3))]
    velocities = [random.uniform(-4, 4, (agents, 3))]
    for _ in range(moments - 1):
        velocities.append(velocities[-1] + random.uniform(-2, 2, (agents, 3)))
        positions.append(positions[-1] + 0.25 * (velocities[-2] + velocities[-1]))
        if not even:
            positions[-1] = positions[-1] + random.uniform(-0.5, 0.5, (agents, 3))
    return np.array(positions), np.array(velocities)


def steps_of(positions, velocities, straight):
    """Of each step the flights of all agents."""
    for k in range(len(positions) - 1):
        yield 0.5 * k, [
            verify_oracle.Step(
                *((p[a], None if straight else v[a]) for p, v in _ends(positions, velocities, k)), 0.5
            )
            for a in range(positions.shape[1])
        ]


def _ends(positions, velocities, k):
    return zip(positions[k : k + 2], velocities[k : k + 2])


@pytest.mark.parametrize("straight", [False, True])
@pytest.mark.parametrize("even", [False, True])
def test_what_is_found_is_what_samples_show(straight, even):
    random = np.random.default_rng(31)
    open_ = found = 0
    for _ in range(4):
        positions, velocities = flight(random, 8, 4, even)
        verifier = beespace.Verifier(
            2,
            max_speed=5,
            max_acceleration=None if straight else 5,
            obstacles=beespace.Obstacles(_obstacles),
            clearance=0.5,
            straight=straight,
        )
        for k in range(4):
            verifier.add(0.5 * k, positions[k], velocities[k])
        verdict = verifier.verdict()
        losses = {tuple(row[:3]): row[4] for row in zip(*verdict.losses.columns().values())}
        near = {tuple(row[:3:2]) for row in zip(*verdict.clearance_losses.columns().values())}
        breaches = set(zip(*list(verdict.breaches.columns().values())[:3]))
        least, peak, hardest = math.inf, 0.0, 0.0
        u = np.linspace(0, 1, 2001)
        for begin, steps in steps_of(positions, velocities, straight):
            for i, step in enumerate(steps):
                for j in range(i + 1, 8):
                    distance = verify_oracle.apart(step, steps[j])
                    least = min(least, distance)
                    told = losses.pop((i, j, begin), None)
                    if abs(distance - 2) < 1e-5:
                        open_ += 1
                        continue
                    assert (told is not None) == (distance < 2)
                    assert told is None or distance - 1e-5 <= told <= distance + 1e-9
                clear = min(verify_oracle.clear_of(step, each) for each in _obstacles)
                if abs(clear - 0.5) < 1e-5:
                    open_ += 1
                else:
                    assert ((i, begin) in near) == (clear < 0.5)
                speed = step.speed(u).max()
                peak = max(peak, speed)
                assert abs(speed - 5) < 1e-4 or ((i, "speed", begin) in breaches) == (speed > 5)
                if not straight:
                    bend = step.acceleration(u).max()
                    hardest = max(hardest, bend)
                    assert abs(bend - 5) < 1e-4 or (
                        ((i, "acceleration", begin) in breaches) == (bend > 5)
                    )
        assert not losses  # nothing else was found
        assert not verdict.holds and not verdict and verdict.steps == 3
        assert math.isclose(verdict.peak_speed, peak, rel_tol=1e-6)
        if straight:
            assert verdict.peak_acceleration is None
        else:
            assert math.isclose(verdict.peak_acceleration, hardest, rel_tol=1e-6)
        assert least - 1e-5 <= verdict.closest_distance <= least + 1e-9
        assert len(verdict.losses) == verdict.loss_count
        assert len(verdict.breaches) == verdict.breach_count
        assert len(verdict.clearance_losses) == verdict.clearance_loss_count == len(near)
        found += verdict.loss_count + verdict.breach_count + verdict.clearance_loss_count
    assert open_ < 3 and found > 60


@pytest.mark.parametrize("kind", range(len(_obstacles)))
def test_each_kind_of_obstacle_is_in_the_way(kind):
    random = np.random.default_rng(32 + kind)
    obstacles = beespace.Obstacles(_obstacles[kind : kind + 1])
    near = 0
    for _ in range(60):
        places = random.uniform(-1, 14, (2, 3))
        verdict = beespace.verify(
            [1, 1], [0, 1], places, 1, obstacles=obstacles, clearance=0.7
        )
        step = verify_oracle.Step((places[0], None), (places[1], None), 1.0)
        clear = verify_oracle.clear_of(step, _obstacles[kind])
        assert abs(clear - 0.7) < 1e-5 or verdict.holds == (clear >= 0.7)
        near += not verdict.holds
    assert 0 < near < 60


def test_rows_stand_in_any_order_and_agents_have_names():
    random = np.random.default_rng(33)
    positions, velocities = flight(random, 6, 5, True)
    names = np.array(["f", "b", "d", "a", "e", "c"])
    ids, times = np.tile(names, 5), np.repeat(0.5 * np.arange(5), 6)
    rows, speeds = positions.reshape(-1, 3), velocities.reshape(-1, 3)
    expected = beespace.verify(ids, times, rows, 4, velocities=speeds, max_speed=4)
    assert len(expected.losses) and len(expected.breaches)
    assert set(expected.losses.i) <= set(names) and (expected.losses.i < expected.losses.j).all()
    verifier = beespace.Verifier(4, max_speed=4, threads=2)
    order = names.argsort()
    for k in range(5):
        verifier.add(0.5 * k, positions[k][order].astype(float), tuple(velocities[k][order].T))
    plain = verifier.verdict()
    shuffled = random.permutation(30)
    mixed = beespace.verify(
        ids[shuffled].tolist(),
        times[shuffled],
        tuple(rows[shuffled].T),
        4,
        velocities=speeds[shuffled],
        max_speed=4,
    )
    for verdict, name in ((mixed, lambda agents: agents), (plain, lambda agents: names[order][agents])):
        for table in ("losses", "breaches"):
            one, other = getattr(expected, table).columns(), getattr(verdict, table).columns()
            for column, values in one.items():
                same = name(other[column]) if column in ("i", "j", "id") else other[column]
                assert np.array_equal(values, same)
        assert verdict.closest_distance == expected.closest_distance
    assert mixed.closest == expected.closest


def test_a_recording_is_verified_in_straight_lines():
    random = np.random.default_rng(34)
    positions, _ = flight(random, 7, 6, True)
    ids, times = np.tile(np.arange(7) * 10 - 30, 6), np.repeat([0, 1, 2, 3, 9, 10.0], 7)
    rows = positions.reshape(-1, 3)
    recording = beespace.Recording(ids, times, rows)
    for max_gap, unseen in ((None, 0), (2, 1), (0.5, 5)):
        one = recording.verify(3, max_gap=max_gap, max_speed=3)
        other = beespace.verify(ids, times, rows, 3, max_gap=max_gap, max_speed=3)
        assert (one.steps, one.unseen) == (other.steps, other.unseen) == (5 - unseen, unseen)
        for table in ("losses", "breaches"):
            columns = zip(*(getattr(each, table).columns().values() for each in (one, other)))
            assert all(np.array_equal(a, b) for a, b in columns)
        assert one.closest == other.closest and repr(one) == repr(other)
    assert len(recording.verify(3).losses)


def test_what_was_not_seen_does_not_hold():
    ids, times, places = [1, 2] * 3, [0, 0, 1, 1, 9, 9], [[0, 0], [9, 0]] * 3
    assert beespace.verify(ids, times, places, 5).holds
    for verdict in (
        beespace.verify(ids, times, places, 5, max_gap=3),
        beespace.Recording(ids, times, places).verify(5, max_gap=3),
    ):
        assert (verdict.holds, verdict.steps, verdict.unseen) == (False, 1, 1)
        assert not verdict and "not seen as a whole" in repr(verdict)
    for verdict in (
        beespace.Verifier(5).verdict(),
        beespace.verify([], [], np.empty((0, 3)), 5),
        beespace.verify([1, 2], [0, 0], places[:2], 5),
        beespace.Recording([], [], []).verify(5),
    ):
        assert not verdict and verdict.steps == 0 and "nothing was checked" in repr(verdict)
        assert verdict.closest is None and verdict.closest_distance is None


@pytest.mark.parametrize(
    ("change", "code", "place", "record"),
    [
        ({"threshold": 0}, "invalid_threshold", "threshold", None),
        ({"threshold": "far"}, "invalid_threshold", "threshold", None),
        ({"max_speed": -1}, "invalid_argument", "max_speed", None),
        ({"max_acceleration": 3}, "invalid_argument", "max_acceleration", None),  # of straight lines
        ({"max_gap": 0}, "invalid_argument", "max_gap", None),
        ({"max_gap": math.nan}, "invalid_argument", "max_gap", None),
        ({"clearance": 3}, "invalid_argument", "clearance", None),
        ({"obstacles": beespace.Obstacles([])}, "invalid_argument", "clearance", None),
        ({"obstacles": [beespace.Ground(0)], "clearance": 1}, "invalid_argument", "obstacles", None),
        ({"times": [0, 0, 1, 2]}, "invalid_argument", "times", None),
        ({"times": [0, 0, 1, math.nan]}, "not_finite", "times", 3),
        ({"ids": [1, 2, 1, 1]}, "time_order", "times", 3),
        ({"ids": [1, 2, 1]}, "invalid_argument", "ids", None),
        ({"velocities": [[0, 0]] * 3}, "invalid_argument", "velocities", None),
        ({"positions": [[0, 0], [9, 0], [math.nan, 0], [9, 0]]}, "not_finite", "positions", 2),
        ({"velocities": [[0, 0]] * 3 + [[0, 1e31]]}, "outside_domain", "velocities", 3),
    ],
)
def test_what_cannot_be_is_named(change, code, place, record):
    given = {"ids": [1, 2, 1, 2], "times": [0, 0, 1, 1], "positions": [[0, 0], [9, 0]] * 2}
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.verify(**{**given, "threshold": 5, **change})
    assert (caught.value.code, caught.value.place, caught.value.record) == (code, place, record)


def test_a_recording_of_other_times_is_refused():
    recording = beespace.Recording([1, 2, 1, 2], [0, 0, 1, 1.5], [[0, 0], [9, 0]] * 2)
    with pytest.raises(beespace.BeespaceError, match="agent 2 are not all at the times") as caught:
        recording.verify(5)
    assert caught.value.code == "invalid_argument"


@pytest.mark.parametrize(
    ("obstacle", "words"),
    [
        (beespace.Sphere((0, 0, 0), -1), "the radius"),
        (beespace.Sphere((0, 0), 1), "three coordinates"),
        (beespace.Sphere((0, math.nan, 0), 1), "center y"),
        (beespace.Box((0, 0, 2), (1, 1, 1)), "from z"),
        (beespace.Cylinder(0, 0, 1, low=2, high=1), "the heights"),
        (beespace.Cylinder(0, 0, "wide"), "a number"),
        (beespace.Prism([(0, 0), (1, 1)]), "corners"),
        (beespace.Prism([(0, 0), (1, 1), (1, 0), (0, 1)]), "crosses"),
        (beespace.Prism([1, 2, 3]), "shape"),
        (beespace.Ground(math.inf), "height"),
        ("a wall", "an obstacle is"),
    ],
)
def test_what_is_no_obstacle_is_named(obstacle, words):
    with pytest.raises(beespace.BeespaceError, match=words) as caught:
        beespace.Obstacles([beespace.Ground(0), obstacle])
    assert (caught.value.place, caught.value.record) == ("obstacles", 1)


def test_a_refused_moment_leaves_the_verifier_as_it_was():
    verifier = beespace.Verifier(5, straight=True)
    verifier.add(0, [[0, 0], [9, 0]])
    for time, places, code in (
        (0, [[0, 0], [9, 0]], "time_order"),
        (math.nan, [[0, 0], [9, 0]], "not_finite"),
        (1, [[0, 0]], "invalid_argument"),
        (1, [[0, 0], [math.inf, 0]], "not_finite"),
    ):
        with pytest.raises(beespace.BeespaceError) as caught:
            verifier.add(time, places)
        assert caught.value.code == code
    verifier.add(1, [[0, 0], [9, 0]])
    assert verifier.verdict().holds
    with pytest.raises(beespace.BeespaceError, match="velocities"):
        beespace.Verifier(5).add(0, [[0, 0]])


def test_more_than_a_thousand_are_counted():
    crowd = np.random.default_rng(35).uniform(0, 1, (60, 3))
    verifier = beespace.Verifier(5, straight=True)
    verifier.add(0, crowd)
    verifier.add(1, crowd)
    verdict = verifier.verdict()
    assert (verdict.loss_count, len(verdict.losses)) == (60 * 59 // 2, 1000)
    assert "1,770 losses of separation" in repr(verdict)


def test_many_threads_may_use_verifiers_and_obstacles():
    obstacles = beespace.Obstacles(_obstacles)
    positions, velocities = flight(np.random.default_rng(36), 20, 6, True)
    answers = []

    def check():
        for _ in range(10):
            verifier = beespace.Verifier(2, obstacles=obstacles, clearance=0.5, max_speed=4)
            for k in range(6):
                verifier.add(k, positions[k], velocities[k])
            verdict = verifier.verdict()
            told = [verdict.losses, verdict.clearance_losses, verdict.breaches]
            answers.append(str([table.columns() for table in told]))

    threads = [threading.Thread(target=check) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(answers) == 80 and len(set(answers)) == 1


def test_what_a_verifier_needs_outlives_its_obstacles():
    verifier = beespace.Verifier(
        1, obstacles=beespace.Obstacles([beespace.Ground(0)]), clearance=1, straight=True
    )
    verifier.add(0, [[0, 0, 5]])
    verifier.add(1, [[0, 0, 0.5]])
    losses = verifier.verdict().clearance_losses
    del verifier
    assert losses.obstacle.tolist() == [0] and losses.distance[0] < 1
    for library in ("pandas", "polars"):
        try:
            frame = getattr(losses, f"to_{library}")()
        except ImportError:
            continue
        assert len(frame) == 1


def test_moments_say_whether_one_was_taken():
    verifier = beespace.Verifier(5, straight=True)
    verifier.add(0, [[0, 0], [9, 0]])
    assert verifier.verdict().moments == 1 and verifier.verdict().steps == 0
    with pytest.raises(beespace.BeespaceError):
        verifier.add(0, [[0, 0], [9, 0]])
    assert verifier.verdict().moments == 1
    verifier.add(1, [[0, 0], [9, 0]])
    assert verifier.verdict().moments == 2
    with pytest.raises(beespace.BeespaceError, match="straight=True"):
        beespace.Verifier(5).add(0, [[0, 0]])
