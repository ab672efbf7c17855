"""SciPy's cKDTree as a contender: the same arguments and the same line of JSON as the others.

  scipy_kdtree.py describe
  scipy_kdtree.py ask QUESTION POINTS THRESHOLD_M REFERENCE

Timed inside Python, from points in memory to the answer in numpy arrays. Queried along the order of
the tree's own leaves, one thread.
"""

import json
import sys
import time

import numpy
import scipy
from scipy.spatial import cKDTree

LEAF_SIZE = 16
NONE = numpy.uint32(0xFFFFFFFF)
NEAREST = numpy.dtype([("id", "<u4"), ("unused", "<u4"), ("distance_m", "<f8")])
MOST_PAIRS_KEPT = 60_000_000


def build(points):
    tree = cKDTree(points, leafsize=LEAF_SIZE, balanced_tree=False)
    return tree, tree.indices


def at_risk(points, threshold_m):
    """The second nearest of those within the threshold; the first is the point itself."""
    tree, order = build(points)
    distances, _ = tree.query(points[order], k=[2], distance_upper_bound=threshold_m)
    return numpy.sort(order[numpy.isfinite(distances[:, 0])])


def pairs(points, threshold_m):
    tree, _ = build(points)
    return tree.query_pairs(threshold_m, output_type="ndarray")


def nearest(points, _threshold_m):
    """Of the two nearest, the one that is not the point itself."""
    tree, order = build(points)
    distances, ids = tree.query(points[order], k=2)
    second = (ids[:, 0] == order).astype(numpy.intp)
    rows = numpy.arange(len(order))
    answer = numpy.zeros(len(points), dtype=NEAREST)
    answer["id"][order] = ids[rows, second]
    answer["distance_m"][order] = distances[rows, second]
    return answer


def counts(points, threshold_m):
    tree, order = build(points)
    answer = numpy.empty(len(points), dtype=numpy.int64)
    answer[order] = tree.query_ball_point(points[order], threshold_m, return_length=True)
    return answer - 1


QUESTIONS = {"at_risk": at_risk, "pairs": pairs, "nearest": nearest, "counts": counts}
ENTRY_TYPES = {"at_risk": "<u4", "pairs": "<u8", "nearest": NEAREST, "counts": "<u4"}


def pair_keys(found):
    """Pairs as numbers that sort as the pairs do."""
    low = found.min(axis=1).astype(numpy.uint64)
    high = found.max(axis=1).astype(numpy.uint64)
    return numpy.sort((low << numpy.uint64(32)) | high)


def difference(question, points, answer, reference):
    """(spurious, missed), as difference_from_reference() of answer.hpp counts them."""
    with open(reference, "rb") as file:
        size, _, kept = numpy.fromfile(file, dtype="<u8", count=3)
        expected = numpy.fromfile(file, dtype=ENTRY_TYPES[question], count=int(kept))
    if question == "counts":
        return int(numpy.count_nonzero(answer != expected)), 0
    if question == "nearest":
        apart = points - points[answer["id"]]
        distance = numpy.sqrt((apart * apart).sum(axis=1))
        wrong = numpy.abs(distance - expected["distance_m"]) > 1e-12 * expected["distance_m"]
        wrong |= answer["id"] == numpy.arange(len(points))
        return int(numpy.count_nonzero(wrong)), 0
    if question == "pairs":
        if kept != size:
            surplus = len(answer) - int(size)
            return max(surplus, 0), max(-surplus, 0)
        # In the file a pair is two numbers of 32 bits, the first one first.
        expected = (expected << numpy.uint64(32)) | (expected >> numpy.uint64(32))
        answer = pair_keys(answer)
    common = len(numpy.intersect1d(answer, expected, assume_unique=True))
    return len(answer) - common, len(expected) - common


class MemoryMeter:
    """How far resident memory rises above what it was at the start."""

    def __init__(self):
        with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
            file.write("5")
        self.start = self._status("VmRSS:")

    @staticmethod
    def _status(name):
        with open("/proc/self/status", encoding="ascii") as status:
            for line in status:
                if line.startswith(name):
                    return int(line.split()[1]) * 1024 / 1e6
        return 0.0

    def peak_mb(self):
        return self._status("VmHWM:") - self.start


def timed(work):
    """(answer, processor ms, wall ms)"""
    wall = time.perf_counter()
    cpu = time.process_time()
    answer = work()
    return answer, 1e3 * (time.process_time() - cpu), 1e3 * (time.perf_counter() - wall)


def timed_runs(first_ms):
    """As in contender_main.cpp."""
    if first_ms < 10:
        return 31
    if first_ms < 100:
        return 9
    if first_ms < 1000:
        return 5
    if first_ms < 4000:
        return 3
    return 1 if first_ms < 8000 else 0


def ask(question, points_file, threshold_m, reference):
    points = numpy.fromfile(points_file, dtype="<f8").reshape(-1, 3)

    def work():
        return QUESTIONS[question](points, threshold_m)

    memory = MemoryMeter()
    answer, cpu, wall = timed(work)
    peak = memory.peak_mb()
    found = int(answer.sum()) if question == "counts" else len(answer)
    spurious, missed = difference(question, points, answer, reference)
    del answer
    times = [(cpu, wall)]
    runs = timed_runs(cpu)
    if runs:
        times = [timed(work)[1:] for _ in range(runs)]
    print(json.dumps({
        "points": len(points), "threshold_m": threshold_m, "found": found, "spurious": spurious,
        "missed": missed, "cpu_ms": [time[0] for time in times],
        "wall_ms": [time[1] for time in times], "peak_mb": round(peak, 1)}))


def describe():
    print(json.dumps({
        "name": "SciPy cKDTree", "version": scipy.__version__, "arithmetic": "float64",
        "use": f"sliding midpoint, {LEAF_SIZE} points a leaf, queried leaf by leaf, all at once",
        "questions": list(QUESTIONS)}))


if __name__ == "__main__":
    if sys.argv[1:] == ["describe"]:
        describe()
    elif len(sys.argv) == 6 and sys.argv[1] == "ask":
        ask(sys.argv[2], sys.argv[3], float(sys.argv[4]), sys.argv[5])
    else:
        sys.exit(__doc__)
