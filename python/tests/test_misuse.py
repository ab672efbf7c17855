"""What users do besides: copies, processes, forks, arguments that are nearly right."""

from __future__ import annotations

import copy
import os
import pickle
import signal
import subprocess
import sys
import warnings

import numpy as np
import pytest

import beespace

points = np.random.default_rng(5).uniform(0, 30, (3000, 3))
fixes = ([1, 2, 1, 2], [0, 0, 1, 1], points[:4])


def _answers():
    yield beespace.pairs(points, 2.0), ("i", "j", "distance", "shape")
    yield beespace.neighbors(points, 2.0), ("indptr", "indices", "distances")
    yield beespace.groups(points, 1.0), ("indptr", "indices", "labels")
    yield beespace.nearest(points, 2), ("ids", "distances")
    yield beespace.closest_pair(points), ("i", "j", "distance")
    yield beespace.predict(points, points[::-1], 1.0, within=0.1), ("i", "begin", "closest_time")
    yield beespace.closest_approach(*points[:4]), ("closest_time", "closest_distance")
    recorded = beespace.Recording(*fixes)
    yield recorded.conflicts(50.0), ("i", "j", "begin", "end")
    yield recorded.conflicts(50.0, max_gap=0.5).gaps, ("id", "begin", "end")


@pytest.mark.parametrize(
    ("answer", "names"), [pytest.param(*each, id=type(each[0]).__name__) for each in _answers()]
)
def test_answers_are_copied_and_sent_to_other_processes(answer, names):
    for again in (pickle.loads(pickle.dumps(answer)), copy.copy(answer), copy.deepcopy(answer)):
        assert type(again) is type(answer) and repr(again) == repr(answer)
        for name in names:
            assert np.array_equal(getattr(again, name), getattr(answer, name))


def test_what_the_library_keeps_is_never_owned_twice():
    kept = [beespace.Index(points), beespace.Recording(*fixes)]
    if "BEESPACE_IO_LIBRARY" in os.environ:
        kept.append(beespace.read("../examples/data/swarm.csv"))
        kept.append(beespace.read_recording("../examples/data/cage.csv"))
    for each in kept:
        for way in (pickle.dumps, copy.deepcopy):
            with pytest.raises(TypeError, match="make it anew"):
                way(each)
    # What never changes has copies that are not deep.
    for each in kept[1:]:
        assert repr(copy.copy(each)) == repr(each)
    other = copy.copy(kept[1])
    kept.clear()
    assert len(other.conflicts(50.0))


def test_what_changes_has_no_copies():
    guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
    for each in (
        beespace.Index(points),
        beespace.Swarm(5),
        beespace.Verifier(5),
        beespace.Adviser(),
        guide,
        beespace.Follower(7, 6, 4, 0.1),
        beespace.OutOfCore("100 MB"),
    ):
        for way in (pickle.dumps, copy.copy, copy.deepcopy):
            with pytest.raises(TypeError, match="make it anew"):
                way(each)


def test_errors_of_python_name_what_was_called():
    for call, name in [
        (lambda: beespace.at_risk(points, 1.0, points), r"^at_risk\(\)"),
        (lambda: beespace.Engine().at_risk(points, 1.0, threshold=1), r"^at_risk\(\)"),
        (lambda: beespace.predict(points, points, 1.0), r"^predict\(\)"),
    ]:
        with pytest.raises(TypeError, match=name):
            call()
    assert pickle.loads(pickle.dumps(beespace.at_risk))(points[:2], 1e-9).size == 0


def test_a_copy_of_an_engine_is_a_new_one():
    engine = beespace.Engine()
    engine.at_risk(points, 1.0)
    for again in (pickle.loads(pickle.dumps(engine)), copy.copy(engine), copy.deepcopy(engine)):
        assert repr(again) == "<beespace.Engine: 0 calls so far>"
        assert np.array_equal(again.at_risk(points, 1.0), engine.at_risk(points, 1.0))


_forks = """
import os, signal, threading, numpy, beespace
points = numpy.random.default_rng(5).uniform(0, 30, (20_000, 3))
engine, dropped = beespace.Engine(), beespace.Engine()
expected = engine.pairs(points, 1.0, threads=2)
dropped.pairs(points, 1.0, threads=2)
child = os.fork()
if child == 0:
    signal.alarm(20)
    del dropped
    same = [
        numpy.array_equal(each.pairs(points, 1.0, threads=2).j, expected.j)
        for each in (engine, beespace, engine)
    ]
    del engine
    os._exit(0 if all(same) else 3)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
print(numpy.array_equal(engine.pairs(points, 1.0, threads=2).j, expected.j))
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
def test_an_engine_works_in_the_child_of_a_fork_too():
    ran = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", _forks], capture_output=True, text=True, timeout=60
    )
    assert ran.stdout == "0\nTrue\n", ran.stdout + ran.stderr


def _double(part):
    return beespace.pairs(part, 2.0)


def test_workers_of_a_pool_ask_and_send_answers():
    multiprocessing = pytest.importorskip("multiprocessing")
    for way in ("fork", "spawn"):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # forks of processes with threads
            with multiprocessing.get_context(way).Pool(2) as pool:
                parts = pool.map_async(_double, [points[:900], points[900:]]).get(timeout=90)
        for part, given in zip(parts, (points[:900], points[900:])):
            assert np.array_equal(part.distance, beespace.pairs(given, 2.0).distance)


def test_masks_are_never_dropped():
    masked = np.ma.masked_array([0.0, 1.0], [False, True])
    for call, place in [
        (lambda: beespace.Recording([1, 1], masked, points[:2]), "times"),
        (lambda: beespace.Recording(masked.astype(int), [0, 1], points[:2]), "ids"),
        (lambda: beespace.to_ecef(masked, [0, 0], 0), "lon"),
        (lambda: beespace.to_ecef([0, 0], [0, 0], masked), "height"),
        (lambda: beespace.Index(points).around(points[:2], masked), "radius"),
        (lambda: beespace.at_risk((masked, masked), 1), "points"),
    ]:
        with pytest.raises(beespace.BeespaceError, match="masked") as caught:
            call()
        assert caught.value.place == place
    clean = np.ma.masked_array([0.0, 1.0], [False, False])
    assert len(beespace.Recording([1, 1], clean, points[:2])) == 2


@pytest.mark.parametrize("threshold", ["5", "5 m", b"5", None, [5], 1j, np.str_("5")])
def test_a_threshold_is_a_number_and_no_text(threshold):
    for call in (
        lambda: beespace.pairs(points, threshold),
        lambda: beespace.pairs(points, 1.0, vertical=[threshold]),
        lambda: beespace.plot(points[:9], threshold, vertical=1.0)
        if threshold is not None and np.ndim(threshold) == 0
        else beespace.count(points, threshold),
    ):
        with pytest.raises(beespace.BeespaceError) as caught:
            call()
        assert caught.value.code == "invalid_threshold"


def test_numbers_that_are_no_doubles_are_refused():
    for call, code in [
        (lambda: beespace.pairs(points, 10**400), "invalid_threshold"),
        (lambda: beespace.predict(points, points, 1.0, within="60"), "invalid_argument"),
        (lambda: beespace.predict(points, points, 1.0, within=10**400), "invalid_argument"),
        (lambda: beespace.Index(points).around(points[:2], ["a", "b"]), "invalid_argument"),
    ]:
        with pytest.raises(beespace.BeespaceError) as caught:
            call()
        assert caught.value.code == code


@pytest.mark.parametrize("row", [1.5, "a", slice(1, 3), None])
def test_rows_are_asked_for_one_by_one(row):
    with pytest.raises(TypeError):
        beespace.neighbors(points, 1.0)[row]


@pytest.mark.parametrize(
    ("given", "hint"),
    [
        ({"x": [1.0], "y": [2.0]}, "tuple"),
        (np.zeros(3, [("x", "f8"), ("y", "f8")]), "tuple"),
        ("swarm.csv", "beespace.read"),
        (iter([[0, 0, 0]]), "list"),
    ],
)
def test_what_is_nearly_points_says_what_to_give(given, hint):
    with pytest.raises(beespace.BeespaceError, match=hint) as caught:
        beespace.at_risk(given, 1.0)
    assert (caught.value.code, caught.value.place) == ("invalid_argument", "points")


def test_without_matplotlib_it_says_so(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match=r"pip install beespace\[plot\]"):
        beespace.plot(points[:9], 1.0)


def test_signals_of_the_user_are_left_alone():
    before = signal.getsignal(signal.SIGINT)
    beespace.pairs(points, 1.0, threads=2)
    assert signal.getsignal(signal.SIGINT) is before
