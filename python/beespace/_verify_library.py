"""What <beespace/c/obstacles.h> and <beespace/c/verify.h> declare of libbeespace.so."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64
from ctypes import c_void_p

from beespace._library import CError, CPoints, CRun, declare, handle_of, library

SPHERE = 1
BOX = 2
GROUND = 3
CYLINDER = 4
PRISM = 5

LOWEST = 1
HIGHEST = 2

MAX_SPEED = 1
MAX_ACCELERATION = 2
STRAIGHT = 4


class CObstacle(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("kind", c_int32),
        ("flags", c_uint32),
        ("center", c_double * 3),
        ("radius_m", c_double),
        ("low", c_double * 3),
        ("high", c_double * 3),
        ("outline", c_void_p),
        ("corners", c_int64),
        ("reserved", c_int64),
    ]


class CVerifyOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("reserved", c_uint32),
        ("threshold_m", c_double),
        ("obstacles", c_void_p),
        ("clearance_m", c_double),
        ("max_speed_mps", c_double),
        ("max_acceleration_mps2", c_double),
    ]


class CVerdict(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("holds", c_int32),
        ("reserved", c_int32),
        ("moments", c_uint64),
        ("steps", c_uint64),
        ("unseen", c_uint64),
        ("losses", c_uint64),
        ("clearance_losses", c_uint64),
        ("breaches", c_uint64),
        ("closest_first", c_int64),
        ("closest_second", c_int64),
        ("closest_m", c_double),
        ("closest_step_s", c_double),
        ("peak_speed_mps", c_double),
        ("peak_acceleration_mps2", c_double),
    ]


CObstacles = handle_of(library, "obstacles")
CVerifier = handle_of(library, "verifier")
CViolations = handle_of(library, "violations")

_run, _error = POINTER(CRun), POINTER(CError)
declare(
    {
        "obstacles_create": (
            c_int32,
            [POINTER(CObstacle), c_int64, POINTER(CObstacles), _error],
        ),
        "obstacles_size": (c_int64, [c_void_p]),
        "verifier_create": (
            c_int32,
            [POINTER(CVerifyOptions), POINTER(CVerifier), _error],
        ),
        "verifier_add": (
            c_int32,
            [c_void_p, c_double, POINTER(CPoints), POINTER(CPoints), _run, _error],
        ),
        "verifier_add_recording": (c_int32, [c_void_p, c_void_p, c_double, _run, _error]),
        "verifier_skip": (None, [c_void_p]),
        "verifier_verdict": (c_int32, [c_void_p, POINTER(CVerdict), _error]),
        "verifier_violations": (c_int32, [c_void_p, c_void_p, _error]),
        "violation_name": (c_char_p, [c_int32]),
        "violations_create": (CViolations, []),
        "violations_size": (c_int64, [c_void_p]),
    }
)
declare(
    {
        f"violations_{name}": (c_void_p, [c_void_p])
        for name in ("kinds", "first", "second", "begins_s", "ends_s", "values")
    }
)
