"""What <beespace/c/advise.h> declares of libbeespace.so."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_int64, c_size_t, c_ssize_t, c_uint32, c_void_p

from beespace import _library
from beespace._library import CError, CPoints, CRun

FREE_SPHERE = 0
FREE_ELLIPSOID = 1
FREE_CYLINDER = 2

PLANAR = 1
REMEMBER = 2

TOO_CLOSE = 0
NEAR_OBSTACLE = 1
NEAR_FENCE = 2
INTRUDER_CONFLICTS = 3
NEAR_UNKNOWN = 4


class CLimits(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("reserved", c_int64),
        ("max_speeds_mps", c_void_p),
        ("max_accelerations_mps2", c_void_p),
        ("max_speeds_stride", c_ssize_t),
        ("max_accelerations_stride", c_ssize_t),
    ]


class CAdviseOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("reserved", c_uint32),
        ("threshold_m", c_double),
        ("step_s", c_double),
        ("shape", c_int32),
        ("method", c_int32),
        ("vertical_factor", c_double),
        ("vertical_m", c_double),
        ("uncertainty_m", c_double),
        ("clearance_m", c_double),
        ("obstacles", c_void_p),
        ("fence_directions", POINTER(CPoints)),
        ("fence_offsets_m", c_void_p),
        ("intruder_positions", POINTER(CPoints)),
        ("intruder_velocities", POINTER(CPoints)),
        ("intruder_margins_m", c_void_p),
        ("intruder_horizon_s", c_double),
        ("unknown_centers", POINTER(CPoints)),
        ("unknown_radii_m", c_void_p),
        ("unknown_growths_mps", c_void_p),
        ("unknown_agents", c_void_p),
        ("unknown_horizon_s", c_double),
        ("radii_m", c_void_p),
        ("tubes_m", c_void_p),
        ("claim_places", POINTER(CPoints)),
        ("claim_offsets", c_void_p),
        ("holds", c_void_p),
    ]


class CFindings(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("count", c_int64),
        ("first", c_void_p),
        ("second", c_void_p),
        ("distances_m", c_void_p),
        ("times_s", c_void_p),
    ]


CAdviser = _library.handle_of(_library.library, "adviser")
CAdvice = _library.handle_of(_library.library, "advice")

_points, _limits, _error = POINTER(CPoints), POINTER(CLimits), POINTER(CError)
_library.declare(
    {
        "adviser_create": (CAdviser, []),
        "adviser_forget": (None, [c_void_p, c_int64]),
        "advice_create": (CAdvice, []),
        "advise": (
            c_int32,
            [
                c_void_p,
                _points,
                _points,
                _points,
                _limits,
                POINTER(CAdviseOptions),
                POINTER(CRun),
                c_void_p,
                _error,
            ],
        ),
        "advice_size": (c_int64, [c_void_p]),
        "advice_velocities": (c_void_p, [c_void_p]),
        "advice_kinds": (c_void_p, [c_void_p]),
        "advice_certified": (c_void_p, [c_void_p]),
        "advice_keeps_apart": (c_void_p, [c_void_p]),
        "advice_clear_of_intruders": (c_void_p, [c_void_p]),
        "advice_clear_of_unknown": (c_void_p, [c_void_p]),
        "advice_clear_of_unknown_s": (c_void_p, [c_void_p]),
        "advice_findings": (c_int32, [c_void_p, c_int32, POINTER(CFindings), _error]),
        "advice_refused_count": (c_int64, [c_void_p]),
        "advice_refused": (c_int32, [c_void_p, c_int64, _error]),
        "velocity_to_goal": (c_int32, [_points, _points, _limits, c_double, c_void_p, _error]),
    }
)
