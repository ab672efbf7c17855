"""Which points are closer than a threshold to which others? Exact answers, fast.

Points are positions in metres, in any Cartesian frame: an array of shape (n, 3), one of shape (n, 2),
or a tuple of two or three arrays, one for each axis. They are read where they are. Distances are
compared with the threshold as real numbers on the given values: no rounding, machine or number of
threads changes an answer.

>>> import beespace
>>> drones = [[0, 0, 50], [80, 60, 50], [300, 0, 50], [300, 0, 149.9]]
>>> beespace.at_risk(drones, 100)
array([2, 3])
"""

from beespace._advice import Adviser, velocity_to_goal
from beespace._advice_answers import Advice, Findings
from beespace._answers import ClosestPair, Groups, Nearest, Neighbors, Pairs
from beespace._conflicts import Approaches, Conflicts, Encounter, Gaps, RecordedConflicts
from beespace._coverage import Coverage
from beespace._engine import Engine
from beespace._errors import BeespaceError, BeespaceFileError, BeespaceOSError
from beespace._events import Event, Events, KnownAgents, SwarmCounts
from beespace._file_conflicts import FileConflicts
from beespace._file_movers import FileMovers
from beespace._file_obstacles import read_obstacles
from beespace._file_points import FilePoints
from beespace._file_recording import FileRecording
from beespace._files import read, read_recording
from beespace._fleet import FleetFigures, LinkFigures, Tube, tube_of
from beespace._flight_verdict import FlightBreaches, FlightLosses, FlightVerdict, Peak
from beespace._follower import Follower
from beespace._geodesy import to_ecef
from beespace._guidance import Guidance, JoinAnswer
from beespace._guide import Guide
from beespace._index import Index
from beespace._large_recording import RecordingOutOfCore, RecordingOutOfCoreFacts
from beespace._library import version as _version
from beespace._messages import (
    Acknowledgement,
    AgentReport,
    Ancestor,
    BranchState,
    Command,
    Setpoint,
    StoredBranch,
)
from beespace._motion import closest_approach
from beespace._obstacles import Box, Cylinder, Ground, Obstacles, Prism, Sphere
from beespace._out_of_core import OutOfCore, OutOfCoreFacts
from beespace._plot import plot
from beespace._recording import Recording
from beespace._report import Report, report, view
from beespace._searches import Searches
from beespace._swarm import Swarm
from beespace._verdict import Breaches, ClearanceLosses, Losses, Verdict
from beespace._verify import Verifier, verify

__version__ = _version()

_searches = Searches()
at_risk = _searches.at_risk
pairs = _searches.pairs
iter_pairs = _searches.iter_pairs
neighbors = _searches.neighbors
count = _searches.count
groups = _searches.groups
nearest = _searches.nearest
closest_pair = _searches.closest_pair
predict = _searches.predict
predict_pairs = _searches.predict_pairs

__all__ = [
    "Acknowledgement",
    "Advice",
    "Adviser",
    "AgentReport",
    "Ancestor",
    "Approaches",
    "BeespaceError",
    "BeespaceFileError",
    "BeespaceOSError",
    "Box",
    "BranchState",
    "Breaches",
    "ClearanceLosses",
    "ClosestPair",
    "Command",
    "Conflicts",
    "Coverage",
    "Cylinder",
    "Encounter",
    "Engine",
    "Event",
    "Events",
    "FileConflicts",
    "FileMovers",
    "FilePoints",
    "FileRecording",
    "Findings",
    "FleetFigures",
    "FlightBreaches",
    "FlightLosses",
    "FlightVerdict",
    "Follower",
    "Gaps",
    "Ground",
    "Groups",
    "Guidance",
    "Guide",
    "Index",
    "JoinAnswer",
    "KnownAgents",
    "LinkFigures",
    "Losses",
    "Nearest",
    "Neighbors",
    "Obstacles",
    "OutOfCore",
    "OutOfCoreFacts",
    "Pairs",
    "Peak",
    "Prism",
    "RecordedConflicts",
    "Recording",
    "RecordingOutOfCore",
    "RecordingOutOfCoreFacts",
    "Report",
    "Setpoint",
    "Sphere",
    "StoredBranch",
    "Swarm",
    "SwarmCounts",
    "Tube",
    "Verdict",
    "Verifier",
    "at_risk",
    "closest_approach",
    "closest_pair",
    "count",
    "groups",
    "iter_pairs",
    "nearest",
    "neighbors",
    "pairs",
    "plot",
    "predict",
    "predict_pairs",
    "read",
    "read_obstacles",
    "read_recording",
    "report",
    "to_ecef",
    "tube_of",
    "velocity_to_goal",
    "verify",
    "view",
]
