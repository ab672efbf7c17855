"""Rows of cells as wide as the swarm is thin, and what the width of a row costs."""

import bisect
import math
import random

from canvas import Picture, Plot

LANES = 16
SLICES = 4  # a cell
# In cells along a row, on average: how far a lane reaches ahead, to the end of a slice; and how
# much more than its own length a block of lanes reaches, at both ends.
AHEAD = (SLICES + 0.5) / SLICES
AROUND = 2.0 * AHEAD
# A million points with two neighbours each, AVX-512, as (own row, across seams, packings); their
# rows are 4 cells wide.
MEASURED = (4, (0.82, 0.70, 0.48))


def rows_a_point(width):
    """Its own, and half of those beyond the seams that its cell lies beside (the other half meets
    it): ((1 + 2/w)^2 - 1) / 2 + 1."""
    return 1.0 + 2.0 / width + 2.0 / width ** 2


def points_a_cell(neighbours):
    return neighbours / (4.0 / 3.0 * math.pi)


def most_ahead(section, blocks=400):
    """How many points the lane of a block that reaches farthest has ahead, on average, where so
    many points come along a cell's length of a row."""
    chance = random.Random(16)
    points = LANES * blocks + math.ceil(2.0 * AHEAD * section) + 64
    slices = sorted(int(chance.random() * points / section * SLICES) for _ in range(points))
    ahead = [bisect.bisect_left(slices, slices[i] + SLICES + 1) - 1 - i
             for i in range(LANES * blocks)]
    return sum(max(ahead[k:k + LANES]) for k in range(0, len(ahead), LANES)) / blocks


def own_row(width, neighbours):
    """Comparisons a point: a block's steps, the last of which reaches no point."""
    return (most_ahead(points_a_cell(neighbours) * width ** 2) + 1.0) / LANES


def across_seams(width, neighbours):
    """Comparisons a point. Of the later rows, two are beyond an edge that 1/w of the points lie
    beside, two beyond a corner, 1/w^2. A block of those meets the points beside its own length, and
    beside what it reaches at both ends."""
    section = points_a_cell(neighbours) * width ** 2
    return sum(2.0 * share * (LANES - 1 + AROUND * share * section) / LANES
               for share in (1.0 / width, 1.0 / width ** 2))


def packings(seams=4):
    """Groups of lanes a point that are packed: once on each side of every seam to a later row."""
    return 2.0 * seams / LANES


def groups_a_point(width, neighbours):
    return own_row(width, neighbours) + across_seams(width, neighbours) + packings()


def chosen_width(neighbours):
    """As in frame.cpp, in a wide and even swarm: doubled while no more than 18 points are expected
    ahead of a point in its own row, within a cell's length."""
    width = 1
    while points_a_cell(neighbours) * (2 * width) ** 2 <= 18.0:
        width *= 2
    return width


def _short(value):
    return f"{value:.3f}".rstrip("0").rstrip(".")


def _sections():
    picture = Picture(860, 336, "Rows seen from their ends")
    for panel, width in enumerate((1, 4)):
        left, top, cells = 24 + panel * 430, 74, 8
        side = 30
        name = "Rows one cell wide" if width == 1 else f"Rows {width} cells wide"
        picture.text(left, 30, name, "ink", None, "strong")
        picture.lines(left, 48, ["Colour: in how many rows, with its own, neighbours may be."])
        for column in range(cells):
            for row in range(cells):
                both = 1
                for place in (column, row):
                    both *= 1 + (place % width == 0) + (place % width == width - 1)
                tint = {1: "goodwash", 2: "coolwash", 4: "oddwash", 9: "hotwash"}[both]
                picture.box(left + column * side, top + row * side, side, side, tint)
        for k in range(cells + 1):
            strong = k % width == 0
            for ends in ((left + k * side, top, left + k * side, top + cells * side),
                         (left, top + k * side, left + cells * side, top + k * side)):
                picture.line(*ends, "soft" if strong else "rule", 1.8 if strong else 0.5)
        x, y = left + 5.4 * side, top + 2.6 * side
        picture.circle(x, y, side * 0.96, "hot", None, 1.6)
        picture.dot(x, y, 3.6)
        shares = {}
        for column in range(width):
            for row in range(width):
                both = 1
                for place in (column, row):
                    both *= 1 + (place % width == 0) + (place % width == width - 1)
                shares[both] = shares.get(both, 0) + 1 / width ** 2
        for k, (count, share) in enumerate(sorted(shares.items())):
            tint = {1: "goodwash", 2: "coolwash", 4: "oddwash", 9: "hotwash"}[count]
            picture.box(left + 258, top + 4 + k * 26, 18, 18, tint, "rule", 3)
            picture.text(left + 284, top + 18 + k * 26, f"{count} row{'s' * (count > 1)}: "
                         f"{100 * share:.0f} %", "ink", None, "small")
        mean = sum(count * share for count, share in shares.items())
        picture.lines(left + 258, top + 18 + len(shares) * 26 + 10,
                      [f"on average {_short(mean)}", "its own and half of",
                       f"the others: {_short(rows_a_point(width))}"])
    return picture


def _widths(most):
    return [2 ** (k / 8) for k in range(8 * int(math.log2(most)) + 1)]


def _cost():
    picture = Picture(860, 404, "What the width of rows costs")
    ticks = [(w, str(w)) for w in (1, 2, 4, 8, 16, 32)]
    plot = Plot(picture, 56, 88, 300, 240, (1, 16), (0, 5), x_log=True)
    picture.text(22, 30, "Two neighbours: what a point costs", "ink", None, "strong")
    picture.lines(22, 48, ["In groups of sixteen lanes. Circles: measured."])
    plot.axes(ticks[:-1], [(k, str(k)) for k in range(6)], "width w of a row, in cells", "groups")
    parts = (("own row", "hot", own_row), ("across seams", "cool", across_seams),
             ("packings", "odd", lambda width, neighbours: packings()))
    for k, (name, tint, cost) in enumerate((("together", "ink", groups_a_point), *parts)):
        values = [(w, cost(w, 2)) for w in _widths(16)]
        plot.curve([value for value in values if value[1] <= 5], tint, 2.2)
        picture.line(158, 100 + 18 * k, 180, 100 + 18 * k, tint, 2.2)
        picture.text(188, 104 + 18 * k, name, tint, None, "small")
    width, measured = MEASURED
    for value, (_, tint, _) in zip(measured, parts):
        picture.circle(plot.x_at(width), plot.y_at(value), 5, tint, "page", 2)
    picture.circle(plot.x_at(width), plot.y_at(sum(measured)), 5, "ink", "page", 2)

    plot = Plot(picture, 468, 88, 300, 240, (1, 32), (0.5, 32), x_log=True, y_log=True)
    picture.text(432, 30, "Thinner and denser swarms, together", "ink", None, "strong")
    picture.lines(432, 48, ["λ neighbours each. Dots: the width that is chosen."])
    plot.axes(ticks, [(k, f"{k:g}") for k in (0.5, 1, 2, 4, 8, 16, 32)],
              "width w of a row, in cells", "groups")
    for neighbours, tint in ((0.02, "good"), (0.2, "odd"), (2, "hot"), (20, "cool")):
        values = [(w, groups_a_point(w, neighbours)) for w in _widths(32)
                  if points_a_cell(neighbours) * w ** 2 < 32 * LANES]
        values = [value for value in values if value[1] <= 32]
        plot.curve(values, tint, 2.2)
        x, y = values[-1]
        picture.text(plot.x_at(x) + 8, plot.y_at(y) + 4, f"λ = {neighbours:g}", tint, None, "small")
        width = chosen_width(neighbours)
        picture.dot(plot.x_at(width), plot.y_at(groups_a_point(width, neighbours)), 5, tint)
    return picture


def pictures():
    yield "rows", _sections()
    yield "row-width", _cost()
