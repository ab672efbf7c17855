"""What a call does besides its answer: errors, Ctrl-C, threads, arrays that stay."""

from __future__ import annotations

import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import beespace

points = np.random.default_rng(3).uniform(0, 30, (2000, 3))


def test_errors_say_what_where_and_which():
    wrong = points.copy()
    wrong[17, 1] = np.nan
    for call, code, place, record in [
        (lambda: beespace.pairs(wrong, 1), "not_finite", "points", 17),
        (lambda: beespace.pairs(points, 1, others=wrong), "not_finite", "others", 17),
        (lambda: beespace.Index(points).nearest(wrong), "not_finite", "places", 17),
        (lambda: beespace.pairs(wrong * 1e200, 1), "outside_domain", "points", 0),
        (lambda: beespace.pairs(points, 0), "invalid_threshold", "threshold", None),
        (lambda: beespace.pairs(points, np.nan), "invalid_threshold", "threshold", None),
        (lambda: beespace.pairs(points, 1, vertical=-1), "invalid_threshold", "vertical", None),
        (lambda: beespace.pairs(points, 1, max_results=2), "too_many_results", None, None),
        (lambda: beespace.neighbors(points, 1, max_results=2), "too_many_results", None, None),
        (lambda: list(beespace.iter_pairs(wrong, 1)), "not_finite", "points", 17),
        # One radius for each point is not what the search can do; nothing is guessed.
        (lambda: beespace.pairs(points, np.ones(2000)), "invalid_threshold", "threshold", None),
        (lambda: beespace.pairs(points, "near"), "invalid_threshold", "threshold", None),
        (lambda: beespace.nearest(points, -1), "invalid_argument", "k", None),
        (lambda: beespace.nearest(points, 1.5), "invalid_argument", "k", None),
        (lambda: beespace.nearest(points, 2, within=1), "invalid_argument", "k", None),
        (lambda: beespace.nearest(points, vertical=1), "invalid_argument", None, None),
        (lambda: beespace.pairs(points, 1, threads=-1), "invalid_argument", "threads", None),
        (lambda: beespace.iter_pairs(points, 1, chunk=0), "invalid_argument", "chunk", None),
        (
            lambda: beespace.neighbors(points, 1, others=points, include_self=True),
            "invalid_argument",
            "include_self",
            None,
        ),
    ]:
        with pytest.raises(beespace.BeespaceError) as caught:
            call()
        error = caught.value
        assert (error.code, error.record) == (code, record), str(error)
        assert place is None or error.place == place
        again = pickle.loads(pickle.dumps(error))
        assert (str(again), again.code, again.place, again.record) == (
            str(error),
            error.code,
            error.place,
            error.record,
        )


def test_max_results_never_cuts():
    whole = beespace.pairs(points, 1)
    assert len(beespace.pairs(points, 1, max_results=len(whole))) == len(whole)
    with pytest.raises(beespace.BeespaceError):
        beespace.pairs(points, 1, max_results=len(whole) - 1)


def test_arrays_outlive_what_made_them():
    i = beespace.pairs(points, 2).i
    copy = i.copy()
    for _ in range(50):
        beespace.pairs(points[::-1], 2)
    assert (i == copy).all()
    assert i.flags.writeable


def test_an_engine_keeps_no_answer():
    engine = beespace.Engine()
    first = engine.pairs(points, 2)
    kept = first.i.copy()
    engine.pairs(points[:100], 1)
    engine.release_memory()
    assert (first.i == kept).all()
    assert len(engine.pairs(points, 2)) == len(first)


def test_eight_threads_have_the_same_answers():
    shared = beespace.Engine()
    expected = beespace.pairs(points, 2)
    same = []

    def ask(engine):
        for _ in range(20):
            found = engine.pairs(points, 2)
            same.append(bool((found.j == expected.j).all()))

    threads = [
        threading.Thread(target=ask, args=(engine,)) for engine in [beespace, shared] * 4
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(same) == 160 and all(same)


def test_other_threads_go_on_meanwhile():
    crowd = np.random.default_rng(5).uniform(0, 1, (20_000, 3))
    turns = 0
    done = threading.Event()

    def search():
        beespace.pairs(crowd, 0.3, distances=False)
        done.set()

    thread = threading.Thread(target=search)
    thread.start()
    while not done.is_set():
        turns += 1
        time.sleep(0.001)
    thread.join()
    assert turns > 20


_interrupted = """
import time, numpy, beespace
crowd = numpy.random.default_rng(5).uniform(0, 1, (100_000, 3))
print("ready", flush=True)
began = time.monotonic()
try:
    {call}
except {error}:
    print("ended", time.monotonic() - began < 20)
"""


@pytest.mark.parametrize(
    ("call", "error"),
    [
        ("for piece in beespace.iter_pairs(crowd, 0.9): pass", "KeyboardInterrupt"),
        ("while True: beespace.count(crowd, 0.4)", "KeyboardInterrupt"),
        ("while True: beespace.predict(crowd, crowd, 0.2, within=9)", "KeyboardInterrupt"),
        (
            "recording = beespace.Recording(range(100_000), [0] * 100_000, crowd)\n"
            "    while True: recording.conflicts(0.2)",
            "KeyboardInterrupt",
        ),
        (
            "import signal; signal.signal(signal.SIGINT, lambda *_: 1 / 0)\n"
            "    while True: beespace.pairs(crowd, 0.05)",
            "ZeroDivisionError",
        ),
    ],
)
def test_ctrl_c_ends_a_long_search(call, error):
    program = subprocess.Popen(
        [sys.executable, "-c", _interrupted.format(call=call, error=error)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert program.stdout.readline() == "ready\n"
    time.sleep(0.4)
    program.send_signal(signal.SIGINT)
    printed, complaint = program.communicate(timeout=60)
    assert printed == "ended True\n", complaint
    assert complaint == ""


_movers_interrupted = """
import signal, threading, time, numpy, beespace
crowd = numpy.random.default_rng(5).uniform(0, 1, (4_000, 3))

def seconds_of(call):
    began = time.process_time()
    try:
        call()
    except KeyboardInterrupt:
        print("ended")
    return time.process_time() - began

ask = lambda: {call}
whole = seconds_of(ask)
threading.Timer(0.02, signal.raise_signal, [signal.SIGINT]).start()
print(seconds_of(ask) < whole / 2)
"""


@pytest.mark.parametrize(
    "call",
    [
        "beespace.predict(crowd, crowd[::-1], 0.9, within=1)",
        "beespace.Recording(list(range(2_000)) * 2, [0] * 2_000 + [1] * 2_000, "
        "numpy.vstack([crowd[:2_000], crowd[2_000:]])).conflicts(0.9)",
    ],
)
def test_ctrl_c_ends_a_long_question_about_few_that_move(call):
    ended = subprocess.run(
        [sys.executable, "-c", _movers_interrupted.format(call=call)],
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert ended.stdout == "ended\nTrue\n", ended.stderr


def test_the_version_is_that_of_the_library():
    assert beespace.__version__.count(".") == 2


def test_great_numbers_take_no_memory_before_anything_is_found():
    for chunk in (2**40, sys.maxsize):
        pieces = list(beespace.iter_pairs(points[:100], 5, chunk=chunk))
        assert len(pieces) == 1 and len(pieces[0]) == len(beespace.pairs(points[:100], 5)) > 0
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.nearest(points, 2**62)
    assert caught.value.place == "k"


def test_a_piece_grows_as_pairs_come():
    crowd = np.random.default_rng(2).uniform(0, 1, (2500, 3))  # over three million pairs
    for chunk, sizes in ((2**40, [3_123_750]), (3_000_000, [3_000_000, 123_750])):
        found = list(beespace.iter_pairs(crowd, 5, chunk=chunk))
        assert [len(piece) for piece in found] == sizes
        i, j = (np.concatenate([getattr(piece, axis) for piece in found]) for axis in "ij")
        assert len(np.unique(i * 2500 + j)) == 3_123_750 and (i < j).all()
        distance = np.concatenate([piece.distance for piece in found])
        assert np.allclose(distance, np.linalg.norm(crowd[i] - crowd[j], axis=1))
