"""Nearest others: a radius that grows for points that have found none."""

import math

from canvas import Picture, Plot
from points import clustered, nearest_of

FIRST_RADIUS = 0.40  # of a cube with a dozen others, as in nearest_search.cpp
OTHERS = 12.0
TINTS = ("good", "cool", "odd", "hot", "ink")


def open_after(radius_ratio):
    """The share of an even swarm that has none within so many first radii."""
    in_ball = OTHERS * 4.0 / 3.0 * math.pi * (FIRST_RADIUS * radius_ratio) ** 3
    return math.exp(-in_ball)


def _rounds():
    picture = Picture(860, 372, "A radius that grows")
    left, top, first = 22, 74, 11.0
    points = clustered(1, [(110, 90, 60, 42), (330, 170, 22, 60), (250, 110, 22, 260)], 470, 250)
    found = nearest_of(points)
    rounds = [0 if distance < first else math.ceil(math.log2(distance / first) + 1e-12)
              for distance, _ in found]
    last = max(rounds)
    picture.text(left, 30, "Round after round, for those still open", "ink", None, "strong")
    picture.lines(left, 48, ["Colour: in which round the nearest was found. Circles: the radius of "
                             "that round."])
    picture.box(left - 8, top - 12, 496, 282, "wash", None, 6)
    for k in range(last + 1):
        members = [i for i, r in enumerate(rounds) if r == k]
        shown = max(members, key=lambda i: (min(points[i][0], 470 - points[i][0], points[i][1],
                                                250 - points[i][1]), i))
        picture.circle(left + points[shown][0], top + points[shown][1], first * 2 ** k,
                       TINTS[k % len(TINTS)], None, 1.3)
    for i, (_, j) in enumerate(found):
        picture.line(left + points[i][0], top + points[i][1], left + points[j][0],
                     top + points[j][1], "rule", 1.2)
    for (x, y), k in zip(points, rounds):
        picture.dot(left + x, top + y, 3.2, TINTS[k % len(TINTS)])
    for k in range(last + 1):
        picture.dot(left + 6 + k * 92, 358, 4, TINTS[k % len(TINTS)])
        picture.text(left + 16 + k * 92, 362, f"round {k + 1}: {rounds.count(k)}", "ink", None,
                     "small")

    picture.text(556, 30, "Still open in an even swarm", "ink", None, "strong")
    plot = Plot(picture, 600, 84, 220, 236, (0, 1.2), (0, 1))
    plot.axes([(k / 5, f"{k / 5:g}") for k in range(0, 7, 2)],
              [(k / 4, f"{25 * k} %") for k in range(5)], "radius, in first radii",
              "have found none")
    plot.curve([(k / 50, open_after(k / 50)) for k in range(61)], "cool", 2.4)
    x, y = plot.x_at(1.0), plot.y_at(open_after(1.0))
    picture.dot(x, y, 4.5, "good")
    picture.line(x, plot.top, x, plot.top + plot.height, "good", 1.2, dashed=True)
    picture.lines(x - 8, plot.top + 24, ["after round 1:", f"{100 * open_after(1.0):.1f} %"],
                  "good", "end")
    return picture


def pictures():
    yield "nearest", _rounds()
