"""What is said of agents and of the space around them, as advice and guides take it."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace import _advice_library as _c
from beespace import _ranges
from beespace._calls import number_of
from beespace._errors import invalid
from beespace._fixes import flags_of, integers_of, numbers_of
from beespace._frames import Described, Known, check_upright
from beespace._points import Points
from beespace._ranges import zero_or_more
from beespace._units import ACCELERATIONS, METRES, NO_UNIT, SECONDS, SPEEDS
PLANAR = _c.PLANAR


class Limits:
    """The C structure of what agents can do, and what must stay alive as long as it."""

    __slots__ = ("keep", "struct")

    def __init__(
        self,
        max_speed: ArrayLike,
        max_acceleration: ArrayLike | None,
        count: int,
        each: bool = False,
    ) -> None:
        """`each`: whether one agent whose limits cannot be is an error of the call."""
        speeds = _for_each(max_speed, "max_speed", count, SPEEDS)
        if each or speeds.ndim == 0:
            _ranges.check_each(speeds, "max_speed", zero_or_more)
        self.struct = _c.CLimits(ctypes.sizeof(_c.CLimits))
        self.struct.max_speeds_mps, self.struct.max_speeds_stride = _address(speeds)
        self.keep: object = speeds
        if max_acceleration is not None:
            accelerations = _for_each(
                max_acceleration, "max_acceleration", count, ACCELERATIONS
            )
            if each or accelerations.ndim == 0:
                _ranges.check_each(accelerations, "max_acceleration", _ranges.above_zero, True)
            self.struct.max_accelerations_mps2, self.struct.max_accelerations_stride = _address(
                accelerations
            )
            self.keep = (speeds, accelerations)


def shape_of(vertical: Any, vertical_factor: Any) -> tuple[int, float, float]:
    """What stays free around an agent: the shape, its factor, half of its height."""
    if vertical is not None and vertical_factor is not None:
        raise invalid("what stays free is a cylinder or an ellipsoid: leave one out", "vertical")
    if vertical is not None:
        return _c.FREE_CYLINDER, 0.0, above_zero(vertical, "vertical", METRES)
    if vertical_factor is not None:
        return _c.FREE_ELLIPSOID, above_zero(vertical_factor, "vertical_factor", NO_UNIT), 0.0
    return _c.FREE_SPHERE, 0.0, 0.0


def check_shape(given: Described, vertical: Any, vertical_factor: Any, planar: bool) -> None:
    """Refuses what stays free upright around an agent, or in a plane, of positions without heights."""
    check_upright(given, vertical, "vertical")
    check_upright(given, vertical_factor, "vertical_factor")
    check_upright(given, planar, "planar")


def above_zero(number: Any, place: str, units: tuple[str, ...]) -> float:
    """A number that must not be zero, which stands for a default in C."""
    return _ranges.above_zero(number_of(number, place, units), place)


def time_above_zero(number: Any, place: str) -> float:
    return _ranges.time_above_zero(number_of(number, place, SECONDS), place)


def check_fences(directions: Any, offsets: Any) -> None:
    """Refuses one without the other."""
    if (directions is None) != (offsets is None):
        missing = "fence_directions" if directions is None else "fence_offsets"
        raise invalid("a fence has a direction and an offset: give both", missing)


def clearance_of(clearance: Any, obstacles: Any, fences: Any) -> float:
    """How far to stay from obstacles and fences; 0 stands for none where there are neither."""
    if clearance is not None:
        return above_zero(clearance, "clearance", METRES)
    for what, given in (("obstacles", obstacles), ("fences", fences)):
        if given is not None:
            raise invalid(
                f"there are {what}: say in metres how close to them is too close", "clearance"
            )
    return 0.0


class ArrayReader:
    """Reads arrays of options, and keeps them alive as long as itself. Positions among them have as
    many axes as those of agents, and are in their frame."""

    __slots__ = ("_copy", "_kept", "count", "known")

    def __init__(self, copy: bool, like: Described) -> None:
        self._kept: list[object] = []
        self._copy = copy
        self.known = Known(like.axes, like.frame)  # of all positions
        self.count = 0

    def points(self, given: Any, place: str) -> Any:
        self.count = 0
        if given is None:
            return None
        points = Points(given, place, self._copy)
        points.check_alike(self.known, place, "positions")
        self.known.take(points)
        self.count = points.count
        self._kept.append(points)
        return ctypes.pointer(points.struct)

    def numbers(
        self, given: Any, place: str, count: int, units: tuple[str, ...], check: Any = None
    ) -> int | None:
        if given is None:
            return None
        numbers = numbers_of(given, count, place, units)
        if check is not None:
            _ranges.check_each(numbers, place, check)
        return self._kept_at(numbers)

    def integers(self, given: Any, place: str, count: int) -> int | None:
        return None if given is None else self._kept_at(integers_of(given, count, place))

    def flags(self, given: Any, place: str, count: int) -> int | None:
        return None if given is None else self._kept_at(flags_of(given, count, place))

    def _kept_at(self, array: NDArray[Any]) -> int:
        kept = array.copy() if self._copy else array
        self._kept.append(kept)
        return address_of(kept)


def address_of(array: NDArray[Any]) -> int:
    """Where its numbers begin."""
    return int(array.__array_interface__["data"][0])


def _for_each(
    given: Any, place: str, count: int, units: tuple[str, ...]
) -> NDArray[np.float64]:
    is_one = not hasattr(given, "__len__") or getattr(given, "ndim", 1) == 0
    if is_one:
        return np.array(number_of(given, place, units))
    return numbers_of(given, count, place, units)


def _address(array: NDArray[np.float64]) -> tuple[int, int]:
    return address_of(array), 0 if array.ndim == 0 else array.itemsize
