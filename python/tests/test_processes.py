"""Forks, handlers of signals, and the end of the interpreter: in a process of its own each."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap

import pytest

_scene = """
import os, signal, sys, threading, time
import numpy as np
import beespace

points = np.random.default_rng(1).uniform(0, 300, (60_000, 3))
still, ids = np.zeros_like(points), np.arange(len(points))


def a_swarm(threads=2):
    swarm = beespace.Swarm(2, threads=threads)
    for time_s in (0, 1):
        swarm.update(ids, time_s, points, still + 1)
        swarm.advance(time_s)
    return swarm


def a_verifier(threads=2):
    verifier = beespace.Verifier(1, straight=True, threads=threads)
    verifier.add(0, points)
    verifier.add(1, points + 1)
    return verifier


def a_guide(threads=2):
    guide = beespace.Guide(2, max_speed=6, max_acceleration=4, threads=threads)
    for agent in range(2000):
        assert guide.join(agent, [30.0 * agent, 0, 0]).joined
    guide.step(1)
    return guide


def advise(adviser, **options):
    return adviser.advise(points, still, still + 1, 2, max_speed=3, **options)


def an_adviser(**options):
    adviser = beespace.Adviser()
    advise(adviser, **options)
    return adviser


def in_child(call):
    # The exit status of a child, which is killed where it hangs.
    child = os.fork()
    if child == 0:
        signal.alarm(20)
        try:
            call()
            os._exit(0)
        except BaseException as problem:
            print(type(problem).__name__, problem, file=sys.stderr)
            os._exit(3)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def is_refused(call):
    try:
        call()
    except beespace.BeespaceError as error:
        assert "forked" in str(error), str(error)
        assert f"this {type(globals()['it']).__name__} has stayed" in str(error), str(error)
    else:
        raise AssertionError("an answer without its threads")
"""


def run(code):
    ended = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", _scene + textwrap.dedent(code)],
        capture_output=True,
        text=True,
        timeout=120,
    )
    return ended.returncode, ended.stdout.split("\n")[:-1], ended.stderr


_no_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")

# What is made, what is asked of it, and whether it has seen too much to be made anew.
_FORKED = [
    ("a_swarm()", "it.advance(2)", True),
    ("a_verifier()", "it.add(2, points)", True),
    ("a_guide()", "it.step(2)", True),
    ("an_adviser(threads=2)", "advise(it, threads=2)", False),
    ("an_adviser(threads=2, remember=True)", "advise(it)", True),
    ("a_swarm(threads=1)", "it.advance(2)", False),
    ("a_verifier(threads=1)", "it.add(2, points)", False),
    ("a_guide(threads=1)", "it.step(2)", False),
]


@_no_fork
@pytest.mark.parametrize(("make", "ask", "stays"), _FORKED)
def test_in_the_child_of_a_fork_nothing_waits_for_threads_of_the_parent(make, ask, stays):
    code, told, problem = run(f"""
        it = {make}

        def use():
            if {stays}:
                is_refused(lambda: {ask})
            else:
                {ask}
            repr(it)

        def drop():
            global it
            del it

        print(in_child(use), in_child(drop))
        {ask}  # in the parent all is as it was
        del it
    """)
    assert (code, told) == (0, ["0 0"]), problem


@_no_fork
def test_what_another_thread_asks_during_a_fork_stays_with_the_parent():
    code, told, problem = run("""
        swarm = a_swarm(threads=1)
        worker = threading.Thread(target=lambda: [swarm.advance(2 + k) for k in range(40)])
        worker.start()
        time.sleep(0.05)
        # Whether or not a call is under way: the child gets an answer or an error, and ends.
        def use():
            try:
                swarm.counts
            except beespace.BeespaceError:
                pass
        print(in_child(use))
        worker.join()
    """)
    assert (code, told) == (0, ["0"]), problem


@pytest.mark.parametrize(("make", "ask", "work"), [
    ("a_swarm(threads=1)", "it.counts", "it.update(ids, 2 + k, points, still); it.advance(2 + k)"),
    ("beespace.Engine()", "it.at_risk(points[:10], 5)", "it.pairs(points, 15)"),
    ("an_adviser()", "it.advise(points[:2], still[:2], still[:2], 2, max_speed=3)", "advise(it)"),
    ("a_verifier(threads=1)", "it.verdict()", "it.add(2 + k, points)"),
    ("a_guide(threads=1)", "len(it), it.claim(3)", "it.claim(5); it.step(2 + k)"),
])  # fmt: skip
def test_the_handler_of_a_signal_asks_what_it_has_interrupted(make, ask, work):
    code, told, problem = run(f"""
        it = {make}
        asked, missed = [], []

        def handler(*_):
            try:
                {ask}
                asked.append(1)
            except beespace.BeespaceError as error:
                assert "signal" in str(error), str(error)
                missed.append(1)

        signal.signal(signal.SIGALRM, handler)
        signal.setitimer(signal.ITIMER_REAL, 0.002, 0.002)
        begun, k = time.monotonic(), 0
        while len(asked) < 40 and time.monotonic() - begun < 60:
            {work}
            k += 1
        signal.setitimer(signal.ITIMER_REAL, 0)
        print(len(asked) >= 40)
    """)
    assert (code, told) == (0, ["True"]), problem


@pytest.mark.parametrize("left", [
    "pieces = beespace.iter_pairs(points[:3000], 30, chunk=10); next(pieces)",
    "for piece in (pieces := beespace.iter_pairs(points[:3000], 30, chunk=10)):\n    break",
    "pieces = beespace.iter_pairs(points[:3000], 30, chunk=10); next(pieces); sys.exit(0)",
    "pieces = [beespace.iter_pairs(points, 9, chunk=10) for _ in range(9)]; [*map(next, pieces)]",
    "pieces = beespace.iter_pairs(points, 9)",
])  # fmt: skip
def test_pieces_that_are_not_taken_do_not_disturb_the_end_of_the_interpreter(left):
    for _ in range(5):
        code, told, problem = run(left + "\nprint('end')\n" if "exit" not in left else left)
        assert code == 0, (code, problem)
        assert told in (["end"], [])


@pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="this system has no alarms")
def test_ctrl_c_in_the_midst_of_pieces_ends_them():
    code, told, problem = run("""
        signal.signal(signal.SIGALRM, signal.default_int_handler)
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        try:
            for piece in beespace.iter_pairs(points, 60, chunk=1000):
                pass
        except KeyboardInterrupt:
            print("ended", threading.active_count())
    """)
    assert (code, told) == (0, ["ended 1"]), problem


@_no_fork
def test_pieces_that_a_thread_of_the_parent_finds_are_refused_in_the_child_of_a_fork():
    code, told, problem = run("""
        pieces = beespace.iter_pairs(points, 60, chunk=1000)
        seen = len(next(pieces))

        def go_on():
            try:
                next(pieces)
            except beespace.BeespaceError as error:
                assert "forked" in str(error), str(error)
            else:
                raise AssertionError("pairs without the thread that finds them")

        print(in_child(go_on))
        print(seen + sum(map(len, pieces)) == len(beespace.pairs(points, 60)))
    """)
    assert (code, told) == (0, ["0", "True"]), problem
