"""Points out of a file."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace import _io_library
from beespace._file_columns import array_of, converted, texts_of
from beespace._file_facts import Facts
from beespace._placed_array import placed


class FilePoints(Facts):
    """The points of a file, as `read` gives them. They are points for all questions:
    ``beespace.at_risk(points, 50)``; ids of an answer are indices of `ids` and `positions`. They have
    no velocities: `notes` say where the file has some, which `read_recording` reads.

    Besides the attributes of what the file was taken for (`frame`, `notes`, ...) it has these:

    Attributes
    ----------
    positions : ndarray of float64, shape (n, 3)
        Metres; of degrees those of ECEF, whose z is not a height. Read-only, and not copied. Rows of
        it know the frame, too; what is computed of it does not.
    ids : ndarray, shape (n,)
        What the file calls each point, as str objects; rows as int64 where it has no ids.
    rows : ndarray of int64, shape (n,)
        The row of data of each point, from 0; records that were left out count.
    degrees : ndarray of float64, shape (n, 3), or None
        Longitude and latitude in degrees and the height in metres; None of points in metres.

    Examples
    --------
    >>> import beespace
    >>> bees = beespace.read("../examples/data/swarm.csv")
    >>> len(bees), bees.frame, bees.positions.shape
    (5, 'metres', (5, 3))
    """

    __slots__ = ("_handle", "_ids")

    def __init__(self, path: str, handle: ctypes.c_void_p) -> None:
        at_once = _io_library.load().at_once
        self._handle = handle
        self._ids: NDArray[Any] | None = None
        self._take(path, at_once.beespace_io_points_facts(handle))

    @property
    def _as_parameter_(self) -> ctypes.c_void_p:
        """What ctypes hands to C."""
        return self._handle

    def __len__(self) -> int:
        return int(_io_library.load().at_once.beespace_io_points_count(self._handle))

    @property
    def positions(self) -> NDArray[np.float64]:
        address = _io_library.load().at_once.beespace_io_points_xyz(self._handle)
        return placed(array_of(self._handle, address, (len(self), 3), np.float64), self.frame)

    @property
    def degrees(self) -> NDArray[np.float64] | None:
        address = _io_library.load().at_once.beespace_io_points_degrees(self._handle)
        if address is None and self.frame != "wgs84":
            return None
        return array_of(self._handle, address, (len(self), 3), np.float64)

    @property
    def rows(self) -> NDArray[np.int64]:
        address = _io_library.load().at_once.beespace_io_points_rows(self._handle)
        return array_of(self._handle, address, (len(self),), np.int64)

    @property
    def ids(self) -> NDArray[Any]:
        if self._ids is None:
            get = _io_library.load().at_once.beespace_io_points_ids
            texts = texts_of(get, self._handle, len(self))
            self._ids = self.rows if texts is None else texts
        return self._ids

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return converted(self.positions, dtype, copy)

    def __repr__(self) -> str:
        count = len(self)
        return f"<FilePoints: {count:,} {'point' if count == 1 else 'points'}{self._said()}>"
