"""libbeespace_io.so, as its header <beespace_io.h> declares it: loaded by the first call that needs it,
as not each installation has it.
"""

from __future__ import annotations

import ctypes
import errno
import functools
import os
from ctypes import POINTER, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32
from ctypes import c_uint64, c_void_p
from pathlib import Path
from typing import Any, NamedTuple

from beespace import _library
from beespace._calls import after_ctrl_c
from beespace._errors import BeespaceFileError, BeespaceOSError

SKIP_BAD = 1
GROUNDED = 2
ANY_LIKELIHOOD = 4
ONE_CLOCK = 8
STRAIGHT = 1
ALONG_LINES = 2
# Findings beside those of limits, whose numbers are those of the options.
LIMITS = 6
LOSS = 6
CLEARANCE = 7
# How it is known how fast an agent flies.
STALE = 1
ESTIMATED = 3
STATED = 4


class CFileError(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("code", c_int32),
        ("reserved", c_int32),
        ("record", c_int64),
        ("line", c_int64),
        ("column", c_int64),
        ("place", c_char * 32),
        ("file", c_char * 1024),
        ("message", c_char * 1024),
    ]


class COptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("threads", c_uint32),
        ("reserved", c_uint64),
        ("frame", c_char_p),
        ("columns", c_char_p),
        ("units", c_char_p),
        ("heights", c_char_p),
        ("format", c_char_p),
        ("time_unit", c_char_p),
        ("time_zone", c_char_p),
        ("scale", c_char_p),
        ("fps", c_double),
        ("dates", c_char_p),
        ("least_likelihood", c_double),
        ("tolerance_m", c_double),
    ]


class CCoverage(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("complete", c_int32),
        ("may_hide", c_int32),
        ("max_gap_s", c_double),
        ("typical_interval_s", c_double),
        ("gaps", c_int64),
        ("agents_with_gaps", c_int64),
        ("in_gaps_s", c_double),
        ("agents_partly", c_int64),
        ("agents_cut_off", c_int64),
        ("outside_s", c_double),
        ("missing", c_int64),
        ("missing_without_id", c_int64),
        ("missing_agents", c_int64),
        ("nowhere", c_int64),
        ("shared_ids", c_int64),
        ("files", c_int64),
        ("jumping", c_int64),
        ("swapped", c_int64),
        ("agents_unplaced", c_int64),
        ("untimed", c_int64),
        ("rough", c_int64),
        ("agents_on_ground", c_int64),
        ("agents_alone", c_int64),
    ]


class CConflictOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("limited", c_uint32),
        ("reserved", c_uint64),
        ("threshold_m", c_double),
        ("max_gap_s", c_double),
        ("vertical", c_char_p),
        ("max_results", c_uint64),
        ("run", POINTER(_library.CRun)),
        ("ignore_below_m", c_double),
    ]


class CConflictFacts(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("risky", c_int32),
        ("compared", c_int32),
        ("velocities", c_int32),
        ("too_far", c_int32),
        ("most_off_m", c_double),
        ("threshold_m", c_double),
        ("with_standing", c_int64),
        ("possible", c_int64),
        ("closest_first", c_int64),
        ("closest_second", c_int64),
        ("closest_m", c_double),
        ("closest_s", c_double),
        ("ignored", c_int64),
        ("takeoff_unknown", c_int64),
    ]


class CPageOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("threads", c_uint32),
        ("reserved", c_uint64),
        ("threshold_m", c_double),
        ("max_gap_s", c_double),
        ("vertical", c_char_p),
        ("title", c_char_p),
        ("run", POINTER(_library.CRun)),
        ("ignore_below_m", c_double),
    ]


class CVerifyOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("limits", c_uint32),
        ("reserved", c_uint64),
        ("most", c_double * LIMITS),
        ("threshold_m", c_double),
        ("max_gap_s", c_double),
        ("obstacles", c_void_p),
        ("obstacle_count", c_int64),
        ("clearance_m", c_double),
        ("run", POINTER(_library.CRun)),
        ("skipped_limits", c_char_p),
        ("ignore_below_m", c_double),
    ]


class CVerdictFacts(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("holds", c_int32),
        ("motion", c_int32),
        ("limits", c_uint32),
        ("declared", c_uint32),
        ("most", c_double * LIMITS),
        ("greatest", c_double * LIMITS),
        ("greatest_s", c_double * LIMITS),
        ("greatest_agent", c_int64 * LIMITS),
        ("threshold_m", c_double),
        ("max_gap_s", c_double),
        ("losses", c_int64),
        ("clearance_losses", c_int64),
        ("breaches", c_int64),
        ("gaps", c_int64),
        ("missing", c_int64),
        ("closest_first", c_int64),
        ("closest_second", c_int64),
        ("closest_m", c_double),
        ("closest_s", c_double),
        ("ignored", c_int64),
        ("takeoff_unknown", c_int64),
    ]


_options, _error = POINTER(COptions), POINTER(CFileError)
_coverage = POINTER(CCoverage)
_page_tail = [POINTER(CPageOptions), c_void_p, _error]
_signatures: dict[str, tuple[object, list[object]]] = {
    "error_text": (c_size_t, [_error, c_char_p, c_size_t]),
    "facts_frame": (c_char_p, [c_void_p]),
    "facts_frame_reason": (c_char_p, [c_void_p]),
    "facts_format": (c_char_p, [c_void_p]),
    "facts_heights": (c_char_p, [c_void_p]),
    "facts_note_count": (c_int64, [c_void_p]),
    "facts_note": (c_char_p, [c_void_p, c_int64]),
    "facts_skipped": (c_int64, [c_void_p]),
    "facts_skipped_error": (c_int32, [c_void_p, c_int64, _error]),
    "read_points": (c_int32, [c_char_p, _options, c_void_p, _error]),
    "points_count": (c_int64, [c_void_p]),
    "points_xyz": (c_void_p, [c_void_p]),
    "points_degrees": (c_void_p, [c_void_p]),
    "points_rows": (c_void_p, [c_void_p]),
    "points_ids": (c_void_p, [c_void_p, c_void_p]),
    "points_facts": (c_void_p, [c_void_p]),
    "read_recording": (c_int32, [c_void_p, c_int64, _options, c_void_p, _error]),
    "recording_agents": (c_int64, [c_void_p]),
    "recording_fixes": (c_int64, [c_void_p]),
    "recording_offsets": (c_void_p, [c_void_p]),
    "recording_agent": (c_void_p, [c_void_p]),
    "recording_times_s": (c_void_p, [c_void_p]),
    "recording_xyz": (c_void_p, [c_void_p]),
    "recording_velocities": (c_void_p, [c_void_p]),
    "recording_degrees": (c_void_p, [c_void_p]),
    "recording_ids": (c_void_p, [c_void_p, c_void_p]),
    "recording_label": (c_char_p, [c_void_p, c_int64]),
    "recording_since_1970": (c_int32, [c_void_p]),
    "recording_missing": (c_int64, [c_void_p]),
    "recording_movers": (
        c_int32,
        [c_void_p, c_double, c_void_p, c_void_p, c_void_p, POINTER(c_double), _error],
    ),
    "recording_facts": (c_void_p, [c_void_p]),
    "recording_is_show": (c_int32, [c_void_p]),
    "recording_coverage": (c_int32, [c_void_p, c_double, _coverage, _error]),
    "coverage_text": (c_size_t, [_coverage, c_char_p, c_size_t]),
    "find_conflicts": (c_int32, [c_void_p, POINTER(CConflictOptions), c_void_p, _error]),
    "conflicts_facts_of": (c_int32, [c_void_p, POINTER(CConflictFacts), _error]),
    "conflicts_coverage": (c_int32, [c_void_p, _coverage, _error]),
    "conflicts_size": (c_int64, [c_void_p]),
    "conflicts_gaps": (c_int64, [c_void_p]),
    **{
        f"conflicts_{name}": (c_void_p, [c_void_p])
        for name in (
            "first", "second", "begins_s", "ends_s", "closest_s", "closest_m", "certain",
            "gap_agent", "gap_begins_s", "gap_ends_s",
        )
    },
    "read_obstacles": (c_int32, [c_char_p, c_void_p, _error]),
    "obstacles_count": (c_int64, [c_void_p]),
    "obstacles_list": (c_void_p, [c_void_p]),
    "verify": (c_int32, [c_void_p, POINTER(CVerifyOptions), c_void_p, _error]),
    "verdict_facts_of": (c_int32, [c_void_p, POINTER(CVerdictFacts), _error]),
    "verdict_coverage": (c_int32, [c_void_p, _coverage, _error]),
    "verdict_not_looked_at": (c_char_p, [c_void_p]),
    "verdict_size": (c_int64, [c_void_p]),
    **{
        f"verdict_{name}": (c_void_p, [c_void_p])
        for name in ("kinds", "first", "second", "begins_s", "ends_s", "values", "at_s")
    },
    "finding_name": (c_char_p, [c_int32]),
    "page_of_files": (c_int32, [c_void_p, c_int64, _options, *_page_tail]),
    "page_of_read": (c_int32, [c_void_p, *_page_tail]),
    "page_of_points": (c_int32, [POINTER(_library.CPoints), c_void_p, *_page_tail]),
    "page_html": (c_void_p, [c_void_p, POINTER(c_size_t)]),
    "page_write": (c_int32, [c_void_p, c_char_p, _error]),
    "page_risky": (c_int32, [c_void_p]),
    "page_note_count": (c_int64, [c_void_p]),
    "page_note": (c_char_p, [c_void_p, c_int64]),
}
_handles = ("points", "recording", "conflicts", "obstacles", "verdict", "page")


class IoLibrary(NamedTuple):
    """The library twice: for calls that take long, without the interpreter's lock, and for others."""

    unlocked: ctypes.CDLL
    at_once: ctypes.PyDLL
    handles: dict[str, type[c_void_p]]


def _find() -> str:
    """The library that is asked for, the one beside this, or that of the system."""
    asked = os.environ.get("BEESPACE_IO_LIBRARY")
    if asked:
        return asked
    beside = Path(__file__).with_name("libbeespace_io.so")
    return str(beside) if beside.exists() else "libbeespace_io.so.1"


@functools.lru_cache(maxsize=None)
def load() -> IoLibrary:
    path = _find()
    try:
        unlocked, at_once = ctypes.CDLL(path), ctypes.PyDLL(path)
        for name, (restype, argtypes) in _signatures.items():
            for each in (unlocked, at_once):
                function = getattr(each, f"beespace_io_{name}")
                function.restype = restype
                function.argtypes = argtypes
    except (OSError, AttributeError) as error:  # none, or one of an older version
        raise ImportError(
            "this installation of beespace cannot read files or make reports, as it finds no "
            f"libbeespace_io.so that fits: {error}. Install the wheel that 'make python' makes in a "
            "clone of beespace; or set BEESPACE_IO_LIBRARY to the path of a libbeespace_io.so, as "
            "'make install' has one."
        ) from error
    handles = {name: _library.handle_of(unlocked, f"io_{name}") for name in _handles}
    return IoLibrary(unlocked, at_once, handles)


def new_error() -> CFileError:
    """An error for one call to fill."""
    return CFileError(ctypes.sizeof(CFileError))


def error_of(error: CFileError) -> BeespaceFileError:
    """What the library said is wrong with a file, as an exception."""
    at_once = load().at_once
    text = ctypes.create_string_buffer(at_once.beespace_io_error_text(error, None, 0) + 1)
    at_once.beespace_io_error_text(error, text, len(text))
    code = _library.at_once.beespace_code_name(error.code).decode()
    file = os.fsdecode(error.file) or None
    of_system = code in ("cannot_open", "read_failed", "write_failed")
    raised = (BeespaceOSError if of_system else BeespaceFileError)(
        text.value.decode(errors="replace"),
        code,
        error.place.decode() or ("threshold" if code == "invalid_threshold" else None),
        None if error.record < 0 else int(error.record),
        file,
        int(error.line) or None,
        int(error.column) or None,
    )
    if isinstance(raised, BeespaceOSError):
        raised.filename = file
        if code == "cannot_open" and file is not None and not os.path.lexists(file):
            raised.errno = errno.ENOENT
    return raised


def check(code: int, error: CFileError) -> None:
    """Raises the error of a call, if it has one."""
    if code == _library.OK:
        return
    if code == _library.OUT_OF_MEMORY:
        raise MemoryError(error.message.decode())
    if code == _library.STOPPED:
        after_ctrl_c()
    raise error_of(error)


def encoded(text: Any) -> bytes | None:
    """A text of an option; None of None."""
    if text is None:
        return None
    if not isinstance(text, str):
        raise TypeError(f"options of reading are texts, not {text!r}")
    if "\0" in text:
        raise ValueError("a text of an option has no zero byte in it")
    return text.encode()
