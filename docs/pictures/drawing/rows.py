"""Rows of cells as wide as the swarm is thin, and the windows that move along them."""

import math
import random

from canvas import Picture, Plot
from points import scattered

LANES = 16
SLICES = 4  # a cell
# In cells: how much of a row's length the points of a window come from, on average. Windows begin
# and end with whole slices; in its own row a point meets only those behind it.
OWN_LENGTH = (SLICES + 0.5) / SLICES
OTHER_LENGTH = (2 * SLICES + 1) / SLICES


def rows_a_point(width):
    """Its own, and half of those beyond the edges that its cell is at (the other half has met it):
    ((1 + 2/w)^2 - 1) / 2 + 1."""
    return 1.0 + 2.0 / width + 2.0 / width ** 2


def looks(mean):
    """Expected instructions for a window that holds a Poisson number of points: one, and another
    for every full one."""
    if mean > 500.0:
        return mean / LANES + 1.0 - (LANES - 1) / (2.0 * LANES)
    probability = math.exp(-mean)
    expected = below = 0.0
    count = 0
    while below < 1.0 - 1e-12 and count < mean + 20.0 * math.sqrt(mean) + 50.0:
        expected += probability * (count // LANES + 1)
        below += probability
        count += 1
        probability *= mean / count
    return expected


def points_a_cell(neighbours):
    return neighbours / (4.0 / 3.0 * math.pi)


def instructions_a_point(width, neighbours):
    section = points_a_cell(neighbours) * width ** 2
    return (looks(OWN_LENGTH * section)
            + (rows_a_point(width) - 1.0) * looks(OTHER_LENGTH * section))


def chosen_width(neighbours):
    """As in frame.cpp, in a wide and even swarm: doubled while no more than 18 points lie in a
    row's window ahead of a point, a cell long."""
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
        picture.lines(left, 48, ["Colour: how many rows a point there looks into, with its own."])
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


def _cost():
    picture = Picture(860, 390, "What the width of rows costs")
    plot = Plot(picture, 56, 74, 300, 240, (1, 32), (0, 5.5), x_log=True)
    picture.text(22, 30, "Rows a point looks into", "ink", None, "strong")
    ticks = [(w, str(w)) for w in (1, 2, 4, 8, 16, 32)]
    plot.axes(ticks, [(k, str(k)) for k in range(6)], "width w of a row, in cells", "rows")
    plot.curve([(2 ** (k / 20), rows_a_point(2 ** (k / 20))) for k in range(101)], "cool", 2.4)
    for width, _ in ticks:
        picture.dot(plot.x_at(width), plot.y_at(rows_a_point(width)), 3.6, "cool")
        picture.text(plot.x_at(width) + 6, plot.y_at(rows_a_point(width)) - 9,
                     _short(rows_a_point(width)), "cool", None, "small")
    picture.text(plot.x_at(3.2), plot.y_at(3.4), "1 + 2/w + 2/w²", "cool")

    plot = Plot(picture, 468, 74, 300, 240, (1, 32), (1, 64), x_log=True, y_log=True)
    picture.text(432, 30, "Instructions a point, sixteen comparisons each", "ink", None, "strong")
    plot.axes(ticks, [(k, str(k)) for k in (1, 2, 4, 8, 16, 32, 64)],
              "width w of a row, in cells (dot: what is chosen)", "instructions")
    for neighbours, tint in ((0.02, "good"), (0.2, "odd"), (2, "hot"), (20, "cool")):
        values = [(2 ** (k / 10), instructions_a_point(2 ** (k / 10), neighbours))
                  for k in range(51)]
        values = [value for value in values if value[1] <= 64]
        plot.curve(values, tint, 2.2)
        x, y = values[-1]
        picture.text(plot.x_at(x) + 8, plot.y_at(y) + 4, f"λ = {neighbours:g}", tint, None, "small")
        width = chosen_width(neighbours)
        picture.dot(plot.x_at(width), plot.y_at(instructions_a_point(width, neighbours)), 5, tint)
    return picture


def _windows():
    picture = Picture(860, 320, "Windows that only move forward")
    left, cell = 30, 100
    slice_width = cell / SLICES
    length = 8 * cell
    chance = random.Random(3)
    tops = (64, 190)
    height = 60
    asked = left + 3.30 * cell
    behind = [left + x for x, _ in scattered(8, 26, length, 1)]
    others = [left + x for x, _ in scattered(9, 26, length, 1)]
    first = left + math.floor((asked - left - cell) / slice_width) * slice_width
    end = left + (math.floor((asked - left + cell) / slice_width) + 1) * slice_width
    own_slice = left + math.floor((asked - left) / slice_width) * slice_width
    picture.text(left, 30, "A point asks in its own row …", "ink", None, "strong")
    picture.lines(left, 48, ["Those behind it in the order, to the end of the slice that is a cell "
                             "away. Those before it have asked already."])
    picture.text(left, 176, "… and in a row around it", "ink", None, "strong")
    for top in tops:
        start = own_slice if top == tops[0] else first
        picture.box(left, top, length, height, "wash")
        picture.box(start, top, end - start, height, "coolwash")
        for k in range(8 * SLICES + 1):
            x = left + k * slice_width
            strong = k % SLICES == 0
            picture.line(x, top, x, top + height, "soft" if strong else "rule",
                         1.2 if strong else 0.6)
    places = {top: [(x, top + 8 + 44 * chance.random()) for x in row]
              for top, row in ((tops[0], behind), (tops[1], others))}
    at = (asked, tops[0] + height - 16)
    for top in tops:
        start = own_slice if top == tops[0] else first
        for place in places[top]:
            inside = start <= place[0] < end
            picture.dot(*place, 3.2, "cool" if inside else "soft")
    picture.dot(*at, 5, "hot")
    picture.line(at[0], tops[0], at[0], tops[1] + height, "hot", 1.2, dashed=True)
    picture.line(first, tops[1] - 5, first, tops[1] + height + 5, "cool", 2.5)
    picture.arrow(first, tops[1] + height + 16, first + 52, tops[1] + height + 16, "cool", 2)
    picture.lines(first + 62, tops[1] + height + 20,
                  ["the window starts where the last one's did, or later; it never goes back"])
    picture.lines(left, 304, ["Strong lines: cells. Fine lines: slices, a quarter of a cell; "
                              "within a slice points stand in any order."])
    return picture


def pictures():
    yield "rows", _sections()
    yield "row-width", _cost()
    yield "windows", _windows()
