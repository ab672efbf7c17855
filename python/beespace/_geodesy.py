"""From degrees to metres."""

from __future__ import annotations

import ctypes
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace import _frames, _library
from beespace._calls import check, number_of
from beespace._errors import invalid
from beespace._library import library
from beespace._placed_array import placed
from beespace._points import Points, PointsLike
from beespace._reals import check_numbers
from beespace._units import DEGREES, METRES, plain


@overload
def to_ecef(lon: ArrayLike, lat: ArrayLike, height: ArrayLike) -> NDArray[np.float64]: ...
@overload
def to_ecef(
    lon: ArrayLike, lat: ArrayLike, height: ArrayLike, velocities: PointsLike
) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...


def to_ecef(
    lon: ArrayLike, lat: ArrayLike, height: ArrayLike, velocities: PointsLike | None = None
) -> NDArray[np.float64] | tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Converts WGS84 positions to metres in an Earth-centred, Earth-fixed frame (ECEF).

    x points towards 0 N 0 E, y towards 0 N 90 E, z towards the north pole; straight-line distances
    are those of space, not along the ground. Every machine returns the same bits, which differ from
    exact arithmetic by less than 1e-8 m. Some nanoseconds a position.

    Parameters
    ----------
    lon : array of shape (n,), or one number
        Longitudes in degrees, -360 to 360, east positive.
    lat : array of shape (n,), or one number
        Latitudes in degrees, -90 to 90, north positive.
    height : array of shape (n,), or one number
        Heights above the ellipsoid in metres, -12,000 to 1,000,000. One number serves for all.
    velocities : array of shape (n, 3) or (n, 2), tuple of arrays, or data frame, optional
        Velocities towards the east, the north and upwards, in metres per second.

    Returns
    -------
    ndarray of float64, shape (n, 3)
        Coordinates in metres; of shape (3,) where all three are single numbers. They know that their
        z is no height, which `vertical=` asks; what is computed of them does not. With velocities a
        tuple: coordinates, and velocities along the same axes, in metres per second.

    Examples
    --------
    >>> import beespace
    >>> beespace.to_ecef(0, 0, 100)
    array([6378237.,       0.,       0.])
    >>> beespace.pairs(beespace.to_ecef([13.4, 13.401], [52.5, 52.5], 120), 100).distance.round(2)
    array([67.91])
    >>> beespace.to_ecef([90], [0], [0], velocities=[[8, 0, 3]])[1].round(9) + 0
    array([[-8.,  3.,  0.]])
    """
    given = {
        "lon": plain(lon, "lon", DEGREES),
        "lat": plain(lat, "lat", DEGREES),
        "height": plain(height, "height", METRES),
    }
    counts = {name: _length(value, name) for name, value in given.items()}
    lengths = {length for length in counts.values() if length is not None}
    if len(lengths) > 1:
        told = ", ".join(f"{length} of {name}" for name, length in counts.items())
        raise invalid(f"the arrays differ in length: {told}")
    count = lengths.pop() if lengths else 1
    # As the axes of points, of which a stride of 0 repeats what there is one of.
    axes = tuple(
        np.broadcast_to(np.float64(number_of(value, name, None)), (count,))
        if counts[name] is None
        else _array_of(value, name)
        for name, value in given.items()
    )
    points = Points(axes, "positions")
    one = all(length is None for length in counts.values())

    def converted(function: Any, *arguments: Any) -> NDArray[np.float64]:
        xyz = np.empty((count, 3))
        error = _library.new_error()
        code = function(
            ctypes.byref(points.struct), *arguments, xyz.ctypes.data, ctypes.byref(error)
        )
        if code != _library.OK and error.record >= 0 and error.place == b"positions":
            error.place = _place_of(axes, error.record).encode()
        check(code, error)
        return xyz[0] if one else xyz

    xyz = placed(converted(library.beespace_to_ecef), _frames.DEGREES)
    if velocities is None:
        return xyz
    speeds = Points([velocities] if one else velocities, "velocities")
    return xyz, converted(library.beespace_to_ecef_velocity, ctypes.byref(speeds.struct))


def _place_of(axes: tuple[Any, ...], record: int) -> str:
    """Which of the three the error of a record is about: the first that cannot be."""
    lon, lat, height = (float(axis[record]) for axis in axes)
    if not np.isfinite([lon, lat, height]).all():
        return ("lon", "lat", "height")[int(np.isfinite([lon, lat, height]).argmin())]
    if abs(lat) > 90:
        return "lat"
    return "lon" if abs(lon) > 360 else "height"


def _array_of(value: Any, place: str) -> NDArray[Any]:
    array = np.asarray(value)
    check_numbers(value, array, place)
    return array


def _length(value: Any, place: str) -> int | None:
    """How many numbers there are; None of a single one."""
    dimensions = value.ndim if hasattr(value, "ndim") else np.ndim(value)
    if dimensions == 0:
        return None
    if dimensions != 1:
        raise invalid(f"this is an array of one dimension, not of {dimensions}", place)
    return len(value)
