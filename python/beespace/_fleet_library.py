"""What <beespace/c/fleet.h> and <beespace/c/guide.h> declare of libbeespace.so."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64, c_void_p

from beespace import _library
from beespace._advice_library import CFindings
from beespace._library import CError, CPoints, CRun

MOST_STATES = 36
MOST_ANCESTORS = 16

LOOPS = {"onboard": 0, "ground": 1}
REPLIES = ("taken", "older", "too_late", "too_early", "no_ancestor", "no_branch", "invalid")
CONTRACTS = ("kept", "doubted", "out")
REASONS = ("none", "deviation", "rate", "silent", "no_branch", "future")
WITH_VELOCITY = 1

CThree = c_double * 3


class CFleetFigures(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("loop", c_int32),
        ("reserved", c_int32),
        ("report_error_m", c_double),
        ("report_age_s", c_double),
        ("sensing_error_m", c_double),
        ("loop_period_s", c_double),
        ("loop_delay_s", c_double),
        ("deviation_mps", c_double),
        ("clock_error_s", c_double),
        ("correction_mps2", c_double),
        ("correction_mps", c_double),
    ]


class CLinkFigures(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("reserved", c_int64),
        ("period_s", c_double),
        ("command_delay", c_int32),
        ("longest_loss", c_int32),
    ]


class CTube(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("reserved", c_int64),
        ("radius_m", c_double),
        ("clock_m", c_double),
        ("error_m", c_double),
        ("gain_per_s", c_double),
        ("correction_mps2", c_double),
        ("correction_mps", c_double),
        ("planned_speed_mps", c_double),
        ("planned_acceleration_mps2", c_double),
    ]


class CBranchState(ctypes.Structure):
    _fields_ = [("position", CThree), ("velocity", CThree), ("correction", CThree)]


class CAncestor(ctypes.Structure):
    _fields_ = [("number", c_uint64), ("departs", c_int64)]


class CCommand(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("reserved", c_int64),
        ("agent", c_int64),
        ("number", c_uint64),
        ("starts", c_int64),
        ("state_count", c_int32),
        ("ancestor_count", c_int32),
        ("states", CBranchState * MOST_STATES),
        ("ancestors", CAncestor * MOST_ANCESTORS),
    ]


class CAcknowledgement(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("reply", c_int32),
        ("reserved", c_int32),
        ("agent", c_int64),
        ("number", c_uint64),
        ("held", c_uint64),
        ("tick", c_int64),
    ]


class CAgentReport(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("reserved", c_uint32),
        ("agent", c_int64),
        ("held", c_uint64),
        ("tick", c_int64),
        ("after_s", c_double),
        ("position", CThree),
        ("velocity", CThree),
    ]


class CStoredBranch(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("promised", c_uint32),
        ("reserved", c_uint32),
        ("tick", c_int64),
        ("branch", CCommand),
    ]


class CSetpoint(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("holding", c_int32),
        ("reserved", c_int32),
        ("position", CThree),
        ("velocity", CThree),
        ("correction", CThree),
    ]


class CGuideOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("reserved", c_uint32),
        ("epoch", c_uint32),
        ("threads", c_uint32),
        ("threshold_m", c_double),
        ("vertical_factor", c_double),
        ("vertical_m", c_double),
        ("shape", c_int32),
        ("more_reserved", c_int32),
        ("figures", POINTER(CFleetFigures)),
        ("link", POINTER(CLinkFigures)),
        ("max_speed_mps", c_double),
        ("max_acceleration_mps2", c_double),
        ("clearance_m", c_double),
        ("obstacles", c_void_p),
        ("fence_directions", POINTER(CPoints)),
        ("fence_offsets_m", c_void_p),
        ("intruder_horizon_s", c_double),
    ]


class CJoinRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("promised", c_uint32),
        ("reserved", c_uint32),
        ("agent", c_int64),
        ("position", CThree),
        ("radius_m", c_double),
        ("figures", POINTER(CFleetFigures)),
        ("max_speed_mps", c_double),
        ("max_acceleration_mps2", c_double),
    ]


class CJoinAnswer(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("joined", c_int32),
        ("reserved", c_int32),
        ("touches", POINTER(c_int64)),
        ("obstacles", POINTER(c_int64)),
        ("fences", POINTER(c_int64)),
        ("touch_count", c_int64),
        ("obstacle_count", c_int64),
        ("fence_count", c_int64),
    ]


CGuide = _library.handle_of(_library.library, "guide")
CGuidance = _library.handle_of(_library.library, "guidance")
CFollower = _library.handle_of(_library.library, "follower")

_error, _points, _tube = POINTER(CError), POINTER(CPoints), POINTER(CTube)
_request, _answer = POINTER(CJoinRequest), POINTER(CJoinAnswer)
_three, _stored = POINTER(c_double), POINTER(CStoredBranch)
_columns = (
    "agents",
    "contracts",
    "reasons",
    "certified",
    "clear_of_intruders",
    "kinds",
    "commanded",
    "branches",
    "positions",
    "velocities",
    "tubes_m",
    "deviations_m",
)
_signatures: dict[str, tuple[object, list[object]]] = {
    "tube_of": (
        c_int32,
        [POINTER(CFleetFigures), POINTER(CLinkFigures), c_double, c_double, _tube, _error],
    ),
    "follower_create": (
        c_int32,
        [c_int64, c_double, c_double, c_double, POINTER(CFollower), _error],
    ),
    "follower_restore": (c_int32, [c_void_p, _stored, _error]),
    "follower_advance": (None, [c_void_p, c_int64]),
    "follower_receive": (
        c_int32,
        [c_void_p, POINTER(CCommand), POINTER(CAcknowledgement), _error],
    ),
    "follower_promise": (c_int32, [c_void_p, c_uint32]),
    "follower_lose": (None, [c_void_p]),
    "follower_held": (c_uint64, [c_void_p]),
    "follower_tick": (c_int64, [c_void_p]),
    "follower_stored": (c_int32, [c_void_p, _stored, _error]),
    "follower_setpoint": (c_int32, [c_void_p, c_double, POINTER(CSetpoint), _error]),
    "guide_create": (c_int32, [POINTER(CGuideOptions), POINTER(CGuide), _error]),
    "guide_join": (c_int32, [c_void_p, _request, _answer, _error]),
    "guide_may_join": (c_int32, [c_void_p, _request, _answer, _error]),
    "guide_adopt": (c_int32, [c_void_p, _request, _stored, _error]),
    "guide_expect": (c_int32, [c_void_p, POINTER(c_int64), c_int64, _error]),
    "guide_leave": (c_int32, [c_void_p, c_int64, _error]),
    "guide_set_goal": (c_int32, [c_void_p, c_int64, _three, _error]),
    "guide_set_preferred": (c_int32, [c_void_p, c_int64, _three, _error]),
    "guide_take_report": (c_int32, [c_void_p, POINTER(CAgentReport), _error]),
    "guide_take_acknowledgement": (c_int32, [c_void_p, POINTER(CAcknowledgement), _error]),
    "guide_set_intruders": (
        c_int32,
        [c_void_p, _points, _points, c_void_p, c_void_p, c_void_p, _error],
    ),
    "guide_size": (c_int64, [c_void_p]),
    "guide_tube": (c_int32, [c_void_p, c_int64, _tube, _error]),
    "guide_claim": (
        c_int32,
        [c_void_p, c_int64, POINTER(POINTER(c_double)), POINTER(c_int64), _error],
    ),
    "guide_step": (c_int32, [c_void_p, c_int64, POINTER(CRun), c_void_p, _error]),
    "guidance_create": (CGuidance, []),
    "guidance_tick": (c_int64, [c_void_p]),
    "guidance_size": (c_int64, [c_void_p]),
    "guidance_command_count": (c_int64, [c_void_p]),
    "guidance_command": (POINTER(CCommand), [c_void_p, c_int64]),
    "guidance_findings": (c_int32, [c_void_p, c_int32, POINTER(CFindings), _error]),
}
_library.declare(_signatures)
_library.declare({f"guidance_{name}": (c_void_p, [c_void_p]) for name in _columns})
