"""What <beespace/c/swarm.h> declares of libbeespace.so."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64
from ctypes import c_void_p
from typing import Any

from beespace._library import CError, CFixes, CPoints, at_once, declare, handle_of, library

SWARM_VERTICAL = 1
SWARM_HEIGHTS_APART = 2
SWARM_HORIZON = 4
SWARM_MAX_SPEED = 8


class CSwarmOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("threads", c_uint32),
        ("threshold_m", c_double),
        ("vertical_m", c_double),
        ("leave_factor", c_double),
        ("horizon_s", c_double),
        ("max_age_s", c_double),
        ("height_unit_m", c_double),
        ("max_speed_mps", c_double),
        ("max_agents", c_uint64),
        ("max_pairs", c_uint64),
        ("reserved", c_uint64),
    ]


class CCounts(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("taken", c_uint64),
        ("repeated", c_uint64),
        ("late", c_uint64),
        ("contrary", c_uint64),
        ("refused", c_uint64),
        ("agents", c_uint64),
        ("stale", c_uint64),
        ("heard_once", c_uint64),
        ("predicted", c_uint64),
        ("unknown_s", c_double),
        ("missed_s", c_double),
    ]


CSwarm = handle_of(library, "swarm")
CEvents = handle_of(library, "events")
CMovers = handle_of(library, "movers")

declare(
    {
        "swarm_create": (
            c_int32,
            [POINTER(CSwarmOptions), POINTER(CSwarm), POINTER(CError)],
        ),
        "swarm_update": (
            c_int32,
            [c_void_p, POINTER(CFixes), POINTER(CPoints), POINTER(CPoints), POINTER(c_int64), POINTER(CError)],
        ),
        "swarm_remove": (c_int32, [c_void_p, c_void_p, c_int64, POINTER(CError)]),
        "swarm_lose": (c_int32, [c_void_p, c_void_p, c_int64, POINTER(CError)]),
        "swarm_advance": (c_int32, [c_void_p, c_double, c_void_p, POINTER(CError)]),
        "swarm_finish": (c_int32, [c_void_p, c_double, c_void_p, POINTER(CError)]),
        "swarm_begin_anew": (c_int32, [c_void_p, c_double, c_double, c_void_p, POINTER(CError)]),
        "swarm_counts": (c_int32, [c_void_p, POINTER(CCounts), POINTER(CError)]),
        "swarm_movers": (c_int32, [c_void_p, c_double, c_void_p, POINTER(CError)]),
        "event_name": (c_char_p, [c_int32]),
        "bound_name": (c_char_p, [c_int32]),
        "events_create": (CEvents, []),
        "events_size": (c_int64, [c_void_p]),
        "movers_create": (CMovers, []),
        "movers_size": (c_int64, [c_void_p]),
    }
)
declare(
    {
        f"{of}_{name}": (c_void_p, [c_void_p])
        for of, names in {
            "events": "kinds times_s first second distances_m closest_s since_s left_out bounds",
            "movers": "ids positions velocities heard_s heard_at stale move unknown_s",
        }.items()
        for name in names.split()
    }
)


def _names_of(function: Any) -> list[str]:
    """All names of a kind of number, by the number."""
    names: list[str] = []
    while (name := function(len(names)).decode()) != "unknown":
        names.append(name)
    return names


EVENT_NAMES = _names_of(at_once.beespace_event_name)
BOUND_NAMES = _names_of(at_once.beespace_bound_name)
