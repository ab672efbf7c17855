"""Peers that make lists of neighbours by cells: vesin, matscipy, freud."""

from __future__ import annotations

from typing import Any

import numpy as np

from questions import Answer, of_pairs, of_rows
from ways import Points, Way, as_flags, as_it_is, of_nearest


def _pairs(found: Any, points: Points) -> Answer:
    return of_pairs(found[0], found[1], len(points), found[2] if len(found) > 2 else None)


def _rows(found: Any, points: Points) -> Answer:
    return of_rows(found[0], found[1], len(points), found[2] if len(found) > 2 else None)


def _flags(ids: Any, n: int) -> Any:
    flags = np.zeros(n, bool)
    for some in ids:
        flags[some] = True
    return flags


def _upper(found: Any) -> tuple[Any, ...]:
    once = found[0] < found[1]
    return tuple(column[once] for column in found)


def _with_offsets(found: Any, n: int) -> tuple[Any, ...]:
    """Of ids in the order of their rows."""
    offsets = np.zeros(n + 1, np.int64)
    np.cumsum(np.bincount(found[0], minlength=n), out=offsets[1:])
    return (offsets, *found[1:])


def of_vesin() -> list[Way]:
    from vesin import NeighborList

    name = "vesin"

    def ask(points: Points, x: float, full: bool, quantities: str) -> Any:
        neighbors = NeighborList(cutoff=x, full_list=full, sorted=full, n_threads=1)
        return neighbors.compute(points, np.zeros((3, 3)), False, quantities)

    def half(points: Points, x: float) -> Any:
        i, j = ask(points, x, False, "ij")
        return i.astype(np.int64, copy=False), j.astype(np.int64, copy=False)

    def counts(points: Points, x: float) -> Any:
        n = len(points)
        return sum(np.bincount(ids, minlength=n) for ids in half(points, x))

    def rows(points: Points, x: float, quantities: str) -> Any:
        i, *more = ask(points, x, True, quantities)
        return _with_offsets((i.astype(np.int64, copy=False), *more), len(points))

    return [
        Way(name, "NeighborList", "at_risk", lambda p, x: _flags(half(p, x), len(p)), as_flags),
        Way(name, "NeighborList", "pairs", half, _pairs),
        Way(name, "NeighborList", "pairs_m", lambda p, x: ask(p, x, False, "ijd"), _pairs),
        Way(name, "NeighborList, then bincount", "counts", counts, as_it_is),
        Way(name, "NeighborList", "neighbors", lambda p, x: rows(p, x, "ij"), _rows),
        Way(name, "NeighborList", "neighbors_m", lambda p, x: rows(p, x, "ijd"), _rows),
    ]


def of_matscipy() -> list[Way]:
    from matscipy.neighbours import neighbour_list

    name = "matscipy"

    def ask(quantities: str, points: Points, x: float) -> Any:
        low = points.min(axis=0)
        cell = np.diag(points.max(axis=0) - low)
        return neighbour_list(
            quantities,
            positions=points,
            cell=cell,
            pbc=np.zeros(3, bool),
            cell_origin=low,
            cutoff=x,
        )

    def rows(points: Points, x: float, quantities: str) -> Any:
        return _with_offsets(ask(quantities, points, x), len(points))

    how = "neighbour_list"
    return [
        Way(name, how, "at_risk", lambda p, x: _flags([ask("i", p, x)], len(p)), as_flags),
        Way(name, how, "pairs", lambda p, x: _upper(ask("ij", p, x)), _pairs),
        Way(name, how, "pairs_m", lambda p, x: _upper(ask("ijd", p, x)), _pairs),
        Way(
            name,
            f"{how}, then bincount",
            "counts",
            lambda p, x: np.bincount(ask("i", p, x), minlength=len(p)),
            as_it_is,
        ),
        Way(name, how, "neighbors", lambda p, x: rows(p, x, "ij"), _rows),
        Way(name, how, "neighbors_m", lambda p, x: rows(p, x, "ijd"), _rows),
    ]


def of_freud() -> list[Way]:
    from freud.box import Box
    from freud.locality import AABBQuery
    from freud.parallel import set_num_threads

    set_num_threads(1)
    name = "freud"

    def box_of(points: Points, x: float) -> tuple[Any, Any]:
        low, high = points.min(axis=0), points.max(axis=0)
        # A box without periods is not implemented: so wide that no points meet across its border.
        box = Box(*(high - low + 4.0 * x))
        return box, (points - (low + high) / 2.0).astype(np.float32)

    def ask(points: Points, x: float) -> Any:
        box, centred = box_of(points, x)
        query = AABBQuery(box, centred)
        return query.query(centred, {"r_max": x, "exclude_ii": True}).toNeighborList()

    def pairs(points: Points, x: float, distances: bool) -> Any:
        found = ask(points, x)
        columns = (found.query_point_indices, found.point_indices)
        return _upper((*columns, found.distances) if distances else columns)

    def rows(points: Points, x: float, distances: bool) -> Any:
        found = ask(points, x)
        columns = (found.query_point_indices, found.point_indices)
        return _with_offsets((*columns, found.distances) if distances else columns, len(points))

    def nearest(points: Points, x: float, k: int) -> Any:
        box, centred = box_of(points, x)
        asked = {"mode": "nearest", "num_neighbors": k, "exclude_ii": True}
        found = AABBQuery(box, centred).query(centred, asked).toNeighborList(sort_by_distance=True)
        shape = (len(points), k)
        return found.distances.reshape(shape), found.point_indices.reshape(shape)

    def way(how: str, question: str, ask_it: Any, read: Any) -> Way:
        return Way(name, how, question, ask_it, read, floats=True)

    return [
        way("AABBQuery", "at_risk", lambda p, x: ask(p, x).neighbor_counts > 0, as_flags),
        way("AABBQuery", "pairs", lambda p, x: pairs(p, x, False), _pairs),
        way("AABBQuery", "pairs_m", lambda p, x: pairs(p, x, True), _pairs),
        way("AABBQuery", "counts", lambda p, x: ask(p, x).neighbor_counts, as_it_is),
        way("AABBQuery", "neighbors", lambda p, x: rows(p, x, False), _rows),
        way("AABBQuery", "neighbors_m", lambda p, x: rows(p, x, True), _rows),
        way("AABBQuery", "nearest", lambda p, x: nearest(p, x, 1), of_nearest),
        way("AABBQuery", "nearest_8", lambda p, x: nearest(p, x, 8), of_nearest),
    ]
