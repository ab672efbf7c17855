"""A model of what a search on a cluster costs: measured in parts, fitted on some scenes, checked on others.

The parts are what Spark runs one after the other: the survey of all points; cutting them into blocks and
sending these; the search, which also hands over its answers. Each is so many processor seconds for being
run at all, and so many for each point (of the survey), each point sent (of the others) and each row of the
answer.
"""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import cluster
from beespace.spark._cut import Cut
from beespace.spark._questions import AtRisk, PairsOf
from beespace.spark._search import Level, Prepared, arguments_of, look, places_of, prepare, reach_of
from scenes import THRESHOLD_M, Scene

_TO_FIT = [Scene(100_000, 2), Scene(500_000, 2), Scene(2_000_000, 2), Scene(200_000, 20)]
_TO_CHECK = [Scene(1_000_000, 2), Scene(300_000, 2, "clusters"), Scene(500_000, 20)]
SCENES = len(_TO_FIT) + len(_TO_CHECK)
_RUNS = 3
_CELL_POINTS = 1_000_000

Row = dict[str, Any]


class Part(NamedTuple):
    """Processor seconds for being run, for each point, and for each row of the answer."""

    fixed_s: float
    point_s: float
    row_s: float = 0.0


def measure(session: Any, folder: Path, small: bool) -> Iterator[Row]:
    """What the parts take of each scene, and how much is sent."""
    scenes = [(scene, True) for scene in _TO_FIT] + [(scene, False) for scene in _TO_CHECK]
    if small:
        scenes = scenes[:1] + scenes[-1:]
    for scene, fit in scenes:
        yield {**_measure(session, scene, folder, fit), "plane_s": _cut_s()}


def _measure(session: Any, scene: Scene, folder: Path, fit: bool) -> Row:
    frame = session.read.parquet(str(scene.write(folder)))
    places = places_of("id", "x", "y", "z", None, None, None)
    level = Level(THRESHOLD_M, None, False)
    reach = reach_of(level, places.columns)
    asked = (places.columns, places.id, places.unit, arguments_of(level))
    taken: dict[str, list[float]] = {}
    row: Row = {
        "scene": scene.name,
        "fit": fit,
        "points": scene.points,
        "neighbours": scene.neighbours,
        "side_m": scene.side_m,
    }

    def note(name: str, work: Any) -> None:
        taken.setdefault(name, []).append(cluster.used(work).processor_s)

    def survey() -> Prepared:
        found = look(frame, places, True, _CELL_POINTS, None)
        return prepare(frame, places, found, reach, _CELL_POINTS, None)

    prepared: list[Prepared] = []
    for _ in range(_RUNS):
        note("survey", lambda: prepared.append(survey()))
        blocks = prepared[-1].blocks
        note("cut", lambda: cluster.run(blocks))
        found = blocks.mapInArrow(PairsOf(*asked), "first long, second long, distance double")
        note("pairs", lambda: cluster.run(found))
        flags = blocks.mapInArrow(AtRisk(*asked), "id long")
        note("at_risk", lambda: cluster.run(flags))
    for name, seconds in taken.items():
        row[name + "_s"] = statistics.median(seconds)
    row["rows"] = found.count()
    row["at_risk_rows"] = flags.count()
    row["bytes"] = cluster.shuffled_bytes(session, lambda: cluster.run(prepared[-1].blocks))
    facts = prepared[-1].facts
    row["cells"], row["halo"] = facts.cells, facts.halo_factor
    return row


def _cut_s() -> float:
    """Seconds of the driver for each point of the sample and each plane above it."""
    random = np.random.default_rng(3)
    sample = list(random.uniform(0.0, 1.0, (3, 400_000)))
    begin = time.process_time()
    cut = Cut.of_sample(sample, [1e-4] * 3, 1_000.0, 1_000.0)
    return (time.process_time() - begin) / 400_000 / math.log2(cut.cells)


def fitted(rows: list[Row]) -> dict[str, Part]:
    """The constants of each part, of the scenes that are there for it."""
    some = [row for row in rows if row["fit"]]
    sent = [row["points"] * row["halo"] for row in some]
    survey = _least([[1.0, row["points"]] for row in some], [row["survey_s"] for row in some])
    cut = _least([[1.0, each] for each in sent], [row["cut_s"] for row in some])
    search = _least(
        [[1.0, each, row[rows_of]] for rows_of in ("rows", "at_risk_rows") for each, row in zip(sent, some)],
        [row[name] - row["cut_s"] for name in ("pairs_s", "at_risk_s") for row in some],
    )
    return {"survey": Part(*survey), "cut": Part(*cut), "search": Part(*search)}


def _least(given: list[list[float]], seconds: list[float]) -> list[float]:
    """Constants that are not negative, so that relative errors of their sums are least squares."""
    wanted = np.array(seconds)
    scaled = np.array(given) / wanted[:, None]
    used = list(range(scaled.shape[1]))
    while True:
        found, *_ = np.linalg.lstsq(scaled[:, used], np.ones(len(wanted)), rcond=None)
        if (found >= 0).all() or len(used) == 1:
            break
        del used[int(found.argmin())]
    constants = [0.0] * scaled.shape[1]
    for at, value in zip(used, found):
        constants[at] = float(value)
    return constants


def predicted(parts: dict[str, Part], points: float, halo: float, answers: float) -> float:
    """Processor seconds of a whole search."""
    sent = points * halo
    return (
        sum(part.fixed_s for part in parts.values())
        + parts["survey"].point_s * points
        + (parts["cut"].point_s + parts["search"].point_s) * sent
        + parts["search"].row_s * answers
    )


def halo_of(points: float, neighbours: float, cells: float) -> float:
    """(1 + 2 r / L) ** 3 of uniform points in cells that are cubes of the side L."""
    volume = points * (4.0 / 3.0) * math.pi / neighbours
    side = (volume / cells) ** (1.0 / 3.0)
    return (1.0 + 2.0 / side) ** 3
