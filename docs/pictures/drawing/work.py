"""How work is shared among threads, and what memory it takes."""

import random
import struct

from canvas import Picture, Plot

WORKERS = 4
TINTS = ("cool", "hot", "good", "odd")


def _threads():
    picture = Picture(860, 384, "The same answer with any number of threads")
    rows_a_layer, layers = 6, 5
    chance = random.Random(6)
    sizes = [6 + int(chance.random() * 20) for _ in range(rows_a_layer * layers)]
    begins = [sum(sizes[:k]) for k in range(len(sizes) + 1)]
    total = begins[-1]
    left, width, top = 120, 716, 92
    scale = width / total

    def row_of(point):
        return max(k for k in range(len(sizes)) if begins[k] <= point)

    picture.text(22, 30, f"Sorted points, shared by {WORKERS} workers", "ink", None, "strong")
    picture.lines(22, 48, ["Each sweeps for its share (full bars) and takes notes also about those "
                           "behind it whom its points may meet (pale bars)."])
    picture.text(left - 12, top + 19, "rows", "soft", "end", "small")
    for k, size in enumerate(sizes):
        picture.box(left + begins[k] * scale, top, size * scale - 1.5, 28,
                    "wash", "rule", 0, 0.6)
    for worker in range(WORKERS):
        begin, end = total * worker // WORKERS, total * (worker + 1) // WORKERS
        last_row = min(row_of(end - 1) + rows_a_layer + 1, len(sizes) - 1)
        reach = begins[last_row + 1]
        y = top + 46 + worker * 40
        picture.text(left - 12, y + 18, f"worker {worker + 1}", TINTS[worker], "end", "small")
        picture.box(left + begin * scale, y, (reach - begin) * scale, 26, TINTS[worker] + "wash")
        picture.box(left + begin * scale, y, (end - begin) * scale, 26, TINTS[worker])
        picture.line(left + begin * scale, top + 34, left + begin * scale, top + 208, "rule", 0.8,
                     dashed=True)
    y = top + 222
    picture.text(left - 12, y + 18, "together", "ink", "end", "small")
    picture.box(left, y, width, 26, "wash", "ink", 0, 1)
    picture.text(left + width / 2, y + 17, "marks: or · counts: sum · groups: union · pairs: sort",
                 "ink", "middle", "small")
    picture.text(22, 372, "None of these depends on which came first or how the points were shared.",
                 "soft", None, "small")
    return picture


def memory_phases():
    """(phase, [(what, bytes a point)]) of an at-risk search without crowds."""
    record = struct.calcsize("iiiI")
    arrays = struct.calcsize("iii") + struct.calcsize("I")
    marks = ("marks", 1)
    return (("scatter", [marks, ("records", record)]),
            ("sort buckets", [marks, ("records", record), ("sorted grid", arrays)]),
            ("sweep", [marks, ("sorted grid", arrays), ("notes", 1)]),
            ("ids", [marks]))


def _memory():
    picture = Picture(860, 330, "Working memory")
    picture.text(22, 30, "Working memory of an at-risk search, in bytes a point", "ink", None,
                 "strong")
    picture.lines(22, 48, ["One worker. Besides: 12 bytes a row that holds points. The caller's "
                           "24 bytes a point are read where they are."])
    plot = Plot(picture, 120, 78, 620, 180, (0, 40), (0, 4))
    tints = {"marks": "odd", "records": "hot", "sorted grid": "cool", "notes": "good"}
    for value in range(0, 41, 8):
        x = plot.x_at(value)
        picture.line(x, plot.top, x, plot.top + plot.height, "rule", 0.7)
        picture.text(x, plot.top + plot.height + 18, str(value), "soft", "middle", "small")
    for k, (phase, parts) in enumerate(memory_phases()):
        y = plot.top + 6 + k * 45
        at = 0
        for what, size in parts:
            picture.box(plot.x_at(at), y, plot.x_at(at + size) - plot.x_at(at) - 1, 32, tints[what])
            at += size
        picture.text(108, y + 21, phase, "ink", "end", "small")
        picture.text(plot.x_at(at) + 8, y + 21, str(at), "ink", None, "small")
    for k, (what, tint) in enumerate(tints.items()):
        picture.box(120 + k * 140, 300, 14, 14, tint, None, 3)
        picture.text(140 + k * 140, 312, what, "ink", None, "small")
    return picture


def pictures():
    yield "threads", _threads()
    yield "memory", _memory()
