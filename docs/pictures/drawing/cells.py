"""Cells: of diagonal X, as in the paper; a little wider than X, as here; none in empty space."""

import math
import random

from canvas import Picture
from points import clustered, scattered


def cell_of(point, side):
    return tuple(int(math.floor(c / side)) for c in point)


def _grid(picture, left, top, side, columns, rows):
    for k in range(columns + 1):
        picture.line(left + k * side, top, left + k * side, top + rows * side)
    for k in range(rows + 1):
        picture.line(left, top + k * side, left + columns * side, top + k * side)


def paper_errors(pairs=200_000, seed=7):
    """Shares in 3D: of pairs closer than X, those not in adjacent cells of diagonal X; of pairs in
    adjacent cells and within X on each axis, those that are not closer than X."""
    chance = random.Random(seed)
    side = 1.0 / math.sqrt(3.0)
    near = missed = taken = false = 0
    for _ in range(pairs):
        here = [chance.random() * side for _ in range(3)]
        step = [2.0 * chance.random() - 1.0 for _ in range(3)]  # within X on each axis
        closer = sum(c * c for c in step) < 1.0
        adjacent = all(-side <= h + s < 2.0 * side for h, s in zip(here, step))
        near += closer
        missed += closer and not adjacent
        taken += adjacent
        false += adjacent and not closer
    return missed / near, false / taken


def _paper():
    missed, false = paper_errors()
    picture = Picture(860, 350, "The paper's idea, and where it is not exact")
    side, left, top = 42, 22, 72
    reach = side * math.sqrt(2.0)
    points = scattered(15, 15, 6 * side, 5 * side, apart=9)
    company = {}
    for point in points:
        company.setdefault(cell_of(point, side), []).append(point)
    for (column, row), here in sorted(company.items()):
        if len(here) > 1:
            picture.box(left + column * side, top + row * side, side, side, "hotwash")
    _grid(picture, left, top, side, 6, 5)
    for here in company.values():
        for x, y in here:
            picture.dot(left + x, top + y, 3.6, "hot" if len(here) > 1 else "ink")
    picture.text(left, 30, "Two in a cell: both at risk", "ink", None, "strong")
    picture.lines(left, 48, ["Cells of diagonal X, found by hashing."])
    picture.line(left, top + 5 * side + 18, left + reach, top + 5 * side + 18, "ink", 2)
    picture.text(left + reach + 10, top + 5 * side + 22, "X, a cell's diagonal", "soft", None,
                 "small")

    left = 322
    picture.text(left, 30, "Missed: two layers away", "ink", None, "strong")
    picture.lines(left, 48, ["Closer than X, but not in an adjacent cell."])
    picture.box(left + side, top + side, 3 * side, 3 * side, "coolwash")
    _grid(picture, left, top, side, 5, 5)
    x, y = left + 2.86 * side, top + 2.45 * side
    picture.circle(x, y, reach, "hot", None, 1.6)
    picture.dot(x, y, 4, "ink")
    picture.dot(left + 4.12 * side, top + 2.2 * side, 4, "hot")
    picture.line(x, y, left + 4.12 * side, top + 2.2 * side, "hot", 1.5)
    picture.lines(left, top + 5 * side + 22,
                  [f"In space {100 * missed:.0f} % of all pairs closer than X",
                   "are at least two cells apart on some axis."])

    left = 592
    picture.text(left, 30, "False: within X on each axis", "ink", None, "strong")
    picture.lines(left, 48, ["In an adjacent cell, but farther than X."])
    picture.box(left + side, top + side, 3 * side, 3 * side, "coolwash")
    _grid(picture, left, top, side, 6, 5)
    x, y = left + 2.2 * side, top + 2.85 * side
    picture.box(x - reach, y - reach, 2 * reach, 2 * reach, None, "soft", 0, 1.4, dashed=True)
    picture.circle(x, y, reach, "hot", None, 1.6)
    other = (left + 3.45 * side, top + 1.62 * side)
    picture.line(x, y, *other, "soft", 1.5)
    picture.dot(x, y, 4, "ink")
    picture.dot(*other, 4, "odd")
    picture.lines(left, top + 5 * side + 22,
                  [f"In space {100 * false:.0f} % of the pairs in adjacent cells",
                   "that pass this test are not closer than X."])
    return picture


def _cells():
    picture = Picture(860, 372, "Cells a little wider than the threshold")
    side, left, top = 84, 30, 66
    margin = 0.12  # drawn much larger than it is
    reach = side * (1.0 - margin)
    picture.text(left, 30, "Adjacent cells are enough", "ink", None, "strong")
    picture.lines(left, 48, ["All points closer than X are in one of 9 cells (in space 27)."])
    picture.box(left, top, 3 * side, 3 * side, "coolwash")
    _grid(picture, left, top, side, 3, 3)
    x, y = left + 1.02 * side, top + 1.97 * side
    picture.circle(x, y, reach, "hot", "hotwash", 1.6, opacity="0.5")
    picture.dot(x, y, 4, "ink")
    picture.text(x - 5, y + 18, "p", "ink")
    picture.line(x, y, x - reach, y, "hot", 1.4)
    picture.text(x - reach / 2, y - 7, "X", "hot", "middle")
    gap = x - reach
    picture.line(left, top + 3 * side + 8, left, top + 3 * side + 26, "soft")
    picture.line(gap, y, gap, top + 3 * side + 26, "soft", 1, dashed=True)
    picture.text(gap + 8, top + 3 * side + 24,
                 "what the margin leaves for rounding (drawn far too wide)", "soft", None, "small")

    left = 420
    picture.text(left, 30, "A coordinate is 30 bits: which cell, where in it", "ink", None,
                 "strong")
    picture.lines(left, 48, ["position = (coordinate − low) · units a metre, cut to an integer"])
    for k, (name, extent_over_reach) in enumerate((("128 cells along the longest axis", 128),
                                                   ("10,000 cells", 10_000),
                                                   ("1,000,000 cells", 1_000_000))):
        row = top + 22 + k * 84
        fraction, cell_bits = fraction_bits(extent_over_reach)
        step = 13.5
        picture.text(left, row, name, "ink", None, "small")
        for bit in range(30):
            role = "cool" if bit < 30 - fraction else "hot"
            unused = bit < 30 - fraction - cell_bits
            picture.box(left + bit * step, row + 8, step - 2, 20, None if unused else role + "wash",
                        "rule" if unused else role, 2, 0.8)
        picture.text(left, row + 45, f"cell: {cell_bits} bits", "cool", None, "small")
        picture.text(left + 30 * step - 2, row + 45, f"{fraction} bits: {2 ** fraction:,} units a "
                     "cell", "hot", "end", "small")
    return picture


def fraction_bits(extent_over_reach):
    """As in lattice.cpp: (bits of a position below the cell, bits of the cell)."""
    cells = int(extent_over_reach / (1.0 + 2.0 ** -20)) + 2
    return min(22, 30 - cells.bit_length()), cells.bit_length()


def _folding():
    picture = Picture(860, 236, "Empty space is cut out of an axis")
    values = sorted(x for x, _ in clustered(
        5, [(90, 0.5, 9, 22), (372, 0.5, 6, 15), (760, 0.5, 1, 1)], 820, 1))
    reach = 12.0
    gap = 4.0 * reach
    left, top = 20, 76
    stretches = [[values[0], values[0]]]
    for before, value in zip(values, values[1:]):
        if value - before > gap:
            stretches.append([value, value])
        stretches[-1][1] = value
    picture.text(left, 30, "An axis with gaps …", "ink", None, "strong")
    picture.lines(left, 48, ["Gaps wider than 4 X, in which no point lies, are dashed."])
    for first, last in stretches:
        picture.box(left + first - 5, top - 12, last - first + 10, 24, "coolwash", None, 4)
    for (_, last), (first, _) in zip(stretches, stretches[1:]):
        picture.line(left + last + 6, top, left + first - 6, top, "soft", 1.2, dashed=True)
    for value in values:
        picture.dot(left + value, top, 3.4)
    picture.line(left + 600, top - 30, left + 600 + reach, top - 30, "hot", 2.5)
    picture.text(left + 600 + reach + 8, top - 26, "X", "hot")

    top = 178
    picture.text(left, 132, "… and its cells", "ink", None, "strong")
    picture.lines(left, 150, ["Numbered along the stretches (drawn twice as large). An empty cell "
                              "keeps each stretch from the next: no two seem adjacent."])
    width = 24
    cell = 0
    for first, last in stretches:
        count = int((last - first) / reach) + 2
        here = [value for value in values if first <= value <= last]
        for k in range(count + 1):
            empty = k == count
            picture.box(left + (cell + k) * width, top - 14, width, 28,
                        None if empty else "coolwash", "rule" if empty else "cool", 0, 0.8,
                        dashed=empty)
            picture.text(left + (cell + k + 0.5) * width, top + 32, str(cell + k), "soft", "middle",
                         "small")
        for value in here:
            picture.dot(left + (cell + (value - first) / reach) * width, top, 3.2)
        cell += count + 1
    return picture


def pictures():
    yield "paper-cells", _paper()
    yield "cells", _cells()
    yield "folding", _folding()
