"""Points are read where they are, whatever their layout; what cannot be read is refused."""

from __future__ import annotations

import numpy as np
import pytest

import beespace
from beespace._points import Points

rng = np.random.default_rng(7)
cube = rng.uniform(0, 10, (200, 3))
expected = beespace.pairs(cube, 1.5)


def same(points):
    found = beespace.pairs(points, 1.5)
    return (
        len(found) == len(expected)
        and bool((found.i == expected.i).all())
        and bool((found.j == expected.j).all())
    )


def is_in_place(points, array):
    """Whether the structure points into the array."""
    begin, end = np.lib.array_utils.byte_bounds(array) if hasattr(np.lib, "array_utils") else (
        np.byte_bounds(array)
    )
    return begin <= Points(points, "points").struct.x < end


def test_any_strides_are_read_in_place():
    wide = np.zeros((400, 7))
    wide[::2, 1:6:2] = cube
    columns = np.asfortranarray(cube)
    backwards = np.ascontiguousarray(cube[::-1])
    mirrored = np.ascontiguousarray(cube[:, ::-1])
    for points, array in [
        (wide[::2, 1:6:2], wide),
        (columns, columns),
        (backwards[::-1], backwards),
        (mirrored[:, ::-1], mirrored),
        (tuple(columns.T), columns),
        (tuple(wide[::2, axis] for axis in (1, 3, 5)), wide),
    ]:
        assert same(points)
        assert is_in_place(points, array)


def test_a_structured_array_is_three_axes():
    table = np.zeros(200, [("name", "S8"), ("x", "f8"), ("y", "f8"), ("z", "f8")])
    table["x"], table["y"], table["z"] = cube.T
    axes = (table["x"], table["y"], table["z"])
    assert same(axes) and is_in_place(axes, table)
    packed = np.zeros(200, np.dtype([("flag", "S1"), ("x", "f8"), ("y", "f8"), ("z", "f8")]))
    packed["x"], packed["y"], packed["z"] = cube.T
    assert same((packed["x"], packed["y"], packed["z"]))


def test_broadcast_axes_have_a_stride_of_zero():
    flat = beespace.pairs((cube[:, 0], cube[:, 1], np.broadcast_to(0.0, 200)), 1.5)
    plane = beespace.pairs(cube[:, :2], 1.5)
    assert (flat.i == plane.i).all() and (flat.j == plane.j).all()
    assert (beespace.pairs((cube[:, 0], cube[:, 1]), 1.5).j == plane.j).all()


def test_floats_stay_floats():
    floats = cube.astype(np.float32)
    assert is_in_place(floats, floats)
    found = beespace.pairs(floats, 1.5)
    doubles = beespace.pairs(floats.astype(np.float64), 1.5)
    assert (found.j == doubles.j).all() and (found.distance == doubles.distance).all()
    mixed = beespace.pairs((floats[:, 0], cube[:, 1], cube[:, 2]), 1.5)
    assert len(mixed) > 0


def test_what_is_exact_is_converted():
    whole = rng.integers(-20, 20, (100, 3))
    for dtype in (np.int8, np.int32, np.int64, np.float16, ">f8", ">f4", ">i4"):
        found = beespace.pairs(whole.astype(dtype), 3)
        assert (found.j == beespace.pairs(whole.astype(float), 3).j).all()
    assert same(cube.astype(">f8"))
    assert same(cube.tolist())
    assert same([tuple(row) for row in cube])
    assert same(np.ma.masked_array(cube))


def test_other_libraries_arrays_are_read():
    class ByDlpack:
        def __dlpack__(self, **options):
            return cube.__dlpack__(**options)

        def __dlpack_device__(self):
            return cube.__dlpack_device__()

    class ByInterface:
        __array_interface__ = cube.__array_interface__

    for points in (ByDlpack(), ByInterface(), memoryview(cube)):
        assert same(points)
        assert is_in_place(points, cube)


def test_of_no_points_there_is_an_answer():
    for points in ([], np.empty((0, 3)), np.empty((0, 2), np.float32), ([], [], [])):
        if isinstance(points, tuple):
            points = tuple(np.asarray(axis, float) for axis in points)
        assert beespace.at_risk(points, 1).tolist() == []
        assert len(beespace.pairs(points, 1)) == 0
        assert len(beespace.neighbors(points, 1)) == 0
        assert len(beespace.groups(points, 1)) == 0
        assert beespace.nearest(points, 3).ids.shape == (0, 3)
        assert beespace.closest_pair(points) is None
        assert list(beespace.iter_pairs(points, 1)) == []


@pytest.mark.parametrize(
    "points",
    [
        [1, 2, 3],
        [[1, 2, 3, 4]],
        [[1], [2]],
        np.zeros((2, 2, 3)),
        [["a", "b", "c"]],
        np.zeros((3, 3), complex),
        np.zeros((3, 3), np.longdouble),
        np.zeros((3, 3), bool),
        np.zeros((3, 3), "M8[s]"),
        [[1, 2, 3], [4, 5]],
        np.array([[None, 1, 2]]),
        np.array([[2**53 + 1, 0, 0]]),
        np.ma.masked_array(np.zeros((2, 3)), [[True, False, False]] * 2),
        (np.zeros(3), np.zeros(4)),
        (np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3)),
        (np.zeros(3),),
        None,
    ],
)
def test_what_is_no_array_of_points_is_refused(points):
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.at_risk(points, 1)
    assert caught.value.code == "invalid_argument"
    assert caught.value.place == "points"
    assert isinstance(caught.value, ValueError)


def test_a_copy_is_one():
    points = Points(cube, "points", copy=True)
    assert not is_in_place(points.keep, cube)
    assert (points.keep == cube).all()


def test_three_points_in_a_list_are_points():
    # Of nine numbers a list is one of rows, and a tuple one of axes, whatever is in it.
    rows = [[0, 0, 0], [0, 0, 1], [9, 9, 9]]
    assert beespace.at_risk(rows, 2).tolist() == [0, 1]
    assert beespace.at_risk([*map(tuple, rows)], 2).tolist() == [0, 1]
    assert beespace.at_risk(tuple(zip(*rows)), 2).tolist() == [0, 1]
    assert beespace.at_risk(tuple(map(list, zip(*rows))), 2).tolist() == [0, 1]
    assert beespace.at_risk(tuple(np.array(rows, float).T), 2).tolist() == [0, 1]
    assert beespace.at_risk([np.array(row) for row in rows], 2).tolist() == [0, 1]


@pytest.mark.parametrize(
    ("axes", "near"),
    [
        (([0, 100, 200], [0, 0, 0], [0, 0, 0]), []),
        (([0, 1], [0, 0], [50, 50]), [0, 1]),
        ((np.array([0.0, 100, 200]), [0, 0, 0], np.zeros(3)), []),
        (((0, 3, 90), (0, 4, 0)), [0, 1]),
    ],
)
def test_a_tuple_of_lists_is_one_of_axes(axes, near):
    assert beespace.at_risk(axes, 10).tolist() == near
    # As where each axis is an array.
    assert beespace.at_risk(tuple(map(np.asarray, axes)), 10).tolist() == near


def test_a_tuple_of_rows_is_refused():
    for rows in (([0, 0, 0],), ([0, 0, 0],) * 4):
        with pytest.raises(beespace.BeespaceError, match="rows are given as a list"):
            beespace.at_risk(rows, 5)
    with pytest.raises(beespace.BeespaceError, match="differ in length: 3, 2, 3"):
        beespace.at_risk(([0, 1, 2], [0, 1], [0, 0, 0]), 5)
