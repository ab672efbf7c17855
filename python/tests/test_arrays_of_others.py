"""Arrays of other libraries are read where they are; what they say of units is heard."""

from __future__ import annotations

import ctypes
import gc
import tracemalloc

import numpy as np
import pytest

import beespace
from arrays_with_units import Astropy, Pint
from beespace._points import Points

cube = np.random.default_rng(7).uniform(0, 10, (300, 3))
found = beespace.pairs(cube, 1.5)
frame = {name: cube[:, axis].copy() for axis, name in enumerate("xyz")}


def same(points):
    answer = beespace.pairs(points, 1.5)
    return np.array_equal(answer.i, found.i) and np.array_equal(answer.j, found.j)


def first_of(points):
    """Where the library reads the first x."""
    return Points(points, "points").struct.x


# ---- DLPack: a producer that shares nothing with NumPy's ---------------------------------------


class Tensor(ctypes.Structure):
    _fields_ = [
        ("data", ctypes.c_void_p),
        ("device_type", ctypes.c_int32),
        ("device_id", ctypes.c_int32),
        ("ndim", ctypes.c_int32),
        ("code", ctypes.c_uint8),
        ("bits", ctypes.c_uint8),
        ("lanes", ctypes.c_uint16),
        ("shape", ctypes.POINTER(ctypes.c_int64)),
        ("strides", ctypes.POINTER(ctypes.c_int64)),
        ("byte_offset", ctypes.c_uint64),
    ]


class Managed(ctypes.Structure):
    pass


Deleter = ctypes.CFUNCTYPE(None, ctypes.POINTER(Managed))
Managed._fields_ = [("tensor", Tensor), ("context", ctypes.c_void_p), ("deleter", Deleter)]

new_capsule = ctypes.pythonapi.PyCapsule_New
new_capsule.restype = ctypes.py_object
new_capsule.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]


class Produced:
    """Memory of its own with an offset, as DLPack describes it; it has no other interface."""

    def __init__(self, numbers, compact, device=1):
        self.device = device
        self.deleted = 0
        real = ctypes.c_float if numbers.dtype == np.float32 else ctypes.c_double
        size = ctypes.sizeof(real)
        rows, axes = numbers.shape
        step = axes if compact else axes + 2
        self.memory = (real * (3 + rows * step))(*[float("nan")] * (3 + rows * step))
        for row in range(rows):
            for axis in range(axes):
                self.memory[3 + row * step + axis] = float(numbers[row, axis])
        self.begin = ctypes.addressof(self.memory) + 3 * size
        self.shape = (ctypes.c_int64 * 2)(rows, axes)
        self.strides = (ctypes.c_int64 * 2)(step, 1)
        self.on_delete = Deleter(self._delete)
        strides = None if compact else self.strides
        self.managed = Managed(
            Tensor(ctypes.addressof(self.memory), device, 0, 2, 2, 8 * size, 1, self.shape, strides,
                   3 * size),
            None,
            self.on_delete,
        )

    def _delete(self, managed):
        self.deleted += 1

    def __dlpack__(self, stream=None):
        return new_capsule(ctypes.addressof(self.managed), b"dltensor", None)

    def __dlpack_device__(self):
        return (self.device, 0)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("compact", [True, False])
def test_dlpack_is_read_in_place_and_given_back(dtype, compact):
    numbers = cube.astype(dtype)
    produced = Produced(numbers, compact)
    points = Points(produced, "points")
    assert points.struct.x == produced.begin
    assert produced.deleted == 0  # as long as it is read
    del points
    gc.collect()
    assert produced.deleted == 1
    answer, expected = beespace.pairs(produced, 1.5), beespace.pairs(numbers, 1.5)
    assert len(answer) and np.array_equal(answer.j, expected.j)
    assert np.array_equal(answer.distance, expected.distance)
    gc.collect()
    assert produced.deleted == 2


def test_memory_of_a_graphics_card_is_refused():
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.pairs(Produced(cube, True, device=2), 1.5)
    assert (caught.value.code, caught.value.place) == ("invalid_argument", "points")


def test_the_array_api():
    xp = pytest.importorskip("array_api_strict")
    assert same(xp.asarray(cube))
    assert first_of(xp.asarray(cube, copy=False)) == cube.ctypes.data
    assert same(tuple(xp.asarray(axis) for axis in frame.values()))


# ---- Data frames -------------------------------------------------------------------------------


def test_pandas_without_a_copy():
    pandas = pytest.importorskip("pandas")
    by_column = pandas.DataFrame(frame)
    assert same(by_column) and same(by_column[["x", "y", "z"]])
    assert first_of(by_column) == by_column["x"].to_numpy().ctypes.data
    at_once = pandas.DataFrame(cube, columns=[*"xyz"], copy=False)
    assert same(at_once) and first_of(at_once) == cube.ctypes.data
    axes = tuple(at_once[name] for name in "xyz")
    assert same(axes) and first_of(axes) == cube.ctypes.data
    assert same(by_column.astype("Float64"))
    broken = by_column.astype("Float64")
    broken.iloc[7, 1] = pandas.NA
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.pairs(broken, 1.5)
    assert caught.value.record in (7, None) and caught.value.place == "points"


def test_polars_without_a_copy():
    polars = pytest.importorskip("polars")
    table = polars.DataFrame(frame)
    address = table["x"].to_numpy(allow_copy=False).ctypes.data
    assert same(table) and first_of(table) == address
    axes = tuple(table[name] for name in "xyz")
    assert same(axes) and first_of(axes) == address
    assert same(table.with_columns(polars.col("x").cast(polars.Float64))[["x", "y", "z"]])
    assert same(polars.concat([table[:100], table[100:]], rechunk=False))
    hole = table.with_columns(
        polars.when(polars.int_range(polars.len()) != 9).then(polars.col("y")).alias("y")
    )
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.pairs(hole, 1.5)
    assert (caught.value.code, caught.value.record) == ("not_finite", 9)
    with pytest.raises(beespace.BeespaceError, match=r"\.collect\(\)"):
        beespace.pairs(table.lazy(), 1.5)


def test_a_recording_of_polars():
    polars = pytest.importorskip("polars")
    table = polars.DataFrame(
        {"id": ["a", "b"] * 2, "t": [0.0, 0, 10, 10], "x": [0.0, 100, 100, 0], "y": [0.0, 3, 0, 3]}
    )
    recording = beespace.Recording.from_frame(table, id="id", time="t", x="x", y="y")
    conflicts = recording.conflicts(5).to_polars()
    assert conflicts.select("i", "j", "closest_time").rows() == [("a", "b", 5.0)]


columns = {"id": ["a", "b"] * 2, "t": [0.0, 0, 10, 10], "x": [0.0, 100, 100, 0], "y": [0.0, 3, 0, 3]}
names = {"id": "id", "time": "t", "x": "x", "y": "y"}


def is_recording_of_columns(table):
    recording = beespace.Recording.from_frame(table, **names)
    pass_by = recording.conflicts(5)
    assert (pass_by.i.tolist(), pass_by.j.tolist()) == (["a"], ["b"])
    assert pass_by.closest_time.tolist() == [5.0]
    with pytest.raises(beespace.BeespaceError, match="it has: .*x") as caught:
        beespace.Recording.from_frame(table, **{**names, "x": "east"})
    assert (caught.value.code, caught.value.place) == ("missing_column", "x")


def test_a_recording_of_a_structured_array():
    rows = list(zip(*columns.values()))
    fields = [("id", "U1"), ("t", "f8"), ("x", "f8"), ("y", "f4")]
    is_recording_of_columns(np.array(rows, fields))
    is_recording_of_columns(np.array(rows, fields).view(np.recarray))
    for table in (np.zeros((4, 3)), [1, 2, 3], 5):
        with pytest.raises(beespace.BeespaceError, match="no columns by name") as caught:
            beespace.Recording.from_frame(table, **names)
        assert caught.value.place == "frame"


def test_a_recording_of_arrow():
    arrow = pytest.importorskip("pyarrow")
    table = arrow.table(columns)
    is_recording_of_columns(table)
    is_recording_of_columns(arrow.concat_tables([table[:1], table[1:]]))  # in chunks
    is_recording_of_columns(table.to_batches()[0])
    twice = arrow.Table.from_arrays([table["x"], table["x"]], names=["x", "x"])
    with pytest.raises(beespace.BeespaceError, match="has no column 'id'"):
        beespace.Recording.from_frame(twice, **names)


def test_a_recording_of_xarray_whose_time_is_a_coordinate():
    xarray = pytest.importorskip("xarray")
    given = {name: ("t", values) for name, values in columns.items() if name != "t"}
    is_recording_of_columns(xarray.Dataset(given, coords={"t": columns["t"]}))


def test_arrow_without_a_copy():
    arrow = pytest.importorskip("pyarrow")
    table = arrow.table(frame)
    address = table["x"].chunk(0).buffers()[1].address
    for points in (table, table.to_batches()[0], tuple(table.columns),
                   tuple(column.chunk(0) for column in table.columns)):
        assert same(points) and first_of(points) == address
    assert same(arrow.concat_tables([table[:100], table[100:]]))
    holes = arrow.table({"x": arrow.array([1.0, None]), "y": [1.0, 2.0]})
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.pairs(holes, 1.5)
    assert (caught.value.code, caught.value.record) == ("not_finite", 1)


def test_xarray_without_a_copy():
    xarray = pytest.importorskip("xarray")
    array = xarray.DataArray(cube, dims=("bee", "axis"))
    assert same(array) and first_of(array) == cube.ctypes.data
    axes = tuple(array.isel(axis=axis) for axis in range(3))
    assert same(axes) and first_of(axes) == cube.ctypes.data
    assert same(array.assign_attrs(units="metres"))
    with pytest.raises(beespace.BeespaceError, match="in km") as caught:
        beespace.pairs(axes[:2] + (axes[2].assign_attrs(units="km"),), 1.5)
    assert caught.value.place == "points"


@pytest.mark.parametrize("library", ["numpy", "pandas", "polars", "pyarrow", "xarray"])
def test_a_million_points_cost_no_memory(library):
    module = pytest.importorskip(library)
    columns = dict(zip("xyz", np.random.default_rng(1).uniform(0, 1e4, (3, 1_000_000))))
    points = {
        "numpy": lambda: tuple(columns.values()),
        "pandas": lambda: module.DataFrame(columns),
        "polars": lambda: module.DataFrame(columns),
        "pyarrow": lambda: module.table(columns),
        "xarray": lambda: module.DataArray(np.stack([*columns.values()], axis=1)),
    }[library]()
    tracemalloc.start()
    try:
        Points(points, "points")
        _, peak = tracemalloc.get_traced_memory()
        Points(points, "points", copy=True)
        _, of_a_copy = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak < 1_000_000 and of_a_copy >= 24_000_000


# ---- Units -------------------------------------------------------------------------------------


def test_what_is_in_another_unit_is_refused():
    speeds = np.ones_like(cube)
    for call, place in [
        (lambda: beespace.at_risk(cube.view(Astropy), 1), "points"),
        (lambda: beespace.at_risk(Pint(cube, "kilometer"), 1), "points"),
        (lambda: beespace.at_risk((cube[:, 0], Pint(cube[:, 1], "foot")), 1), "points"),
        (lambda: beespace.at_risk(cube, 1, others=cube.view(Astropy)), "others"),
        (lambda: beespace.predict(cube, Pint(speeds, "knot"), 1, within=1), "velocities"),
        (lambda: beespace.predict(cube, Pint(speeds, "meter"), 1, within=1), "velocities"),
        (lambda: beespace.Recording([1, 1], Pint(np.arange(2.0), "minute"), cube[:2]), "times"),
        (lambda: beespace.Index(cube).around(cube[:2], Pint(np.ones(2), "foot")), "radius"),
        (lambda: beespace.Index(cube).insert(cube[0].view(Astropy)), "point"),
        (lambda: beespace.to_ecef(Pint(np.ones(2), "radian"), np.ones(2), 0), "lon"),
        (lambda: beespace.to_ecef([1, 1], [1, 1], Pint(np.ones(2), "foot")), "height"),
    ]:
        with pytest.raises(beespace.BeespaceError, match="convert it first") as caught:
            call()
        assert caught.value.place == place


def test_what_is_in_the_unit_that_is_taken_is_read():
    assert same(Pint(cube, "meter")) and same(Pint(cube, "dimensionless"))
    assert first_of(Pint(cube, "m")) == cube.ctypes.data
    slow = beespace.predict(cube, Pint(cube, "meter / second"), 1, within=1)
    assert len(slow) == len(beespace.predict(cube, cube, 1, within=1))
    recording = beespace.Recording([1, 1], Pint(np.arange(2.0), "second"), cube[:2])
    assert len(recording) == 2
    ones = np.ones(2)
    degrees = beespace.to_ecef(Pint(ones, "degree"), Pint(ones, "degree"), Pint(ones, "meter"))
    assert np.array_equal(degrees, beespace.to_ecef(ones, ones, ones))
