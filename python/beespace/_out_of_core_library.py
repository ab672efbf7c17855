"""What <beespace/c/out_of_core.h> and <beespace/c/large_recording.h> declare of libbeespace.so."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int, c_int32, c_int64, c_size_t, c_uint64, c_void_p

from beespace._library import (
    VISITOR,
    CError,
    CFixes,
    CPoints,
    CRun,
    CSearch,
    declare,
    handle_of,
    library,
)

PROGRESS = ctypes.CFUNCTYPE(None, c_void_p, c_int32, c_int64, c_int64)
IDS_VISITOR = ctypes.CFUNCTYPE(c_int, c_void_p, c_void_p, c_int64)
COUNTS_VISITOR = ctypes.CFUNCTYPE(c_int, c_void_p, c_void_p, c_void_p, c_int64)
NEAREST_VISITOR = ctypes.CFUNCTYPE(
    c_int, c_void_p, c_void_p, c_int64, c_void_p, c_void_p, c_int64
)
CONFLICTS_VISITOR = ctypes.CFUNCTYPE(
    c_int, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p, c_int64
)
GAPS_VISITOR = ctypes.CFUNCTYPE(c_int, c_void_p, c_void_p, c_void_p, c_void_p, c_int64)


class COptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("memory_bytes", c_uint64),
        ("folder", c_char_p),
        ("height_unit_m", c_double),
        ("progress", PROGRESS),
        ("progress_data", c_void_p),
        ("reserved", c_uint64),
    ]


class CFacts(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("cells", c_int64),
        ("copies", c_int64),
        ("crowded_cells", c_int64),
        ("largest_cell", c_int64),
    ]


class CRecordingFacts(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("windows", c_int64),
        ("copies", c_int64),
        ("largest_window", c_int64),
        ("encounters", c_int64),
    ]


COutOfCore = handle_of(library, "out_of_core")
CLargeRecording = handle_of(library, "large_recording")

_points: list[object] = [c_void_p, POINTER(CPoints), c_void_p, POINTER(CError)]
_search, _run = POINTER(CSearch), POINTER(CRun)
_tail = [c_void_p, POINTER(CError)]
declare({
    "out_of_core_create": (
        c_int32,
        [POINTER(COptions), POINTER(COutOfCore), POINTER(CError)],
    ),
    "out_of_core_size": (c_int64, [c_void_p]),
    "out_of_core_add": (c_int32, _points),
    "out_of_core_refer": (c_int32, _points),
    "out_of_core_at_risk": (c_int32, [c_void_p, _search, _run, IDS_VISITOR, *_tail]),
    "out_of_core_pairs": (c_int32, [c_void_p, _search, _run, VISITOR, *_tail]),
    "out_of_core_count": (c_int32, [c_void_p, _search, _run, COUNTS_VISITOR, *_tail]),
    "out_of_core_nearest": (c_int32, [c_void_p, c_int64, _run, NEAREST_VISITOR, *_tail]),
    "out_of_core_closest_pair": (c_int32, [c_void_p, _run, *_tail]),
    "out_of_core_facts_of": (c_int32, [c_void_p, POINTER(CFacts), POINTER(CError)]),
    "large_recording_create": (
        c_int32,
        [POINTER(COptions), POINTER(CLargeRecording), POINTER(CError)],
    ),
    "large_recording_size": (c_int64, [c_void_p]),
    "large_recording_add": (
        c_int32,
        [c_void_p, POINTER(CFixes), POINTER(CPoints), POINTER(CError)],
    ),
    "large_recording_conflicts": (
        c_int32,
        [c_void_p, _search, c_double, _run, CONFLICTS_VISITOR, GAPS_VISITOR, *_tail],
    ),
    "large_recording_facts_of": (
        c_int32,
        [c_void_p, POINTER(CRecordingFacts), POINTER(CError)],
    ),
})
