"""Crowds: cells that prove, points that look around, and boxes that answer for all in them."""

import math

from canvas import Picture, Plot
from points import clustered

CROWDED = 2.0  # expected neighbours in a proof cell, as in at_risk_search.cpp
LEAF = 16


def expected_neighbors(neighbours):
    """Others in a cell of diagonal X, with `neighbours` in a ball of radius X."""
    return neighbours * (1.0 / math.sqrt(27.0)) / (4.0 / 3.0 * math.pi)


def settled(neighbours):
    """The share of the points of an even swarm that have a neighbour in their cell."""
    return 1.0 - math.exp(-expected_neighbors(neighbours))


def _proof():
    picture = Picture(860, 370, "Proof by cells")
    side, columns, rows, left, top = 30, 12, 8, 22, 74
    reach = side * math.sqrt(2.0)
    points = clustered(16, [(130, 120, 130, 85), (280, 70, 40, 45), (180, 120, 14, 190)],
                       columns * side, rows * side)
    cells = {}
    for x, y in points:
        cells.setdefault((int(x / side), int(y / side)), []).append((x, y))
    proved = sum(len(here) for here in cells.values() if len(here) > 1)
    alone = sorted((cell, here[0]) for cell, here in cells.items() if len(here) == 1)
    picture.text(left, 30, "Two in a cell of diagonal X are at risk", "ink", None, "strong")
    picture.lines(left, 48, [f"{proved} of {len(points)} points are proved without a distance; "
                             f"{len(alone)} look around."])
    for (column, row), here in sorted(cells.items()):
        if len(here) > 1:
            picture.box(left + column * side, top + row * side, side, side, "hotwash")
    for k in range(columns + 1):
        picture.line(left + k * side, top, left + k * side, top + rows * side, "rule", 0.7)
    for k in range(rows + 1):
        picture.line(left, top + k * side, left + columns * side, top + k * side, "rule", 0.7)
    inner = [(cell, at) for cell, at in alone
             if 2 <= cell[0] < columns - 2 and 2 <= cell[1] < rows - 2]
    (column, row), (x, y) = inner[len(inner) // 2]
    picture.box(left + (column - 2) * side, top + (row - 2) * side, 5 * side, 5 * side, None,
                "cool", 0, 2)
    picture.circle(left + x, top + y, reach, "cool", None, 1.6)
    for here in cells.values():
        for at in here:
            picture.dot(left + at[0], top + at[1], 2.8, "hot" if len(here) > 1 else "ink")
    picture.lines(left, top + rows * side + 24,
                  ["A lone point is compared with those within two cells (blue)."])

    picture.text(432, 30, "How many it settles in an even swarm", "ink", None, "strong")
    plot = Plot(picture, 476, 90, 340, 210, (1, 1000), (0, 1), x_log=True)
    plot.axes([(1, "1"), (10, "10"), (100, "100"), (1000, "1,000")],
              [(k / 4, f"{25 * k} %") for k in range(5)], "neighbours within X on average",
              "settled by cells")
    plot.curve([(10 ** (k / 40), settled(10 ** (k / 40))) for k in range(121)], "hot", 2.4)
    at = CROWDED / expected_neighbors(1.0)
    x, y = plot.x_at(at), plot.y_at(settled(at))
    picture.line(x, plot.top, x, plot.top + plot.height, "cool", 1.3, dashed=True)
    picture.dot(x, y, 4.5, "cool")
    picture.lines(x + 10, y + 92, [f"from {CROWDED:g} others a cell on", f"({at:.0f} neighbours) "
                                   "proofs", "are tried first"], "cool")
    return picture


def leaves_of(points):
    """Boxes of 16 points, by halving along the wider axis."""
    if len(points) <= LEAF:
        return [points]
    spans = [max(p[a] for p in points) - min(p[a] for p in points) for a in range(2)]
    axis = 0 if spans[0] >= spans[1] else 1
    ordered = sorted(points, key=lambda p: (p[axis], p))
    middle = (len(points) // 2 + LEAF - 1) // LEAF * LEAF
    return leaves_of(ordered[:middle]) + leaves_of(ordered[middle:])


def box_of(points):
    return [(min(p[a] for p in points), max(p[a] for p in points)) for a in range(2)]


def extremes(a, b):
    """The least and the greatest distance between points of two boxes."""
    least = math.hypot(*(max(0.0, b[k][0] - a[k][1], a[k][0] - b[k][1]) for k in range(2)))
    most = math.hypot(*(max(b[k][1] - a[k][0], a[k][1] - b[k][0]) for k in range(2)))
    return least, most


def _boxes():
    picture = Picture(860, 400, "Boxes that answer for all their points")
    left, top, threshold = 22, 74, 120.0
    points = clustered(4, [(250, 140, 900, 125), (420, 230, 200, 60)], 520, 300)
    leaves = leaves_of(points)
    boxes = [box_of(leaf) for leaf in leaves]
    asked = min(range(len(leaves)), key=lambda k: math.dist(
        (sum(boxes[k][0]) / 2, sum(boxes[k][1]) / 2), (250, 150)))
    counts = {"goodwash": 0, "hotwash": 0, "wash": 0}
    for leaf, box in zip(leaves, boxes):
        least, most = extremes(boxes[asked], box)
        tint = "goodwash" if most < threshold else "hotwash" if least < threshold else "wash"
        counts[tint] += len(leaf)
        (x0, x1), (y0, y1) = box
        picture.box(left + x0, top + y0, x1 - x0, y1 - y0, tint, "rule", 0, 0.6)
    for x, y in points:
        picture.dot(left + x, top + y, 1.2, "soft")
    (x0, x1), (y0, y1) = boxes[asked]
    picture.box(left + x0, top + y0, x1 - x0, y1 - y0, None, "cool", 0, 2.5)
    picture.circle(left + (x0 + x1) / 2, top + (y0 + y1) / 2, threshold, "cool", None, 1.4,
                   dashed=True)
    picture.text(left, 30, "A leaf of sixteen points and the leaves around it", "ink", None,
                 "strong")
    picture.lines(left, 48, [f"{len(points):,} points in {len(leaves)} leaves; blue: the query leaf, "
                             "and a circle of radius X around its middle."])
    total = len(points)
    texts = (("goodwash", "all near", "counted at once, for all sixteen"),
             ("hotwash", "open", "compared, sixteen at a time"),
             ("wash", "none near", "left out"))
    for k, (tint, name, what) in enumerate(texts):
        y = top + 24 + k * 74
        picture.box(572, y, 26, 26, tint, "rule", 4)
        share = 100 * counts[tint] / total
        picture.text(610, y + 11, f"{name}: {share:.0f} % of the points")
        picture.text(610, y + 29, what, "soft", None, "small")
    return picture


def pictures():
    yield "proof", _proof()
    yield "boxes", _boxes()
