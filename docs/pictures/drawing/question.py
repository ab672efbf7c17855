"""What is asked: at risk, pairs, nearest, groups, over one small swarm."""

from canvas import Picture
from points import groups, near_pairs, nearest_of, scattered

THRESHOLD = 28.0
TINTS = ("hot", "cool", "good", "odd", "ink")


def _panels():
    picture = Picture(860, 300, "One swarm, four questions")
    points = scattered(41, 24, 180, 170, apart=11)
    pairs = near_pairs(points, THRESHOLD)
    at_risk = {i for pair in pairs for i in pair}

    def place(panel, i):
        return 24 + panel * 210 + points[i][0], 70 + points[i][1]

    names = (("Who is at risk?", f"{len(at_risk)} of {len(points)} bees"),
             ("Which pairs?", f"{len(pairs)} pairs"), ("Who is nearest?", "one arrow a bee"),
             ("Which conflict groups?", ""))
    roots = groups(len(points), pairs)
    sizes = {root: roots.count(root) for root in set(roots)}
    shown = [root for root in sorted(sizes) if sizes[root] > 1]
    for panel, (name, remark) in enumerate(names):
        picture.box(14 + panel * 210, 58, 200, 194, "wash", None, 6)
        picture.text(16 + panel * 210, 30, name, "ink", None, "strong")
        remark = remark or f"{len(shown)} groups"
        picture.text(16 + panel * 210, 48, remark, "soft", None, "small")
    for i in range(len(points)):
        x, y = place(0, i)
        risky = i in at_risk
        picture.circle(x, y, THRESHOLD / 2, "hot" if risky else "soft",
                       "hotwash" if risky else None, 0.8, opacity="0.45")
    for i, (_, j) in enumerate(nearest_of(points)):
        picture.arrow(*place(2, i), *place(2, j), "cool", 1.2)
    for i, j in pairs:
        picture.line(*place(1, i), *place(1, j), "hot", 1.6)
        tint = TINTS[shown.index(roots[i]) % len(TINTS)]
        picture.line(*place(3, i), *place(3, j), tint, 1.6)
    for i in range(len(points)):
        picture.dot(*place(0, i), 3.2, "hot" if i in at_risk else "soft")
        picture.dot(*place(1, i), 3.2)
        picture.dot(*place(2, i), 3.2)
        grouped = roots[i] in shown
        picture.dot(*place(3, i), 3.8, TINTS[shown.index(roots[i]) % len(TINTS)] if grouped
                    else "rule")
    y = 278
    picture.line(24, y, 24 + THRESHOLD, y, "ink", 2)
    picture.line(24, y - 4, 24, y + 4, "ink", 1.5)
    picture.line(24 + THRESHOLD, y - 4, 24 + THRESHOLD, y + 4, "ink", 1.5)
    picture.text(24 + THRESHOLD + 10, y + 4, "the threshold X; left, discs of diameter X overlap "
                 "where two bees are closer than X", "soft", None, "small")
    return picture


def pictures():
    yield "question", _panels()
