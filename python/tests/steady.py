"""Asks every question again and again, also wrongly and of visits that end early, and prints what has
grown since the first rounds: bytes in memory, bytes of Python, references, threads, open files.

    BEESPACE_LIBRARY=LIBRARY PYTHONPATH=python python3 python/tests/steady.py [CALLS]
"""

from __future__ import annotations

import ctypes
import gc
import itertools
import json
import os
import sys
import threading
import tracemalloc

import numpy as np

import beespace

points = np.random.default_rng(3).uniform(0, 30, (50, 3))
broken = points.copy()
broken[7, 1] = np.nan
others = points[:20] + 1.0
floats = tuple(points.astype(np.float32).T)
ids = np.arange(50)
kept = [points, broken, others, ids, *floats]
engine = beespace.Engine()
index = beespace.Index(points)


def _refused(call):
    try:
        call()
    except beespace.BeespaceError:
        return
    raise AssertionError("this should have been refused")


def _one_piece():
    pieces = beespace.iter_pairs(points, 20, chunk=10)
    next(pieces)
    pieces.close()


def _come_and_go():
    id = index.insert([1, 2, 3])
    index.move(id, [3, 2, 1])
    index.remove(id)


def _live():
    swarm = beespace.Swarm(5, max_agents=40)
    for time in range(2):
        _refused(lambda: swarm.update(ids, time, points, broken))
    swarm.remove(ids[:5])
    assert len(swarm.finish(1)) + len(swarm.movers(1)) + swarm.counts.taken > 0
    _refused(lambda: beespace.Swarm(0))
    _refused(lambda: swarm.update(ids[1:], 0, points))


adviser = beespace.Adviser()
_still = others * 0.0
_limits = {"max_speed": 5.0, "max_acceleration": 3.0}


def _advised():
    advice = adviser.advise(others, _still, _still, 12.0, **_limits)
    assert len(advice.too_close) and len(advice.velocities) == len(others)
    listed = adviser.advise(broken[:20], _still, _still, 2.0, **_limits).refused
    assert listed[0].place == "positions"


def _guided():
    guide = beespace.Guide(2, **_limits)
    follower = beespace.Follower(1, *_limits.values(), 0.1)
    assert guide.join(1, [0, 0, 0]).joined and not guide.join(2, [1, 0, 0]).joined
    guide.set_goal(1, [9, 0, 0])
    for tick in (1, 2, 3):
        follower.advance(tick)
        for command in guide.step(tick).commands:
            guide.take(follower.receive(command))
    _refused(lambda: guide.step(3))
    _refused(lambda: guide.take(beespace.AgentReport(1, 99, 3, (0, 0, 0))))
    follower.restore(follower.stored())


def _check():
    masts = beespace.Obstacles([beespace.Cylinder(5, 5, 1), beespace.Prism([(0, 0), (9, 0), (0, 9)])])
    _refused(lambda: beespace.Obstacles([beespace.Sphere((0, 0, 0), -1)]))
    verifier = beespace.Verifier(5, obstacles=masts, clearance=1, straight=True)
    verifier.add(0, points)
    _refused(lambda: verifier.add(1, broken))
    verifier.add(1, points, points)
    assert len(verifier.verdict().losses)
    assert not beespace.verify(ids % 25, ids // 25, points, 5, velocities=points, max_speed=1)
    _refused(lambda: beespace.verify(ids, ids, points, 5))


calls = [
    lambda: beespace.at_risk(points, 5),
    lambda: beespace.at_risk(points, 5, mask=True, others=others),
    lambda: beespace.pairs(points, 5),
    lambda: beespace.pairs(floats, 5, distances=False, vertical=2),
    lambda: beespace.neighbors(points, 5, include_self=True),
    lambda: beespace.count(points, 5, others=others),
    lambda: beespace.groups(points, 5).labels,
    lambda: beespace.nearest(points, 3),
    lambda: beespace.nearest(points, within=5, others=others),
    lambda: beespace.closest_pair(points),
    lambda: engine.pairs(points, 5),
    lambda: engine.neighbors(points.tolist(), 5),
    lambda: index.around(points, 5),
    lambda: index.nearest(points, 3),
    lambda: index[3],
    lambda: _refused(lambda: index[70]),
    lambda: _refused(lambda: index.around(broken, 5)),
    lambda: _refused(lambda: beespace.at_risk(points, 0)),
    lambda: _refused(lambda: beespace.pairs(points, 5, max_results=2)),
    lambda: _refused(lambda: engine.neighbors(points, 5, others=broken)),
    lambda: _refused(lambda: beespace.Index(broken)),
    lambda: _refused(lambda: list(beespace.iter_pairs(broken, 5))),
    _come_and_go,
    _live,
    _advised,
    _guided,
    _check,
    lambda: beespace.Engine().count(points, 5),
    lambda: beespace.Index(points),
]
_slow = [_one_piece, lambda: sum(map(len, beespace.iter_pairs(points, 20, chunk=300)))]


def ask(count: int) -> None:
    for number, call in zip(range(count), itertools.cycle(calls)):
        call()
        if number % 50 == 0:  # these have a thread of their own
            _slow[number // 50 % 2]()


def measured() -> dict[str, int]:
    gc.collect()
    # What is free may stay with the process for a while: only what is in use is to be counted.
    ctypes.CDLL(None).malloc_trim(0)
    with open("/proc/self/statm") as statm:
        pages = int(statm.read().split()[1])
    return {
        "resident_bytes": pages * os.sysconf("SC_PAGE_SIZE"),
        "python_bytes": tracemalloc.get_traced_memory()[0] if tracemalloc.is_tracing() else 0,
        "references": sum(sys.getrefcount(each) for each in kept),
        "threads": threading.active_count() + len(os.listdir("/proc/self/task")),
        "files": len(os.listdir("/proc/self/fd")),
    }


if __name__ == "__main__":
    total = int(sys.argv[1])
    if sys.argv[2:] == ["--trace"]:
        tracemalloc.start()
    ask(max(1000, total // 10))
    measured()
    before = measured()
    ask(total)
    after = measured()
    print(json.dumps({name: after[name] - value for name, value in before.items()}))
