"""Every question, with every option, of one set and of two, in every layout and both types of
floats: what loops over fractions answer. Thresholds are distances of the points themselves, and the
floats beside them, where the arithmetic of floats cannot tell."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import beespace
import oracle
from layouts import layouts

_many = settings(
    max_examples=40,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
    derandomize=True,
)
_elements = [
    st.integers(-3, 3).map(float),
    st.integers(-12, 12).map(lambda tenths: float(np.float32(tenths / 10))),
    st.floats(-1e6, 1e6, allow_subnormal=False, width=32).filter(
        lambda value: value == 0 or abs(value) > 1e-30
    ),
]


@dataclass
class Question:
    """Points and options, and the pairs that two loops find."""

    points: Any
    others: Any
    threshold: float
    vertical: float | None
    inclusive: bool
    layout: str
    others_layout: str
    engine: Any

    @property
    def given(self) -> Any:
        return layouts[self.layout](self.points)

    @property
    def sets(self) -> dict[str, Any]:
        return {} if self.others is None else {"others": layouts[self.others_layout](self.others)}

    @property
    def options(self) -> dict[str, Any]:
        return {"vertical": self.vertical, "inclusive": self.inclusive, **self.sets}

    def pairs(self) -> list[tuple[int, int]]:
        return oracle.pairs(
            self.points, self.threshold, self.others, self.inclusive, self.vertical
        )

    def rows(self) -> list[list[int]]:
        rows: list[list[int]] = [[] for _ in self.points]
        for i, j in self.pairs():
            rows[i].append(j)
            if self.others is None:
                rows[j].append(i)
        return [sorted(row) for row in rows]

    def distance(self, i: int, j: int) -> float:
        theirs = self.points if self.others is None else self.others
        return oracle.distance(self.points[i], theirs[j])


@st.composite
def _sets(draw: Any, axes: int) -> Any:
    dtype = draw(st.sampled_from([np.float64, np.float32]))
    shape = st.integers(0, 9).map(lambda count: (count, axes))
    return draw(hnp.arrays(dtype, shape, elements=draw(st.sampled_from(_elements))))


@st.composite
def questions(draw: Any, two_sets: bool) -> Question:
    axes = draw(st.sampled_from([2, 3]))
    points = draw(_sets(axes))
    others = draw(_sets(axes)) if two_sets else None
    theirs = points if others is None else others
    threshold = draw(st.sampled_from([1.0, 2.5, 1e5]))
    if len(points) and len(theirs):
        i = draw(st.integers(0, len(points) - 1))
        j = draw(st.integers(0, len(theirs) - 1))
        between = oracle.distance(points[i], theirs[j])
        if between > 0:
            towards = draw(st.sampled_from([0.0, between, np.inf]))
            threshold = float(np.nextafter(between, towards))
    vertical = draw(st.sampled_from([None, None, 0.5, 1.0, 1e5]))
    named = st.sampled_from(list(layouts))
    engine = draw(st.sampled_from([beespace, _engine]))
    return Question(
        points, others, threshold, vertical, draw(st.booleans()), draw(named), draw(named), engine
    )


_engine = beespace.Engine()
_any_sets = st.booleans().flatmap(questions)


@_many
@given(_any_sets)
def test_pairs(asked):
    expected = asked.pairs()
    found = asked.engine.pairs(asked.given, asked.threshold, **asked.options)
    assert list(zip(found.i.tolist(), found.j.tolist())) == expected
    assert found.distance.tolist() == [asked.distance(i, j) for i, j in expected]
    bare = asked.engine.pairs(asked.given, asked.threshold, distances=False, **asked.options)
    assert bare.distance is None and (bare.i == found.i).all() and (bare.j == found.j).all()


@_many
@given(_any_sets, st.integers(0, 12))
def test_max_results_is_an_error_or_nothing(asked, most):
    expected = asked.pairs()
    neighbours = sum(len(row) for row in asked.rows())
    for ask, count in [
        (asked.engine.pairs, len(expected)),
        (asked.engine.neighbors, neighbours),
    ]:
        if count > most:
            with pytest.raises(beespace.BeespaceError) as caught:
                ask(asked.given, asked.threshold, max_results=most, **asked.options)
            assert caught.value.code == "too_many_results"
        else:
            found = ask(asked.given, asked.threshold, max_results=most, **asked.options)
            assert len(found.i if hasattr(found, "i") else found.indices) == count


@_many
@given(_any_sets)
def test_at_risk_neighbors_and_counts(asked):
    rows = asked.rows()
    at_risk = [i for i, row in enumerate(rows) if row]
    assert asked.engine.at_risk(asked.given, asked.threshold, **asked.options).tolist() == at_risk
    mask = asked.engine.at_risk(asked.given, asked.threshold, mask=True, **asked.options)
    assert np.flatnonzero(mask).tolist() == at_risk and len(mask) == len(rows)
    neighbors = asked.engine.neighbors(asked.given, asked.threshold, **asked.options)
    assert [row.tolist() for row in neighbors] == rows
    assert neighbors.distances.tolist() == [
        asked.distance(i, j) for i, row in enumerate(rows) for j in row
    ]
    counts = asked.engine.count(asked.given, asked.threshold, **asked.options)
    assert counts.tolist() == [len(row) for row in rows]
    if asked.others is None:
        options = {**asked.options, "include_self": True}
        with_self = [sorted([*row, i]) for i, row in enumerate(rows)]
        found = asked.engine.neighbors(asked.given, asked.threshold, **options)
        assert [row.tolist() for row in found] == with_self
        assert found.distances.tolist() == [
            asked.distance(i, j) for i, row in enumerate(with_self) for j in row
        ]
        counts = asked.engine.count(asked.given, asked.threshold, **options)
        assert counts.tolist() == [len(row) for row in with_self]


@_many
@given(questions(two_sets=False), st.integers(1, 5))
def test_groups_and_pieces(asked, chunk):
    rows = asked.rows()
    label = list(range(len(rows)))
    for _ in rows:  # labels go down along steps, until none does
        label = [min([label[i], *(label[j] for j in row)]) for i, row in enumerate(rows)]
    members: dict[int, list[int]] = {}
    for i, row in enumerate(rows):
        if row:
            members.setdefault(label[i], []).append(i)
    groups = asked.engine.groups(asked.given, asked.threshold, **asked.options)
    assert [group.tolist() for group in groups] == list(members.values())
    number = {first: n for n, first in enumerate(members)}
    assert groups.labels.tolist() == [number[label[i]] if row else -1 for i, row in enumerate(rows)]

    expected = asked.pairs()
    shown_in_pieces = asked.engine.iter_pairs(
        asked.given, asked.threshold, chunk=chunk, **asked.options
    )
    pieces = list(shown_in_pieces)
    assert [len(piece) for piece in pieces[:-1]] == [chunk] * (len(pieces) - 1)
    assert len(pieces) == -(-len(expected) // chunk)
    shown = {(i, j): d for piece in pieces for i, j, d in zip(piece.i, piece.j, piece.distance)}
    assert sorted(shown) == expected == sorted(
        (i, j) for piece in pieces for i, j in zip(piece.i, piece.j)
    )
    assert all(between == asked.distance(i, j) for (i, j), between in shown.items())


@_many
@given(_any_sets, st.integers(0, 6))
def test_the_nearest(asked, k):
    expected = oracle.nearest(asked.points, k, asked.others)
    found = asked.engine.nearest(asked.given, k, **asked.sets)
    assert found.ids.tolist() == expected
    assert found.distances.tolist() == [
        [asked.distance(i, j) if j >= 0 else np.inf for j in row] for i, row in enumerate(expected)
    ]
    mine = oracle.exact(asked.points)
    theirs = mine if asked.others is None else oracle.exact(asked.others)
    within = [
        min(row, key=lambda j, i=i: (oracle.squared(mine[i], theirs[j]), j), default=-1)
        for i, row in enumerate(asked.rows())
    ]
    found = asked.engine.nearest(asked.given, within=asked.threshold, **asked.options)
    assert found.ids[:, 0].tolist() == within
    assert found.distances[:, 0].tolist() == [
        asked.distance(i, j) if j >= 0 else np.inf for i, j in enumerate(within)
    ]


@_many
@given(_any_sets)
def test_the_closest_pair(asked):
    mine = oracle.exact(asked.points)
    theirs = mine if asked.others is None else oracle.exact(asked.others)
    all_pairs = [
        (oracle.squared(a, b), i, j)
        for i, a in enumerate(mine)
        for j, b in enumerate(theirs)
        if asked.others is not None or i < j
    ]
    closest = asked.engine.closest_pair(asked.given, **asked.sets)
    if not all_pairs:
        assert closest is None
    else:
        _, i, j = min(all_pairs)
        assert tuple(closest) == (i, j, asked.distance(i, j))


@_many
@given(questions(two_sets=True), st.integers(0, 6))
def test_an_index(asked, k):
    index = beespace.Index(layouts[asked.others_layout](asked.others))
    rows: list[list[int]] = [[] for _ in asked.points]
    for i, j in oracle.pairs(asked.points, asked.threshold, asked.others, asked.inclusive):
        rows[i].append(j)
    around = index.around(asked.given, asked.threshold, inclusive=asked.inclusive)
    assert [row.tolist() for row in around] == rows
    found = index.nearest(asked.given, k)
    expected = oracle.nearest(asked.points, k, asked.others)
    assert found.ids.tolist() == expected
    assert found.distances.tolist() == [
        [asked.distance(i, j) if j >= 0 else np.inf for j in row] for i, row in enumerate(expected)
    ]


@pytest.mark.parametrize("layout", layouts)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("axes", [2, 3])
def test_layouts_are_the_same_points(layout, dtype, axes):
    points = np.random.default_rng(4).uniform(0, 9, (40, axes)).astype(dtype)
    seen = beespace._points.Points(layouts[layout](points), "points")
    given_rows = layouts[layout](points)
    found = beespace.pairs(given_rows, 2.0)
    assert list(zip(found.i.tolist(), found.j.tolist())) == oracle.pairs(points, 2.0)
    assert seen.count == 40


@pytest.mark.parametrize("ask", ["at_risk", "pairs", "iter_pairs", "neighbors", "count", "groups"])
def test_objects_are_refused(ask):
    objects = np.array([[0, 0, 0], [1, 0, 0]], dtype=object)
    for points in (objects, tuple(objects.T), [[0, 0, None], [1, 0, 0]]):
        with pytest.raises(beespace.BeespaceError) as caught:
            list(getattr(beespace, ask)(points, 2.0))
        assert caught.value.code == "invalid_argument" and caught.value.place == "points"


def test_objects_are_refused_everywhere_else():
    objects = np.array([[0, 0, 0], [1, 0, 0]], dtype=object)
    numbers = objects.astype(float)
    index = beespace.Index(numbers)
    for call, place in [
        (lambda: beespace.nearest(objects), "points"),
        (lambda: beespace.closest_pair(objects), "points"),
        (lambda: beespace.pairs(numbers, 2, others=objects), "others"),
        (lambda: beespace.Index(objects), "points"),
        (lambda: index.around(objects, 2), "places"),
        (lambda: index.nearest(objects), "places"),
        (lambda: index.insert(objects[0]), "point"),
        (lambda: index.move(0, objects[0]), "point"),
    ]:
        with pytest.raises(beespace.BeespaceError) as caught:
            call()
        assert caught.value.code == "invalid_argument" and caught.value.place == place
    assert len(index) == 2 and index[0].tolist() == [0, 0, 0]
