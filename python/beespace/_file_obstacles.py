"""Obstacles out of files."""

from __future__ import annotations

import ctypes

import numpy as np

from beespace import _io_library
from beespace import _verify_library as _c
from beespace._files import PathLike, encoded_path
from beespace._obstacles import Box, Cylinder, Ground, Obstacle, Obstacles, Prism, Sphere


def read_obstacles(path: PathLike) -> Obstacles:
    """Reads obstacles from a file: JSON, as the command takes it with --obstacles; plain or
    gzip-compressed.

    Parameters
    ----------
    path : str or path
        The file. "-" is a file of that name; standard input is "/dev/stdin".

    Returns
    -------
    Obstacles
        In metres, z up.

    Raises
    ------
    BeespaceFileError, BeespaceOSError, ImportError
        As `read`; what is no obstacle is named.

    Examples
    --------
    >>> import beespace
    >>> city = beespace.read_obstacles("../examples/data/city.json")
    >>> city
    <beespace.Obstacles: 2 boxes, 1 ground, 1 cylinder>
    """
    error = _io_library.new_error()
    io = _io_library.load()
    handle = io.handles["obstacles"]()
    code = io.unlocked.beespace_io_read_obstacles(
        encoded_path(path), ctypes.byref(handle), ctypes.byref(error)
    )
    _io_library.check(code, error)
    count = int(io.at_once.beespace_io_obstacles_count(handle))
    if not count:
        return Obstacles([])
    address = io.at_once.beespace_io_obstacles_list(handle)
    structs = (_c.CObstacle * count).from_address(address)
    return Obstacles([_obstacle_of(each) for each in structs])


def _obstacle_of(struct: _c.CObstacle) -> Obstacle:
    low, high = tuple(struct.low), tuple(struct.high)
    if struct.kind == _c.SPHERE:
        return Sphere(tuple(struct.center), struct.radius_m)
    if struct.kind == _c.BOX:
        return Box(low, high)
    if struct.kind == _c.GROUND:
        return Ground(high[2])
    lowest = low[2] if struct.flags & _c.LOWEST else None
    highest = high[2] if struct.flags & _c.HIGHEST else None
    if struct.kind == _c.CYLINDER:
        x, y = struct.center[:2]
        return Cylinder(x, y, struct.radius_m, lowest, highest)
    numbers = ctypes.c_double * (2 * struct.corners)
    outline = np.array(numbers.from_address(struct.outline)).reshape(-1, 2)
    return Prism(outline, lowest, highest)
