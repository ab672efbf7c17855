"""Peers that are trees: SciPy, scikit-learn, pykdtree."""

from __future__ import annotations

from typing import Any

import numpy as np

from questions import Answer, of_pairs, of_rows
from ways import Points, Way, as_flags, as_it_is, of_nearest


def _pairs(found: Any, points: Points) -> Answer:
    return of_pairs(found[:, 0], found[:, 1], len(points))


def _pairs_m(found: Any, points: Points) -> Answer:
    pairs, distances = found
    return of_pairs(pairs[:, 0], pairs[:, 1], len(points), distances)


def _matrix(found: Any, points: Points) -> Answer:
    return of_rows(found.indptr, found.indices, len(points))


def _matrix_m(found: Any, points: Points) -> Answer:
    return of_rows(found.indptr, found.indices, len(points), found.data)


def _flags(pairs: Any, n: int) -> Any:
    flags = np.zeros(n, bool)
    flags[pairs.ravel()] = True
    return flags


def of_scipy() -> list[Way]:
    from scipy.sparse import coo_matrix
    from scipy.spatial import cKDTree

    name = "SciPy cKDTree"

    def pairs(points: Points, x: float) -> Any:
        return cKDTree(points).query_pairs(x, output_type="ndarray")

    def pairs_m(points: Points, x: float) -> Any:
        found = pairs(points, x)
        apart = points[found[:, 0]] - points[found[:, 1]]
        return found, np.sqrt(np.einsum("ij,ij->i", apart, apart))

    def matrix(points: Points, x: float, distances: bool) -> Any:
        found, values = pairs_m(points, x) if distances else (pairs(points, x), None)
        if values is None:
            values = np.ones(len(found), bool)
        i = np.concatenate([found[:, 0], found[:, 1]])
        j = np.concatenate([found[:, 1], found[:, 0]])
        n = len(points)
        return coo_matrix((np.concatenate([values, values]), (i, j)), (n, n)).tocsr()

    def query(points: Points, k: int, **bounds: Any) -> Any:
        return cKDTree(points).query(points, k, **bounds)

    def nearest(points: Points, k: int) -> Any:
        distances, ids = query(points, k + 1)
        return distances[:, 1:], ids[:, 1:]  # the first is the point itself

    def some_near(points: Points, x: float) -> Any:
        distances, _ = query(points, 2, distance_upper_bound=x)
        return np.isfinite(distances[:, 1])

    def counts(points: Points, x: float) -> Any:
        return cKDTree(points).query_ball_point(points, x, return_length=True) - 1

    return [
        Way(name, "query_pairs", "at_risk", lambda p, x: _flags(pairs(p, x), len(p)), as_flags),
        Way(name, "query", "at_risk", some_near, as_flags),
        Way(name, "query_pairs", "pairs", pairs, _pairs),
        Way(name, "query_pairs, then NumPy", "pairs_m", pairs_m, _pairs_m),
        Way(
            name,
            "query_pairs, then bincount",
            "counts",
            lambda p, x: np.bincount(pairs(p, x).ravel(), minlength=len(p)),
            as_it_is,
        ),
        Way(name, "query_ball_point", "counts", counts, as_it_is),
        Way(
            name,
            "query_pairs, then tocsr",
            "neighbors",
            lambda p, x: matrix(p, x, False),
            _matrix,
        ),
        Way(
            name,
            "query_pairs, then tocsr",
            "neighbors_m",
            lambda p, x: matrix(p, x, True),
            _matrix_m,
        ),
        Way(name, "query", "nearest", lambda p, _: nearest(p, 1), of_nearest),
        Way(name, "query", "nearest_8", lambda p, _: nearest(p, 8), of_nearest),
    ]


def of_scikit_learn() -> list[Way]:
    from sklearn.neighbors import KDTree, NearestNeighbors

    name = "scikit-learn"

    def matrix(points: Points, x: float, mode: str) -> Any:
        fitted = NearestNeighbors(radius=x, algorithm="kd_tree").fit(points)
        return fitted.radius_neighbors_graph(mode=mode)

    def nearest(points: Points, k: int) -> Any:
        distances, ids = KDTree(points).query(points, k + 1)
        return distances[:, 1:], ids[:, 1:]

    return [
        Way(name, "KDTree.query", "at_risk", lambda p, x: nearest(p, 1)[0][:, 0] < x, as_flags),
        Way(
            name,
            "KDTree.query_radius",
            "counts",
            lambda p, x: KDTree(p).query_radius(p, x, count_only=True) - 1,
            as_it_is,
        ),
        Way(
            name,
            "radius_neighbors_graph",
            "neighbors",
            lambda p, x: matrix(p, x, "connectivity"),
            _matrix,
        ),
        Way(
            name,
            "radius_neighbors_graph",
            "neighbors_m",
            lambda p, x: matrix(p, x, "distance"),
            _matrix_m,
        ),
        Way(name, "KDTree.query", "nearest", lambda p, _: nearest(p, 1), of_nearest),
        Way(name, "KDTree.query", "nearest_8", lambda p, _: nearest(p, 8), of_nearest),
    ]


def of_pykdtree() -> list[Way]:
    from pykdtree.kdtree import KDTree

    name = "pykdtree"

    def nearest(points: Points, k: int) -> Any:
        distances, ids = KDTree(points).query(points, k + 1)
        return distances[:, 1:], ids[:, 1:]

    def some_near(points: Points, x: float) -> Any:
        distances, _ = KDTree(points).query(points, 2, distance_upper_bound=x)
        return np.isfinite(distances[:, 1])

    return [
        Way(name, "query", "at_risk", some_near, as_flags),
        Way(name, "query", "nearest", lambda p, _: nearest(p, 1), of_nearest),
        Way(name, "query", "nearest_8", lambda p, _: nearest(p, 8), of_nearest),
    ]
