"""One comparison of a kernel: sixteen pairs of points, a lane each, in whole units."""

import itertools
import random

from canvas import Picture

LANES = 16
THRESHOLD = 100  # units; a real cell has a thousand to four million
# As in near_pairs.hpp, less the share for float arithmetic, which small integers do not need.
NEAR = (THRESHOLD - 2) ** 2
FAR = (THRESHOLD + 2) ** 2


def _differences():
    """Of the first seed that shows all three verdicts."""
    for seed in itertools.count():
        chance = random.Random(seed)
        lanes = [tuple(int(chance.random() * 250) - 125 for _ in range(3)) for _ in range(LANES)]
        verdicts = [verdict(lane) for lane in lanes]
        if verdicts.count("unsure") == 1 and verdicts.count("near") >= 5:
            return lanes
    raise AssertionError("unreachable")


def verdict(difference):
    squared = sum(c * c for c in difference)
    if squared < NEAR:
        return "near"
    return "unsure" if squared <= FAR else "far"


def _look():
    picture = Picture(860, 330, "One comparison of a kernel")
    lanes = _differences()
    verdicts = [verdict(lane) for lane in lanes]
    left, step, top, row = 132, 44.5, 74, 30
    picture.text(22, 30, "Sixteen pairs at once", "ink", None, "strong")
    picture.lines(22, 48, ["In each lane p asks and q is met; differences in units, X is "
                           f"{THRESHOLD}. Surely near: below {THRESHOLD - 2}² = {NEAR:,}; surely "
                           f"far: above {THRESHOLD + 2}² = {FAR:,}."])
    tints = {"near": "good", "far": "soft", "unsure": "hot"}
    washes = {"near": "goodwash", "far": "wash", "unsure": "hotwash"}
    rows = [[f"{lane[axis]:,}".replace("-", "−") for lane in lanes] for axis in range(3)]
    rows.append([f"{sum(c * c for c in lane):,}" for lane in lanes])
    rows.append(verdicts)
    for k, (name, values) in enumerate(zip(("x of q − p", "y of q − p", "z of q − p",
                                            "sum of squares", "verdict"), rows)):
        y = top + k * (row + 6)
        picture.text(left - 12, y + 20, name, "ink", "end", "small")
        for lane, value in enumerate(values):
            final = k >= 3
            picture.box(left + lane * step, y, step - 3, row,
                        washes[verdicts[lane]] if final else "wash", None, 4)
            picture.text(left + lane * step + (step - 3) / 2, y + 20, value,
                         tints[verdicts[lane]] if final else "ink", "middle", "small")
    y = top + 5 * (row + 6) + 26
    mask = "".join("1" if name == "near" else "0" for name in verdicts)
    picture.text(left - 12, y, "near", "good", "end", "small")
    picture.text(left, y, f"{mask}: a bit a lane, by which all near ones are marked, counted or "
                 "stored together", "ink", None, "small")
    lane = verdicts.index("unsure")
    picture.text(left - 12, y + 24, "unsure", "hot", "end", "small")
    picture.text(left, y + 24, f"lane {lane + 1}: the given doubles decide at once; √"
                 f"{sum(c * c for c in lanes[lane]):,} is within 2 units of {THRESHOLD}", "ink",
                 None, "small")
    return picture


def pictures():
    yield "kernel", _look()
