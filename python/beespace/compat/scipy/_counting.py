"""Pairs of two trees, counted for many distances."""

from __future__ import annotations

from typing import Any

import numpy as np

from beespace.compat.scipy import _arguments
from beespace.compat.scipy._arguments import RADIUS, REFUSED
from beespace.compat.scipy._handing import HandOver
from beespace.compat.scipy._points import TreePoints


def count_pairs(points: TreePoints, others: TreePoints, r: Any, cumulative: bool) -> Any:
    """How many pairs are within one distance, or each of many; or beyond the one before it."""
    given = np.asarray(r)
    if given.dtype.kind not in "fiub" or given.ndim > 1 or given.size == 0:
        raise HandOver(REFUSED)
    if given.ndim == 0:
        return points.count_between(others, _arguments.radius(given))
    radii = given.astype(np.float64)
    if not ((radii >= 0.0) & (radii < np.inf)).all():
        raise HandOver(RADIUS)
    if not cumulative and (np.diff(radii) < 0.0).any():
        raise HandOver(REFUSED)
    each, place = np.unique(radii, return_inverse=True)
    counts = np.array([points.count_between(others, float(radius)) for radius in each], np.intp)
    counts = counts[place.reshape(-1)]
    return counts if cumulative else np.diff(counts, prepend=0)
