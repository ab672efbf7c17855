"""Recordings beyond memory: the answers of recordings in memory, and what is refused."""

from __future__ import annotations

import pickle
import signal
import threading
import time

import numpy as np
import pytest

import beespace

agents, fixes = 300, 1500


def flights(seed):
    """Rows in the order of time: who, when, where; agents are silent now and then."""
    random = np.random.default_rng(seed)
    times = np.repeat(np.arange(fixes, dtype=float), agents) + random.uniform(0, 0.9, agents * fixes)
    steps = random.uniform(-3, 3, (fixes, agents, 3))
    places = (random.uniform(0, 300, (agents, 3)) + np.cumsum(steps, axis=0)).reshape(-1, 3)
    ids = np.tile(np.arange(agents) * 7 - 900, fixes)
    there = random.uniform(size=len(ids)) > 0.2
    return ids[there], times[there], places[there]


def out_of_core(ids, times, positions, heights=None, parts=7, **options):
    recording = beespace.RecordingOutOfCore("16 MiB", **options)
    mixed = np.random.default_rng(1).permutation(len(ids))
    for rows in np.array_split(mixed, parts):
        recording.add(
            np.asarray(ids)[rows],
            times[rows],
            positions[rows],
            heights=None if heights is None else heights[rows],
        )
    return recording


def expect_same(found, expected):
    for name, column in expected.columns().items():
        np.testing.assert_array_equal(found.columns()[name], column, err_msg=name)
        assert found.columns()[name].dtype.kind == column.dtype.kind
    for name, column in expected.gaps.columns().items():
        np.testing.assert_array_equal(found.gaps.columns()[name], column, err_msg=name)
    assert repr(found) == repr(expected)


@pytest.mark.parametrize("max_gap", [None, 2.5])
def test_answers_are_those_in_memory(tmp_path, max_gap):
    ids, times, places = flights(1)
    expected = beespace.Recording(ids, times, places).conflicts(9, max_gap=max_gap)
    assert len(expected) > 1000
    recording = out_of_core(ids, times, places, folder=tmp_path)
    expect_same(recording.conflicts(9, max_gap=max_gap), expected)
    assert recording.facts.windows > 1 and recording.facts.copies > 0
    assert list(tmp_path.iterdir()) == []


def test_options_and_texts_are_those_in_memory():
    ids, times, places = flights(2)
    some = times < 200
    ids, times, places = np.char.add("bee ", ids[some].astype("U")), times[some], places[some]
    heights = np.random.default_rng(3).uniform(0, 100, len(ids))
    for options in ({"threads": 1}, {"threads": 1, "height_unit": 0.3048}):
        unit = options.get("height_unit", 1.0)
        whole = beespace.Recording(ids, times, places, heights=heights, height_unit=unit)
        asked = {"vertical": 20, "inclusive": True, "max_gap": 3}
        recording = out_of_core(ids, times, places, heights, **options)
        expected = whole.conflicts(12, **asked)
        assert len(expected) > 100
        expect_same(recording.conflicts(12, **asked), expected)
    with pytest.raises(beespace.BeespaceError, match="vertical") as refused:
        recording.conflicts(12)
    assert refused.value.code == "invalid_argument"


def test_an_empty_one():
    recording = beespace.RecordingOutOfCore("16 MiB")
    assert len(recording) == 0 and len(recording.conflicts(5)) == 0
    recording.add([], [], np.empty((0, 3)))
    assert not recording.facts.encounters


def test_what_is_no_fix():
    recording = beespace.RecordingOutOfCore("16 MiB")
    recording.add([1, 1, 2], [0, 1, 0], [[0, 0], [1, 1], [2, 2]])
    for ids, times, places, code, place, record in (
        ([1, 2], [5, np.nan], [[0, 0], [0, 0]], "not_finite", "times", 1),
        ([1, 2], [5, 5], [[0, 0], [0, 1e31]], "outside_domain", "positions", 1),
        (["a", "b"], [5, 5], [[0, 0], [0, 1]], "invalid_argument", "ids", None),
        ([1.5, 2.5], [5, 5], [[0, 0], [0, 1]], "invalid_argument", "ids", None),
    ):
        with pytest.raises(beespace.BeespaceError) as refused:
            recording.add(ids, times, places)
        error = refused.value
        assert (error.code, error.place, error.record) == (code, place, record)
        assert len(recording) == 3
    recording.add([2, 1], [9, 1], [[0, 0], [1, 1]])
    with pytest.raises(beespace.BeespaceError, match="the first as record 1") as refused:
        recording.conflicts(5)
    assert refused.value.code == "time_order" and refused.value.record == 4
    with pytest.raises(TypeError):
        pickle.dumps(recording)
    with pytest.raises(beespace.BeespaceError, match="16 MiB"):
        beespace.RecordingOutOfCore("1 MB")
    with pytest.raises(beespace.BeespaceError, match="no folder"):
        beespace.RecordingOutOfCore("1 GB", "/no/such/folder")


def test_progress_is_told_and_ends_it():
    ids, times, places = flights(4)
    told = []
    recording = out_of_core(
        ids, times, places, progress=lambda phase, done, of: told.append((phase, done, of))
    )
    recording.conflicts(5)
    assert {phase for phase, _, _ in told} >= {"searching"}
    assert all(0 <= done <= of == len(ids) for _, done, of in told)

    class Enough(Exception):
        pass

    def stop(*_told):
        raise Enough

    recording = out_of_core(ids, times, places, progress=stop)
    with pytest.raises(Enough):
        recording.conflicts(5)


def test_ctrl_c_ends_it():
    ids, times, places = flights(5)
    recording = out_of_core(ids, times, places)
    begin = time.monotonic()
    recording.conflicts(60)
    whole = time.monotonic() - begin
    timer = threading.Timer(whole / 4, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        while True:
            recording.conflicts(60)
    timer.join()


class _Degrees(np.ndarray):
    frame = "wgs84"


def test_frames_axes_and_units_of_heights_are_checked_as_in_memory():
    places = np.array([[4e6, 5e5, 4.9e6], [4e6, 5e5 + 30, 4.9e6]])
    recording = beespace.RecordingOutOfCore("16 MiB")
    recording.add([1, 2], [0, 0], places.view(_Degrees))
    recording.add([1, 2], [1, 1], places)  # says nothing: what was said before holds
    assert len(recording.conflicts(50)) == 1
    with pytest.raises(beespace.BeespaceError, match="vertical") as refused:
        recording.conflicts(50, vertical=10)
    assert refused.value.place == "vertical"
    with pytest.raises(beespace.BeespaceError, match="axes") as refused:
        recording.add([1], [2], [[0, 0]])
    assert refused.value.place == "positions"
    in_feet = beespace.RecordingOutOfCore("16 MiB", height_unit=0.3048)
    in_feet.add([1, 2], [0, 0], [[0, 0, 0], [1, 0, 500]])
    with pytest.raises(beespace.BeespaceError, match="no heights apart") as refused:
        in_feet.conflicts(50, vertical=1)
    assert refused.value.place == "height_unit"
