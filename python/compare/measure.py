"""How long a way takes, and how much memory: of one process, without its threads' waiting."""

from __future__ import annotations

import gc
import json
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ways import Points, Way

# A peer whose first run takes so many times as long as that of the fastest is not asked again.
_HOPELESS = 2.0


@dataclass
class Cost:
    """Seconds of processor time of each run."""

    seconds: list[float]

    @property
    def median(self) -> float:
        return statistics.median(self.seconds)

    @property
    def least(self) -> float:
        return min(self.seconds)


def seconds_of(ask: Callable[[], Any]) -> float:
    gc.collect()
    before = time.process_time()
    found = ask()
    after = time.process_time()
    del found
    return after - before


def alternate(
    ways: list[Way],
    points: Points,
    threshold_m: float,
    first: dict[str, float],
    runs: int,
    beside: Callable[[], None],
) -> dict[str, Cost]:
    """Costs by the names of ways, asked in turn, as often each; those that are hopeless once, with
    the cost of their first run. `beside` is called in each turn, too."""
    peers = [first[way.name] for way in ways if way.peer != ways[0].peer]
    limit = _HOPELESS * min(peers, default=float("inf"))
    costs = {way.name: Cost([first[way.name]]) for way in ways}
    rounds = [way for way in ways if first[way.name] <= limit]
    for way in rounds:
        costs[way.name].seconds.clear()
    for _ in range(runs):
        for way in rounds:
            taken = seconds_of(lambda asked=way: asked.ask(points, threshold_m))
            costs[way.name].seconds.append(taken)
        beside()
    return costs


def bytes_of(found: Any) -> int:
    """The memory of the arrays of an answer: one, some, or an object that has them."""
    if isinstance(found, (tuple, list)):
        return sum(bytes_of(each) for each in found)
    if hasattr(found, "nbytes"):
        return int(found.nbytes)
    names = ("i", "j", "distance", "indptr", "indices", "distances", "data")
    each = [getattr(found, name, None) for name in names]
    return sum(int(array.nbytes) for array in each if array is not None)


def peak_of(way: Way, points: Points, threshold_m: float) -> int:
    """By how many bytes a first call raises the peak memory of this process, beyond its answer."""
    before = _peak()
    found = way.ask(points, threshold_m)
    return _peak() - before - bytes_of(found)


def peak_in_child(program: Path, question: str, way: str, points: Path) -> int | None:
    """The same in a process of its own; None where it fails."""
    command = [sys.executable, "-B", str(program), "--peak", question, way, str(points)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return None if done.returncode else int(json.loads(done.stdout))


def _peak() -> int:
    """The most memory that this process has had. Not of getrusage: there a child begins with the peak
    of its parent."""
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith("VmHWM:"):
            return 1024 * int(line.split()[1])
    raise OSError("/proc/self/status has no VmHWM")


def load() -> str:
    return f"{os.getloadavg()[0]:.1f}"
