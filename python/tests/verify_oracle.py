"""How close agents come to each other and to obstacles, the slow way: curves that are sampled densely,
and around the least sample again. In NumPy, from the textbook's basis of Hermite."""

from __future__ import annotations

from typing import Any

import numpy as np

import beespace


class Step:
    """How one agent flies from one time to the next."""

    def __init__(self, before: Any, after: Any, lasts: float) -> None:
        (self.p, self.v), (self.q, self.w), self.lasts = before, after, lasts

    def place(self, u: Any) -> Any:
        u = u[:, None]
        if self.v is None:
            return self.p + (self.q - self.p) * u
        return (
            (2 * u**3 - 3 * u**2 + 1) * self.p
            + (u**3 - 2 * u**2 + u) * self.lasts * self.v
            + (3 * u**2 - 2 * u**3) * self.q
            + (u**3 - u**2) * self.lasts * self.w
        )

    def speed(self, u: Any) -> Any:
        u = u[:, None]
        if self.v is None:
            return np.linalg.norm((self.q - self.p) / self.lasts + 0 * u, axis=1)
        rate = (
            (6 * u**2 - 6 * u) * (self.p - self.q) / self.lasts
            + (3 * u**2 - 4 * u + 1) * self.v
            + (3 * u**2 - 2 * u) * self.w
        )
        return np.linalg.norm(rate, axis=1)

    def acceleration(self, u: Any) -> Any:
        u = u[:, None]
        rate = (
            (12 * u - 6) * (self.p - self.q) / self.lasts
            + (6 * u - 4) * self.v
            + (6 * u - 2) * self.w
        ) / self.lasts
        return np.linalg.norm(rate, axis=1)


def least(function: Any) -> float:
    """The least value in [0, 1]."""
    low, high = 0.0, 1.0
    for _ in range(5):
        u = np.linspace(low, high, 401)
        best = int(function(u).argmin())
        low, high = u[max(0, best - 1)], u[min(400, best + 1)]
    return float(function(np.array([low, 0.5 * (low + high), high])).min())


def apart(one: Step, other: Step) -> float:
    return least(lambda u: np.linalg.norm(one.place(u) - other.place(u), axis=1))


def clear_of(step: Step, obstacle: Any) -> float:
    return least(lambda u: distances(obstacle, step.place(u)))


def distances(obstacle: Any, places: Any) -> Any:
    """From places to an obstacle; 0 or less inside."""
    x, y, z = places.T
    if isinstance(obstacle, beespace.Sphere):
        return np.linalg.norm(places - np.asarray(obstacle.center), axis=1) - obstacle.radius
    if isinstance(obstacle, beespace.Ground):
        return z - obstacle.height
    if isinstance(obstacle, beespace.Box):
        low, high = np.asarray(obstacle.low), np.asarray(obstacle.high)
        return np.linalg.norm(np.maximum(np.maximum(low - places, places - high), 0), axis=1)
    above = 0 * z
    if obstacle.low is not None:
        above = np.maximum(above, obstacle.low - z)
    if obstacle.high is not None:
        above = np.maximum(above, z - obstacle.high)
    if isinstance(obstacle, beespace.Cylinder):
        beside = np.maximum(np.hypot(x - obstacle.x, y - obstacle.y) - obstacle.radius, 0)
    else:
        beside = _beside(np.asarray(obstacle.outline, float), places[:, :2])
    return np.hypot(beside, above)


def _beside(outline: Any, places: Any) -> Any:
    """From places in a plane to a polygon."""
    nearest = np.full(len(places), np.inf)
    inside = np.zeros(len(places), bool)
    for a, b in zip(outline, np.roll(outline, -1, axis=0)):
        along = b - a
        share = np.clip((places - a) @ along / (along @ along), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(places - a - share[:, None] * along, axis=1))
        crosses = (a[1] > places[:, 1]) != (b[1] > places[:, 1])
        with np.errstate(divide="ignore", invalid="ignore"):
            at = a[0] + (places[:, 1] - a[1]) * along[0] / along[1]
        inside ^= crosses & (places[:, 0] < at)
    return np.where(inside, 0, nearest)
