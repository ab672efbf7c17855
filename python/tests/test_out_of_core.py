"""Points beyond memory: the answers of NumPy and of a search in memory, and what is refused."""

from __future__ import annotations

import gc
import pickle
import signal
import threading
import time

import numpy as np
import pytest

import beespace

points = np.random.default_rng(3).uniform(0, 9, (700, 3))
apart = np.linalg.norm(points[:, None] - points[None], axis=2)
near = (apart < 1.0) & ~np.eye(len(points), dtype=bool)
many = np.random.default_rng(4).uniform(0, 50, (150_000, 3))


def filled(*parts, **options):
    search = beespace.OutOfCore("16 MiB", **options)
    for part in parts:
        search.add(part)
    return search


def sorted_pairs(pieces):
    pieces = list(pieces)
    i, j = (np.concatenate([getattr(piece, name) for piece in pieces]) for name in "ij")
    order = np.lexsort((j, i))
    return i[order], j[order], np.concatenate([piece.distance for piece in pieces])[order]


def test_answers_are_those_of_numpy(tmp_path):
    search = filled(points[:300], points[300:].astype(np.float64), folder=tmp_path)
    assert len(search) == 700 and repr(search).startswith("<beespace.OutOfCore: 700 points")
    ids = search.at_risk(1.0)
    assert ids.dtype == np.int64
    np.testing.assert_array_equal(ids, np.flatnonzero(near.any(axis=1)))
    np.testing.assert_array_equal(search.count(1.0), near.sum(axis=1))
    i, j, _ = sorted_pairs(search.iter_pairs(1.0, chunk=50))
    first, second = np.nonzero(np.triu(near))
    np.testing.assert_array_equal(i, first)
    np.testing.assert_array_equal(j, second)
    order = np.argsort(apart + np.diag(np.full(len(points), np.inf)), axis=1)[:, :3]
    np.testing.assert_array_equal(search.nearest(3).ids, order)
    assert list(tmp_path.iterdir()) == []


def test_answers_of_many_cells_are_those_in_memory(tmp_path):
    file = tmp_path / "points.npy"
    np.save(file, many)
    for threads in (1, 2):
        search = beespace.OutOfCore(32 << 20, tmp_path, threads=threads)
        search.refer(np.load(file, mmap_mode="r"))
        gc.collect()
        np.testing.assert_array_equal(search.at_risk(1.0), beespace.at_risk(many, 1.0))
        assert search.facts.cells > 1 and search.facts.copies > 0
        np.testing.assert_array_equal(
            np.sort(np.concatenate(list(search.iter_at_risk(1.0)))), search.at_risk(1.0)
        )
        expected = beespace.pairs(many, 1.0)
        for given, wanted in zip(
            sorted_pairs(search.iter_pairs(1.0)), (expected.i, expected.j, expected.distance)
        ):
            np.testing.assert_array_equal(given, wanted)
        np.testing.assert_array_equal(search.count(1.0), beespace.count(many, 1.0))
        for given, wanted in zip(search.nearest(2), beespace.nearest(many, 2)):
            np.testing.assert_array_equal(given, wanted)
        assert search.closest_pair() == beespace.closest_pair(many)


def test_float32_and_vertical_thresholds():
    narrow = many.astype(np.float32)
    search = beespace.OutOfCore("16 MiB")
    search.refer(narrow)
    expected = beespace.at_risk(narrow, 1.5, vertical=0.5, inclusive=True)
    np.testing.assert_array_equal(search.at_risk(1.5, vertical=0.5, inclusive=True), expected)


def test_heights_apart():
    heights = np.random.default_rng(5).uniform(0, 100, len(points))
    search = beespace.OutOfCore("16 MiB", height_unit=0.3048)
    search.refer(points[:300], heights=heights[:300])
    search.add(points[300:], heights=heights[300:])
    level = near & (np.abs(heights[:, None] - heights[None]) < 20.0)
    np.testing.assert_array_equal(search.at_risk(1.0, vertical=20.0), np.flatnonzero(level.any(1)))
    i, j, distance = sorted_pairs(search.iter_pairs(1.0, vertical=20.0))
    np.testing.assert_array_equal((i, j), np.nonzero(np.triu(level)))
    up = (heights[i] - heights[j]) * 0.3048
    np.testing.assert_allclose(distance, np.hypot(apart[i, j], up), rtol=1e-14)
    for refused in (lambda: search.at_risk(1.0), search.closest_pair, lambda: search.add(points)):
        with pytest.raises(beespace.BeespaceError) as caught:
            refused()
        assert caught.value.code == "invalid_argument"


def test_few_points_have_few_neighbours():
    search = beespace.OutOfCore("16 MiB")
    assert search.closest_pair() is None and search.at_risk(1.0).shape == (0,)
    assert search.nearest(2).ids.shape == (0, 2) and search.count(1.0).shape == (0,)
    search.add(points[:2])
    assert search.nearest(3).ids.tolist() == [[1, -1, -1], [0, -1, -1]]
    assert search.nearest(3).distances[0, 1] == np.inf


@pytest.mark.parametrize(
    ("call", "code", "place"),
    [
        (lambda: beespace.OutOfCore("much"), "invalid_argument", "memory"),
        (lambda: beespace.OutOfCore("1 MB"), "invalid_argument", "memory"),
        (lambda: beespace.OutOfCore(-1), "invalid_argument", "memory"),
        (lambda: beespace.OutOfCore("1GB", "/no/such/folder"), "invalid_argument", "folder"),
        (lambda: beespace.OutOfCore("1GB", height_unit=0), "invalid_argument", "height_unit"),
        (lambda: filled(points, threads=4).at_risk(1.0), "invalid_argument", None),
        (lambda: filled(points).at_risk(0.0), "invalid_threshold", "threshold"),
        (lambda: filled(points).iter_pairs(1.0, chunk=0), "invalid_argument", "chunk"),
        (lambda: filled(points).nearest(-1), "invalid_argument", "k"),
        (lambda: filled([[0, 0], [np.nan, 0]]), "not_finite", "points"),
        (lambda: filled([[0, 0, 0, 0]]), "invalid_argument", "points"),
        (lambda: filled().add(points, heights=[1.0]), "invalid_argument", "heights"),
    ],
)
def test_what_makes_no_sense_is_refused(call, code, place):
    with pytest.raises(beespace.BeespaceError) as caught:
        call()
    assert (caught.value.code, caught.value.place) == (code, place)


def test_sizes_have_units():
    for text, size in {"20000000": 2e7, "20MB": 2e7, "0.02 GB": 2e7, "32 mib": 2**25}.items():
        assert f"{int(size):,} bytes" in repr(beespace.OutOfCore(text))


def test_degrees_have_no_vertical_threshold():
    class FilePoints(np.ndarray):
        frame = "wgs84"

    search = filled(points.view(FilePoints))
    with pytest.raises(beespace.BeespaceError):
        search.at_risk(1.0, vertical=1.0)
    np.testing.assert_array_equal(search.at_risk(1.0), np.flatnonzero(near.any(axis=1)))

    class Metres(np.ndarray):
        frame = "metres"

    with pytest.raises(beespace.BeespaceError, match="frame"):
        search.add(points.view(Metres))


def test_one_question_at_a_time_and_a_closed_iterator_makes_room():
    search = filled(many)
    pieces = search.iter_pairs(1.0, chunk=10)
    assert len(next(pieces)) == 10
    with pytest.raises(beespace.BeespaceError, match="another question"):
        search.count(1.0)
    pieces.close()
    assert len(search.count(1.0)) == len(many)


def test_progress_is_told_and_what_it_raises_ends_the_question():
    told = []
    search = filled(many, progress=lambda *how: told.append(how))
    search.at_risk(1.0)
    assert told[-1] == ("searching", len(many), len(many))
    assert told[0][0] == "distributing"

    def fail(*_how):
        raise KeyError("progress")

    failing = filled(many, progress=fail)
    for ask in (lambda: failing.count(1.0), lambda: list(failing.iter_pairs(1.0))):
        with pytest.raises(KeyError):
            ask()


def test_ctrl_c_ends_a_question_and_the_next_one_is_whole():
    crowd = np.random.default_rng(6).uniform(0, 1, (60_000, 3))
    search = filled(crowd)
    begin = time.monotonic()
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        search.nearest(300)
    assert time.monotonic() - begin < 20
    np.testing.assert_array_equal(search.at_risk(0.01), beespace.at_risk(crowd, 0.01))


def test_it_can_be_neither_copied_nor_pickled():
    with pytest.raises(TypeError, match="neither copied nor pickled"):
        pickle.dumps(filled(points))
