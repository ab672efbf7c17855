"""Compares the Python package with others that answer the same questions.

Answers are compared first. Then all are asked in turn, on one core, and the median of the processor
time of each is kept, with its tree or list of cells included. Results are rows of JSON in
build/compare-python/results.jsonl; docs/benchmarks/python.md and its chart are made of them.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path
from typing import Any

# Before NumPy and the peers come: one thread is what is compared.
for _variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[_variable] = "1"

import numpy as np

import report
from library import ask_library
from measure import alternate, load, peak_in_child, peak_of, seconds_of
from own import NAME as OURS
from peers import versions, ways_of
from questions import QUESTIONS, difference
from scenes import THRESHOLD_M, Scene
from ways import Points, Way

_PROJECT = Path(__file__).resolve().parents[2]
_DOCUMENTS = _PROJECT / "docs" / "benchmarks"
_SCENES = [Scene(points, lam) for points in (100_000, 1_000_000) for lam in (2.0, 50.0)]
# Of fewer points, memory is what the interpreter and its modules take.
_MANY = 1_000_000
_OF_MEMORY = ("at_risk", "pairs_m", "neighbors_m", "nearest")
_SMALL = [Scene(2_000, 2.0), Scene(2_000, 50.0)]

Row = dict[str, Any]


def check(ways: list[Way], points: Points, side_m: float) -> tuple[dict[str, float], list[str]]:
    """Seconds of one call of each way, and what is wrong with answers; the first way is held to be
    right, as all others must agree with it."""
    seconds: dict[str, float] = {}
    wrong: list[str] = []
    right = ways[0].read(ways[0].ask(points, THRESHOLD_M), points)
    for way in ways:
        found: list[Any] = []
        seconds[way.name] = seconds_of(
            lambda asked=way, into=found: into.append(asked.ask(points, THRESHOLD_M))
        )
        said = difference(
            way.question, way.read(found[0], points), right, points, way.off_m(side_m)
        )
        if said:
            wrong.append(f"{way.name}, {way.question}: {said}")
    return seconds, wrong


def compare(scene: Scene, question: str, folder: Path, options: argparse.Namespace) -> Row:
    """One row of the results."""
    path = scene.write(folder)
    points = np.fromfile(path).reshape(-1, 3)
    ways = [way for way in ways_of(question) if way.peer in (OURS, *(options.peers or [way.peer]))]
    first, wrong = check(ways, points, scene.side_m)
    library: list[float] = []

    def ask_beside() -> None:
        asked = ask_library(options.library, question, path, 2)
        if asked is not None:
            library.append(asked.seconds[-1])  # the first one finds no memory warm

    costs = alternate(ways, points, THRESHOLD_M, first, options.runs, ask_beside)
    row: Row = {
        "points": scene.points,
        "neighbours": scene.neighbours,
        "question": question,
        "ways": {
            way.name: {
                "peer": way.peer,
                "how": way.how,
                "floats": way.floats,
                "seconds": costs[way.name].seconds,
            }
            for way in ways
        },
        "wrong": wrong,
        "load": load(),
    }
    if library:
        row["library"] = {"seconds": library}
    return row


def measure_memory(row: Row, scene: Scene, options: argparse.Namespace) -> Row:
    """The memory of the fastest way of each peer, of a question that was compared."""
    path = scene.write(options.folder)
    peaks = {
        way["peer"]: peak_in_child(Path(__file__), row["question"], f"{way['peer']}: {way['how']}", path)
        for way in report.by_peer(row).values()
    }
    library = ask_library(options.library, row["question"], path, 1)
    if library is not None:
        peaks["C++"] = library.peak_bytes
    return {**{key: row[key] for key in ("points", "neighbours", "question")}, "peaks": peaks}


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="scripts/compare-python", description=__doc__)
    parser.add_argument("--smoke", action="store_true", help="few points; the page goes to the folder")
    parser.add_argument("--render", action="store_true", help="measure nothing, write anew")
    parser.add_argument("--runs", type=int, default=5, help="how often each is asked (5)")
    parser.add_argument("--memory", action="store_true", help="peak memory of a million points, too")
    parser.add_argument("--library", type=Path, help="the program answer_benchmark")
    parser.add_argument("--folder", type=Path, default=_PROJECT / "build" / "compare-python")
    parser.add_argument("--only", nargs="+", default=list(QUESTIONS), choices=list(QUESTIONS))
    parser.add_argument("--points", nargs="+", type=int, help="scenes of so many points only")
    parser.add_argument("--neighbours", nargs="+", type=float, help="scenes of this λ only")
    parser.add_argument("--peers", nargs="+", help="these only, beside beespace")
    parser.add_argument("--peak", nargs=3, metavar=("QUESTION", "WAY", "POINTS"))
    return parser.parse_args()


def print_peak(question: str, name: str, path: str) -> int:
    """What `peak_in_child` asks a child."""
    points = np.fromfile(path).reshape(-1, 3)
    way = next(way for way in ways_of(question, name.split(":")[0]) if way.name == name)
    way.ask(points[:100], THRESHOLD_M)  # what is loaded at the first call is no memory of the answer
    print(json.dumps(peak_of(way, points, THRESHOLD_M)))
    return 0


def main() -> int:
    options = parse_arguments()
    if options.peak:
        return print_peak(*options.peak)
    options.folder.mkdir(parents=True, exist_ok=True)
    results = options.folder / "results.jsonl"
    if options.render:
        report.write(results, _DOCUMENTS)
        return 0
    wrong: list[str] = []
    with results.open("w") as file:
        file.write(json.dumps({"versions": versions()}) + "\n")
        for scene in _SMALL if options.smoke else _SCENES:
            if scene.points not in (options.points or [scene.points]):
                continue
            if scene.neighbours not in (options.neighbours or [scene.neighbours]):
                continue
            for question in options.only:
                row = compare(scene, question, options.folder, options)
                file.write(json.dumps(row) + "\n")
                file.flush()
                wrong += row["wrong"]
                print(f"{scene.name}, {question}: {report.summary(row)}", flush=True)
                if scene.points >= _MANY or options.smoke:
                    if options.memory and question in _OF_MEMORY:
                        file.write(json.dumps(measure_memory(row, scene, options)) + "\n")
    for line in wrong:
        print(f"wrong: {line}", file=sys.stderr)
    if not wrong:
        report.write(results, options.folder if options.smoke else _DOCUMENTS)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
