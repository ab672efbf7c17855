"""Which tracks were too close, and when, from the definition, with numbers that do not round."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from motion_oracle import (
    Vector,
    closest_time,
    conflict_span,
    in_conflict,
    minus,
    root,
    squared_at,
    vector,
)

Fixes = list[tuple[Fraction, Vector]]


def tracks_of(ids: Any, times: Any, positions: Any) -> dict[Any, Fixes]:
    tracks: dict[Any, Fixes] = {}
    for id, time, position in zip(ids, times, positions):
        tracks.setdefault(id, []).append((Fraction(float(time)), vector(position)))
    return tracks


def pieces(track: Fixes, max_gap: float) -> list[Fixes]:
    """The track without its gaps."""
    all = [[track[0]]]
    for before, after in zip(track, track[1:]):
        if math.isinf(max_gap) or after[0] - before[0] <= Fraction(max_gap):
            all[-1].append(after)
        else:
            all.append([after])
    return all


def gaps(tracks: dict[Any, Fixes], max_gap: float) -> list[tuple[Any, float, float]]:
    found = []
    for id in sorted(tracks):
        parts = pieces(tracks[id], max_gap)
        for before, after in zip(parts, parts[1:]):
            found.append((id, float(before[-1][0]), float(after[0][0])))
    return found


def place(piece: Fixes, time: Fraction) -> Vector:
    for (begin, from_), (end, to) in zip(piece, piece[1:]):
        if begin <= time <= end:
            share = (time - begin) / (end - begin)
            return tuple(a + (b - a) * share for a, b in zip(from_, to))
    assert piece[0][0] == time
    return piece[0][1]


def straight_parts(one: Fixes, other: Fixes) -> list[tuple[Fraction, Fraction, Vector, Vector]]:
    """Times in which both move in straight lines: from, to, how far apart, and how fast."""
    begin, end = max(one[0][0], other[0][0]), min(one[-1][0], other[-1][0])
    if begin > end:
        return []
    cuts = sorted({begin, end} | {time for time, _ in one + other if begin <= time <= end})
    apart = [minus(place(other, cut), place(one, cut)) for cut in cuts]
    if len(cuts) == 1:
        return [(begin, end, apart[0], (Fraction(0),) * 3)]
    return [
        (a, b, p, tuple((y - x) / (b - a) for x, y in zip(p, q)))
        for a, b, p, q in zip(cuts, cuts[1:], apart, apart[1:])
    ]


def stretches(
    one: Fixes, other: Fixes, threshold: float, vertical: float | None, inclusive: bool
) -> list[list[float]]:
    """Conflicts of two pieces: begin, end, closest time and distance of each."""
    found: list[list[float]] = []
    joined = False  # whether the conflict before lasts until this part, its first instant included
    for begin, end, apart, speed in straight_parts(one, other):
        span = (Fraction(0), end - begin)
        if not in_conflict(apart, speed, span, threshold, vertical, inclusive):
            joined = False
            continue
        first, last = conflict_span(apart, speed, span, threshold, vertical)
        closest = min(max(closest_time(apart, speed, span), Fraction(first)), Fraction(last))
        distance = float(root(squared_at(apart, speed, closest)))
        conflict = [float(begin) + first, float(begin) + last, float(begin + closest), distance]
        if joined:
            found[-1][1] = conflict[1]
            if distance < found[-1][3]:
                found[-1][2:] = conflict[2:]
        else:
            found.append(conflict)
        at_end = tuple(p + v * span[1] for p, v in zip(apart, speed))
        still = (Fraction(0),) * 3
        joined = in_conflict(
            at_end, still, (Fraction(0), Fraction(0)), threshold, vertical, inclusive
        )
    return found


def conflicts(
    tracks: dict[Any, Fixes],
    threshold: float,
    max_gap: float = math.inf,
    vertical: float | None = None,
    inclusive: bool = False,
) -> list[tuple[Any, Any, list[float]]]:
    found = []
    ids = sorted(tracks)
    for i, a in enumerate(ids):
        for b in ids[i + 1 :]:
            for one in pieces(tracks[a], max_gap):
                for other in pieces(tracks[b], max_gap):
                    for stretch in stretches(one, other, threshold, vertical, inclusive):
                        found.append((a, b, stretch))
    return sorted(found)


def least_squared_distance(tracks: dict[Any, Fixes], max_gap: float) -> Fraction | None:
    least = None
    ids = sorted(tracks)
    for i, a in enumerate(ids):
        for b in ids[i + 1 :]:
            for one in pieces(tracks[a], max_gap):
                for other in pieces(tracks[b], max_gap):
                    for begin, end, apart, speed in straight_parts(one, other):
                        closest = closest_time(apart, speed, (Fraction(0), end - begin))
                        squared = squared_at(apart, speed, closest)
                        least = squared if least is None else min(least, squared)
    return least
