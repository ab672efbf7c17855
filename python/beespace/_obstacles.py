"""Static obstacles: buildings, masts, no-fly zones, the ground."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace import _library
from beespace import _verify_library as _c
from beespace._calls import number_of
from beespace._errors import BeespaceError, invalid
from beespace._frames import DEGREES, Described
from beespace._library import library
from beespace._reals import check_numbers
from beespace._tables import plural
from beespace._units import METRES, plain


class Sphere(NamedTuple):
    """A sphere.

    Attributes
    ----------
    center : array of shape (3,)
        In metres.
    radius : float
        In metres; zero or more.

    Examples
    --------
    >>> import beespace
    >>> beespace.Obstacles([beespace.Sphere((0, 0, 50), 10)])
    <beespace.Obstacles: 1 sphere>
    """

    center: ArrayLike
    radius: float


class Box(NamedTuple):
    """A box along the axes.

    Attributes
    ----------
    low, high : array of shape (3,)
        Its lowest and its highest corner, in metres.

    Examples
    --------
    >>> import beespace
    >>> beespace.Obstacles([beespace.Box(low=(0, 0, 0), high=(20, 30, 15))])
    <beespace.Obstacles: 1 box>
    """

    low: ArrayLike
    high: ArrayLike


class Ground(NamedTuple):
    """All space below a height.

    Attributes
    ----------
    height : float
        In metres.

    Examples
    --------
    >>> import beespace
    >>> beespace.Obstacles([beespace.Ground(height=0)])
    <beespace.Obstacles: 1 ground>
    """

    height: float


class Cylinder(NamedTuple):
    """A cylinder whose axis is vertical.

    Attributes
    ----------
    x, y : float
        Its axis, in metres.
    radius : float
        In metres; zero or more.
    low, high : float, optional
        From which height to which it goes, in metres; None: without an end there.

    Examples
    --------
    >>> import beespace
    >>> beespace.Obstacles([beespace.Cylinder(x=5, y=5, radius=1, high=40)])
    <beespace.Obstacles: 1 cylinder>
    """

    x: float
    y: float
    radius: float
    low: float | None = None
    high: float | None = None


class Prism(NamedTuple):
    """A prism whose edges are vertical: what its outline encloses.

    Attributes
    ----------
    outline : array of shape (n, 2)
        Corner after corner, either way round, in metres. It must not cross or touch itself.
    low, high : float, optional
        From which height to which it goes, in metres; None: without an end there.

    Examples
    --------
    >>> import beespace
    >>> beespace.Obstacles([beespace.Prism([(0, 0), (40, 0), (0, 30)], high=25)])
    <beespace.Obstacles: 1 prism>
    """

    outline: ArrayLike
    low: float | None = None
    high: float | None = None


Obstacle = Sphere | Box | Ground | Cylinder | Prism


class Obstacles:
    """Static obstacles, checked and ordered in space. Any number of threads may use them at once.

    Parameters
    ----------
    obstacles : sequence of Sphere, Box, Ground, Cylinder and Prism
        In metres, in the frame of the positions that they are compared with, in which z is up.

    Raises
    ------
    BeespaceError
        With the index as `record`: an obstacle that is none (a radius below zero, a box or heights
        upside down, an outline that crosses itself or encloses nothing), a number that is none.

    Examples
    --------
    >>> import beespace
    >>> masts = [beespace.Cylinder(x, 0, 0.5, high=60) for x in (0, 100, 200)]
    >>> obstacles = beespace.Obstacles([*masts, beespace.Ground(0)])
    >>> obstacles
    <beespace.Obstacles: 1 ground, 3 cylinders>
    >>> len(obstacles), obstacles[1].x
    (4, 100)
    """

    __slots__ = ("_all", "_handle")

    def __init__(self, obstacles: Sequence[Obstacle]) -> None:
        try:
            self._all = tuple(obstacles)
        except TypeError:
            raise invalid(f"these are obstacles in a list, and not {obstacles!r}", "obstacles") from None
        structs, keep = structs_of(self._all)
        self._handle = _c.CObstacles()
        error = _library.new_error()
        code = library.beespace_obstacles_create(
            structs, len(self._all), ctypes.byref(self._handle), ctypes.byref(error)
        )
        del keep
        if code != _library.OK:
            _library.raise_error(error)

    def __len__(self) -> int:
        return len(self._all)

    def __getitem__(self, index: int) -> Obstacle:
        return self._all[index]

    def __repr__(self) -> str:
        kinds = [type(each) for each in self._all]
        told = [
            plural(kinds.count(kind), name) if name != "box" or kinds.count(kind) == 1
            else f"{kinds.count(kind):,} boxes"
            for kind, name in _names.items()
            if kind in kinds
        ]
        return f"<beespace.Obstacles: {', '.join(told) or 'none'}>"

    @property
    def handle(self) -> ctypes.c_void_p:
        """For the package's own use."""
        return self._handle


def structs_of(
    obstacles: Sequence[Obstacle],
) -> tuple[ctypes.Array[_c.CObstacle], list[NDArray[np.float64] | None]]:
    """As structures of C, and what must stay alive as long as these."""
    structs = (_c.CObstacle * len(obstacles))()
    keep = [_fill(structs[i], obstacle, i) for i, obstacle in enumerate(obstacles)]
    return structs, keep


def handle_of_obstacles(obstacles: Any) -> ctypes.c_void_p | None:
    """What an option of C that takes obstacles holds; None of None."""
    if obstacles is None:
        return None
    if not isinstance(obstacles, Obstacles):
        raise invalid("these are Obstacles, made of what stands in the way", "obstacles")
    return obstacles.handle


def check_frame_of_obstacles(obstacles: Obstacles | None, positions: Described) -> None:
    """Refuses obstacles that stand upright, beside positions whose z is not a height."""
    if obstacles is None or positions.frame != DEGREES:
        return
    for index in range(len(obstacles)):
        if isinstance(obstacles[index], _UPRIGHT):
            raise BeespaceError(
                "the positions were longitudes and latitudes, of which z is not a height, and this "
                "stands upright: of such positions only spheres and boxes of the same frame count",
                "invalid_argument",
                "obstacles",
                index,
            )


_UPRIGHT = (Ground, Cylinder, Prism)

_names: dict[type, str] = {
    Sphere: "sphere",
    Box: "box",
    Ground: "ground",
    Cylinder: "cylinder",
    Prism: "prism",
}


def _fill(struct: _c.CObstacle, obstacle: Any, index: int) -> NDArray[np.float64] | None:
    """Writes the C structure; what must stay alive as long as it."""
    struct.struct_size = ctypes.sizeof(_c.CObstacle)
    try:
        return _fill_fields(struct, obstacle)
    except (TypeError, ValueError) as error:
        raise BeespaceError(str(error), "invalid_argument", "obstacles", index) from None


def _fill_fields(struct: _c.CObstacle, obstacle: Any) -> NDArray[np.float64] | None:
    if isinstance(obstacle, Sphere):
        struct.kind = _c.SPHERE
        struct.center = _corner(obstacle.center)
        struct.radius_m = number_of(obstacle.radius, "radius", METRES)
    elif isinstance(obstacle, Box):
        struct.kind = _c.BOX
        struct.low, struct.high = _corner(obstacle.low), _corner(obstacle.high)
    elif isinstance(obstacle, Ground):
        struct.kind = _c.GROUND
        struct.high[2] = number_of(obstacle.height, "height", METRES)
    elif isinstance(obstacle, Cylinder):
        struct.kind = _c.CYLINDER
        struct.center[0] = number_of(obstacle.x, "x", METRES)
        struct.center[1] = number_of(obstacle.y, "y", METRES)
        struct.radius_m = number_of(obstacle.radius, "radius", METRES)
        _set_heights(struct, obstacle.low, obstacle.high)
    elif isinstance(obstacle, Prism):
        struct.kind = _c.PRISM
        _set_heights(struct, obstacle.low, obstacle.high)
        outline = np.ascontiguousarray(_numbers(obstacle.outline, "outline"))
        if outline.ndim != 2 or outline.shape[1] != 2:
            raise invalid(f"an outline has the shape (n, 2), not {outline.shape}")
        struct.outline = outline.__array_interface__["data"][0]
        struct.corners = len(outline)
        return outline
    else:
        raise invalid(f"an obstacle is a Sphere, Box, Ground, Cylinder or Prism, not {obstacle!r}")
    return None


def _numbers(given: ArrayLike, place: str) -> NDArray[np.float64]:
    bare = plain(given, place, METRES)
    numbers = np.asarray(bare)
    check_numbers(bare, numbers, place)
    return numbers.astype(np.float64)


def _corner(point: ArrayLike) -> tuple[float, float, float]:
    numbers = _numbers(point, "point")
    if numbers.shape != (3,):
        raise invalid(f"a point has three coordinates, not the shape {numbers.shape}")
    x, y, z = numbers.tolist()
    return x, y, z


def _set_heights(struct: _c.CObstacle, low: float | None, high: float | None) -> None:
    if low is not None:
        struct.flags |= _c.LOWEST
        struct.low[2] = number_of(low, "low", METRES)
    if high is not None:
        struct.flags |= _c.HIGHEST
        struct.high[2] = number_of(high, "high", METRES)
