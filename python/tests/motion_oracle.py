"""When movers and tracks are too close, from the definition, with numbers that do not round."""

from __future__ import annotations

from decimal import Context, Decimal, localcontext
from fractions import Fraction
from typing import Any

import numpy as np

Vector = tuple[Fraction, ...]
Span = tuple[Fraction, Fraction]


def vector(row: Any) -> Vector:
    """As numbers that count: less than 2^-100 of anything is nothing, as the documents say."""
    numbers = [Fraction(float(value) if abs(value) >= 2.0**-100 else 0) for value in row]
    return tuple(numbers + [Fraction(0)] * (3 - len(numbers)))


def minus(a: Vector, b: Vector) -> Vector:
    return tuple(x - y for x, y in zip(a, b))


def squared_at(apart: Vector, speed: Vector, time: Fraction) -> Fraction:
    return sum(((p + v * time) ** 2 for p, v in zip(apart, speed)), Fraction(0))


def closest_time(apart: Vector, speed: Vector, span: Span) -> Fraction:
    """The first instant of the span at which the distance is least."""
    a = sum((v * v for v in speed), Fraction(0))
    if a == 0:
        return span[0]
    b = sum((p * v for p, v in zip(apart, speed)), Fraction(0))
    return min(max(-b / a, span[0]), span[1])


def closest_in_height(apart: Vector, speed: Vector, span: Span, vertical: float) -> Span | None:
    """The part of the span in which the heights differ by at most the vertical threshold."""
    height, climb, limit = apart[2], speed[2], Fraction(vertical)
    if climb == 0:
        return span if abs(height) <= limit else None
    ends = sorted([(-limit - height) / climb, (limit - height) / climb])
    inside = (max(span[0], ends[0]), min(span[1], ends[1]))
    return inside if inside[0] <= inside[1] else None


def in_conflict(
    apart: Vector,
    speed: Vector,
    span: Span,
    threshold: float,
    vertical: float | None,
    inclusive: bool,
) -> bool:
    """Whether some instant of the closed span has them too close.

    The instants at which they are close in height are an interval. Where ends do not belong to it,
    the least distance on its closure is not attained perhaps, but all greater ones nearby are.
    """
    limit = Fraction(threshold) ** 2
    if vertical is not None:
        near = closest_in_height(apart, speed, span, vertical)
        if near is None:
            return False
        if not inclusive:
            middle = (near[0] + near[1]) / 2
            if abs(apart[2] + speed[2] * middle) >= Fraction(vertical):
                return False  # nothing but ends
        span, apart, speed = near, (*apart[:2], Fraction(0)), (*speed[:2], Fraction(0))
    least = squared_at(apart, speed, closest_time(apart, speed, span))
    return least <= limit if inclusive else least < limit


def conflict_span(
    apart: Vector, speed: Vector, span: Span, threshold: float, vertical: float | None
) -> tuple[float, float]:
    """From when to when two that are in conflict are."""
    if vertical is not None:
        near = closest_in_height(apart, speed, span, vertical)
        assert near is not None
        span, apart, speed = near, (*apart[:2], Fraction(0)), (*speed[:2], Fraction(0))
    a = sum((v * v for v in speed), Fraction(0))
    if a == 0:
        return float(span[0]), float(span[1])
    b = sum((p * v for p, v in zip(apart, speed)), Fraction(0))
    c = sum((p * p for p in apart), Fraction(0)) - Fraction(threshold) ** 2
    half = root((b / a) ** 2 - c / a)
    begins = max(decimal(span[0]), decimal(-b / a) - half)
    ends = min(decimal(span[1]), decimal(-b / a) + half)
    return float(begins), float(ends)


def decimal(number: Fraction) -> Decimal:
    with localcontext(Context(prec=120)):
        return Decimal(number.numerator) / Decimal(number.denominator)


def root(number: Fraction) -> Decimal:
    with localcontext(Context(prec=120)):
        return decimal(number).sqrt()


def predicted(
    positions: Any,
    velocities: Any,
    threshold: float,
    within: float,
    inclusive: bool = False,
    vertical: float | None = None,
) -> dict[tuple[int, int], tuple[float, float, float, float]]:
    """Of each pair in conflict: when it begins, is closest, ends, and how close it is."""
    at = [vector(row) for row in np.asarray(positions)]
    going = [vector(row) for row in np.asarray(velocities)]
    span = (Fraction(0), Fraction(within))
    found = {}
    for i in range(len(at)):
        for j in range(i + 1, len(at)):
            apart, speed = minus(at[j], at[i]), minus(going[j], going[i])
            if not in_conflict(apart, speed, span, threshold, vertical, inclusive):
                continue
            begins, ends = conflict_span(apart, speed, span, threshold, vertical)
            closest = closest_time(apart, speed, span)
            if vertical is not None:
                closest = min(max(closest, Fraction(begins)), Fraction(ends))
            distance = root(squared_at(apart, speed, closest))
            found[i, j] = (begins, float(closest), ends, float(distance))
    return found
