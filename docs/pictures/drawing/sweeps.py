"""Which points are compared: blocks in their own row and across a seam, and one point at a time."""

import itertools
import math
import random

from canvas import Picture
from points import scattered

LANES = 16
SLICES = 4  # a cell


class Row:
    """Points of a row seen from its side, in their order: by slices, within one in any order."""

    def __init__(self, points, cell):
        self._slice = cell / SLICES
        self.points = sorted(points, key=lambda point: int(point[0] / self._slice))

    def slice_of(self, k):
        return int(self.points[k][0] / self._slice)

    def reach_begin(self, k):
        """Where the slice begins that is a cell before that of point k."""
        return (self.slice_of(k) - SLICES) * self._slice

    def reach_end(self, k):
        return (self.slice_of(k) + SLICES + 1) * self._slice

    def ahead(self, k):
        return sum(1 for x, _ in self.points[k + 1:] if x < self.reach_end(k))


def _slices(picture, left, top, length, height, cell):
    for k in range(round(length / cell * SLICES) + 1):
        x = left + k * cell / SLICES
        strong = k % SLICES == 0
        picture.line(x, top, x, top + height, "soft" if strong else "rule", 1.2 if strong else 0.5)


def _block_row(cell, length, height):
    """A row whose first block takes six steps, the last of which reaches no point."""
    for seed in itertools.count():
        row = Row([(x, y + 8) for x, y in scattered(seed, 29, length, height - 12, 17)], cell)
        most = max(row.ahead(k) for k in range(LANES))
        if most == 5 and 6 < row.points[0][0] < 30:
            return row, most
    raise AssertionError("unreachable")


def _own_row():
    cell, length, height = 60, 780, 120
    left, top = 34, 66
    row, most = _block_row(cell, length, height)
    picture = Picture(860, 446, "A block in its own row")
    picture.text(22, 30, "In their own row: lane by lane", "ink", None, "strong")
    picture.lines(22, 48, ["Points 1 to 16 ask together. The row is two cells wide; fine lines: "
                           "slices, a quarter of a cell, within which points stand in any order."])
    asks = 4
    picture.box(left, top, length, height, "wash")
    start, end = row.slice_of(asks) * cell / SLICES, row.reach_end(asks)
    picture.box(left + start, top, end - start, height, "coolwash")
    _slices(picture, left, top, length, height, cell)
    for k, (x, y) in enumerate(row.points):
        picture.dot(left + x, top + y, 3.4, "hot" if k < LANES else "soft")
        picture.text(left + x, top + y + (-6 if y > 20 else 15), str(k + 1),
                     "ink" if k < LANES else "soft", "middle", "small")
    picture.text(left + start, top + height + 16, f"how far point {asks + 1} reaches ahead: to the "
                 "end of the slice a cell away", "cool", None, "small")

    table, column, line = top + height + 34, 42, 25
    first = left + 108
    for lane in range(LANES):
        picture.box(first + lane * column, table, column - 3, line - 3, "hotwash", None, 4)
        picture.text(first + lane * column + (column - 3) / 2, table + 16, str(lane + 1), "hot",
                     "middle", "small")
    picture.text(first - 12, table + 16, "asks", "hot", "end", "small")
    for step in range(1, most + 2):
        y = table + step * line + 4
        picture.text(first - 12, y + 16, f"step {step} meets", "ink", "end", "small")
        for lane in range(LANES):
            met = lane + step
            near = math.dist(row.points[lane], row.points[met]) < cell
            reached = row.points[met][0] < row.reach_end(lane)
            wash, tint = (("goodwash", "good") if near else
                          ("coolwash", "cool") if reached else ("wash", "soft"))
            picture.box(first + lane * column, y, column - 3, line - 3, wash, None, 4)
            picture.text(first + lane * column + (column - 3) / 2, y + 16, str(met + 1), tint,
                         "middle", "small")
    y = table + (most + 2) * line + 16
    for x, wash, text in ((0, "goodwash", "near"), (86, "coolwash", "within reach along the row"),
                          (290, "wash", "beyond it; where all are, the block is done")):
        picture.box(first + x, y, 15, 15, wash, "rule", 3)
        picture.text(first + x + 22, y + 12, text, "ink", None, "small")
    return picture


def _apart(row, i, other, j, height):
    """Of a point of a row and one of the row below it."""
    (x, y), (to_x, to_y) = row.points[i], other.points[j]
    return math.dist((x, y), (to_x, to_y + height))


def _seam_rows(cell, length, width):
    """Two rows, one above the other, of which exactly a block lies beside the seam in the first."""
    height = width * cell
    for seed in itertools.count():
        mine = Row(scattered(2 * seed, 58, length, height, 9), cell)
        theirs = Row(scattered(2 * seed + 1, 58, length, height, 9), cell)
        beside = [k for k, (_, y) in enumerate(mine.points) if y >= height - cell]
        if len(beside) != LANES:
            continue
        window = (mine.reach_begin(beside[0]), mine.reach_end(beside[-1]))
        if window[0] < cell or window[1] > length - cell:
            continue
        met = [k for k, (x, y) in enumerate(theirs.points)
               if y < cell and window[0] <= x < window[1]]
        twice = any(sum(1 for i in beside if _apart(mine, i, theirs, j, height) < cell) > 1
                    for j in met[:LANES])
        if twice and LANES - 1 <= len(met) <= LANES + 1:
            return mine, beside, theirs, met, window
    raise AssertionError("unreachable")


def _unpacked(mine, theirs):
    """Comparisons, if all of the first row were compared with all of the other."""
    total = 0
    for first in range(0, len(mine.points), LANES):
        last = min(first + LANES, len(mine.points)) - 1
        total += sum(1 for x, _ in theirs.points
                     if mine.reach_begin(first) <= x < mine.reach_end(last))
    return total


def _seam():
    cell, width, cells = 30, 4, 26
    length, height = cell * cells, cell * width
    left, top = 40, 66
    mine, beside, theirs, met, window = _seam_rows(cell, length, width)
    picture = Picture(860, 486, "A block across a seam")
    picture.text(22, 30, "Across a seam: only points beside it", "ink", None, "strong")
    picture.lines(22, 48, [f"Two rows {width} cells wide, seen from their sides. The upper one "
                           "has the query points; lines join near points across the seam."])
    seam = top + height
    picture.box(left, top, length, 2 * height, "wash")
    picture.box(left, seam - cell, length, cell, "hotwash")
    picture.box(left + window[0], seam, window[1] - window[0], cell, "coolwash")
    for k in range(2 * width + 1):
        picture.line(left, top + k * cell, left + length, top + k * cell, "rule", 0.5)
    for k in range(cells + 1):
        picture.line(left + k * cell, top, left + k * cell, seam + height, "rule", 0.5)
    picture.line(left, seam, left + length, seam, "ink", 2)
    for x in window:
        picture.line(left + x, seam - cell, left + x, seam + cell, "cool", 2)
        picture.line(left + x, seam + cell, left + x, seam + height + 6, "cool", 1.2, dashed=True)

    def place(row, k, at):
        x, y = row.points[k]
        return left + x, at + y

    near = [(i, j) for i in beside for j in met
            if _apart(mine, i, theirs, j, height) < cell]
    for i, j in near:
        picture.line(*place(mine, i, top), *place(theirs, j, seam), "good", 2)
    for row, at, chosen, tint in ((mine, top, beside, "hot"), (theirs, seam, met, "cool")):
        for k in range(len(row.points)):
            picture.dot(*place(row, k, at), 3.4 if k in chosen else 2.6,
                        tint if k in chosen else "soft")
    picture.text(left + window[0], seam + height + 20, "a cell before the first of the block",
                 "cool", None, "small")
    picture.text(left + window[1], seam + height + 20, "a cell behind the last", "cool", "end",
                 "small")

    passing = max(met[:LANES], key=lambda j: sum(1 for pair in near if pair[1] == j))
    column, line = 40.5, 26
    first = left + 92
    y = seam + height + 42
    for lane, k in enumerate(beside):
        hit = (k, passing) in near
        picture.box(first + lane * column, y, column - 3, line, "goodwash" if hit else "hotwash",
                    None, 4)
        picture.text(first + lane * column + (column - 3) / 2, y + 18, str(k + 1),
                     "good" if hit else "hot", "middle", "small")
    picture.text(first - 12, y + 18, "a lane each", "hot", "end", "small")
    y += line + 22
    for lane, k in enumerate(met):
        now = k == passing
        picture.box(first + lane * column, y, column - 3, line, "coolwash", "cool" if now else None,
                    4, 2)
        picture.text(first + lane * column + (column - 3) / 2, y + 18, str(k + 1), "cool", "middle",
                     "small")
        if now:
            picture.arrow(first + lane * column + (column - 3) / 2, y - 3,
                          first + lane * column + (column - 3) / 2, y - 20, "cool", 2)
    picture.text(first - 12, y + 18, "one by one", "cool", "end", "small")
    picture.lines(first, y + line + 20, [
        "Numbers: places in the order of each row.",
        f"These are {len(met)} comparisons of sixteen lanes; with all of both rows, "
        f"unpacked, there would be {_unpacked(mine, theirs)}."])
    return picture


def _windows():
    picture = Picture(860, 344, "Windows that only move forward")
    left, cell = 30, 100
    length, height = 8 * cell, 60
    tops = (64, 190)
    chance = random.Random(3)
    rows = [Row([(x, 8 + 44 * chance.random()) for x, _ in scattered(seed, count, length, 1)], cell)
            for seed, count in ((8, 10), (9, 84))]
    asks = 4
    asked = rows[0]
    first, end = asked.reach_begin(asks), asked.reach_end(asks)
    inside = [k for k, (x, _) in enumerate(rows[1].points) if first <= x < end]
    picture.text(left, 30, "A point asks, in all lanes …", "ink", None, "strong")
    picture.lines(left, 48, ["Those before it in its row have asked already; those behind it come "
                             "next."])
    picture.text(left, 158, "… past its window in a row of the others", "ink", None, "strong")
    picture.lines(left, 176, [f"The {len(inside)} points in it take "
                               f"{len(inside) // LANES + 1} comparisons of sixteen lanes."])
    for row, top in zip(rows, tops):
        picture.box(left, top, length, height, "wash")
        if row is not asked:
            picture.box(left + first, top, end - first, height, "coolwash")
        _slices(picture, left, top, length, height, cell)
        for k, (x, y) in enumerate(row.points):
            tint = "cool" if row is not asked and k in inside else "soft"
            picture.dot(left + x, top + y, 3.2, tint)
    x, y = asked.points[asks]
    picture.dot(left + x, tops[0] + y, 5, "hot")
    bottom = tops[1] + height
    picture.line(left + x, tops[0] + y, left + x, tops[0] + height, "hot", 1.2, dashed=True)
    picture.line(left + x, tops[1], left + x, bottom, "hot", 1.2, dashed=True)
    picture.line(left + first, tops[1] - 5, left + first, bottom + 5, "cool", 2.5)
    picture.arrow(left + first, bottom + 16, left + first + 52, bottom + 16, "cool", 2)
    picture.lines(left + first + 62, bottom + 20,
                  ["the window starts where the last one's did, or later; it never goes back"])
    picture.lines(left, 312, ["Strong lines: cells. Fine lines: slices, a quarter of a cell, "
                              "within which points stand in any order."])
    return picture


def pictures():
    yield "block", _own_row()
    yield "seam", _seam()
    yield "windows", _windows()
