"""Ids that differ stay apart, and heights that were not given are not taken for 0."""

from __future__ import annotations

import numpy as np
import pytest

import beespace

flat, high = [[0, 0], [9, 0]], [[0, 0, 100], [9, 0, 100]]
still = {2: [[0, 0], [0, 0]], 3: [[0, 0, 0], [0, 0, 0]]}


def record(ids):
    """Each agent passes the other one at 3 m."""
    places = [[0, 0], [100, 3], [100, 0], [0, 3]]
    return beespace.Recording(ids, [0, 0.5, 10, 10.5], places)


MIXED = [
    ([1, "1", 1, "1"], 1),
    (["a", float("nan"), "a", float("nan")], 1),
    (("a", None, "a", None), 1),
    ([1, True, 1, True], 1),
    ([1, 1.5, 1, 1.5], 1),
    (["a", b"a", "a", b"a"], 1),
    (np.array([1, "1", 1, "1"], object), 1),
    ([1, 2, 1, 2.0], 3),
]


@pytest.mark.parametrize(("ids", "row"), MIXED)
def test_ids_of_several_kinds_are_refused_and_not_made_one(ids, row):
    frame = {"id": ids, "t": [0, 0.5, 10, 10.5], "x": [0, 100, 100, 0], "y": [0, 3, 0, 3]}
    for call in (
        lambda: record(ids),
        lambda: beespace.Recording.from_frame(frame, id="id", time="t", x="x", y="y"),
        lambda: beespace.verify(ids, frame["t"], high * 2, 5),
        lambda: beespace.Swarm(5).update(ids, 0, high * 2),
    ):
        with pytest.raises(beespace.BeespaceError) as caught:
            call()
        assert (caught.value.place, caught.value.record) == ("ids", row), str(caught.value)


@pytest.mark.parametrize("ids", [
    ["a", "a\0", "a", "a\0"],
    [b"a", b"a\0", b"a", b"a\0"],
    np.array(["a", "a\0", "a", "a\0"], object),
    ["a", "b", "a", "b"],
    np.array([1, 2, 1, 2], object),
    [2**62, 2**62 + 1, 2**62, 2**62 + 1],
    [np.int32(5), 6, np.int32(5), 6],
])  # fmt: skip
def test_ids_that_differ_are_two_agents(ids):
    found = record(ids).conflicts(5)
    assert len(found) == 1 and (found.i[0], found.j[0]) == (ids[0], ids[1])


def test_ids_beyond_64_bits_are_refused():
    for ids in ([1, 2**63, 1, 2**63], [-(2**63) - 1, 1] * 2):
        with pytest.raises(beespace.BeespaceError, match="64 bits"):
            record(ids)
    with pytest.raises(beespace.BeespaceError, match="64 bits"):
        beespace.Adviser().advise(
            high, still[3], still[3], 2, max_speed=3, unknown_centers=high[:1], unknown_radii=[0],
            unknown_growths=[0], unknown_agents=np.array([2**64 - 1], np.uint64),
        )  # fmt: skip


def test_a_swarm_says_to_number_agents_that_have_names():
    for ids in (["a", "b"], np.array(["a", "b"])):
        with pytest.raises(beespace.BeespaceError, match="number the agents"):
            beespace.Swarm(5).update(ids, 0, flat)


def advise(positions, **options):
    zeros = still[len(positions[0])]
    return beespace.Adviser().advise(positions, zeros, zeros, 2, max_speed=5, **options)


def of_guide(positions, velocities):
    guide = beespace.Guide(2, max_speed=6, max_acceleration=4)
    guide.set_intruders(positions, velocities)


def of_swarm(first, second):
    swarm = beespace.Swarm(5)
    swarm.update([1, 2], 0, first)
    swarm.update([3, 4], 0, second)


def of_verifier(first, second):
    verifier = beespace.Verifier(5, straight=True)
    verifier.add(0, first)
    verifier.add(1, second)


# (what is asked of two sets of points, the argument that differs)
BETWEEN = [
    (lambda a, b: beespace.at_risk(a, 5, others=b), "others"),
    (lambda a, b: beespace.pairs(a, 5, others=b), "others"),
    (lambda a, b: beespace.neighbors(a, 5, others=b), "others"),
    (lambda a, b: beespace.count(a, 5, others=b), "others"),
    (lambda a, b: beespace.nearest(a, others=b), "others"),
    (lambda a, b: beespace.closest_pair(a, others=b), "others"),
    (lambda a, b: beespace.Engine().at_risk(a, 5, others=b), "others"),
    (lambda a, b: beespace.Index(a).around(b, 5), "places"),
    (lambda a, b: beespace.Index(a).around(b, [5, 5]), "places"),
    (lambda a, b: beespace.Index(a).nearest(b), "places"),
    (lambda a, b: beespace.Index(a).insert(b[0]), "point"),
    (lambda a, b: beespace.Index(a).move(0, b[0]), "point"),
    (lambda a, b: beespace.predict(a, b, 5, within=1), "velocities"),
    (lambda a, b: beespace.closest_approach(a, a, b, b), "other_positions"),
    (lambda a, b: beespace.closest_approach(a, b, a, a), "velocities"),
    (lambda a, b: beespace.velocity_to_goal(a, b, max_speed=1), "goals"),
    (lambda a, b: beespace.verify([1, 2], [0, 0], a, 5, velocities=b), "velocities"),
    (lambda a, b: beespace.Verifier(5).add(0, a, b), "velocities"),
    (of_verifier, "positions"),
    (lambda a, b: beespace.Swarm(5).update([1, 2], 0, a, b), "velocities"),
    (of_swarm, "positions"),
    (lambda a, b: beespace.Adviser().advise(a, a, b, 2, max_speed=5), "preferred"),
    (lambda a, b: advise(a, intruder_positions=b, intruder_velocities=b), "intruder_positions"),
    (lambda a, b: advise(a, intruder_positions=a, intruder_velocities=b), "intruder_velocities"),
    (lambda a, b: advise(a, unknown_centers=b, unknown_radii=[1, 1], unknown_growths=[0, 0]),
     "unknown_centers"),
    (lambda a, b: advise(a, claim_places=b, claim_indptr=[0, 1, 2]), "claim_places"),
]  # fmt: skip


@pytest.mark.parametrize(("ask", "argument"), BETWEEN)
def test_points_of_two_axes_beside_points_of_three_are_refused(ask, argument):
    for first, second in ((flat, high), (high, flat)):
        with pytest.raises(beespace.BeespaceError) as caught:
            ask(first, second)
        assert caught.value.place == argument, str(caught.value)


def test_intruders_of_a_fleet_have_heights():
    with pytest.raises(beespace.BeespaceError, match="2 axes, and the fleet 3"):
        of_guide(flat, still[2])
    of_guide(high, still[3])


def test_no_points_go_with_any():
    assert len(beespace.pairs(high, 5, others=[])) == 0
    assert len(beespace.pairs([], 5, others=flat)) == 0
    index = beespace.Index([])
    assert index.insert([1, 2]) == 0 and index.around([[1, 2]], 5)[0].tolist() == [0]
    with pytest.raises(beespace.BeespaceError):
        index.insert([1, 2, 3])
    # What an index says of a point of a plane is a place in it.
    index.move(0, index[0])
    swarm = beespace.Swarm(5)
    swarm.update([1, 2], 0, flat)
    swarm.finish(1)
    swarm.update([1, 2], 0, high)
    assert swarm.counts.agents == 2
