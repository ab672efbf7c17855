"""The questions, and answers in one form, in which they can be compared."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scenes import THRESHOLD_M

# By the name that results have; how it is shown; the factor that is aimed at where pairs are few.
QUESTIONS = {
    "at_risk": ("at risk", 10.0),
    "pairs": ("pairs", 10.0),
    "pairs_m": ("pairs with distances", 10.0),
    "counts": ("counts", 10.0),
    "neighbors": ("neighbours in CSR", 10.0),
    "neighbors_m": ("CSR, with distances", 10.0),
    "nearest": ("nearest, k = 1", 5.0),
    "nearest_8": ("nearest, k = 8", 5.0),
}


@dataclass(frozen=True)
class Answer:
    """`ids` are a flag a point (at risk), a count a point, a number a pair ``i * n + j`` in ascending
    order (pairs; neighbours both ways), or the nearest in rows; `distances` belong to them."""

    ids: NDArray[Any]
    distances: NDArray[np.float64] | None = None


def of_pairs(i: Any, j: Any, n: int, distances: Any = None) -> Answer:
    """Of pairs in any order, each once."""
    low, high = np.minimum(i, j).astype(np.int64), np.maximum(i, j).astype(np.int64)
    return _in_order(low * n + high, distances)


def of_rows(indptr: Any, indices: Any, n: int, distances: Any = None) -> Answer:
    """Of compressed sparse rows, ascending or not."""
    lengths = np.diff(np.asarray(indptr).astype(np.int64))
    rows = np.repeat(np.arange(n, dtype=np.int64), lengths)
    return _in_order(rows * n + np.asarray(indices).astype(np.int64), distances)


def _in_order(keys: NDArray[np.int64], distances: Any) -> Answer:
    if distances is None:
        return Answer(np.sort(keys))
    order = np.argsort(keys, kind="stable")
    return Answer(keys[order], np.asarray(distances, np.float64)[order])


def difference(
    question: str, found: Answer, right: Answer, points: NDArray[np.float64], off_m: float
) -> str:
    """What is wrong with an answer whose distances may be off by so much; "" where nothing is.

    What lies so near to the threshold, or so near to being as near as another, may be decided the
    other way round.
    """
    if question.startswith("nearest"):
        return _of_nearest(found, right, points, off_m)
    if question in ("at_risk", "counts"):
        if found.ids.shape != right.ids.shape:
            return f"{found.ids.shape} entries, not {right.ids.shape}"
        wrong = int((found.ids != right.ids).sum())
        # Of a float of 32 bits, of a point in thousands; none of a double.
        allowed = 0 if off_m < 1e-6 else len(right.ids) // 1000 + 1
        return "" if wrong <= allowed else f"{wrong:,} of {len(right.ids):,} are wrong"
    if not np.array_equal(found.ids, right.ids):
        other = np.setxor1d(found.ids, right.ids)
        wrong = int((np.abs(_length_of(other, points) - THRESHOLD_M) > off_m).sum())
        wrong += len(found.ids) - len(np.unique(found.ids))  # those that are there twice
        return f"{wrong:,} pairs too many or missing" if wrong else ""
    if found.distances is None or right.distances is None:
        return ""
    off = float(np.abs(found.distances - right.distances).max(initial=0.0))
    return "" if off <= off_m else f"distances are off by {off:g} m"


def _of_nearest(
    found: Answer, right: Answer, points: NDArray[np.float64], off_m: float
) -> str:
    if found.ids.shape != right.ids.shape:
        return f"the shape is {found.ids.shape}, not {right.ids.shape}"
    assert found.distances is not None and right.distances is not None
    off = float(np.abs(found.distances - right.distances).max(initial=0.0))
    if off > off_m:
        return f"distances are off by {off:g} m"
    differ = (found.ids != right.ids).nonzero()
    own = points[differ[0]] - points[found.ids[differ].astype(np.int64)]
    wrong = np.abs(np.sqrt((own**2).sum(axis=1)) - right.distances[differ]) > 2.0 * off_m
    return f"{int(wrong.sum()):,} neighbours are wrong" if wrong.any() else ""


def _length_of(keys: NDArray[np.int64], points: NDArray[np.float64]) -> NDArray[np.float64]:
    i, j = np.divmod(keys, len(points))
    return np.sqrt(((points[i] - points[j]) ** 2).sum(axis=1))
