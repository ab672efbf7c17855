"""A verification, as the library does it."""

from __future__ import annotations

import ctypes
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace import _library
from beespace import _verify_library as _c
from beespace._calls import check, length, number_of, run_of, seconds
from beespace._columns import Columns
from beespace._errors import invalid
from beespace._frames import Described, Known
from beespace._library import at_once, library
from beespace._obstacles import check_frame_of_obstacles, handle_of_obstacles
from beespace._points import Points
from beespace._ranges import above_zero, zero_or_more
from beespace._turns import InTurn
from beespace._units import ACCELERATIONS, METRES, SPEEDS
from beespace._verdict import Breaches, ClearanceLosses, Losses, Verdict

_kinds = np.array([at_once.beespace_violation_name(kind).decode() for kind in range(4)])
_loss, _clearance = 0, 1


class Check(InTurn):
    """The C verifier, which serves one call at a time."""

    __slots__ = ("_known", "_obstacles", "_straight", "_threads")

    def __init__(
        self,
        threshold: Any,
        max_speed: Any,
        max_acceleration: Any,
        obstacles: Any,
        clearance: Any,
        straight: bool,
        threads: Any,
    ) -> None:
        options = _c.CVerifyOptions(ctypes.sizeof(_c.CVerifyOptions))
        options.threshold_m = length(threshold, "threshold")
        if max_speed is not None:
            options.flags |= _c.MAX_SPEED
            options.max_speed_mps = zero_or_more(
                number_of(max_speed, "max_speed", SPEEDS), "max_speed", endless=True
            )
        if max_acceleration is not None:
            options.flags |= _c.MAX_ACCELERATION
            options.max_acceleration_mps2 = zero_or_more(
                number_of(max_acceleration, "max_acceleration", ACCELERATIONS),
                "max_acceleration",
                endless=True,
            )
        if straight:
            options.flags |= _c.STRAIGHT
        if straight and max_acceleration is not None:
            raise invalid("of straight lines, without velocities, no acceleration is known", "max_acceleration")
        options.obstacles = handle_of_obstacles(obstacles)
        if (clearance is None) != (obstacles is None):
            raise invalid("a clearance goes with obstacles: give both, or none", "clearance")
        if clearance is not None:
            options.clearance_m = above_zero(number_of(clearance, "clearance", METRES), "clearance")
        self._threads = threads
        self._straight = straight
        self._known = Known()  # of all moments
        self._obstacles = obstacles
        self._take_turns(_c.CVerifier(), threaded=threads != 1)
        error = _library.new_error()
        code = library.beespace_verifier_create(
            ctypes.byref(options), ctypes.byref(self._handle), ctypes.byref(error)
        )
        check(code, error)

    def _called(self) -> str:
        return "Verifier"

    def add(self, time: Any, places: Points, speeds: Points | None) -> None:
        """Takes where all agents are at a time."""
        moment = seconds(time, "time")
        if speeds is None and not self._straight:
            raise invalid("give these: only with straight=True they are not needed", "velocities")
        if speeds is not None:
            speeds.check_alike(places, "velocities", "positions")
        check_frame_of_obstacles(self._obstacles, places)
        error = _library.new_error()
        run = run_of(self._threads, places.count, moving=True)
        with self._lock:
            places.check_alike(self._known, "positions", "moments before")
            code = library.beespace_verifier_add(
                self._handle,
                moment,
                ctypes.byref(places.struct),
                None if speeds is None else ctypes.byref(speeds.struct),
                None if run is None else ctypes.byref(run),
                ctypes.byref(error),
            )
            if code == _library.OK:
                self._known.take(places)
        check(code, error)

    def add_recording(
        self, recording: ctypes.c_void_p, fixes: int, known: Described, max_gap: float
    ) -> None:
        """Takes a recording of the library."""
        check_frame_of_obstacles(self._obstacles, known)
        error = _library.new_error()
        run = run_of(self._threads, fixes, moving=True)
        with self._lock:
            code = library.beespace_verifier_add_recording(
                self._handle,
                recording,
                max_gap,
                None if run is None else ctypes.byref(run),
                ctypes.byref(error),
            )
        check(code, error)

    def skip(self) -> None:
        """What comes until the next time was not seen."""
        with self._lock:
            at_once.beespace_verifier_skip(self._handle)

    def verdict(self, names: NDArray[Any] | None) -> Verdict:
        """What was found; of agents by their names."""
        told = _c.CVerdict(ctypes.sizeof(_c.CVerdict))
        columns = Columns(at_once.beespace_violations_create)
        error = _library.new_error()
        with self._lock:
            for function, into in (
                (at_once.beespace_verifier_verdict, ctypes.byref(told)),
                (library.beespace_verifier_violations, columns.handle),
            ):
                check(function(self._handle, into, ctypes.byref(error)), error)
        return _verdict_of(told, columns, names)


def gap_of(max_gap: Any) -> float:
    """The longest step that was seen."""
    longest = np.inf if max_gap is None else seconds(max_gap, "max_gap")
    if not longest > 0:
        raise invalid("the longest gap is a time above zero", "max_gap")
    return longest


def _verdict_of(told: _c.CVerdict, columns: Columns, names: NDArray[Any] | None) -> Verdict:
    verdict = Verdict()
    verdict.holds = bool(told.holds)
    verdict.moments = told.moments
    verdict.steps, verdict.unseen, verdict.unknown = told.steps, told.unseen, ""
    verdict.loss_count, verdict.breach_count = told.losses, told.breaches
    verdict.clearance_loss_count = told.clearance_losses
    verdict.peak_speed = told.peak_speed_mps
    is_known = not np.isnan(told.peak_acceleration_mps2)
    verdict.peak_acceleration = told.peak_acceleration_mps2 if is_known else None
    verdict.closest = verdict.closest_distance = verdict.closest_begin = None
    if told.closest_first >= 0:
        two = np.array([told.closest_first, told.closest_second])
        first, second = (two if names is None else names[two]).tolist()
        verdict.closest = (first, second)
        verdict.closest_distance = told.closest_m
        verdict.closest_begin = told.closest_step_s
    _set_tables(verdict, columns, names)
    return verdict


def _set_tables(verdict: Verdict, columns: Columns, names: NDArray[Any] | None) -> None:
    size = int(at_once.beespace_violations_size(columns.handle))

    def column(name: str, code: str) -> NDArray[Any]:
        return columns.array(getattr(at_once, sys.intern(f"beespace_violations_{name}")), size, code)

    def named(agents: NDArray[np.int64]) -> NDArray[Any]:
        return agents if names is None else names[agents]

    kinds, first, second = column("kinds", "<i4"), column("first", "<i8"), column("second", "<i8")
    begin, end, value = (column(name, "<f8") for name in ("begins_s", "ends_s", "values"))
    of = kinds == _loss
    verdict.losses = Losses(named(first[of]), named(second[of]), begin[of], end[of], value[of])
    of = kinds == _clearance
    verdict.clearance_losses = ClearanceLosses(
        named(first[of]), second[of], begin[of], end[of], value[of]
    )
    of = kinds > _clearance
    verdict.breaches = Breaches(named(first[of]), _kinds[kinds[of]], begin[of], end[of], value[of])
