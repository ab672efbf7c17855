"""Swarms that fly as advised keep their distance, by NumPy alone between the steps, too; what cannot
be used is named and clears no other."""

from __future__ import annotations

import gc
import threading

import numpy as np
import pytest

import beespace

STEP = 0.1


def flown(places, speeds, advised, parts=8):
    """Where all are within the step, part after part: velocities change evenly."""
    for part in range(1, parts + 1):
        after = part / parts * STEP
        yield places + speeds * after + (advised - speeds) * (after * after / (2 * STEP))


def closest(places):
    """The least distance of two, by all differences."""
    apart = np.linalg.norm(places[:, None] - places[None], axis=2)
    return apart[np.triu_indices(len(places), 1)].min()


def crossing(count, seed):
    """On a circle, at three heights, each to the opposite point."""
    random = np.random.default_rng(seed)
    turn = np.arange(count) * 2 * np.pi / count
    around = 40 + random.uniform(-2, 2, count)
    places = np.stack(
        [around * np.cos(turn), around * np.sin(turn), 30 + 0.5 * (np.arange(count) % 3)], axis=1
    )
    return places, places * [-1, -1, 1]


def fly(adviser, places, goals, steps, threshold, advised_of, **options):
    """Flies as `advised_of` the advice, and yields it with the closest two of each step."""
    speeds = np.zeros_like(places)
    limits = {"max_speed": 6.0, "max_acceleration": 4.0}
    for _ in range(steps):
        preferred = beespace.velocity_to_goal(places, goals, step=STEP, **limits)
        advice = adviser.advise(places, speeds, preferred, threshold, step=STEP, **limits, **options)
        velocities = advised_of(advice, preferred)
        least = min(closest(part) for part in flown(places, speeds, velocities))
        *_, places = flown(places, speeds, velocities)
        speeds = velocities
        yield advice, least, places


@pytest.mark.parametrize("threads", [1, 2])
def test_fifty_that_cross_keep_their_distance(threads):
    places, goals = crossing(50, 1)
    swarm = fly(
        beespace.Adviser(), places, goals, 200, 2.0, lambda advice, _: advice.velocities,
        threads=threads,
    )
    deflected = 0
    for advice, least, end in swarm:
        assert advice.certified.all() and len(advice.refused) == 0
        assert least > 2.0 - 1e-9
        deflected += int((advice.kind == "deflected").sum())
    assert deflected > 100
    assert np.linalg.norm(end - goals, axis=1).mean() < np.linalg.norm(places - goals, axis=1).mean()


def test_they_would_not_without_advice():
    places, goals = crossing(50, 1)
    swarm = fly(beespace.Adviser(), places, goals, 120, 2.0, lambda _, preferred: preferred)
    assert min(least for _, least, _ in swarm) < 1.0


def test_in_a_plane_velocities_have_two_axes():
    places, goals = crossing(20, 2)
    swarm = fly(
        beespace.Adviser(), places[:, :2].copy(), goals[:, :2].copy(), 80, 2.0,
        lambda advice, _: advice.velocities,
    )
    for advice, least, _ in swarm:
        assert advice.velocities.shape == (20, 2)
        assert advice.certified.all()
        assert least > 2.0 - 1e-9


def test_vertical_shapes_keep_one_of_both_distances():
    random = np.random.default_rng(4)
    places = random.uniform(0, 40, (30, 3))
    goals = places[::-1].copy()
    adviser = beespace.Adviser()
    kept = adviser.advise(
        places, np.zeros((30, 3)), goals * 0, 2.0, max_speed=6, vertical=1.0
    ).certified
    speeds = np.zeros((30, 3))
    limits = {"max_speed": 6.0, "max_acceleration": 4.0}
    for _ in range(100):
        preferred = beespace.velocity_to_goal(places, goals, **limits)
        advice = adviser.advise(places, speeds, preferred, 2.0, vertical=1.0, **limits)
        for part in flown(places, speeds, advice.velocities):
            offsets = np.abs(part[:, None] - part[None])
            within = (np.hypot(offsets[..., 0], offsets[..., 1]) < 2 - 1e-9) & (
                offsets[..., 2] < 1 - 1e-9
            )
            np.fill_diagonal(within, False)
            assert not within[kept][:, kept].any()
        *_, places = flown(places, speeds, advice.velocities)
        speeds = advice.velocities


def test_one_that_cannot_be_used_clears_no_other():
    places, goals = crossing(10, 3)
    still = np.zeros_like(places)
    adviser = beespace.Adviser()

    def ask(places=places, speeds=still, preferred=goals * 0.1, max_speed=20.0, **options):
        return adviser.advise(places, speeds, preferred, 2.0, max_speed=max_speed, **options)

    assert ask().certified.all()
    for place in ("places", "speeds", "max_speed"):
        given = {"places": places, "speeds": still, "max_speed": np.full(10, 20.0)}[place].copy()
        given[4] = np.nan
        advice = ask(**{place: given})
        assert not advice.certified.any()
        assert advice.kind[4] == "none" and (advice.velocities[4] == 0).all()
        (refused,) = advice.refused
        name = {"places": "positions", "speeds": "velocities", "max_speed": "max_speed"}[place]
        assert (refused.place, refused.record) == (name, 4)
        assert "1 refused" in repr(advice)
    wanted = goals * 0.1
    wanted[4, 1] = np.inf
    advice = ask(preferred=wanted)
    assert advice.refused[0].place == "preferred" and advice.certified.all()
    # One whose ball is known is not advised, and the others are clear of it for a time.
    advice = ask(
        unknown_centers=places[4:5], unknown_radii=[1.0], unknown_growths=[0.5], unknown_agents=[4]
    )
    assert advice.kind[4] == "none" and not advice.certified[4]
    assert advice.refused == ()
    assert np.isfinite(advice.clear_of_unknown_time[np.arange(10) != 4]).all()


def test_each_agent_has_limits_of_its_own():
    places = np.arange(12.0).reshape(4, 3) * 30
    speeds, accelerations = np.array([1.0, 2, 3, 4]), np.array([0.5, 1, 1.5, 2])
    wanted = np.tile([9.0, 0, 0], (4, 1))
    adviser = beespace.Adviser()
    advised = adviser.advise(places, places * 0, wanted, 2.0, max_speed=speeds)
    assert advised.velocities[:, 0].tolist() == pytest.approx(speeds)
    advised = adviser.advise(
        places, places * 0, wanted, 2.0, max_speed=speeds, max_acceleration=accelerations
    )
    assert advised.velocities[:, 0].tolist() == pytest.approx(accelerations * STEP)


def test_obstacles_are_kept_clear_of():
    mast = beespace.Obstacles([beespace.Cylinder(0, 0, 2), beespace.Ground(0)])
    places, goals = crossing(8, 8)
    swarm = fly(
        beespace.Adviser(), places, goals, 200, 2.0, lambda advice, _: advice.velocities,
        obstacles=mast, clearance=1.5,
    )
    for advice, least, now in swarm:
        assert advice.certified.all() and least > 2.0 - 1e-9
        assert np.hypot(now[:, 0], now[:, 1]).min() > 3.5 - 1e-9
        assert now[:, 2].min() > 1.5
    near = beespace.Adviser().advise(
        [[3, 0, 9]], [[0, 0, 0]], [[0, 0, 0]], 2, max_speed=5, obstacles=mast, clearance=1.5
    ).near_obstacle
    assert (near.first.tolist(), near.second.tolist(), near.distance.tolist()) == ([0], [0], [1])
    with pytest.raises(beespace.BeespaceError, match="obstacles"):
        beespace.Adviser().advise(
            [[3, 0, 9]], [[0, 0, 0]], [[0, 0, 0]], 2, max_speed=5, obstacles=[beespace.Ground(0)]
        )


def test_agents_have_radii_tubes_and_claims():
    places = np.array([[0.0, 0, 0], [5, 0, 0], [0, 40, 0]])
    still = places * 0
    adviser = beespace.Adviser()

    def close(**options):
        advice = adviser.advise(places, still, still, 2.0, max_speed=5, **options)
        return list(zip(advice.too_close.first.tolist(), advice.too_close.second.tolist())), advice

    assert close()[0] == []
    assert close(radii=[3.0, 1, 1])[0] == []
    assert close(radii=[3.0, 2.5, 1])[0] == [(0, 1)]
    assert close(tubes=[2.0, 2, 0])[0] == [(0, 1)]
    claim = {"claim_places": [[0, 0, 0], [0, 39, 0]], "claim_indptr": [0, 2, 2, 2]}
    pairs, advice = close(**claim, holds=[True, False, False], remember=True)
    assert pairs == [(0, 2)]
    assert advice.kind.tolist()[0] == "braking" and advice.certified.tolist() == [False, True, False]
    for change, place in (
        ({"radii": [1.0]}, "radii"),
        ({"holds": [1, 0, 0]}, "holds"),
        ({"claim_indptr": [0, 0, 0, 0]}, "claim_places"),
        ({**claim, "claim_indptr": [0, 2, 1, 2]}, "claim_indptr"),
    ):
        with pytest.raises(beespace.BeespaceError) as raised:
            close(**change)
        assert raised.value.place == place


def test_fences_and_intruders_are_named():
    places = np.array([[0.0, 0, 1.5], [0, 0, 30]])
    advice = beespace.Adviser().advise(
        places, places * 0, [[0, 0, -3], [0, 0, 0]], 2.0, max_speed=5, max_acceleration=2,
        fence_directions=[[0, 0, 1]], fence_offsets=[0.0], clearance=2.0,
        intruder_positions=[[-30, 0, 30]], intruder_velocities=[[20, 0, 0]],
    )
    assert advice.near_fence.first.tolist() == [0]
    assert advice.near_fence.distance.tolist() == [1.5]
    assert advice.near_fence.time is None
    assert advice.velocities[0, 2] > -1e-12
    assert advice.intruder_conflicts.first.tolist() == [1]
    assert not advice.clear_of_intruders[1] and advice.clear_of_intruders[0]
    assert list(advice.columns())[:3] == ["vx", "vy", "vz"]


@pytest.mark.parametrize(
    ("change", "place", "code"),
    [
        ({"threshold": 0}, "threshold", "invalid_threshold"),
        ({"threshold": "two"}, "threshold", "invalid_threshold"),
        ({"velocities": [[0, 0, 0]] * 2}, "velocities", "invalid_argument"),
        ({"preferred": [[0, 0, 0]] * 2}, "preferred", "invalid_argument"),
        ({"max_speed": [1, 2]}, "max_speed", "invalid_argument"),
        ({"max_speed": "fast"}, "max_speed", "invalid_argument"),
        ({"max_speed": -1}, "max_speed", "invalid_argument"),
        ({"max_acceleration": 0}, "max_acceleration", "invalid_argument"),
        ({"step": 0}, "step", "invalid_argument"),
        ({"step": -1}, "step", "invalid_argument"),
        ({"step": None}, "step", "invalid_argument"),
        ({"uncertainty": -1}, "uncertainty", "invalid_argument"),
        ({"method": "magic"}, "method", "invalid_argument"),
        ({"vertical": 1, "vertical_factor": 2}, "vertical", "invalid_argument"),
        ({"clearance": 0}, "clearance", "invalid_argument"),
        ({"fence_directions": [[0, 0, 1]]}, "fence_offsets", "invalid_argument"),
        (
            {"fence_directions": [[0, 0, 1]], "fence_offsets": [0, 1]},
            "fence_offsets",
            "invalid_argument",
        ),
        ({"fence_directions": [[0, 0, 1]], "fence_offsets": [0]}, "clearance", "invalid_argument"),
        ({"intruder_velocities": [[0, 0, 1]]}, "intruder_positions", "invalid_argument"),
        ({"unknown_centers": [[0, 0, 1]]}, "unknown_radii", "invalid_argument"),
        (
            {
                "unknown_centers": [[0, 0, 1]],
                "unknown_radii": [1],
                "unknown_growths": [1],
                "unknown_agents": [0.5],
            },
            "unknown_agents",
            "invalid_argument",
        ),
        ({"threads": -1}, "threads", "invalid_argument"),
    ],
)
def test_what_makes_no_sense_is_refused(change, place, code):
    given = {
        "positions": [[0, 0, 0], [9, 0, 0], [0, 9, 0]],
        "velocities": [[0, 0, 0]] * 3,
        "preferred": [[0, 0, 0]] * 3,
        "threshold": 2.0,
        "max_speed": 5.0,
        **change,
    }
    with pytest.raises(beespace.BeespaceError) as raised:
        beespace.Adviser().advise(**given)
    assert (raised.value.code, raised.value.place) == (code, place)


def test_velocity_to_goal_stops_there():
    velocities = beespace.velocity_to_goal([0, 0], [[9, 0], [0, 9]], max_speed=2)
    assert velocities.tolist() == [[2, 0], [0, 2]]
    assert beespace.velocity_to_goal([1, 2, 3], [1, 2, 3], max_speed=2).tolist() == [[0, 0, 0]]
    assert beespace.velocity_to_goal(np.empty((0, 3)), [0, 0, 0], max_speed=2).shape == (0, 3)
    with pytest.raises(beespace.BeespaceError, match="goals") as raised:
        beespace.velocity_to_goal([[0, 0, 0]] * 3, [0, np.nan, 0], max_speed=2)
    assert raised.value.code == "not_finite"
    with pytest.raises(beespace.BeespaceError, match="axes"):
        beespace.velocity_to_goal([[0, 0, 0]], [[0, 0]], max_speed=2)


def test_threads_share_an_adviser_and_answers_outlive_it():
    places, goals = crossing(50, 5)
    adviser = beespace.Adviser()
    expected = adviser.advise(places, places * 0, goals * 0.1, 2.0, max_speed=6)
    answers = []

    def ask():
        for _ in range(50):
            answers.append(adviser.advise(places, places * 0, goals * 0.1, 2.0, max_speed=6))

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    velocities = expected.velocities
    kept = velocities.copy()
    del expected, adviser
    gc.collect()
    assert (velocities == kept).all()
    assert len(answers) == 200
    assert all((each.velocities == kept).all() for each in answers)
