"""One place at a time: a shorter way, that must say the same as the way of many places."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from beespace.compat.scipy import KDTree, cKDTree, handed_over

coordinate = st.one_of(st.integers(-3, 3).map(float), st.floats(-3.0, 3.0).map(lambda x: round(x, 6)))
radius = st.one_of(st.integers(0, 4), st.floats(0.0, 4.0).map(lambda x: round(x, 6)))


def by_definition(data: Any, place: Any) -> list[tuple[float, int]]:
    """All points by their distance, in the precision of `longdouble`."""
    apart = data.astype(np.longdouble) - place.astype(np.longdouble)
    squares = (apart * apart).sum(axis=1)
    return sorted(zip(np.sqrt(squares).tolist(), range(len(data))))


@settings(max_examples=150, deadline=None, derandomize=True)
@given(st.data(), st.sampled_from([2, 3]), st.integers(1, 9))
def test_one_place_is_answered_as_by_definition(data: Any, m: int, k: int) -> None:
    points = np.array(
        data.draw(st.lists(st.tuples(*[st.integers(-3, 3)] * m), min_size=1, max_size=12)), float
    )
    place = np.array(data.draw(st.tuples(*[st.integers(-6, 6)] * m)), float) / 2.0
    r = data.draw(radius)
    for kind in (KDTree, cKDTree):
        tree = kind(points)
        right = by_definition(points, place)
        distances, ids = tree.query(place, k)
        found = np.atleast_1d(ids).tolist()
        missing = [len(points)] * max(0, k - len(right))
        assert found == [i for _, i in right[:k]] + missing
        expected = [distance for distance, _ in right[:k]] + [np.inf] * len(missing)
        assert np.atleast_1d(distances).tolist() == pytest.approx(expected)
        # Squares of halves and of integers are exact, so is their comparison.
        near = ((points - place) ** 2).sum(axis=1) <= np.longdouble(r) ** 2
        assert tree.query_ball_point(place, r) == np.flatnonzero(near).tolist()


@settings(max_examples=150, deadline=None, derandomize=True)
@given(st.data(), st.sampled_from([2, 3]), st.integers(1, 7))
def test_one_place_is_answered_as_one_of_many(data: Any, m: int, k: int) -> None:
    places = st.lists(st.tuples(*[coordinate] * m), min_size=1, max_size=12)
    points = np.array(data.draw(places))
    asked = np.array(data.draw(places))
    r = data.draw(radius)
    tree = KDTree(points)
    distances, ids = tree.query(asked, k)
    balls = tree.query_ball_point(asked, r)
    for each, place in enumerate(asked):
        distance, id = tree.query(place, k)
        assert np.array_equal(distance, distances[each]) and np.array_equal(id, ids[each])
        assert np.shape(id) == (() if k == 1 else (k,))
        assert tree.query_ball_point(place, r) == balls[each]


def test_what_the_library_refuses_is_handed_over_as_ever() -> None:
    spatial = pytest.importorskip("scipy.spatial", reason="SciPy is not installed")
    handed_over.clear()
    tree = KDTree(np.eye(3))
    for place in (np.array([0.0, 0.0]), np.zeros(4)):
        with pytest.raises(ValueError):
            tree.query(place)
        with pytest.raises(ValueError):
            tree.query_ball_point(place, 1.0)
    far = np.array([1e200, 0.0, 0.0])
    assert tree.query(far)[1] == spatial.KDTree(np.eye(3)).query(far)[1]
    tiny = np.array([[0.0, 1e-150, 0.0], [1.0, 0.0, 0.0]])  # no index can be made of these
    assert KDTree(tiny).query(np.zeros(3)) == spatial.KDTree(tiny).query(np.zeros(3))
    assert KDTree(tiny).query_ball_point(np.zeros(3), 0.5) == [0]
    assert sum(handed_over.values()) == 7


def test_answers_can_be_written_and_stay() -> None:
    points = np.random.default_rng(3).normal(size=(100, 3))
    tree = KDTree(points)
    first = tree.query(points[0], 5)
    kept = [column.copy() for column in first]
    tree.query(points[1], 5)
    assert all(np.array_equal(mine, column) for mine, column in zip(first, kept))
    first[0][:] = 0.0
    first[1][:] = 0
    assert np.array_equal(tree.query(points[0], 5)[0], kept[0])


def test_threads_do_not_share_a_place() -> None:
    points = np.random.default_rng(4).normal(size=(3_000, 3))
    tree = KDTree(points)
    right = tree.query_ball_point(points, 0.3)

    def ask(first: int) -> bool:
        return all(
            tree.query_ball_point(points[row], 0.3) == right[row]
            and tree.query(points[row])[1] == row
            for row in range(first, len(points), 8)
        )

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(ask, range(8)))
