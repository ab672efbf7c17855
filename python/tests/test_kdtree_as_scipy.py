"""The trees of SciPy, run by beespace, answer as SciPy does, and hand over what is SciPy's."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from beespace.compat.scipy import KDTree, answered, cKDTree, handed_over

spatial = pytest.importorskip("scipy.spatial", reason="SciPy is not installed")


@pytest.fixture(autouse=True)
def counters() -> None:
    answered.clear()
    handed_over.clear()


def same(ours: Any, theirs: Any) -> None:
    """Of the same types, shapes and values, but for the order in rows."""
    assert type(ours) is type(theirs)
    if isinstance(ours, tuple):
        for mine, its in zip(ours, theirs):
            same(mine, its)
    elif isinstance(ours, list):
        assert sorted(ours) == sorted(theirs)
        assert all(type(each) is int or isinstance(each, list) for each in ours)
    elif isinstance(ours, np.ndarray):
        assert ours.shape == theirs.shape and ours.dtype == theirs.dtype
        assert ours.flags.writeable == theirs.flags.writeable
        if ours.dtype == object:
            for mine, its in zip(ours.ravel(), theirs.ravel()):
                same(mine, its)
        elif ours.dtype.names or ours.ndim == 2 and ours.dtype == np.intp and ours.shape[1] == 2:
            assert np.array_equal(np.sort(ours, axis=0), np.sort(theirs, axis=0))
        else:
            assert np.array_equal(ours, theirs)
    elif hasattr(ours, "toarray"):
        assert ours.shape == theirs.shape and ours.dtype == theirs.dtype
        assert np.array_equal(ours.toarray(), theirs.toarray()) and ours.nnz == theirs.nnz
    else:
        assert ours == theirs


# Points in general position: no distance is near a threshold, and no two are the same.
CALLS: dict[str, Any] = {
    "query": lambda t, o, x: t.query(x),
    "query, one": lambda t, o, x: t.query(x[0]),
    "query, one of a list": lambda t, o, x: t.query(list(x[0]), 3),
    "query, k=5": lambda t, o, x: t.query(x, 5),
    "query, k=[1]": lambda t, o, x: t.query(x, [1]),
    "query, k=[3, 1]": lambda t, o, x: t.query(x, [3, 1]),
    "query, k as numpy": lambda t, o, x: t.query(x, np.int32(2)),
    "query, k as array": lambda t, o, x: t.query(x[0], np.array([2, 5])),
    "query, more than there are": lambda t, o, x: t.query(x, 1000),
    "query, list with more": lambda t, o, x: t.query(x, [1, 1000]),
    "query, bound": lambda t, o, x: t.query(x, 20, distance_upper_bound=0.4),
    "query, bound, all": lambda t, o, x: t.query(x, t.n, distance_upper_bound=0.4),
    "query, bound 0": lambda t, o, x: t.query(x, 2, distance_upper_bound=0),
    "query, shapes": lambda t, o, x: t.query(x.reshape(4, 5, -1), 2),
    "query, nothing": lambda t, o, x: t.query(x[:0]),
    "query, nothing, k=2": lambda t, o, x: t.query(x[:0], 2),
    "query, strides": lambda t, o, x: t.query(np.asfortranarray(x)[::2], 2),
    "query, float32": lambda t, o, x: t.query(x.astype(np.float32), 2),
    "query, integers": lambda t, o, x: t.query(x.astype(int)[:1]),
    "query, workers": lambda t, o, x: t.query(x, 2, workers=-1),
    "query, workers 3": lambda t, o, x: t.query(x, 2, workers=3),
    "query, workers None": lambda t, o, x: t.query(x, 2, workers=None),
    "ball": lambda t, o, x: t.query_ball_point(x, 0.3),
    "ball, one": lambda t, o, x: t.query_ball_point(x[0], 0.3),
    "ball, shapes": lambda t, o, x: t.query_ball_point(x.reshape(5, 4, -1), 0.3),
    "ball, 0": lambda t, o, x: t.query_ball_point(t.data, 0),
    "ball, nothing": lambda t, o, x: t.query_ball_point(x[:0], 0.3),
    "ball, lengths": lambda t, o, x: t.query_ball_point(x, 0.3, return_length=True),
    "ball, length": lambda t, o, x: t.query_ball_point(x[0], 0.3, return_length=True),
    "ball, each": lambda t, o, x: t.query_ball_point(x, np.linspace(0, 1, len(x))),
    "ball, broadcast": lambda t, o, x: t.query_ball_point(x.reshape(4, 5, -1), [0.1, 0.2, 0.3, 0, 2]),
    "ball, sorted": lambda t, o, x: t.query_ball_point(x, 0.3, return_sorted=True, workers=2),
    "tree": lambda t, o, x: t.query_ball_tree(o, 0.3),
    "tree, itself": lambda t, o, x: t.query_ball_tree(t, 0.3),
    "pairs": lambda t, o, x: t.query_pairs(0.3),
    "pairs, array": lambda t, o, x: t.query_pairs(0.3, output_type="ndarray"),
    "pairs, none": lambda t, o, x: t.query_pairs(0, output_type="ndarray"),
    "count": lambda t, o, x: t.count_neighbors(o, 0.3),
    "count, 0-d": lambda t, o, x: t.count_neighbors(o, np.array(0.3)),
    "count, many": lambda t, o, x: t.count_neighbors(o, [0.3, 0.1, 0.3, 2]),
    "count, apart": lambda t, o, x: t.count_neighbors(t, [0, 0.1, 0.3, 2], cumulative=False),
    "matrix": lambda t, o, x: t.sparse_distance_matrix(o, 0.3),
    "matrix, coo": lambda t, o, x: t.sparse_distance_matrix(t, 0.3, output_type="coo_matrix"),
    "matrix, dict": lambda t, o, x: t.sparse_distance_matrix(o, 0.3, output_type="dict"),
    "matrix, array": lambda t, o, x: t.sparse_distance_matrix(o, 0.3, output_type="ndarray"),
    "mins": lambda t, o, x: (t.mins, t.maxes, t.n, t.m, t.leafsize, t.boxsize),
}


@pytest.mark.parametrize("m", [2, 3])
@pytest.mark.parametrize("name", ["KDTree", "cKDTree"])
@pytest.mark.parametrize("call", CALLS)
def test_answers_have_the_form_of_scipys(call: str, name: str, m: int) -> None:
    random = np.random.default_rng(20)
    data, others, places = (random.normal(size=(size, m)) for size in (60, 30, 20))
    answers = []
    for maker in ({"KDTree": KDTree, "cKDTree": cKDTree}[name], getattr(spatial, name)):
        answers.append(CALLS[call](maker(data), maker(others), places))
    same(*answers)
    assert not handed_over and (answered or call == "mins")


REFUSED: dict[str, Any] = {
    "query, other shape": lambda t: t.query([1.0, 2.0, 3.0, 4.0]),
    "query, number": lambda t: t.query(1.0),
    "query, text": lambda t: t.query("abc"),
    "query, k=None": lambda t: t.query([1.0, 2.0], None),
    "query, k=0": lambda t: t.query([1.0, 2.0], 0),
    "query, k=[]": lambda t: t.query([1.0, 2.0], []),
    "query, k in two dimensions": lambda t: t.query([1.0, 2.0], [[1, 2]]),
    "query, k=array(2)": lambda t: t.query([1.0, 2.0], np.array(2)),
    "query, p": lambda t: t.query([1.0, 2.0], p=0.5),
    "query, bounds": lambda t: t.query([1.0, 2.0], distance_upper_bound=[1.0, 2.0]),
    "query, workers": lambda t: t.query([[1.0, 2.0]], workers=0),
    "query, workers 1.5": lambda t: t.query([[1.0, 2.0]], workers=1.5),
    "ball, other shape": lambda t: t.query_ball_point([1.0], 1),
    "ball, radii": lambda t: t.query_ball_point([1.0, 2.0], [1, 2]),
    "ball, more radii": lambda t: t.query_ball_point([[1.0, 2.0]] * 2, [1, 2, 3]),
    "tree, None": lambda t: t.query_ball_tree(None, 1),
    "tree, other dimension": lambda t: t.query_ball_tree(type(t)([[1.0, 2.0, 3.0]]), 1),
    "pairs, type": lambda t: t.query_pairs(1, output_type="list"),
    "pairs, array": lambda t: t.query_pairs([1, 2]),
    "pairs, None": lambda t: t.query_pairs(None),
    "count, rows": lambda t: t.count_neighbors(t, [[1, 2]]),
    "count, descending": lambda t: t.count_neighbors(t, [2, 1], cumulative=False),
    "matrix, type": lambda t: t.sparse_distance_matrix(t, 1, output_type="csr_matrix"),
    "of one dimension": lambda t: type(t)([1.0, 2.0]),
    "of three dimensions": lambda t: type(t)(np.zeros((2, 2, 2))),
    "of text": lambda t: type(t)([["a", "b"]]),
    "leafsize": lambda t: type(t)([[1.0, 2.0]], leafsize=0),
    "box": lambda t: type(t)([[1.0, 2.0]], boxsize=0.5),
}


@pytest.mark.parametrize("call", REFUSED)
def test_refuses_what_scipy_refuses(call: str) -> None:
    kinds = []
    for maker in (KDTree, spatial.KDTree):
        with pytest.raises((ValueError, TypeError, AttributeError)) as caught:
            REFUSED[call](maker([[0.0, 0.0], [1.0, 1.0]]))
        kinds.append(caught.type)
    assert kinds[0] is kinds[1] or issubclass(kinds[0], ValueError) and "k=" in call


def test_ranks_below_one_are_refused_where_scipy_may_crash() -> None:
    tree = KDTree([[0.0, 0.0], [1.0, 1.0]])
    for k in (0, -1, [0], [1, -1], [0.5], []):
        with pytest.raises(ValueError, match="from 1"):
            tree.query([0.0, 0.0], k)
    assert not handed_over


@pytest.mark.parametrize("of", ["data", "query", "ball"])
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_what_is_not_finite_is_for_scipy(of: str, value: float) -> None:
    def ask(maker: Any) -> Any:
        try:
            if of == "data":
                return maker([[0.0, 1.0], [value, 0.0]]).query_pairs(3)
            tree = maker([[0.0, 1.0], [1.0, 0.0]])
            return tree.query([value, 0]) if of == "query" else tree.query_ball_point([value, 0], 1)
        except ValueError as error:
            return str(error)

    same(ask(KDTree), ask(spatial.KDTree))
    assert handed_over and not answered


HANDED: dict[str, Any] = {
    "p is not 2": lambda t: t.query_pairs(0.5, p=1),
    "eps is not 0": lambda t: t.query_ball_tree(t, 0.5, eps=0.1),
    "weights": lambda t: t.count_neighbors(t, 0.5, weights=np.ones(t.n)),
    "boxsize": lambda t: type(t)(abs(t.data), boxsize=9).query(t.data, 2),
    "points of 4 coordinates": lambda t: type(t)(np.tile(t.data, 2)).query_pairs(0.5),
    "points of 1 coordinates": lambda t: type(t)(t.data[:, :1]).query_pairs(0.5),
    "a radius that is negative, infinite or no number": lambda t: t.query_pairs(np.inf),
    "an upper bound that is negative or no number": lambda t: t.query(
        t.data, distance_upper_bound=np.nan
    ),
    "coordinates or a radius beyond 2^400 or 2^-400": lambda t: t.query_ball_point(t.data, 1e-300),
    "arguments that SciPy refuses, or knows better": lambda t: t.query(t.data, 2.0),
    "an attribute of the tree itself": lambda t: (t.size, t.indices),
}


@pytest.mark.parametrize("reason", HANDED)
def test_hands_over_and_counts_why(reason: str) -> None:
    data = np.random.default_rng(4).normal(size=(50, 2))
    same(HANDED[reason](KDTree(data)), HANDED[reason](spatial.KDTree(data)))
    assert handed_over and {why for _, why in handed_over} == {reason}
    assert not answered
    assert KDTree.handed_over is handed_over and KDTree.answered is answered


def test_takes_trees_of_scipy_and_gives_one() -> None:
    random = np.random.default_rng(5)
    data, others = random.normal(size=(40, 3)), random.normal(size=(30, 3))
    ours, theirs = KDTree(data), spatial.KDTree(others)
    same(ours.count_neighbors(theirs, 0.7), spatial.KDTree(data).count_neighbors(theirs, 0.7))
    assert not handed_over
    same(theirs.query_pairs(0.5), ours.to_scipy().__class__(others).query_pairs(0.5))
    same(theirs.count_neighbors(ours.to_scipy(), 0.7), ours.count_neighbors(theirs, 0.7))
    handed_over.clear()
    boxed = spatial.KDTree(abs(others), boxsize=9)
    same(ours.count_neighbors(boxed, 0.7), spatial.KDTree(data).count_neighbors(boxed, 0.7))
    assert handed_over == {("count_neighbors", "boxsize"): 1}


def test_the_tree_itself_is_scipys() -> None:
    tree = KDTree(np.random.default_rng(6).normal(size=(50, 2)))
    assert isinstance(tree.tree, KDTree.innernode) and tree.tree.children == 50
    assert type(tree.tree).__module__.startswith("scipy.")
    assert isinstance(KDTree.node(), spatial.KDTree.node)
    assert not hasattr(tree, "no_such_name") and not hasattr(KDTree, "no_such_name")
    with pytest.raises(AttributeError):
        tree.n = 3  # type: ignore[misc]


def test_holds_the_callers_points_unless_copied() -> None:
    data = np.random.default_rng(7).normal(size=(50, 2))
    held = KDTree(data).data
    assert held.base is data if not held.flags.writeable else held is data
    assert KDTree(data.tolist()).data.dtype == np.float64
    copied = KDTree(data, copy_data=True)
    expected = copied.query(data)
    places = data.copy()
    data[:] = 0
    same(copied.query(places), expected)
    assert KDTree(places[:, ::-1]).data.flags.c_contiguous


def test_pickles() -> None:
    data = np.random.default_rng(8).normal(size=(50, 3))
    for tree in (KDTree(data, leafsize=3), cKDTree(data), KDTree(abs(data), boxsize=9)):
        tree.query(abs(data))
        restored = pickle.loads(pickle.dumps(tree))
        assert type(restored) is type(tree) and restored.leafsize == tree.leafsize
        same(restored.query(abs(data), 3), tree.query(abs(data), 3))


def test_other_threads_may_ask() -> None:
    data = np.random.default_rng(9).normal(size=(2000, 3))
    tree, expected, wrong = KDTree(data), KDTree(data).query(data, 3), []

    def ask() -> None:
        for _ in range(5):
            if not np.array_equal(tree.query(data, 3)[1], expected[1]):
                wrong.append(1)

    threads = [threading.Thread(target=ask) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong and answered["query"] == 41


@settings(max_examples=30, deadline=None, derandomize=True)
@given(st.integers(0, 2**32))
def test_many_points_as_scipy(seed: int) -> None:
    random = np.random.default_rng(seed)
    m = int(random.integers(2, 4))
    data, places = random.random((700, m)), random.random((int(random.choice([3, 900])), m))
    ours, theirs = KDTree(data), spatial.KDTree(data)
    k = int(random.integers(1, 30))
    same(ours.query(places, k), theirs.query(places, k))
    same(
        ours.query(places, k, distance_upper_bound=0.1),
        theirs.query(places, k, distance_upper_bound=0.1),
    )
    same(ours.query_ball_point(places, 0.1), theirs.query_ball_point(places, 0.1))
    each = random.random(len(places)) * 0.2
    same(ours.query_ball_point(places, each), theirs.query_ball_point(places, each))
    same(ours.query_pairs(0.1), theirs.query_pairs(0.1))


def run_python(*arguments: str) -> subprocess.CompletedProcess[str]:
    root = str(Path(__file__).resolve().parent.parent)
    environment = {**os.environ, "PYTHONPATH": root}
    return subprocess.run(
        [sys.executable, *arguments], env=environment, capture_output=True, text=True, check=False
    )


def test_needs_scipy_only_for_what_is_handed_over() -> None:
    script = """
import sys
from beespace.compat.scipy import KDTree
tree = KDTree([[0.0, 0.0], [3.0, 4.0]])
assert tree.query([1, 1]) == (2 ** 0.5, 0) and tree.query_pairs(5) == {(0, 1)}
assert not any(name.split(".")[0] == "scipy" for name in sys.modules)
sys.modules["scipy"] = None
assert not hasattr(tree, "tree") and not hasattr(KDTree, "node")
try:
    tree.query_pairs(5, p=1)
except ImportError as error:
    print(error)
"""
    ran = run_python("-c", script)
    assert ran.returncode == 0, ran.stderr
    assert "p is not 2" in ran.stdout and "pip install scipy" in ran.stdout


def test_the_tests_of_scipy_pass() -> None:
    pytest.importorskip("scipy.spatial.tests.test_kdtree", reason="this SciPy has no tests inside")
    ran = run_python(str(Path(__file__).with_name("run_scipy_tests.py")))
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert "calls answered by beespace" in ran.stdout
