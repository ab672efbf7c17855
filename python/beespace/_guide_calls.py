"""What all calls of a guide have in common."""

from __future__ import annotations

import ctypes
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace import _fleet_library as _c
from beespace import _library
from beespace._advice_arguments import (
    PLANAR,
    ArrayReader,
    above_zero,
    check_fences,
    check_shape,
    clearance_of,
    shape_of,
    time_above_zero,
)
from beespace._calls import length, number_of, threads_of
from beespace._errors import invalid
from beespace._fleet import FleetFigures, LinkFigures, c_figures, c_link, check_fleet, integer
from beespace._frames import Known, check_alike, frame_of
from beespace._guidance import JoinAnswer
from beespace._library import at_once
from beespace._messages import three
from beespace._obstacles import check_frame_of_obstacles, handle_of_obstacles
from beespace._ranges import zero_or_more
from beespace._turns import InTurn
from beespace._units import ACCELERATIONS, METRES, SPEEDS


class GuideCalls(InTurn):
    """The handle of a guide, for one call at a time."""

    __slots__ = ("_known", "_limits", "_obstacles", "_shape", "_shows", "_threshold")

    def __init__(
        self,
        threshold: Any,
        limits: tuple[float, float],
        figures: FleetFigures,
        link: LinkFigures,
        shape: tuple[Any, Any],
        planar: bool,
        clearance: Any,
        obstacles: Any,
        fences: tuple[Any, Any],
        intruder_horizon: Any,
        epoch: Any,
        threads: Any,
    ) -> None:
        self._threshold = length(threshold, "threshold")
        self._limits = limits
        options = _c.CGuideOptions(
            ctypes.sizeof(_c.CGuideOptions),
            PLANAR if planar else 0,
            0,
            integer(epoch, "epoch", 1, 2**32 - 1),
            threads_of(threads),
            self._threshold,
        )
        options.shape, options.vertical_factor, options.vertical_m = shape_of(*shape)
        options.figures = ctypes.pointer(c_figures(figures))
        options.link = ctypes.pointer(c_link(link))
        options.max_speed_mps, options.max_acceleration_mps2 = self._limits
        options.obstacles = handle_of_obstacles(obstacles)
        check_fences(*fences)
        read = ArrayReader(False, Known(axes=3))
        options.fence_directions = read.points(fences[0], "fence_directions")
        options.fence_offsets_m = read.numbers(
            fences[1], "fence_offsets", read.count, METRES
        )
        options.clearance_m = clearance_of(clearance, obstacles, fences[0])
        options.intruder_horizon_s = time_above_zero(intruder_horizon, "intruder_horizon")
        self._take_turns(_c.CGuide(), threaded=threads != 1)
        self._shows = False
        self._known = Known(axes=3)  # of agents, goals and intruders
        self._shape = (*shape, planar)
        self._obstacles = obstacles
        error = _library.new_error()
        code = at_once.beespace_guide_create(
            ctypes.byref(options), ctypes.byref(self._handle), ctypes.byref(error)
        )
        check_fleet(code, error)

    def _request(
        self,
        agent: int,
        position: Any,
        radius: float,
        figures: FleetFigures | None,
        max_speed: float | None,
        max_acceleration: float | None,
    ) -> _c.CJoinRequest:
        request = _c.CJoinRequest(ctypes.sizeof(_c.CJoinRequest))
        request.agent = integer(agent, "agent")
        request.position = self._place(position, "position")
        request.radius_m = zero_or_more(number_of(radius, "radius", METRES), "radius")
        if figures is not None:
            request.figures = ctypes.pointer(c_figures(figures))
        if max_speed is not None or max_acceleration is not None:
            speed, acceleration = self._limits
            request.max_speed_mps = (
                speed
                if max_speed is None
                else zero_or_more(number_of(max_speed, "max_speed", SPEEDS), "max_speed")
            )
            request.max_acceleration_mps2 = (
                acceleration
                if max_acceleration is None
                else above_zero(max_acceleration, "max_acceleration", ACCELERATIONS)
            )
        return request

    def _place(self, place: Any, what: str) -> Any:
        """A place of one agent, in the frame of all others as far as they say."""
        given = Known(frame=frame_of(place))
        check_alike(given, self._known, what, "fleet")
        if given.frame is not None:
            check_frame_of_obstacles(self._obstacles, given)
            check_shape(given, *self._shape)
        numbers = three(place, what)
        self._known.take(given)
        return numbers

    def _ask_to_join(self, function: Any, request: _c.CJoinRequest) -> JoinAnswer:
        answer = _c.CJoinAnswer(ctypes.sizeof(_c.CJoinAnswer))
        error = _library.new_error()
        with self._lock, self._showing():
            code = function(
                self._handle, ctypes.byref(request), ctypes.byref(answer), ctypes.byref(error)
            )
            check_fleet(code, error)
            return JoinAnswer(
                bool(answer.joined),
                tuple(answer.touches[: answer.touch_count]),
                tuple(answer.obstacles[: answer.obstacle_count]),
                tuple(answer.fences[: answer.fence_count]),
            )

    def _claim_of(self, agent: int) -> NDArray[np.float64]:
        first = ctypes.POINTER(ctypes.c_double)()
        count = ctypes.c_int64()
        error = _library.new_error()
        with self._lock, self._showing():
            code = at_once.beespace_guide_claim(
                self._handle, agent, ctypes.byref(first), ctypes.byref(count), ctypes.byref(error)
            )
            check_fleet(code, error)
            # Copied before another call of a thread overwrites them.
            return np.array(first[: 3 * count.value]).reshape(count.value, 3)

    @contextmanager
    def _showing(self) -> Generator[None, None, None]:
        """While an answer is read that the next call of its kind overwrites."""
        if self._shows:
            raise invalid("the handler of a signal cannot ask this while it is being answered")
        self._shows = True
        try:
            yield
        finally:
            self._shows = False

    def _tell(
        self, function: Any, *arguments: Any, places: Mapping[str, str] | None = None
    ) -> None:
        error = _library.new_error()
        with self._lock:
            code = function(self._handle, *arguments, ctypes.byref(error))
        check_fleet(code, error, places)
