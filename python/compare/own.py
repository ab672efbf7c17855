"""beespace itself."""

from __future__ import annotations

from typing import Any

import beespace
from questions import Answer, of_pairs, of_rows
from ways import Points, Way, as_it_is, flags_of_ids, of_nearest

NAME = "beespace"


def _pairs(found: Any, points: Points) -> Answer:
    return of_pairs(found.i, found.j, len(points), found.distance)


def _rows(found: Any, points: Points) -> Answer:
    return of_rows(found.indptr, found.indices, len(points), found.distances)


def _nearest(found: Any, points: Points) -> Answer:
    return of_nearest((found.distances, found.ids), points)


def ways() -> list[Way]:
    """One for each question."""
    return [
        Way(NAME, "at_risk", "at_risk", beespace.at_risk, flags_of_ids),
        Way(
            NAME,
            "pairs",
            "pairs",
            lambda points, x: beespace.pairs(points, x, distances=False),
            _pairs,
        ),
        Way(NAME, "pairs", "pairs_m", beespace.pairs, _pairs),
        Way(NAME, "count", "counts", beespace.count, as_it_is),
        Way(
            NAME,
            "neighbors",
            "neighbors",
            lambda points, x: beespace.neighbors(points, x, distances=False),
            _rows,
        ),
        Way(NAME, "neighbors", "neighbors_m", beespace.neighbors, _rows),
        Way(NAME, "nearest", "nearest", lambda points, _: beespace.nearest(points), _nearest),
        Way(NAME, "nearest", "nearest_8", lambda points, _: beespace.nearest(points, 8), _nearest),
    ]
