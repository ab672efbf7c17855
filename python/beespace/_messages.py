"""What the planner of a fleet and its agents tell each other."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, NamedTuple

from beespace import _fleet_library as _c
from beespace._calls import number_of
from beespace._errors import BeespaceError, invalid
from beespace._fleet import integer
from beespace._units import METRES, SECONDS, SPEEDS, plain

Three = tuple[float, float, float]


class BranchState(NamedTuple):
    """One state of a branch: where an agent is and how fast, and what it flies in addition.

    Examples
    --------
    >>> import beespace
    >>> beespace.BranchState((0.0, 0.0, 30.0), (1.0, 0.0, 0.0)).correction
    (0.0, 0.0, 0.0)
    """

    position: Three
    velocity: Three
    correction: Three = (0.0, 0.0, 0.0)


class Ancestor(NamedTuple):
    """A branch that another one departs from, and the tick up to which both lead the same way.

    Examples
    --------
    >>> import beespace
    >>> beespace.Ancestor(number=(1 << 32) + 5, departs=17)
    Ancestor(number=4294967301, departs=17)
    """

    number: int
    departs: int


@dataclass(frozen=True)
class Command:
    """A command: the branch that one agent shall be on. It can be pickled, and sent by any means.

    Attributes
    ----------
    agent : int
        For whom.
    number : int
        The branch: the epoch of its planner in the upper 32 bits, and a count below.
    starts : int
        The tick of the first state.
    states : tuple of BranchState
        The path, at `starts` and each tick after it; then the agent brakes to a stop and stays.
    ancestors : tuple of Ancestor
        From which branches it departs, in descending order; none: a root.

    Examples
    --------
    >>> import beespace
    >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
    >>> answer = guide.join(7, [0, 0, 30])
    >>> guide.step(1).commands[0]
    <Command: agent 7 on branch 1.1 from tick 0 on, a root>
    """

    agent: int
    number: int
    starts: int
    states: tuple[BranchState, ...]
    ancestors: tuple[Ancestor, ...] = ()

    def __repr__(self) -> str:
        branch = f"{self.number >> 32}.{self.number & 0xFFFFFFFF}"
        count = len(self.ancestors)
        of = "a root" if not count else f"{count} ancestor{'s' if count > 1 else ''}"
        return f"<Command: agent {self.agent} on branch {branch} from tick {self.starts} on, {of}>"


@dataclass(frozen=True)
class Acknowledgement:
    """The reply of an agent to one command. It can be pickled.

    Attributes
    ----------
    agent, number : int
        Who replies, and to which command.
    reply : str
        "taken", "older", "too_late", "too_early", "no_ancestor", "no_branch" or "invalid".
    held : int
        The branch that it is on after that; 0: none.
    tick : int
        Its tick at that moment.

    Examples
    --------
    >>> import beespace
    >>> beespace.Acknowledgement(agent=7, number=(1 << 32) + 1, reply="older").reply
    'older'
    """

    agent: int
    number: int
    reply: str
    held: int = 0
    tick: int = 0


@dataclass(frozen=True)
class AgentReport:
    """What an agent says about itself. It can be pickled.

    Attributes
    ----------
    agent : int
        Who reports.
    held : int
        The branch that it is on; 0: it lost it.
    tick : int
        Its tick as it was measured.
    position : three floats
        Where it was measured to be, in metres.
    after : float
        How long after that tick, in seconds.
    velocity : three floats, optional
        How fast, in metres per second.

    Examples
    --------
    >>> import beespace
    >>> beespace.AgentReport(7, (1 << 32) + 1, 130, (3.31, 1.02, 29.98), after=0.02).velocity is None
    True
    """

    agent: int
    held: int
    tick: int
    position: Three
    after: float = 0.0
    velocity: Three | None = None


@dataclass(frozen=True)
class StoredBranch:
    """What an agent must remember to go on after a restart. It can be pickled.

    Attributes
    ----------
    branch : Command or None
        The branch that it is on.
    promised : int
        It refuses epochs below this.
    tick : int
        Its tick.

    Examples
    --------
    >>> import beespace
    >>> beespace.Follower(7, 5, 3, 0.1).stored()
    StoredBranch(branch=None, promised=0, tick=0)
    """

    branch: Command | None
    promised: int
    tick: int


class Setpoint(NamedTuple):
    """Where an agent should be: position, velocity, what it flies in addition, and whether it stands.

    Examples
    --------
    >>> import beespace
    >>> beespace.Setpoint((0.0, 0.0, 30.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), True).holding
    True
    """

    position: Three
    velocity: Three
    correction: Three
    holding: bool


def branch(number: Any, place: str = "number") -> int:
    """The number of a branch."""
    return integer(number, place, 0, 2**64 - 1)


def three(numbers: Any, place: str, units: tuple[str, ...] = METRES) -> Any:
    """Three numbers of C; of two the third is zero."""
    given = plain(numbers, place, units)
    try:
        if isinstance(given, (str, bytes)):
            raise TypeError
        values = [number_of(number, place, units) for number in given]
    except TypeError:
        raise invalid(f"these are three numbers, not {numbers!r}", place) from None
    if len(values) not in (2, 3):
        raise invalid(f"these are three numbers, not {len(values)}", place)
    return _c.CThree(*values)


def c_command(command: Command) -> _c.CCommand:
    check_type(command, Command, "command")
    try:
        return _c_command(command)
    except BeespaceError:
        raise
    except (TypeError, ValueError) as error:
        raise invalid(f"this is no command: {error}", "command") from None


def check_type(given: Any, kind: type, place: str) -> None:
    """Refuses what is something else."""
    if not isinstance(given, kind):
        raise invalid(f"this is of the type {kind.__name__}, and not {given!r}", place)


def _c_command(command: Command) -> _c.CCommand:
    if len(command.states) > _c.MOST_STATES or len(command.ancestors) > _c.MOST_ANCESTORS:
        raise invalid(
            f"a command has at most {_c.MOST_STATES} states and {_c.MOST_ANCESTORS} ancestors",
            "command",
        )
    into = _c.CCommand(
        ctypes.sizeof(_c.CCommand),
        0,
        integer(command.agent, "agent"),
        branch(command.number),
        integer(command.starts, "starts"),
        len(command.states),
        len(command.ancestors),
    )
    for k, state in enumerate(command.states):
        position, velocity, correction = state
        into.states[k] = _c.CBranchState(
            three(position, "states"), three(velocity, "states", SPEEDS), three(correction, "states", SPEEDS)
        )
    for k, (number, departs) in enumerate(command.ancestors):
        into.ancestors[k] = _c.CAncestor(branch(number, "ancestors"), integer(departs, "ancestors"))
    return into


def command_from(command: Any) -> Command:
    return Command(
        command.agent,
        command.number,
        command.starts,
        tuple(
            BranchState(_tuple(state.position), _tuple(state.velocity), _tuple(state.correction))
            for state in command.states[: command.state_count]
        ),
        tuple(
            Ancestor(ancestor.number, ancestor.departs)
            for ancestor in command.ancestors[: command.ancestor_count]
        ),
    )


def c_acknowledgement(said: Acknowledgement) -> _c.CAcknowledgement:
    check_type(said, Acknowledgement, "message")
    if said.reply not in _c.REPLIES:
        raise invalid(f"there is no reply {said.reply!r}: {', '.join(_c.REPLIES)}", "reply")
    return _c.CAcknowledgement(
        ctypes.sizeof(_c.CAcknowledgement),
        _c.REPLIES.index(said.reply) + 1,
        0,
        integer(said.agent, "agent"),
        branch(said.number),
        branch(said.held, "held"),
        integer(said.tick, "tick"),
    )


def acknowledgement_from(said: _c.CAcknowledgement) -> Acknowledgement:
    return Acknowledgement(
        said.agent, said.number, _c.REPLIES[int(said.reply) - 1], said.held, said.tick
    )


def c_report(report: AgentReport) -> _c.CAgentReport:
    into = _c.CAgentReport(
        ctypes.sizeof(_c.CAgentReport),
        0,
        0,
        integer(report.agent, "agent"),
        branch(report.held, "held"),
        integer(report.tick, "tick"),
        number_of(report.after, "after", SECONDS),
        three(report.position, "position"),
    )
    if report.velocity is not None:
        into.flags = _c.WITH_VELOCITY
        into.velocity = three(report.velocity, "velocity", SPEEDS)
    return into


def c_stored(stored: StoredBranch) -> _c.CStoredBranch:
    check_type(stored, StoredBranch, "stored")
    into = _c.CStoredBranch(
        ctypes.sizeof(_c.CStoredBranch),
        integer(stored.promised, "promised", 0, 2**32 - 1),
        0,
        integer(stored.tick, "tick"),
    )
    if stored.branch is None:
        into.branch.struct_size = ctypes.sizeof(_c.CCommand)
    else:
        into.branch = c_command(stored.branch)
    return into


def stored_from(stored: _c.CStoredBranch) -> StoredBranch:
    held = command_from(stored.branch) if stored.branch.number else None
    return StoredBranch(held, stored.promised, stored.tick)


def setpoint_from(setpoint: _c.CSetpoint) -> Setpoint:
    return Setpoint(
        _tuple(setpoint.position),
        _tuple(setpoint.velocity),
        _tuple(setpoint.correction),
        bool(setpoint.holding),
    )


def _tuple(numbers: Any) -> Three:
    x, y, z = numbers
    return x, y, z
