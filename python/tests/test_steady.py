"""Threads side by side, calls by the thousand, errors and Ctrl-C in the middle: what comes after is as
if they had not been."""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

import beespace

points = np.random.default_rng(3).uniform(0, 30, (3000, 3))
others = points[::3] + 0.25
broken = points.copy()
broken[17] = np.inf


def _questions(engine):
    found = engine.pairs(points, 2.0)
    yield from (found.i, found.j, found.distance)
    yield engine.at_risk(points, 2.0, others=others)
    rows = engine.neighbors(points, 1.5, include_self=True)
    yield from (rows.indptr, rows.indices, rows.distances)
    yield engine.count(points, 2.0, vertical=1.0)
    yield engine.groups(points, 1.2).labels
    yield from engine.nearest(points, 3)
    yield np.array(engine.closest_pair(points, others=others))
    pieces = engine.iter_pairs(points, 1.5, chunk=500)
    yield np.array(sorted((i, j) for piece in pieces for i, j in zip(piece.i, piece.j)))


def _of_index(index):
    around = index.around(others, 2.0)
    yield from (around.indptr, around.indices)
    yield from index.nearest(others, 4)


def _ask_in_threads(asks, rounds):
    """Each in a thread of its own, all beginning together; what they found wrong."""
    wrong = []
    together = threading.Barrier(len(asks))

    def work(ask, expected):
        together.wait()
        for _ in range(rounds):
            try:
                answers = list(ask())
            except BaseException as problem:
                wrong.append(problem)
                return
            if len(answers) != len(expected) or not all(
                np.array_equal(answer, right) for answer, right in zip(answers, expected)
            ):
                wrong.append(ask)

    threads = [threading.Thread(target=work, args=each) for each in asks]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return wrong


def test_eight_threads_with_engines_of_their_own():
    expected = list(_questions(beespace))
    asks = [
        (lambda engine=beespace.Engine(): _questions(engine), expected) for _ in range(8)
    ]
    assert _ask_in_threads(asks, rounds=4) == []


def test_eight_threads_ask_one_index():
    index = beespace.Index(points)
    for _ in range(50):
        index.remove(index.insert([1, 2, 3]))
    expected = list(_of_index(beespace.Index(points)))
    assert _ask_in_threads([(lambda: _of_index(index), expected)] * 8, rounds=20) == []


def test_errors_in_one_thread_are_not_those_of_another():
    shared, index = beespace.Engine(), beespace.Index(points)
    right, around = list(_questions(beespace)), list(_of_index(index))

    def refused():
        for call, code in [
            (lambda: shared.pairs(broken, 2.0), "not_finite"),
            (lambda: shared.pairs(points, 2.0, max_results=3), "too_many_results"),
            (lambda: index.around(broken, 2.0), "not_finite"),
            (lambda: shared.count(points, -1.0), "invalid_threshold"),
        ]:
            with pytest.raises(beespace.BeespaceError) as caught:
                call()
            assert caught.value.code == code
            assert (caught.value.record == 17) == (code == "not_finite")
        return []

    asks = [
        (refused, []),
        (lambda: _questions(shared), right),
        (lambda: _of_index(index), around),
        (lambda: _questions(beespace), right),
    ] * 2
    assert _ask_in_threads(asks, rounds=3) == []


def test_after_an_error_an_engine_and_an_index_answer_as_before():
    engine, index = beespace.Engine(), beespace.Index(points)
    right, around = list(_questions(engine)), list(_of_index(index))
    for wrong in (
        lambda: engine.pairs(broken, 2.0),
        lambda: engine.pairs(points, 2.0, max_results=3),
        lambda: engine.neighbors(points, 2.0, max_results=3),
        lambda: engine.nearest(points, 3, others=broken),
        lambda: list(engine.iter_pairs(broken, 2.0)),
        lambda: index.insert([np.nan, 0, 0]),
        lambda: index.move(3, [np.inf, 0, 0]),
        lambda: index.around(broken, 2.0),
    ):
        with pytest.raises(beespace.BeespaceError):
            wrong()
        assert all(map(np.array_equal, _questions(engine), right))
        assert all(map(np.array_equal, _of_index(index), around))


_ctrl_c = """
import signal, sys, threading, time, numpy, beespace
crowd = numpy.random.default_rng(5).uniform(0, 1, (60_000, 3))
engine, index = beespace.Engine(), beespace.Index(crowd)
right = engine.count(crowd[:6000], 0.05), index.around(crowd[:6000], 0.05).indices
for each in ({calls}):
    asking = threading.Event()
    def press():
        asking.wait()
        time.sleep(0.3)
        signal.raise_signal(signal.SIGINT)
    thread = threading.Thread(target=press)
    thread.start()
    try:
        asking.set()
        while True: each()
    except KeyboardInterrupt:
        thread.join()
    assert (engine.count(crowd[:6000], 0.05) == right[0]).all()
    assert (index.around(crowd[:6000], 0.05).indices == right[1]).all()
print("as before")
"""


def test_after_ctrl_c_an_engine_and_an_index_answer_as_before():
    calls = (
        "lambda: engine.pairs(crowd, 0.05), lambda: engine.count(crowd, 0.3), "
        "lambda: engine.neighbors(crowd, 0.05), lambda: engine.nearest(crowd, 20), "
        "lambda: engine.groups(crowd, 0.2), lambda: index.nearest(crowd, 20), "
        "lambda: index.around(crowd, 0.05), lambda: beespace.Index(crowd)"
    )
    run = subprocess.run(
        [sys.executable, "-c", _ctrl_c.format(calls=calls)],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert (run.stdout, run.stderr) == ("as before\n", "")


@pytest.mark.parametrize(("calls", "options"), [(5000, []), (2500, ["--trace"])])
def test_nothing_grows(calls, options):
    # The whole of it, 100,000 calls, is run by hand: see steady.py.
    printed = subprocess.run(
        [sys.executable, str(Path(__file__).with_name("steady.py")), str(calls), *options],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    grown = json.loads(printed)
    assert grown["references"] == grown["threads"] == grown["files"] == 0
    if options and sys.version_info < (3, 11):
        pytest.skip("Python 3.10 gives each function a cache at its 1,024th call; then nothing grows")
    if options:
        assert grown["python_bytes"] < 8192, grown
    else:
        assert grown["resident_bytes"] < 2**20, grown  # 200 bytes a call
