"""Space is cut so that all within reach of a home point are in its cell."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import scenes
from beespace.spark._cut import Cut
from beespace.spark._parts import keys_of_parts, pack


def _cut_of(points, most):
    axes = list(np.ascontiguousarray(points.T))
    return axes, Cut.of_sample(axes, [scenes.THRESHOLD] * len(axes), most, most)


@pytest.mark.parametrize("name", sorted(scenes.ALL))
def test_each_point_has_one_home_and_its_cell_all_that_is_within_reach(name):
    _, points = scenes.swarm(name)
    axes, cut = _cut_of(points, 150)
    homes = np.full(len(points), -1)
    members = {}
    for cell, home, halo in cut.distribute(axes):
        assert (homes[home] == -1).all()
        homes[home] = cell
        both = np.concatenate([home, halo])
        assert len(np.unique(both)) == len(both)
        members[cell] = set(both.tolist())
    assert (homes >= 0).all()
    # As rational numbers, of a few points against all.
    some = np.random.default_rng(3).choice(len(points), 60, replace=False)
    for one in some.tolist():
        # Doubles choose whom to look at, generously; rational numbers decide.
        near = np.flatnonzero((np.abs(points - points[one]) <= 1.001).all(axis=1))
        for other in near.tolist():
            apart = [abs(Fraction(a) - Fraction(b)) for a, b in zip(points[one], points[other])]
            if max(apart) <= Fraction(scenes.THRESHOLD):
                assert other in members[homes[one]]


@pytest.mark.parametrize("name", ["uniform", "clusters", "plane", "dense_cell"])
def test_no_cell_has_more_than_the_limit_where_that_can_be(name):
    _, points = scenes.swarm(name)
    _, cut = _cut_of(points, 2_000)
    assert cut.cells > 3
    assert max(home + copy for home, copy in zip(cut.homes, cut.copies)) <= 2_000
    assert sum(cut.homes) == len(points)


def test_a_crowd_smaller_than_the_threshold_stays_whole():
    _, points = scenes.swarm("one_place")
    _, cut = _cut_of(points, 10)
    assert cut.cells == 1


def test_parts_are_as_large_as_each_other():
    sizes = [float(size) for size in np.random.default_rng(2).integers(50, 100, 240)]
    loads = np.bincount(pack(sizes, 24), weights=sizes)
    assert loads.max() <= 1.2 * np.median(loads)


def test_each_part_goes_to_a_partition_of_its_own(session):
    for parts in (1, 2, 7, 60):
        keys = keys_of_parts(parts)
        frame = session.createDataFrame([(key,) for key in keys], "part int").repartition(parts, "part")
        rows = frame.selectExpr("spark_partition_id() AS at").collect()
        assert sorted(row["at"] for row in rows) == list(range(parts))


def test_halos_reach_as_far_as_rounding_does():
    """A point an ulp below a plane, and one whose distance from it is 1 or less, though plane + 1 rounds to it."""
    rng = np.random.default_rng(5)
    tried = 0
    for plane in (rng.random(2_000) * 0.1 + 0.1).tolist():
        below, above = np.nextafter(plane, 0), plane + 1.0
        if Fraction(above) - Fraction(float(below)) > 1:
            continue
        tried += 1
        cut = Cut()
        rows = np.arange(2)
        axes = [np.array([below, above])]
        cut._split(0, (0, plane), axes, [1.0], rows, rows[:0])
        cut.child[1:] = [0, 1]
        for _, home, halo in cut.distribute(axes):
            assert len(home) + len(halo) == 2
    assert tried > 100
