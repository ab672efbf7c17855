"""Swarms that are hard to cut, and where cells meet."""

from __future__ import annotations

import numpy as np

THRESHOLD = 1.0


def uniform(rng, count=12_000):
    return rng.random((count, 3)) * (count * 2.0) ** (1 / 3)


def clusters(rng):
    centres = rng.random((8, 3)) * 200
    return np.concatenate([centre + rng.normal(0, 3, (900, 3)) for centre in centres])


def one_place(rng):
    return np.full((700, 3), 12.5)


def plane(rng):
    points = rng.random((6_000, 3)) * 90
    points[:, 2] = 7
    return points


def dense_cell(rng):
    """A part a thousand times denser than the rest."""
    rest = rng.random((6_000, 3)) * 300
    return np.concatenate([rest, 100 + rng.random((6_000, 3)) * 30])


def lattice(rng):
    """On whole numbers, exactly the threshold apart or in one place, also where planes are."""
    points = np.stack(np.meshgrid(*[np.arange(18.0)] * 3), -1).reshape(-1, 3)
    return np.concatenate([points, points[rng.integers(0, len(points), 800)]])


def ulps(rng):
    """Pairs across every place of an axis: at the threshold, an ulp closer, an ulp farther."""
    at = np.arange(0, 4_000, 2.5) + rng.random(1_600)
    beyond = at + THRESHOLD
    turn = np.arange(len(at)) % 3
    beyond = np.where(turn == 1, np.nextafter(beyond, -np.inf), beyond)
    beyond = np.where(turn == 2, np.nextafter(beyond, np.inf), beyond)
    along = np.concatenate([at, beyond])
    return np.column_stack([along, np.zeros_like(along), np.zeros_like(along)])


def negative_and_huge(rng):
    points = rng.random((3_000, 3)) * 40 - 20
    points[:40] += 2.0**60
    return points


ALL = {
    each.__name__: each
    for each in (uniform, clusters, one_place, plane, dense_cell, lattice, ulps, negative_and_huge)
}


def swarm(name):
    """The points of a scene, and ids that are large, in no order, and different."""
    rng = np.random.default_rng(19)
    points = ALL[name](rng)
    ids = rng.permutation(len(points)).astype(np.int64) * 3 + (np.int64(1) << 40) - 9
    return ids, points
