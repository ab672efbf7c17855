#!/usr/bin/env python3
"""Times the k-d tree of SciPy and that of beespace.compat.scipy on one core.

    kdtree.py [--points N...] [--neighbors L...] [--runs R]

Uniform points in a cube, float64. Each question is asked of both, in turns, R times; trees are built
anew each time, and their time is included. Answers are compared before anything is timed. Prints the
median seconds of processor time as a table of Markdown. Needs SciPy, NumPy and beespace; with a build
that is not installed, PYTHONPATH=python BEESPACE_LIBRARY=build/release/c/libbeespace.so.
"""

from __future__ import annotations

import argparse
import gc
import math
import statistics
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import scipy
import scipy.spatial

import beespace
from beespace.compat.scipy import KDTree, handed_over

Ask = Callable[[Any, Any, float], Any]

QUESTIONS: dict[str, Ask] = {
    "`query`, k=1": lambda t, x, r: t.query(x),
    "`query`, k=8": lambda t, x, r: t.query(x, 8),
    '`query_pairs`, "ndarray"': lambda t, x, r: t.query_pairs(r, output_type="ndarray"),
    '`query_pairs`, "set"': lambda t, x, r: t.query_pairs(r),
    "`query_ball_point`": lambda t, x, r: t.query_ball_point(x, r),
    "`query_ball_point`, r each": lambda t, x, r: t.query_ball_point(
        x, np.linspace(0.5 * r, r, len(x))
    ),
    "`query_ball_point`, lengths": lambda t, x, r: t.query_ball_point(x, r, return_length=True),
    "`count_neighbors`": lambda t, x, r: t.count_neighbors(t, r),
    '`sparse_distance_matrix`, "coo"': lambda t, x, r: t.sparse_distance_matrix(
        t, r, output_type="coo_matrix"
    ),
}
# A set of 25 million pairs takes 6 GB.
FEW_ONLY = '`query_pairs`, "set"'
MOST_IN_A_SET = 3_000_000


def in_order(answer: Any) -> Any:
    """What is the same of equal answers, whose rows may be in any order."""
    if isinstance(answer, tuple):
        return [in_order(part) for part in answer]
    if isinstance(answer, np.ndarray) and answer.dtype == object:
        return [sorted(row) for row in answer]
    if isinstance(answer, np.ndarray) and answer.ndim == 2 and answer.dtype.kind == "i":
        return answer[np.lexsort(answer.T[::-1])].tolist()
    if hasattr(answer, "tocsr"):
        rows = answer.tocsr()
        rows.sort_indices()
        return [rows.indptr.tolist(), rows.indices.tolist(), rows.data.tolist()]
    return answer.tolist() if isinstance(answer, np.ndarray) else answer


def seconds(maker: Any, ask: Ask, points: Any, places: Any, radius: float) -> float:
    gc.collect()
    begin = time.process_time()
    ask(maker(points), places, radius)
    return time.process_time() - begin


def compare(count: int, neighbors: float, runs: int) -> bool:
    random = np.random.default_rng(20)
    points = random.random((count, 3))
    places = random.random((count, 3))
    radius = (neighbors / count * 3 / (4 * math.pi)) ** (1 / 3)
    for name, ask in QUESTIONS.items():
        if name == FEW_ONLY and count * neighbors / 2 > MOST_IN_A_SET:
            continue
        ours, theirs = (ask(kind(points), places, radius) for kind in (KDTree, scipy.spatial.KDTree))
        if in_order(ours) != in_order(theirs):
            print(f"{name}: the answers differ", file=sys.stderr)
            return False
        del ours, theirs
        taken: dict[Any, list[float]] = {scipy.spatial.KDTree: [], KDTree: []}
        for _ in range(runs):
            for kind, times in taken.items():
                times.append(seconds(kind, ask, points, places, radius))
        their, our = (statistics.median(times) for times in taken.values())
        print(
            f"| {count:,} | {neighbors:g} | {name} | {their:.3g} | {our:.3g} | {their / our:.1f} |",
            flush=True,
        )
    return True


def main() -> int:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--points", type=int, nargs="+", default=[100_000])
    options.add_argument("--neighbors", type=float, nargs="+", default=[2, 50])
    options.add_argument("--runs", type=int, default=5)
    chosen = options.parse_args()
    print(f"SciPy {scipy.__version__}, NumPy {np.__version__}, beespace {beespace.__version__}\n")
    print("| points | λ | question | SciPy | beespace | ratio |\n|---|---|---|---|---|---|")
    for count in chosen.points:
        for neighbors in chosen.neighbors:
            if not compare(count, neighbors, chosen.runs):
                return 1
    if handed_over:
        print(f"handed over: {dict(handed_over)}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
