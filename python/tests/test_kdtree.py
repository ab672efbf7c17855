"""The trees of SciPy, run by beespace, are right: by two loops over fractions."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import oracle
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from beespace.compat.scipy import KDTree, answered, handed_over

spatial = pytest.importorskip("scipy.spatial", reason="SciPy is not installed")

many = settings(
    max_examples=80, deadline=None, suppress_health_check=[HealthCheck.too_slow], derandomize=True
)
radii = st.one_of(
    st.sampled_from([0.0, 0.1, 0.2, 0.25, 0.5, 1.25, 10.0]), st.floats(1e-3, 3.0)
)


@st.composite
def sets(draw: Any, most: int = 10) -> list[np.ndarray[Any, Any]]:
    """Two sets of points. Steps of 0.1 meet thresholds of 0.1 at the last digit; quarters meet them
    exactly; other numbers do not."""
    random = np.random.default_rng(draw(st.integers(0, 2**32)))
    m, step = draw(st.sampled_from([2, 3])), draw(st.sampled_from([0.1, 0.25, None]))
    dtype = draw(st.sampled_from([np.float64, np.float64, np.float32]))
    made = []
    for _ in range(2):
        shape = (draw(st.integers(0, most)), m)
        points = random.normal(size=shape) if step is None else random.integers(-3, 4, shape) * step
        made.append(points.astype(dtype))
    return made


@pytest.fixture(autouse=True)
def counters() -> None:
    answered.clear()
    handed_over.clear()


def within(mine: Any, theirs: Any, r: float) -> list[list[int]]:
    found = oracle.pairs(mine, r, others=theirs, inclusive=True)
    return [[j for i, j in found if i == row] for row in range(len(mine))]


@many
@given(sets(), radii)
def test_radius_searches_are_exact(both: Any, r: float) -> None:
    data, places = both
    tree, other = KDTree(data), KDTree(places)
    rows = within(places, data, r)
    balls = tree.query_ball_point(places, r)
    assert balls.shape == (len(places),) and balls.dtype == object
    assert list(balls) == rows
    lengths = tree.query_ball_point(places, r, return_length=True)
    assert lengths.dtype == np.intp and lengths.tolist() == [len(row) for row in rows]
    for place, row in zip(places, rows):
        assert tree.query_ball_point(place, r) == row
        assert tree.query_ball_point(place, r, return_length=True) == len(row)
    assert other.query_ball_tree(tree, r) == rows
    assert other.count_neighbors(tree, r) == sum(len(row) for row in rows)
    assert tree.query_ball_tree(tree, r) == within(data, data, r)
    assert tree.count_neighbors(tree, r) == sum(len(row) for row in within(data, data, r))
    pairs = oracle.pairs(data, r, inclusive=True)
    assert tree.query_pairs(r) == set(pairs)
    array = tree.query_pairs(r, output_type="ndarray")
    assert array.dtype == np.intp and array.shape == (len(pairs), 2)
    assert [tuple(pair) for pair in array.tolist()] == pairs
    assert not handed_over


@many
@given(sets(), st.data())
def test_each_place_has_its_radius(both: Any, draw: Any) -> None:
    data, places = both
    each = [draw.draw(radii) for _ in places]
    tree = KDTree(data)
    rows = [within(place[np.newaxis], data, r)[0] for place, r in zip(places, each)]
    assert list(tree.query_ball_point(places, each)) == rows
    lengths = tree.query_ball_point(places, np.array(each), return_length=True)
    assert lengths.tolist() == [len(row) for row in rows]
    assert not handed_over


@many
@given(sets(), radii)
def test_distance_matrices_are_exact(both: Any, r: float) -> None:
    data, places = both
    for mine, theirs in ((data, places), (data, data)):
        tree, other = KDTree(mine), KDTree(theirs)
        if theirs is mine:
            other = tree
        expected = {
            (i, j): oracle.distance(mine[i], theirs[j])
            for i, row in enumerate(within(mine, theirs, r))
            for j in row
        }
        assert tree.sparse_distance_matrix(other, r, output_type="dict") == expected
        records = tree.sparse_distance_matrix(other, r, output_type="ndarray")
        assert records.dtype.names == ("i", "j", "v")
        found = {(int(i), int(j)): float(v) for i, j, v in records}
        assert found == expected and len(records) == len(expected)
        for kind in ("dok_matrix", "coo_matrix"):
            matrix = tree.sparse_distance_matrix(other, r, output_type=kind)
            assert matrix.format == kind[:3] and matrix.shape == (len(mine), len(theirs))
            # Distances of 0 are entries, too.
            entries = matrix.tocoo()
            assert dict(zip(zip(entries.row, entries.col), entries.data)) == expected
    assert not handed_over


@many
@given(sets(), st.integers(1, 14), st.one_of(st.just(np.inf), radii))
def test_nearest_are_exact(both: Any, k: int, bound: float) -> None:
    data, places = both
    tree = KDTree(data)
    d, i = tree.query(places, k, distance_upper_bound=bound)
    shape = (len(places),) if k == 1 else (len(places), k)
    assert d.shape == i.shape == shape and d.dtype == np.float64 and i.dtype == np.intp
    for row, ids in enumerate(oracle.nearest(places, k, others=data)):
        expected = [(oracle.distance(places[row], data[j]), j) for j in ids if j >= 0]
        expected = [(far, j) for far, j in expected if far < bound]
        expected += [(np.inf, len(data))] * (k - len(expected))
        got = list(zip(np.atleast_1d(d[row]).tolist(), np.atleast_1d(i[row]).tolist()))
        assert got == expected
        single = tree.query(places[row], k, distance_upper_bound=bound)
        assert np.array_equal(single[0], d[row]) and np.array_equal(single[1], i[row])
    ranks = [k, 1, (k + 1) // 2]
    some = tree.query(places, ranks, distance_upper_bound=bound)
    columns = [rank - 1 for rank in ranks]
    assert np.array_equal(some[0], d.reshape(-1, k)[:, columns])
    assert np.array_equal(some[1], i.reshape(-1, k)[:, columns])
    assert not handed_over


@many
@given(sets(), st.lists(radii, min_size=1, max_size=5))
def test_counts_of_many_distances(both: Any, each: list[float]) -> None:
    data, places = both
    tree, other = KDTree(data), KDTree(places)
    expected = [sum(len(row) for row in within(data, places, r)) for r in each]
    counts = tree.count_neighbors(other, each)
    assert counts.dtype == np.intp and counts.tolist() == expected
    ascending = sorted(each)
    apart = tree.count_neighbors(other, ascending, cumulative=False)
    assert np.cumsum(apart).tolist() == tree.count_neighbors(other, ascending).tolist()
    assert not handed_over


def test_radii_are_compared_as_real_numbers() -> None:
    # Squares and sums round: of 0.1 and 0.2 SciPy may call either side of r "within".
    steps = np.arange(8) * 0.1
    data = np.array([(x, y, z) for x in steps for y in steps for z in (0.0, 0.1)])
    exact = [[Fraction(float(value)) for value in row] for row in data]
    tree = KDTree(data)
    differ = 0
    for r in (0.1, 0.2, 0.3, float(np.sqrt(0.02)), 0.5):
        limit = Fraction(r) ** 2
        right = {
            (i, j)
            for i, a in enumerate(exact)
            for j, b in enumerate(exact)
            if i < j and sum((x - y) ** 2 for x, y in zip(a, b)) <= limit
        }
        assert tree.query_pairs(r) == right
        differ += right != spatial.KDTree(data).query_pairs(r)
    assert differ, "SciPy rounds as real numbers are: then the documents are wrong"
