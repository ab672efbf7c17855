"""Each function answers as two loops do that never round: of any floats, lattices and ties, both
types of floats, one set and two."""

from __future__ import annotations

import time

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import beespace
import oracle

lattice = st.integers(-4, 4).map(float)
anywhere = st.floats(-1e6, 1e6, allow_subnormal=False, width=32).filter(
    lambda value: value == 0 or abs(value) > 1e-30
)
points_of = st.builds(
    lambda dtype, axes, coordinates: (dtype, axes, coordinates),
    st.sampled_from([np.float32, np.float64]),
    st.sampled_from([2, 3]),
    st.sampled_from([lattice, anywhere]),
).flatmap(
    lambda kind: hnp.arrays(
        kind[0], st.integers(0, 9).map(lambda n: (n, kind[1])), elements=kind[2]
    )
)
thresholds = st.sampled_from([1.0, np.sqrt(2.0), 2.0, np.nextafter(2.0, 0.0), 5.0, 1e5])
engines = st.sampled_from([beespace, beespace.Engine()])
many = settings(
    max_examples=80, deadline=None, suppress_health_check=[HealthCheck.too_slow], derandomize=True
)


@many
@given(engines, points_of, thresholds, st.booleans(), st.sampled_from([None, 1.0, 2.5]))
def test_of_one_set(engine, points, threshold, inclusive, vertical):
    expected = oracle.pairs(points, threshold, None, inclusive, vertical)
    options = {"inclusive": inclusive, "vertical": vertical}
    found = engine.pairs(points, threshold, **options)
    assert list(zip(found.i, found.j)) == expected
    assert found.i.dtype == found.j.dtype == np.int64
    assert found.distance.tolist() == [oracle.distance(points[i], points[j]) for i, j in expected]

    at_risk = sorted({point for pair in expected for point in pair})
    assert engine.at_risk(points, threshold, **options).tolist() == at_risk
    flags = engine.at_risk(points, threshold, mask=True, **options)
    assert flags.shape == (len(points),) and np.flatnonzero(flags).tolist() == at_risk

    rows = [[] for _ in points]
    for i, j in expected:
        rows[i].append(j)
        rows[j].append(i)
    neighbors = engine.neighbors(points, threshold, **options)
    assert [row.tolist() for row in neighbors] == [sorted(row) for row in rows]
    with_self = engine.neighbors(points, threshold, include_self=True, **options)
    assert [row.tolist() for row in with_self] == [
        sorted([*row, i]) for i, row in enumerate(rows)
    ]
    assert engine.count(points, threshold, **options).tolist() == [len(row) for row in rows]
    assert engine.count(points, threshold, include_self=True, **options).tolist() == [
        len(row) + 1 for row in rows
    ]


@many
@given(engines, points_of, thresholds)
def test_groups_are_what_steps_reach(engine, points, threshold):
    label = list(range(len(points)))
    linked = oracle.pairs(points, threshold)
    for i, j in linked:
        old, new = max(label[i], label[j]), min(label[i], label[j])
        label = [new if each == old else each for each in label]
    at_risk = {point for pair in linked for point in pair}
    members = {}
    for point in sorted(at_risk):
        members.setdefault(label[point], []).append(point)
    groups = engine.groups(points, threshold)
    assert [group.tolist() for group in groups] == list(members.values())
    assert all(
        (groups.labels[i] == groups.labels[j]) == (label[i] == label[j])
        for i in at_risk
        for j in at_risk
    )
    assert (groups.labels == -1).sum() == len(points) - len(at_risk)


@many
@given(engines, points_of, st.data(), thresholds)
def test_of_two_sets(engine, points, data, threshold):
    others = data.draw(
        hnp.arrays(points.dtype, st.integers(0, 9).map(lambda n: (n, points.shape[1])),
                   elements=lattice)
    )
    expected = oracle.pairs(points, threshold, others)
    found = engine.pairs(points, threshold, others=others)
    assert list(zip(found.i, found.j)) == expected
    assert found.shape == (len(points), len(others))
    rows = [[j for first, j in expected if first == i] for i in range(len(points))]
    assert [
        row.tolist() for row in engine.neighbors(points, threshold, others=others)
    ] == rows
    assert engine.count(points, threshold, others=others).tolist() == [len(row) for row in rows]
    assert engine.at_risk(points, threshold, others=others).tolist() == [
        i for i, row in enumerate(rows) if row
    ]
    for k in (1, 2):
        assert engine.nearest(points, k, others=others).ids.tolist() == oracle.nearest(
            points, k, others
        )


@many
@given(engines, points_of, st.integers(0, 5), thresholds)
def test_the_nearest(engine, points, k, threshold):
    expected = oracle.nearest(points, k)
    found = engine.nearest(points, k)
    assert found.ids.shape == found.distances.shape == (len(points), k)
    assert found.ids.tolist() == expected
    assert found.distances.tolist() == [
        [np.inf if j < 0 else oracle.distance(points[i], points[j]) for j in row]
        for i, row in enumerate(expected)
    ]
    first = oracle.nearest(points, 1)
    near = set(oracle.pairs(points, threshold))
    within = engine.nearest(points, within=threshold)
    assert within.ids[:, 0].tolist() == [
        j if tuple(sorted((i, j))) in near else -1 for i, (j,) in enumerate(first)
    ]
    closest = engine.closest_pair(points)
    if len(points) < 2:
        assert closest is None
    else:
        distances = oracle.exact(points)
        assert (closest.i, closest.j) == min(
            ((i, j) for j in range(len(points)) for i in range(j)),
            key=lambda pair: (oracle.squared(distances[pair[0]], distances[pair[1]]), pair),
        )
        assert closest.distance == oracle.distance(points[closest.i], points[closest.j])


@many
@given(points_of, hnp.arrays(np.float64, (3, 3), elements=lattice), thresholds)
def test_an_index_answers_about_any_place(points, places, threshold):
    index = beespace.Index(points)
    axes = points.shape[1]
    given_points = np.zeros((len(points), 3))
    given_points[:, :axes] = points
    flown, places = places[:, :axes], places.copy()
    places[:, axes:] = 0
    around = index.around(flown, threshold)
    expected = oracle.pairs(places, threshold, given_points)
    assert [row.tolist() for row in around] == [
        [j for i, j in expected if i == row] for row in range(3)
    ]
    each = [0.0, threshold, 2 * threshold]
    assert [row.tolist() for row in index.around(flown, each, inclusive=True)] == [
        [
            j
            for j, other in enumerate(oracle.exact(given_points))
            if oracle.is_closer(place, other, radius, True, None)
        ]
        for place, radius in zip(oracle.exact(places), each)
    ]
    assert index.nearest(flown, 2).ids.tolist() == oracle.nearest(places, 2, given_points)
    assert len(index) == len(points)


def test_an_index_wants_one_radius_or_one_for_each_place():
    index = beespace.Index([[0, 0, 0], [10, 0, 0]])
    for radii, code, place, record in (
        ([1.0], "invalid_argument", "radius", None),
        ([[1.0, 2.0]], "invalid_argument", "radius", None),
        ([1.0, -2.0], "invalid_threshold", "radius", 1),
    ):
        with pytest.raises(beespace.BeespaceError) as caught:
            index.around([[0, 0, 0], [1, 0, 0]], radii)
        error = caught.value
        assert (error.code, error.place, error.record) == (code, place, record)


def test_an_index_changes():
    index = beespace.Index([[0, 0, 0], [10, 0, 0]])
    assert index.insert((20, 0, 0)) == 2
    index.move(0, (30, 0, 0))
    index.remove(1)
    assert len(index) == 2
    assert index[0].tolist() == [30, 0, 0]
    assert index.nearest([[0, 0, 0]], 3).ids.tolist() == [[2, 0, -1]]
    assert index.around([[20, 0, 0]], 10, inclusive=True).to_csr().shape == (1, 3)
    for id in (1, 3, 2**40):
        with pytest.raises(beespace.BeespaceError) as caught:
            index.remove(id)
        assert caught.value.code == "invalid_argument"


@pytest.mark.parametrize("chunk", [1, 7, 4096, 10**6])
@pytest.mark.parametrize("threads", [1, 2])
def test_pieces_are_all_pairs(chunk, threads):
    points = np.random.default_rng(18).uniform(0, 20, (3000, 3))
    pieces = list(beespace.iter_pairs(points, 1.5, chunk=chunk, threads=threads))
    assert all(0 < len(piece) <= chunk for piece in pieces)
    expected = beespace.pairs(points, 1.5)
    i, j, distance = (
        np.concatenate([getattr(piece, name) for piece in pieces]) for name in ("i", "j", "distance")
    )
    order = np.lexsort((j, i))
    assert (i[order] == expected.i).all() and (j[order] == expected.j).all()
    assert (distance[order] == expected.distance).all()
    assert len(pieces) == -(-len(expected) // chunk)


def test_who_takes_one_piece_ends_the_search():
    points = np.random.default_rng(18).uniform(0, 1, (50_000, 3))
    pieces = beespace.iter_pairs(points, 0.9, chunk=1000, distances=False)
    piece = next(pieces)
    assert len(piece) == 1000 and piece.distance is None
    began = time.monotonic()
    pieces.close()
    assert time.monotonic() - began < 5  # all of them would take a minute
    assert list(pieces) == []


def test_answers_turn_into_what_others_use():
    points = np.random.default_rng(1).uniform(0, 10, (60, 3))
    found = beespace.pairs(points, 3)
    matrix = found.to_csr()
    assert (matrix != beespace.neighbors(points, 3).to_csr()).nnz == 0
    assert matrix[found.i[0], found.j[0]] == matrix[found.j[0], found.i[0]] == found.distance[0]
    between = beespace.pairs(points, 3, others=points[:10]).to_csr()
    assert between.shape == (60, 10)
    assert beespace.pairs(points, 3, distances=False).to_csr().dtype == bool
    assert repr(found).startswith(f"<Pairs: {len(found):,} pairs of 60 points, ")
    assert repr(beespace.groups(points, 3)).startswith("<Groups: ")
    assert " of 60 points, " in repr(beespace.neighbors(points, 3))
    assert repr(beespace.nearest(points, 2)).startswith("<Nearest: the 2 nearest of each of 60 points, ")
    for call, said in [
        (lambda: beespace.pairs(points[:1], 3), "<Pairs: 0 pairs of 1 point>"),
        (lambda: beespace.pairs(points[:0], 3), "<Pairs: 0 pairs of 0 points>"),
        (lambda: beespace.neighbors(points[:0], 3), "<Neighbors: 0 neighbours of 0 points>"),
        (lambda: beespace.groups(points[:1], 3), "<Groups: 0 groups with 0 of 1 point>"),
        (lambda: beespace.nearest(points[:1], 2), "<Nearest: the 2 nearest of 1 point, none found>"),
        (lambda: beespace.Index(points[:1]), "<beespace.Index: 1 point>"),
        (beespace.Engine, "<beespace.Engine: 0 calls so far>"),
    ]:
        assert repr(call()) == said


def test_of_pandas():
    points = np.random.default_rng(1).uniform(0, 10, (60, 3))
    found = beespace.pairs(points, 3)
    pandas = pytest.importorskip("pandas")
    frame = found.to_pandas()
    assert frame.columns.tolist() == ["i", "j", "distance"] and len(frame) == len(found)
    given_frame = pandas.DataFrame(points, columns=["x", "y", "z"])
    assert (beespace.pairs(given_frame, 3).j == found.j).all()
    assert (beespace.pairs(tuple(given_frame[c] for c in "xyz"), 3).j == found.j).all()


def test_of_polars():
    points = np.random.default_rng(1).uniform(0, 10, (60, 3))
    found = beespace.pairs(points, 3)
    polars = pytest.importorskip("polars")
    assert found.to_polars().shape == (len(found), 3)
    frame = polars.DataFrame({name: points[:, axis] for axis, name in enumerate("xyz")})
    assert (beespace.pairs(frame, 3).j == found.j).all()
