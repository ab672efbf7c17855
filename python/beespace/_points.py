"""What callers give as points, as the library reads them: in place, wherever that is possible."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace._errors import invalid
from beespace._frames import Described, Known, check_alike, frame_of
from beespace._library import FLOAT32, FLOAT64, CPoints
from beespace._reals import check_integers, check_list
from beespace._units import METRES, NO_UNIT, SPEEDS, plain

PointsLike = ArrayLike  # or a tuple of arrays, a data frame, anything that DLPack knows

_types = {np.dtype(np.float64): FLOAT64, np.dtype(np.float32): FLOAT32}
_size = ctypes.sizeof(CPoints)


class Points:
    """The C structure of points, and what must stay alive as long as it."""

    __slots__ = ("count", "frame", "keep", "struct")

    def __init__(self, points: Any, place: str, copy: bool = False) -> None:
        self.frame: str | None = None
        if not copy and _is_readable(points):
            self._of_rows(points)
            return
        self.frame = frame_of(points)
        axes = _axes_of(points, place)
        if axes is None:
            rows = _numbers(_array_of(points, place), place, copy)
            if rows.ndim == 1 and rows.size == 0:
                rows = rows.reshape(0, 3)
            if rows.ndim != 2 or rows.shape[1] not in (2, 3):
                raise invalid(
                    f"points have the shape (n, 3) or (n, 2), not {rows.shape}; one array an axis "
                    "is given as a tuple",
                    place,
                )
            self._of_rows(rows)
            return
        self._of_axes([_numbers(axis, place, copy) for axis in axes], place)

    @property
    def axes(self) -> int | None:
        """How many there are; None where there are no points, which then go with any."""
        return None if not self.count else 2 if self.struct.z is None else 3

    def check_alike(self, others: Described, place: str, of: str) -> None:
        """Refuses points that cannot be compared with those others."""
        check_alike(self, others, place, of)

    def rows(self) -> NDArray[np.float64]:
        """The same as an array of shape (n, 3)."""
        keep: Any = self.keep
        rows = np.zeros((self.count, 3))
        for axis, numbers in enumerate(keep if _is_a(keep, list) else keep.T):
            rows[:, axis] = numbers
        return rows

    def _of_rows(self, rows: NDArray[Any]) -> None:
        address = rows.__array_interface__["data"][0]
        count, axes = rows.shape
        row, column = rows.strides
        self.keep: object = rows
        self.count = count
        self.struct = CPoints(
            _size,
            _types[rows.dtype],
            0,
            count,
            address,
            address + column,
            address + 2 * column if axes == 3 else None,
            row,
            row,
            row,
        )

    def _of_axes(self, axes: list[NDArray[Any]], place: str) -> None:
        if any(axis.ndim != 1 for axis in axes):
            raise invalid("each array of a tuple is one axis, of one dimension", place)
        if len({len(axis) for axis in axes}) != 1:
            lengths = ", ".join(str(len(axis)) for axis in axes)
            raise invalid(f"the axes differ in length: {lengths}", place)
        if len({axis.dtype for axis in axes}) != 1:
            axes = [axis.astype(np.float64) for axis in axes]
        addresses = [axis.__array_interface__["data"][0] for axis in axes]
        strides = [axis.strides[0] for axis in axes]
        if len(axes) == 2:
            addresses.append(None)
            strides.append(0)
        self.keep = axes
        self.count = len(axes[0])
        self.struct = CPoints(_size, _types[axes[0].dtype], 0, self.count, *addresses, *strides)


def position(point: Any, others: Known) -> ctypes.Array[ctypes.c_double]:
    """One position of as many coordinates as others have axes; beside those in a plane z may be 0."""
    place, axes = "point", others.axes
    check_alike(Known(frame=frame_of(point)), others, place, "points")
    numbers = _numbers(_array_of(point, place), place, False)
    if numbers.shape not in ((2,), (3,)):
        raise invalid("a position has two or three coordinates", place)
    if axes is not None and len(numbers) != axes and (axes == 3 or numbers[2] != 0):
        raise invalid(f"this has {len(numbers)} coordinates, and the points have {axes}", place)
    return (ctypes.c_double * 3)(*(float(number) for number in numbers))


def _is_readable(array: Any) -> bool:
    # Of a dtype of foreign bytes there is no entry either.
    return (
        _is_plain(array)
        and array.dtype in _types
        and array.ndim == 2
        and array.shape[1] in (2, 3)
        and bool(array.flags.aligned)
    )


def _is_plain(array: Any) -> bool:
    return type(array) is np.ndarray


def _is_a(thing: Any, kind: type) -> bool:
    return isinstance(thing, kind)


def _axes_of(points: Any, place: str) -> list[NDArray[Any]] | None:
    """One array an axis, of a tuple or of a data frame; None of anything else. In a tuple there may be
    lists and tuples, too: only a list, or an array, is one of rows."""
    columns: list[Any]
    if _are_columns(points):
        columns = [*points]
    elif hasattr(points, "column_names") and hasattr(points, "itercolumns"):  # pyarrow
        columns = list(points.columns)
    elif hasattr(points, "get_columns"):  # polars
        columns = list(points.get_columns())
    elif hasattr(points, "iloc") and getattr(points, "ndim", 0) == 2:  # pandas
        columns = [points.iloc[:, each] for each in range(points.shape[1])]
    else:
        return None
    if len(columns) not in (2, 3):
        if _is_a(points, tuple):
            raise invalid(
                f"a tuple has two or three axes, not {len(columns)}; rows are given as a list", place
            )
        raise invalid(
            f"points have two or three axes, not {len(columns)}: choose the columns, as in "
            'frame[["x", "y", "z"]]',
            place,
        )
    return [_array_of(column, place) for column in columns]


def _are_columns(points: Any) -> bool:
    """Whether this is one array or list an axis: any tuple is, but for one of numbers. Not all arrays
    have a length, nor have all lists a number of dimensions."""
    return _is_a(points, tuple) and any(
        hasattr(axis, "__len__") or getattr(axis, "ndim", 0) > 0 for axis in points
    )


def units_of(place: str) -> tuple[str, ...]:
    """In which unit the points of an argument are."""
    if place == "fence_directions":
        return NO_UNIT
    return SPEEDS if place == "preferred" or place.endswith("velocities") else METRES


def _array_of(points: Any, place: str) -> NDArray[Any]:
    points = plain(points, place, units_of(place))
    try:
        if hasattr(points, "__dlpack__") and not hasattr(points, "__array__"):
            array = np.from_dlpack(points)
        else:
            array = np.asarray(points)
    except (TypeError, ValueError, RuntimeError, BufferError) as error:
        raise invalid(f"this is no array of numbers: {error}", place) from error
    if array.dtype.kind not in "fiu" and (hint := _hint(points)):
        raise invalid(hint, place)
    check_list(points, array, place)
    return array


def _hint(points: Any) -> str | None:
    """What to give instead of what is no array."""
    if isinstance(points, (str, bytes, os.PathLike)):
        return "this is a text: points of a file are given by beespace.read"
    if hasattr(points, "times") and hasattr(points, "agents"):
        return (
            "this is a recording: all of it is for Recording.from_file; or choose fixes of one moment, "
            "as in r.positions[r.times == 10]"
        )
    if hasattr(points, "collect"):
        return "this is a query that is not answered yet: give its .collect()"
    if isinstance(points, Mapping) or getattr(getattr(points, "dtype", None), "names", None):
        return (
            "this has columns by name: give a tuple of them, as in "
            '(table["x"], table["y"], table["z"])'
        )
    if hasattr(points, "__next__"):
        return "this can be gone through only once: give a list of it"
    return None


def _numbers(array: NDArray[Any], place: str, copy: bool) -> NDArray[Any]:
    """The same as native, aligned doubles or floats; a copy only where these are not, or if asked."""
    if array.dtype in _types:
        if copy or not array.flags.aligned:
            return array.copy()
        return array
    kind = array.dtype.kind
    if kind == "f" and array.dtype.itemsize <= 8:
        # Halves, and foreign bytes.
        return array.astype(np.float32 if array.dtype.itemsize <= 4 else np.float64)
    if kind in "iu":
        check_integers(array, place)
        return array.astype(np.float64)
    raise invalid(f"coordinates are floats or integers, not {array.dtype}", place)
