"""What happens in a live swarm, from the definition, once all reports are there: with fractions, and
nothing that is kept from step to step."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from motion_oracle import in_conflict, minus
from recording_oracle import Fixes, pieces, place, stretches

Told = tuple[str, Any, Any, float]  # kind, first, second, time


def encounters(
    tracks: dict[Any, Fixes],
    threshold: float,
    leave_factor: float,
    max_age: float,
    now: float,
    vertical: float | None = None,
) -> tuple[list[Told], list[tuple[Any, Any, tuple[float, float, float]]]]:
    """What entered, and how it ended; and of each from when to when, and how close."""
    told: list[Told] = []
    closest: list[tuple[Any, Any, tuple[float, float, float]]] = []
    height = None if vertical is None else vertical * leave_factor
    ids = sorted(tracks)
    for i, a in enumerate(ids):
        for b in ids[i + 1 :]:
            for one in pieces(tracks[a], max_age):
                for other in pieces(tracks[b], max_age):
                    near = stretches(one, other, threshold, vertical, False)
                    for begin, end, _, distance in stretches(
                        one, other, threshold * leave_factor, height, True
                    ):
                        within = [each for each in near if begin <= each[0] and each[1] <= end]
                        if not within:
                            continue
                        told.append(("entered", a, b, within[0][0]))
                        kind = _end_of(tracks, (a, one), (b, other), max_age, now)
                        known_to = float(min(one[-1][0], other[-1][0]))
                        reach = (one, other, threshold * leave_factor, height)
                        if end != known_to or not _is_near(*reach, inclusive=True):
                            kind = "left"
                        elif not _is_near(*reach, inclusive=False):
                            kind = "left or " + kind  # just as far, at the last known instant
                        told.append((kind, a, b, end))
                        closest.append((a, b, (within[0][0], end, distance)))
    return sorted(told, key=lambda each: each[3]), closest


def _is_near(
    one: Fixes, other: Fixes, threshold: float, vertical: float | None, inclusive: bool
) -> bool:
    """Whether they are, where what is known of both ends."""
    end = min(one[-1][0], other[-1][0])
    apart = minus(place(other, end), place(one, end))
    still, instant = (Fraction(0),) * 3, (Fraction(0), Fraction(0))
    return in_conflict(apart, still, instant, threshold, vertical, inclusive)


def _end_of(
    tracks: dict[Any, Fixes],
    one: tuple[Any, Fixes],
    other: tuple[Any, Fixes],
    max_age: float,
    now: float,
) -> str:
    """Lost where one of those that are known no longer than the other has fallen silent."""
    end = min(one[1][-1][0], other[1][-1][0])
    for id, piece in (one, other):
        is_last = tracks[id][-1][0] == piece[-1][0]
        if piece[-1][0] == end and not (is_last and now - float(end) <= max_age):
            return "lost"
    return "ended"


def silences(tracks: dict[Any, Fixes], max_age: float, now: float) -> list[Told]:
    """When agents fell silent, and were heard of again."""
    told: list[Told] = []
    for id, track in tracks.items():
        parts = pieces(track, max_age)
        for before, after in zip(parts, parts[1:]):
            told.append(("stale", id, id, float(before[-1][0])))
            told.append(("heard", id, id, float(after[0][0])))
        last = float(track[-1][0])
        if now - last > max_age:
            told.append(("stale", id, id, last))
    return told
