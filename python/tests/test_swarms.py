"""Hundreds of points, where grids, rows of cells and crowds are at work: what all distances say, in
NumPy where its rounding cannot matter, and in fractions where it can."""

from __future__ import annotations

import numpy as np
import pytest

import beespace
import oracle

_rounding = 1e-12  # far above that of a sum of three squares


def _near(points, others, threshold, inclusive, vertical):
    """The matrix of who is near to whom."""
    p, o = points.astype(float), others.astype(float)
    p, o = (np.pad(a, ((0, 0), (0, 3 - a.shape[1]))) for a in (p, o))
    squares = (p[:, None, :] - o[None, :, :]) ** 2
    parts = [(squares.sum(axis=2), threshold)]
    if vertical is not None:
        parts = [(squares[:, :, :2].sum(axis=2), threshold), (squares[:, :, 2], vertical)]
    sure, open_ = np.ones(squares.shape[:2], bool), np.zeros(squares.shape[:2], bool)
    for value, limit in parts:
        sure &= value < limit**2 * (1 - _rounding)
        open_ |= np.abs(value - limit**2) <= limit**2 * _rounding
    mine, theirs = oracle.exact(points), oracle.exact(others)
    for i, j in np.argwhere(open_):
        sure[i, j] = oracle.is_closer(mine[i], theirs[j], threshold, inclusive, vertical)
    return sure, int(open_.sum())


def _scenes():
    rng = np.random.default_rng(18)
    yield "a cloud", rng.uniform(0, 20, (400, 3)), 2.0
    yield "a lattice", np.stack(np.meshgrid(*[np.arange(7.0)] * 3), -1).reshape(-1, 3) * 0.1, 0.2
    yield "one place", np.full((300, 3), 0.1), 1e-3
    yield "two crowds", np.repeat([[0.0, 0, 0], [3, 4, 0]], 150, axis=0), 5.0
    yield "a line", np.column_stack([np.arange(400) * 0.3, np.zeros(400), np.zeros(400)]), 0.3
    yield "a plane", rng.integers(0, 30, (400, 2)) * 0.7, 0.7
    yield "far off", rng.uniform(0, 20, (400, 3)) + 6.4e6, 1.5
    yield "far apart", rng.uniform(-1, 1, (300, 3)) ** 9 * 1e6, 30.0
    yield "crowds and few", np.concatenate(
        [rng.normal(0, 0.2, (300, 3)), rng.uniform(-50, 50, (100, 3))]
    ), 1.0


_of_each_scene = pytest.mark.parametrize(
    ("points", "threshold"), [pytest.param(*scene, id=name) for name, *scene in _scenes()]
)


@_of_each_scene
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("inclusive", [False, True])
@pytest.mark.parametrize("vertical", [None, 0.4])
def test_all_questions_of_a_swarm(points, threshold, dtype, inclusive, vertical):
    points = points.astype(dtype)
    if dtype == np.float32:
        threshold = float(np.float32(threshold))
    options = {"inclusive": inclusive, "vertical": vertical}
    near, _ = _near(points, points, threshold, inclusive, vertical)
    np.fill_diagonal(near, False)
    i, j = np.nonzero(np.triu(near))
    found = beespace.pairs(points, threshold, threads=2, **options)
    assert (found.i.tolist(), found.j.tolist()) == (i.tolist(), j.tolist())
    assert beespace.at_risk(points, threshold, **options).tolist() == (
        np.flatnonzero(near.any(axis=1)).tolist()
    )
    assert beespace.count(points, threshold, **options).tolist() == near.sum(axis=1).tolist()
    rows = beespace.neighbors(points, threshold, **options)
    assert rows.indices.tolist() == np.nonzero(near)[1].tolist()
    assert rows.indptr.tolist() == [0, *near.sum(axis=1).cumsum().tolist()]
    shown = list(beespace.iter_pairs(points, threshold, chunk=1000, **options))
    assert sorted((a, b) for piece in shown for a, b in zip(piece.i, piece.j)) == list(zip(i, j))
    assert beespace.groups(points, threshold, **options).labels.tolist() == _labels(near)

    mine, theirs = points[::2], points[1::2]
    near, _ = _near(mine, theirs, threshold, inclusive, vertical)
    found = beespace.pairs(mine, threshold, others=theirs, **options)
    i, j = np.nonzero(near)
    assert (found.i.tolist(), found.j.tolist()) == (i.tolist(), j.tolist())
    counts = beespace.count(mine, threshold, others=theirs, **options)
    assert counts.tolist() == near.sum(axis=1).tolist()
    if vertical is None:
        around = beespace.Index(theirs).around(mine, threshold, inclusive=inclusive)
        assert around.indices.tolist() == j.tolist()


def _labels(near):
    label = np.arange(len(near))
    for _ in label:
        lowest = np.where(near, label[None, :], len(near)).min(axis=1)
        lower = np.minimum(label, lowest)
        if (lower == label).all():
            break
        label = lower
    at_risk = near.any(axis=1)
    numbers = {first: n for n, first in enumerate(np.unique(label[at_risk]).tolist())}
    return [numbers[one] if risk else -1 for one, risk in zip(label.tolist(), at_risk)]


@_of_each_scene
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_the_nearest_of_a_swarm(points, threshold, dtype):
    points = points.astype(dtype)[:200]
    k = 3
    p = np.pad(points.astype(float), ((0, 0), (0, 3 - points.shape[1])))
    squares = ((p[:, None, :] - p[None, :, :]) ** 2).sum(axis=2)
    np.fill_diagonal(squares, np.inf)
    exact = oracle.exact(points)
    expected = []
    for i, row in enumerate(squares):
        # All that may be among the nearest, whatever was rounded; those are put in order exactly.
        limit = np.sort(row)[k - 1] * (1 + _rounding)
        may = np.flatnonzero(row <= limit).tolist()
        expected.append(sorted(may, key=lambda j, i=i: (oracle.squared(exact[i], exact[j]), j))[:k])
    found = beespace.nearest(points, k)
    assert found.ids.tolist() == expected
    assert beespace.nearest(points).ids[:, 0].tolist() == [row[0] for row in expected]
    index = beespace.Index(points)
    assert index.nearest(points, k + 1).distances[:, 1:].tolist() == found.distances.tolist()
    closest = beespace.closest_pair(points)
    assert (closest.i, closest.j) == min(
        ((i, row[0]) for i, row in enumerate(expected) if i < row[0]),
        key=lambda pair: (oracle.squared(exact[pair[0]], exact[pair[1]]), pair),
    )


def test_thresholds_are_where_floats_cannot_tell():
    unsure = 0
    for _, points, threshold in _scenes():
        unsure += _near(points, points, threshold, False, None)[1]
    assert unsure > 1000  # or the scenes prove nothing about the threshold itself


def test_a_row_of_the_grid_that_is_searched_part_by_part():
    # All are in one row, which has more comparisons than are made at once. Whole numbers: distances
    # are compared exactly, and many are the threshold itself.
    places = np.random.default_rng(8).integers(0, [4000, 2, 2], (7000, 3))
    counts = np.full(len(places), 0)
    for start in range(0, len(places), 500):
        offsets = places[start : start + 500, None, :] - places[None, :, :]
        near = (offsets**2).sum(axis=2) < 25**2
        counts[start : start + 500] = near.sum(axis=1) - 1
    points = places.astype(float)
    assert (beespace.count(points, 25) == counts).all()
    found = beespace.pairs(points, 25, distances=False)
    assert (np.bincount(np.r_[found.i, found.j], minlength=len(points)) == counts).all()
    assert (np.diff(beespace.neighbors(points, 25, distances=False).indptr) == counts).all()
