"""The answers as two loops give them, with numbers that do not round."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np


def exact(points: Any) -> list[tuple[Fraction, Fraction, Fraction]]:
    rows = [[Fraction(float(value)) for value in row] for row in np.asarray(points)]
    return [tuple(row + [Fraction(0)] * (3 - len(row))) for row in rows]


def squared(a: tuple[Fraction, ...], b: tuple[Fraction, ...]) -> Fraction:
    return sum(((x - y) ** 2 for x, y in zip(a, b)), Fraction(0))


def is_closer(a: Any, b: Any, threshold: float, inclusive: bool, vertical: float | None) -> bool:
    def below(left: Fraction, right: float) -> bool:
        limit = Fraction(right) ** 2
        return left <= limit if inclusive else left < limit

    if vertical is None:
        return below(squared(a, b), threshold)
    return below(squared(a[:2], b[:2]), threshold) and below(squared(a[2:], b[2:]), vertical)


def pairs(
    points: Any,
    threshold: float,
    others: Any = None,
    inclusive: bool = False,
    vertical: float | None = None,
) -> list[tuple[int, int]]:
    mine = exact(points)
    theirs = mine if others is None else exact(others)
    return [
        (i, j)
        for i, a in enumerate(mine)
        for j, b in enumerate(theirs)
        if (others is not None or i < j) and is_closer(a, b, threshold, inclusive, vertical)
    ]


def distance(a: Any, b: Any) -> float:
    difference = np.asarray(a, np.float64) - np.asarray(b, np.float64)
    x, y, z = [*difference, 0.0][:3]
    return float(np.sqrt(x * x + y * y + z * z))


def nearest(points: Any, k: int, others: Any = None) -> list[list[int]]:
    mine = exact(points)
    theirs = mine if others is None else exact(others)
    rows = []
    for i, a in enumerate(mine):
        order = sorted(
            (squared(a, b), j) for j, b in enumerate(theirs) if others is not None or i != j
        )
        ids = [j for _, j in order[:k]]
        rows.append(ids + [-1] * (k - len(ids)))
    return rows
