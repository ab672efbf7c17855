"""Seeded points, and brute force over them: what the pictures show is worked out, not drawn up."""

import math
import random


def scattered(seed, count, width, height, apart=0.0):
    """Points of a box, none closer to another than `apart`."""
    chance = random.Random(seed)
    points = []
    while len(points) < count:
        point = (chance.random() * width, chance.random() * height)
        if all(math.dist(point, other) >= apart for other in points):
            points.append(point)
    return points


def clustered(seed, centres, width, height):
    """(count, spread) points around each centre (x, y, count, spread), kept in the box."""
    chance = random.Random(seed)
    points = []
    for x, y, count, spread in centres:
        while count > 0:
            # A sum of uniform numbers: bell-shaped, and alike on every machine.
            dx, dy = (spread * sum(chance.random() - 0.5 for _ in range(6)) for _ in range(2))
            if 0 <= x + dx < width and 0 <= y + dy < height:
                points.append((x + dx, y + dy))
                count -= 1
    return points


def near_pairs(points, threshold):
    return [(i, j) for j in range(len(points)) for i in range(j)
            if math.dist(points[i], points[j]) < threshold]


def nearest_of(points):
    return [min((math.dist(p, q), j) for j, q in enumerate(points) if j != i)
            for i, p in enumerate(points)]


def groups(count, pairs):
    """The root of each point's connected component."""
    root = list(range(count))

    def find(i):
        while root[i] != i:
            i = root[i]
        return i

    for i, j in pairs:
        a, b = sorted((find(i), find(j)))
        root[b] = a
    return [find(i) for i in range(count)]
