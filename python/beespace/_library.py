"""libbeespace.so, as its header <beespace.h> declares it.

Calls that may take long release the lock of the interpreter, so other threads go on meanwhile.
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Mapping
from ctypes import POINTER, c_char, c_char_p, c_double, c_int, c_int32, c_int64, c_uint32, c_uint64
from ctypes import c_size_t, c_ssize_t, c_void_p
from pathlib import Path
from typing import Any

from beespace._errors import BeespaceError

OK = 0
STOPPED = 23
OUT_OF_MEMORY = 100

FLOAT64 = 0
FLOAT32 = 1

INCLUSIVE = 1
VERTICAL = 2
MAX_RESULTS = 4
DISTANCES = 8
WITH_SELF = 16

ALL_PROCESSORS = 0xFFFFFFFF


class CError(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("code", c_int32),
        ("reserved", c_int32),
        ("record", c_int64),
        ("place", c_char * 32),
        ("message", c_char * 512),
    ]


class CPoints(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("type", c_int32),
        ("reserved", c_int32),
        ("count", c_int64),
        ("x", c_void_p),
        ("y", c_void_p),
        ("z", c_void_p),
        ("x_stride", c_ssize_t),
        ("y_stride", c_ssize_t),
        ("z_stride", c_ssize_t),
    ]


class CSearch(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("reserved", c_uint32),
        ("threshold_m", c_double),
        ("vertical_m", c_double),
        ("max_results", c_uint64),
    ]


class CFixes(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("reserved", c_int64),
        ("agents", c_void_p),
        ("times_s", c_void_p),
        ("agents_stride", c_ssize_t),
        ("times_stride", c_ssize_t),
        ("heights_m", c_void_p),
        ("climbs_mps", c_void_p),
        ("heights_stride", c_ssize_t),
        ("climbs_stride", c_ssize_t),
        ("height_unit_m", c_double),
    ]


POLL = ctypes.CFUNCTYPE(c_int, c_void_p)
VISITOR = ctypes.CFUNCTYPE(c_int, c_void_p, c_void_p, c_void_p, c_void_p, c_int64)


class CRun(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("threads", c_uint32),
        ("reserved", c_uint32),
        ("stop", c_void_p),
        ("poll", POLL),
        ("poll_data", c_void_p),
    ]


def _load() -> tuple[ctypes.CDLL, ctypes.PyDLL]:
    # The first is for the tests of a build that is not installed.
    path = os.environ.get("BEESPACE_LIBRARY") or str(Path(__file__).with_name("libbeespace.so"))
    try:
        return ctypes.CDLL(path), ctypes.PyDLL(path)
    except OSError as error:
        raise ImportError(
            f"beespace cannot load its library, {path}: {error}. "
            "Install the package with pip, or set BEESPACE_LIBRARY to a libbeespace.so."
        ) from error


# What takes long goes through the first, which gives the lock of the interpreter to others meanwhile.
# What is over at once goes through the second and keeps it: to get it back may take milliseconds.
library, at_once = _load()



def _method_of_c(function: object) -> object:
    """The function as a method that no Python code runs for. In the Python code of a destructor, the
    handler of Ctrl-C could run, and its exception would be lost."""
    try:
        bind = ctypes.pythonapi.PyInstanceMethod_New
    except AttributeError:  # an interpreter that is not CPython
        return lambda self: function(self)  # type: ignore[operator]
    bind.restype = ctypes.py_object
    bind.argtypes = [ctypes.py_object]
    return bind(function)


def refuse_to_copy(self: object) -> Any:
    """What `__reduce__` of a handle does, and of what changes."""
    # ctypes would copy the address, and what is there would be freed twice.
    raise TypeError(
        "what the library of beespace keeps can be neither copied nor pickled: pickle what it was made "
        "of, such as the points or the path of the file, and make it anew"
    )


def handle_of(of: ctypes.CDLL, name: str) -> type[c_void_p]:
    """A pointer to what a library has made, freed with the last reference to it."""
    free = of[f"beespace_{name}_free"]
    free.restype = None
    free.argtypes = [c_void_p]
    members = {"__del__": _method_of_c(free), "__reduce__": refuse_to_copy}
    return type(f"C{name.title()}", (c_void_p,), members)


def _handle(name: str) -> type[c_void_p]:
    return handle_of(library, name)


CResult = _handle("result")
CEngine = _handle("engine")
CIndex = _handle("index")
CRecording = _handle("recording")
CStop = _handle("stop")

_points, _search, _run = POINTER(CPoints), POINTER(CSearch), POINTER(CRun)
_tail = [_run, c_void_p, POINTER(CError)]
_signatures: dict[str, tuple[object, list[object]]] = {
    "version": (c_char_p, []),
    "stop_create": (CStop, []),
    "stop_request": (None, [c_void_p]),
    "code_name": (c_char_p, [c_int32]),
    "result_create": (CResult, []),
    "result_size": (c_int64, [c_void_p]),
    "result_rows": (c_int64, [c_void_p]),
    "result_ids": (c_void_p, [c_void_p]),
    "result_offsets": (c_void_p, [c_void_p]),
    "result_first": (c_void_p, [c_void_p]),
    "result_second": (c_void_p, [c_void_p]),
    "result_counts": (c_void_p, [c_void_p]),
    "result_distances_m": (c_void_p, [c_void_p]),
    "result_begins_s": (c_void_p, [c_void_p]),
    "result_closest_s": (c_void_p, [c_void_p]),
    "result_ends_s": (c_void_p, [c_void_p]),
    "engine_create": (CEngine, []),
    "engine_release_memory": (None, [c_void_p]),
    "at_risk": (c_int32, [c_void_p, _points, _points, _search, *_tail]),
    "pairs": (c_int32, [c_void_p, _points, _points, _search, *_tail]),
    "visit_pairs": (
        c_int32,
        [c_void_p, _points, _search, _run, VISITOR, c_void_p, POINTER(CError)],
    ),
    "neighbors": (c_int32, [c_void_p, _points, _points, _search, *_tail]),
    "count": (c_int32, [c_void_p, _points, _points, _search, *_tail]),
    "groups": (c_int32, [c_void_p, _points, _search, *_tail]),
    "nearest": (c_int32, [c_void_p, _points, _points, c_int64, *_tail]),
    "nearest_within": (c_int32, [c_void_p, _points, _points, _search, *_tail]),
    "closest_pair": (c_int32, [c_void_p, _points, _points, *_tail]),
    "closest_approach": (
        c_int32,
        [_points, _points, _points, _points, _search, c_double, *_tail],
    ),
    "predict": (c_int32, [c_void_p, _points, _points, _search, c_double, *_tail]),
    "predict_pairs": (c_int32, [c_void_p, _points, _points, _search, c_double, *_tail]),
    "recording_create": (
        c_int32,
        [POINTER(CFixes), _points, _run, POINTER(CRecording), POINTER(CError)],
    ),
    "recording_agents": (c_int64, [c_void_p]),
    "recording_conflicts": (c_int32, [c_void_p, _search, c_double, *_tail]),
    "recording_closest": (c_int32, [c_void_p, c_double, *_tail]),
    "result_gaps": (c_int64, [c_void_p]),
    "result_gap_agents": (c_void_p, [c_void_p]),
    "result_gap_begins_s": (c_void_p, [c_void_p]),
    "result_gap_ends_s": (c_void_p, [c_void_p]),
    "to_ecef_velocity": (c_int32, [_points, _points, c_void_p, POINTER(CError)]),
    "to_ecef": (c_int32, [_points, c_void_p, POINTER(CError)]),
    "index_create": (c_int32, [_points, _run, POINTER(CIndex), POINTER(CError)]),
    "index_size": (c_int64, [c_void_p]),
    "index_position": (c_int32, [c_void_p, c_int64, POINTER(c_double), POINTER(CError)]),
    "index_around": (c_int32, [c_void_p, _points, _search, *_tail]),
    "index_around_each": (c_int32, [c_void_p, _points, POINTER(c_double), _search, *_tail]),
    "index_nearest": (c_int32, [c_void_p, _points, c_int64, *_tail]),
    "index_insert": (
        c_int32,
        [c_void_p, POINTER(c_double), POINTER(c_int64), POINTER(CError)],
    ),
    "index_move": (c_int32, [c_void_p, c_int64, POINTER(c_double), POINTER(CError)]),
    "index_remove": (c_int32, [c_void_p, c_int64, POINTER(CError)]),
}


def declare(signatures: dict[str, tuple[object, list[object]]]) -> None:
    """Says what functions of the library take and return."""
    for name, (restype, argtypes) in signatures.items():
        for each in (library, at_once):
            function = getattr(each, f"beespace_{name}")
            function.restype = restype
            function.argtypes = argtypes


declare(_signatures)


def version() -> str:
    """The version of the library."""
    return str(library.beespace_version().decode())


def new_error() -> CError:
    """An error for one call to fill."""
    return CError(ctypes.sizeof(CError))


def raise_error(error: CError, places: Mapping[str, str] | None = None) -> None:
    """Raises what the library said is wrong."""
    if error.code == OUT_OF_MEMORY:
        raise MemoryError(error.message.decode())
    raise error_of(error, places=places)


# Arguments that are called otherwise here.
_places = {"claim_offsets": "claim_indptr", "after_s": "after", "recording": ""}


def error_of(
    error: CError, of_agent: bool = False, places: Mapping[str, str] | None = None
) -> BeespaceError:
    """What the library said is wrong, as an exception; of an agent, any record is its number."""
    code = library.beespace_code_name(error.code).decode()
    said: str = error.place.decode()
    if code == "invalid_threshold" and said in ("", "options"):
        said = "vertical" if error.message.startswith(b"the vertical") else "threshold"
    elif code == "too_many_results" and not said:
        said = "max_results"
    called = {**_places, **(places or {})}
    place = called.get(said, said) or None
    record = None if error.record < 0 and not of_agent else int(error.record)
    message: str = error.message.decode()
    if " NULL" in message:
        message = "these are not given, and go with the others"
    return BeespaceError(message, code, place, record)
