"""Claims: where two agents can be if nothing more is sent, and the half-spaces that hold them."""

import math

from canvas import Picture

METRE = 15.0  # as so many units of the picture
THRESHOLD = 5.0
ACCELERATION = 5.0
STEP = 0.5


def _stop(place, velocity):
    """The end of the stopping segment."""
    speed = math.hypot(*velocity)
    way = (speed * speed / (2 * ACCELERATION) + speed * STEP / 2) / speed if speed else 0.0
    return (place[0] + velocity[0] * way, place[1] + velocity[1] * way)


def _fly(place, velocity, later):
    """A period, with the velocity at its end; the places of its Bezier curve."""
    middle = (place[0] + velocity[0] * STEP / 2, place[1] + velocity[1] * STEP / 2)
    end = (place[0] + (velocity[0] + later[0]) * STEP / 2,
           place[1] + (velocity[1] + later[1]) * STEP / 2)
    curve = []
    for k in range(9):
        t = k / 8
        curve.append(tuple((1 - t) ** 2 * a + 2 * t * (1 - t) * b + t * t * c
                           for a, b, c in zip(place, middle, end)))
    return middle, end, curve


def hull(points):
    """The corners of the convex hull, in order."""
    points = sorted(set(points))

    def half(order):
        corners = []
        for point in order:
            while len(corners) > 1 and ((corners[-1][0] - corners[-2][0]) * (point[1] - corners[-2][1])
                                        <= (corners[-1][1] - corners[-2][1]) * (point[0] - corners[-2][0])):
                corners.pop()
            corners.append(point)
        return corners[:-1]

    return half(points) + half(points[::-1])


def _tube(corners, radius):
    """The outline of all within a radius of a hull."""
    outline = []
    for k, corner in enumerate(corners):
        before, after = corners[k - 1], corners[(k + 1) % len(corners)]
        begin = math.atan2(corner[1] - before[1], corner[0] - before[0]) - math.pi / 2
        end = math.atan2(after[1] - corner[1], after[0] - corner[0]) - math.pi / 2
        while end < begin:
            end += 2 * math.pi
        for j in range(9):
            angle = begin + (end - begin) * j / 8
            outline.append((corner[0] + radius * math.cos(angle),
                            corner[1] + radius * math.sin(angle)))
    return outline + outline[:1]


def _claims():
    picture = Picture(860, 396, "Two claims, and the plane between them")
    tube = 1.1

    def at(point):
        return (30 + point[0] * METRE, 366 - point[1] * METRE)

    picture.text(30, 30, "Two claims, and the plane between them", "ink", None, "strong")
    picture.lines(30, 48, ["Solid: the nominal path that is sent. Dashed: braking to a stop, on each "
                           "branch that is not ruled out. Within the thin line: the true agents."])
    # The first: two periods that are sent, and a command that may have been lost.
    place, velocity = (3.0, 5.2), (7.0, 4.0)
    path, places = [place], [place]
    stops = []
    for later in ((8.2, 2.6), (8.8, 0.6)):
        stops.append((place, velocity, _stop(place, velocity)))
        middle, place, curve = _fly(place, velocity, later)
        path += curve[1:]
        places += [middle, place]
        velocity = later
    stops.append((place, velocity, _stop(place, velocity)))
    first = hull(places + [stop for _, _, stop in stops[1:]])
    # The second holds; then it flies down and to the left.
    other, other_velocity = (35.0, 18.4), (-5.5, -3.2)
    other_stop = _stop(other, other_velocity)
    second = hull([other, other_stop])

    normal = None
    best = -1e9
    for k in range(3600):
        angle = 2 * math.pi * k / 3600
        n = (math.cos(angle), math.sin(angle))
        gap = (min(p[0] * n[0] + p[1] * n[1] for p in second)
               - max(p[0] * n[0] + p[1] * n[1] for p in first))
        if gap > best:
            best, normal = gap, n
    high = max(p[0] * normal[0] + p[1] * normal[1] for p in first)
    middle = high + best / 2
    kept = THRESHOLD + 2 * tube
    across = (-normal[1], normal[0])
    centre = (21.5, 12.4)
    shift = middle - (centre[0] * normal[0] + centre[1] * normal[1])
    centre = (centre[0] + normal[0] * shift, centre[1] + normal[1] * shift)
    for side, tint in ((-1, "cool"), (1, "hot")):
        edge = (centre[0] + side * normal[0] * kept / 2, centre[1] + side * normal[1] * kept / 2)
        begin = at((edge[0] - 8.0 * across[0], edge[1] - 8.0 * across[1]))
        end = at((edge[0] + 6.0 * across[0], edge[1] + 6.0 * across[1]))
        picture.line(*begin, *end, tint, 1.4)
    for corners, tint in ((first, "cool"), (second, "hot")):
        picture.path([at(p) for p in corners + corners[:1]], tint, 1.4, f"{tint}wash")
        picture.path([at(p) for p in _tube(corners, tube)], tint, 0.8)
    for begin, _, stop in stops[1:]:
        picture.path([at(begin), at(stop)], "cool", 1.6, dashed=True)
        picture.dot(*at(stop), 3.2, "cool")
    picture.path([at(p) for p in path], "cool", 2.6)
    picture.path([at(other), at(other_stop)], "hot", 1.6, dashed=True)
    picture.dot(*at(other_stop), 3.2, "hot")
    picture.dot(*at((3.0, 5.2)), 5, "cool")
    picture.dot(*at(other), 5, "hot")
    picture.dot(*at(place), 4, "page", "cool")
    picture.arrow(*at((centre[0] - normal[0] * kept / 2, centre[1] - normal[1] * kept / 2)),
                  *at((centre[0] + normal[0] * kept / 2, centre[1] + normal[1] * kept / 2)), "ink")
    x, y = at(centre)
    picture.text(x + 16, y + 40, "S(n) = σ(n) + ρ + ρ", "ink", "middle", "small")
    x, y = at(place)
    picture.lines(x - 40, y + 58, ["here a new command departs;", "one point decides: its stop"],
                  "soft")
    picture.line(x, y + 6, x - 6, y + 44, "soft", 0.8)
    for side, tint, words in ((-1, "cool", "the first stays on its left"),
                              (1, "hot", "the second stays on its right")):
        edge = (centre[0] + side * normal[0] * kept / 2 - 8.0 * across[0],
                centre[1] + side * normal[1] * kept / 2 - 8.0 * across[1])
        x, y = at(edge)
        picture.text(x + 8, y + 8, words, tint, None, "small")
    return picture


def pictures():
    yield "claims", _claims()
