"""Compares beespace.spark with other ways on one cluster of processes; scripts/compare-spark runs it."""

from __future__ import annotations

import argparse
import json
import os
import platform
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

import beespace
import cluster
import cost
import report
import ways
from scenes import THRESHOLD_M, Scene

_PROJECT = Path(__file__).resolve().parents[2]
_WARM = Scene(20_000, 2)
_ASKED = [
    (Scene(500_000, 2), ("pairs",)),
    (Scene(500_000, 20), ("at_risk",)),
    (Scene(2_000_000, 2), ("pairs",)),
    (Scene(100_000, 2), ("pairs", "at_risk")),
    (Scene(200_000, 20), ("pairs",)),
    (Scene(300_000, 2, "clusters"), ("pairs",)),
    (Scene(1_000_000, 2), ("pairs", "at_risk")),
]
# With more points, only the grid join that was faster there.
_HALF_UP_TO = 200_000
# What took so many times as long as our way at the first time is asked once more only.
_HOPELESS = 3.0

Row = dict[str, Any]


def answer_of(frame: Any, question: str) -> list[np.ndarray]:
    rows = frame.toPandas()
    names = ["first", "second", "distance"] if question == "pairs" else ["id"]
    rows = rows.sort_values(names[:2])
    return [rows[name].to_numpy() for name in names]


def expected(points: np.ndarray, question: str) -> list[np.ndarray]:
    if question == "at_risk":
        return [beespace.at_risk(points, THRESHOLD_M, threads=2)]
    found = beespace.pairs(points, THRESHOLD_M, threads=2)
    return [found.i, found.j, found.distance]


def difference(found: list[np.ndarray], wanted: list[np.ndarray], exact: bool) -> str | None:
    """What is wrong. Of others, distances may differ in the last digits."""
    if len(found[0]) != len(wanted[0]):
        return f"{len(found[0])} rows, not {len(wanted[0])}"
    for at, (one, other) in enumerate(zip(found, wanted)):
        same = np.array_equal(one, other)
        if not same and not (at == 2 and not exact and np.allclose(one, other, rtol=1e-12, atol=0)):
            return f"column {at} differs"
    return None


def compare(session: Any, scene: Scene, question: str, options: argparse.Namespace) -> Row:
    folder = scene.write(options.folder / "data")
    frame = session.read.parquet(str(folder))
    wanted = expected(scene.make(), question)
    some = [
        way for way in ways.on_the_cluster() if way.name != ways.HALF or scene.points <= _HALF_UP_TO
    ]
    asked: dict[str, Any] = {
        way.name: lambda way=way: cluster.run(way.ask(frame, question, THRESHOLD_M)) for way in some
    }
    asked[ways.ONE_PROCESS] = lambda: ways.one_process(folder, question, THRESHOLD_M)
    asked[ways.OUT_OF_CORE] = lambda: ways.out_of_core(folder, question, THRESHOLD_M)
    row: Row = {
        "scene": scene.name,
        "points": scene.points,
        "neighbours": scene.neighbours,
        "layout": scene.layout,
        "question": question,
        "answers": len(wanted[0]),
        "wrong": [],
        "ways": {name: [] for name in asked},
    }
    for way in some:
        found = answer_of(way.ask(frame, question, THRESHOLD_M), question)
        problem = difference(found, wanted, way.name == ways.OURS)
        if problem:
            row["wrong"].append(f"{scene.name}, {question}, {way.name}: {problem}")
    for turn in range(options.runs):
        for name, ask in asked.items():
            if turn and _is_hopeless(row, name):
                continue
            row["ways"][name].append(cluster.used(ask))
    row["load"] = os.getloadavg()[0]
    return row


def _is_hopeless(row: Row, name: str) -> bool:
    ours = row["ways"][ways.OURS][0][1]
    return row["ways"][name][0][1] > _HOPELESS * ours


def warm(session: Any, options: argparse.Namespace) -> None:
    """Everything is asked some times first, so that Java has compiled what it compiles."""
    frame = session.read.parquet(str(_WARM.write(options.folder / "data")))
    for _ in range(options.warm):
        for way in ways.on_the_cluster():
            for question in ("pairs", "at_risk"):
                cluster.run(way.ask(frame, question, THRESHOLD_M))


def facts_of_machine(session: Any) -> Row:
    java = session.sparkContext._jvm.java.lang.System.getProperty("java.version")
    model = [line for line in Path("/proc/cpuinfo").read_text().splitlines() if "model name" in line]
    memory = [line for line in Path("/proc/meminfo").read_text().splitlines() if "MemTotal" in line]
    return {
        "spark": session.version,
        "java": java,
        "python": platform.python_version(),
        "numpy": np.__version__,
        "processor": " ".join(model[0].split(":")[1].split()[:2]) if model else platform.machine(),
        "cores": os.cpu_count(),
        "memory_gib": round(int(memory[0].split()[1]) / 2**20) if memory else None,
    }


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--warm", type=int, default=3)
    parser.add_argument("--render", action="store_true", help="write the document of what was measured before")
    parser.add_argument("--small", action="store_true", help="the smallest scenes only, and no document")
    parser.add_argument("--folder", type=Path, default=_PROJECT / "build" / "compare-spark")
    return parser.parse_args()


def main() -> int:
    options = parse_arguments()
    results = options.folder / "results.jsonl"
    document = _PROJECT / "docs" / "benchmarks" / "scale.md"
    if options.render:
        report.write(results, document)
        return 0
    begin = time.monotonic()
    session = cluster.start()
    asked = [(Scene(20_000, 2), ("pairs", "at_risk"))] if options.small else _ASKED
    wrong: list[str] = []
    warm(session, options)
    print(f"warm after {time.monotonic() - begin:.0f} s", flush=True)
    with results.open("w") as file:

        def keep(kind: str, told: Row) -> None:
            file.write(json.dumps({kind: told}) + "\n")
            file.flush()

        keep("machine", facts_of_machine(session))
        for scene, questions in asked:
            for question in questions:
                row = compare(session, scene, question, options)
                keep("row", row)
                wrong += row["wrong"]
                print(report.summary(row), f"after {time.monotonic() - begin:.0f} s", flush=True)
        for row in cost.measure(session, options.folder / "data", options.small):
            keep("cost", row)
            print(f"cost: {row}", flush=True)
    session.stop()
    print("\n".join(wrong), file=sys.stderr, end="\n" if wrong else "")
    if not wrong and not options.small:
        report.write(results, document)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
