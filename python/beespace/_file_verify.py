"""Recordings of files, verified along their curves."""

from __future__ import annotations

import ctypes
import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from beespace import _io_library
from beespace._calls import length, number_of, run_of
from beespace._checks import gap_of
from beespace._coverage import Coverage
from beespace._errors import BeespaceError, invalid
from beespace._file_columns import array_of
from beespace._flight_verdict import FlightBreaches, FlightLosses, FlightVerdict, Peak
from beespace._obstacles import Obstacles, structs_of
from beespace._ranges import above_zero, zero_or_more
from beespace._units import ACCELERATIONS, METRES, SPEEDS
from beespace._verdict import ClearanceLosses

if TYPE_CHECKING:
    from beespace._file_recording import FileRecording

# In the order of C, with what each is measured in.
LIMITS: dict[str, tuple[str, ...]] = {
    "max_speed": SPEEDS,
    "max_horizontal": SPEEDS,
    "max_climb": SPEEDS,
    "max_descent": SPEEDS,
    "max_acceleration": ACCELERATIONS,
    "max_height": METRES,
}
_MOTIONS = ("show", "velocities", "straight")


def verify_recording(
    recording: FileRecording,
    threshold: Any,
    limits: dict[str, Any],
    obstacles: Any,
    clearance: Any,
    max_gap: Any,
    straight: bool,
    skip_limits: Any,
    ignore_below: Any,
    threads: Any,
) -> FlightVerdict:
    """As `FileRecording.verify`; `limits` by the names of its arguments."""
    options = _io_library.CVerifyOptions(ctypes.sizeof(_io_library.CVerifyOptions))
    if threshold is not None:
        options.threshold_m = length(threshold, "threshold")
        if not options.threshold_m > 0:
            raise BeespaceError("a threshold is above zero", "invalid_threshold", "threshold")
    if straight:
        options.flags |= _io_library.STRAIGHT
    for index, (name, units) in enumerate(LIMITS.items()):
        if limits.get(name) is None:
            continue
        options.limits |= 1 << index
        options.most[index] = zero_or_more(number_of(limits[name], name, units), name, endless=True)
    options.max_gap_s = 0.0 if max_gap is None else gap_of(max_gap)
    skipped = _names_of(skip_limits)
    options.skipped_limits = ",".join(skipped).encode() if skipped else None
    if ignore_below is not None:
        options.ignore_below_m = above_zero(length(ignore_below, "ignore_below"), "ignore_below")
    keep = _set_obstacles(options, obstacles, clearance)
    run = run_of(threads, len(recording), moving=True)
    if run is not None:
        options.run = ctypes.pointer(run)
    io = _io_library.load()
    handle = io.handles["verdict"]()
    error = _io_library.new_error()
    code = io.unlocked.beespace_io_verify(
        recording.handle, ctypes.byref(options), ctypes.byref(handle), ctypes.byref(error)
    )
    del keep
    _io_library.check(code, error)
    verdict = _verdict_of(handle, recording.ids)
    verdict.undecided = tuple(name for name in verdict.not_looked_at if name not in skipped)
    return verdict


def _names_of(skip_limits: Any) -> list[str]:
    names = [skip_limits] if isinstance(skip_limits, str) else list(skip_limits)
    for name in names:
        if not isinstance(name, str) or not name or "," in name or "\0" in name:
            raise invalid("these are names of limits: ['minNavAltitude']", "skip_limits")
    return names


def _set_obstacles(options: _io_library.CVerifyOptions, obstacles: Any, clearance: Any) -> Any:
    """What must stay alive as long as the options."""
    if (clearance is None) != (obstacles is None):
        raise invalid("a clearance goes with obstacles: give both, or none", "clearance")
    if obstacles is None:
        return None
    if not isinstance(obstacles, Obstacles):
        raise invalid("these are Obstacles, made of what stands in the way", "obstacles")
    options.clearance_m = above_zero(number_of(clearance, "clearance", METRES), "clearance")
    structs, keep = structs_of([obstacles[index] for index in range(len(obstacles))])
    options.obstacles = ctypes.addressof(structs)
    options.obstacle_count = len(obstacles)
    return structs, keep


def _verdict_of(handle: ctypes.c_void_p, ids: NDArray[Any]) -> FlightVerdict:
    at_once = _io_library.load().at_once
    facts = _io_library.CVerdictFacts(ctypes.sizeof(_io_library.CVerdictFacts))
    error = _io_library.new_error()
    code = at_once.beespace_io_verdict_facts_of(
        handle, ctypes.byref(facts), ctypes.byref(error)
    )
    _io_library.check(code, error)
    names = [at_once.beespace_io_finding_name(k).decode() for k in range(_io_library.LIMITS)]
    verdict = FlightVerdict()
    verdict.holds = bool(facts.holds)
    verdict.motion = _MOTIONS[facts.motion]
    verdict.threshold = facts.threshold_m
    verdict.limits = {name: facts.most[k] for k, name in enumerate(names) if facts.limits >> k & 1}
    verdict.declared = tuple(name for k, name in enumerate(names) if facts.declared >> k & 1)
    verdict.greatest = {
        name: Peak(facts.greatest[k], str(ids[facts.greatest_agent[k]]), facts.greatest_s[k])
        for k, name in enumerate(names)
        if facts.greatest_agent[k] >= 0
    }
    verdict.closest = verdict.closest_distance = verdict.closest_at = None
    if facts.closest_first >= 0:
        verdict.closest = str(ids[facts.closest_first]), str(ids[facts.closest_second])
        verdict.closest_distance, verdict.closest_at = facts.closest_m, facts.closest_s
    names_left = at_once.beespace_io_verdict_not_looked_at(handle).decode()
    verdict.not_looked_at = tuple(names_left.split(",")) if names_left else ()
    verdict.gap_count, verdict.missing_count = facts.gaps, facts.missing
    verdict.ignored_count = facts.ignored
    verdict.takeoff_unknown_count = facts.takeoff_unknown
    verdict.coverage = Coverage(at_once.beespace_io_verdict_coverage, handle)
    limits = [*facts.most, math.nan, math.nan]
    _set_tables(verdict, handle, ids, np.array(names), np.array(limits))
    return verdict


def _set_tables(
    verdict: FlightVerdict,
    handle: ctypes.c_void_p,
    ids: NDArray[Any],
    names: NDArray[np.str_],
    limits: NDArray[np.float64],
) -> None:
    at_once = _io_library.load().at_once
    size = int(at_once.beespace_io_verdict_size(handle))

    def column(name: str, dtype: Any) -> NDArray[Any]:
        get = getattr(at_once, f"beespace_io_verdict_{name}")
        return array_of(handle, get(handle), (size,), dtype)

    kinds = column("kinds", np.int32)
    first, second = column("first", np.int64), column("second", np.int64)
    begin, end = column("begins_s", np.float64), column("ends_s", np.float64)
    value, at = column("values", np.float64), column("at_s", np.float64)
    of = kinds == _io_library.LOSS
    verdict.losses = FlightLosses(
        ids[first[of]], ids[second[of]], begin[of], end[of], value[of], at[of]
    )
    of = kinds == _io_library.CLEARANCE
    verdict.clearance_losses = ClearanceLosses(
        ids[first[of]], second[of], begin[of], end[of], value[of]
    )
    of = kinds < _io_library.LIMITS
    verdict.breaches = FlightBreaches(
        ids[first[of]], names[kinds[of]], begin[of], end[of], value[of], limits[kinds[of]], at[of]
    )
