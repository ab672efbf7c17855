"""The agent's side of a fleet that is not exact."""

from __future__ import annotations

import ctypes

from beespace import _fleet_library as _c
from beespace import _library
from beespace._advice_arguments import above_zero, time_above_zero
from beespace._calls import number_of
from beespace._errors import BeespaceError
from beespace._fleet import check_fleet, integer
from beespace._library import at_once
from beespace._messages import (
    Acknowledgement,
    Command,
    Setpoint,
    StoredBranch,
    acknowledgement_from,
    c_command,
    c_stored,
    setpoint_from,
    stored_from,
)
from beespace._ranges import zero_or_more
from beespace._turns import InTurn
from beespace._units import ACCELERATIONS, SECONDS, SPEEDS


class Follower(InTurn):
    """The agent's side: takes or refuses commands, and says where to be now.

    It holds one branch, and changes it as the rules of docs/prevention.md allow. It has no clock of
    its own: `advance` tells it the tick.

    Parameters
    ----------
    agent : int
        Its number: any of 64 bits.
    planned_speed, planned_acceleration : float
        What is planned with: those of its `Tube`.
    period : float
        A tick, in seconds: that of the `LinkFigures`.

    Examples
    --------
    >>> import beespace
    >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
    >>> joined = guide.join(7, [0, 0, 30])
    >>> follower = beespace.Follower(7, 6, 4, 0.1)
    >>> follower.advance(1)
    >>> follower.receive(guide.step(1).commands[0]).reply
    'taken'
    >>> follower
    <beespace.Follower: agent 7 on branch 1.1 at tick 1>
    >>> follower.setpoint().position
    (0.0, 0.0, 30.0)
    """

    __slots__ = ("agent",)

    def __init__(
        self, agent: int, planned_speed: float, planned_acceleration: float, period: float
    ) -> None:
        self.agent = integer(agent, "agent")
        self._take_turns(_c.CFollower(), threaded=False)
        error = _library.new_error()
        code = at_once.beespace_follower_create(
            self.agent,
            zero_or_more(number_of(planned_speed, "planned_speed", SPEEDS), "planned_speed"),
            above_zero(planned_acceleration, "planned_acceleration", ACCELERATIONS),
            time_above_zero(period, "period"),
            ctypes.byref(self._handle),
            ctypes.byref(error),
        )
        check_fleet(code, error)

    def __repr__(self) -> str:
        held = self.held
        on = f"on branch {held >> 32}.{held & 0xFFFFFFFF}" if held else "on no branch"
        return f"<beespace.Follower: agent {self.agent} {on} at tick {self.tick}>"

    def advance(self, tick: int) -> None:
        """Sets the tick; it never runs backwards. Before the first call no command is taken.

        Examples
        --------
        >>> import beespace
        >>> follower = beespace.Follower(7, 6, 4, 0.1)
        >>> follower.advance(12)
        >>> follower.advance(5)
        >>> follower.tick
        12
        """
        number = integer(tick, "tick")
        with self._lock:
            at_once.beespace_follower_advance(self._handle, number)

    def receive(self, command: Command) -> Acknowledgement:
        """Takes a command or refuses it: anything may be in it, and what is no command is "invalid".

        Returns
        -------
        Acknowledgement
            What was done. Of one that was "taken": store what `stored` says, then send this.

        Examples
        --------
        >>> import beespace
        >>> follower = beespace.Follower(7, 6, 4, 0.1)
        >>> state = beespace.BranchState((0, 0, 30), (0, 0, 0))
        >>> follower.receive(beespace.Command(8, (1 << 32) + 1, 0, (state,))).reply
        'invalid'
        """
        try:
            given = c_command(command)
        except BeespaceError:
            number = getattr(command, "number", 0)
            is_one = isinstance(number, int) and 0 <= number < 2**64
            return Acknowledgement(self.agent, number if is_one else 0, "invalid", self.held, self.tick)
        said = _c.CAcknowledgement(ctypes.sizeof(_c.CAcknowledgement))
        error = _library.new_error()
        with self._lock:
            code = at_once.beespace_follower_receive(
                self._handle, ctypes.byref(given), ctypes.byref(said), ctypes.byref(error)
            )
        check_fleet(code, error)
        return acknowledgement_from(said)

    def promise(self, epoch: int) -> bool:
        """Answers a planner that was started anew: promises to refuse all older epochs.

        Returns
        -------
        bool
            Whether it promises: then store what `stored` says, and send it.

        Examples
        --------
        >>> import beespace
        >>> follower = beespace.Follower(7, 6, 4, 0.1)
        >>> follower.promise(3), follower.promise(2), follower.stored().promised
        (True, False, 3)
        """
        number = integer(epoch, "epoch", 0, 2**32 - 1)
        with self._lock:
            return bool(at_once.beespace_follower_promise(self._handle, number))

    def lose(self) -> None:
        """Forgets its branch: the agent is not where it should be, and must join anew.

        Examples
        --------
        >>> import beespace
        >>> follower = beespace.Follower(7, 6, 4, 0.1)
        >>> follower.lose()
        >>> follower.held, follower.stored().promised
        (0, 1)
        """
        with self._lock:
            at_once.beespace_follower_lose(self._handle)

    def stored(self) -> StoredBranch:
        """What to store durably, wherever it has changed, before anything is sent.

        Examples
        --------
        >>> import beespace
        >>> beespace.Follower(7, 6, 4, 0.1).stored()
        StoredBranch(branch=None, promised=0, tick=0)
        """
        into = _c.CStoredBranch(ctypes.sizeof(_c.CStoredBranch))
        error = _library.new_error()
        with self._lock:
            code = at_once.beespace_follower_stored(
                self._handle, ctypes.byref(into), ctypes.byref(error)
            )
        check_fleet(code, error)
        return stored_from(into)

    def restore(self, stored: StoredBranch) -> None:
        """Goes on after a restart with what was stored.

        Examples
        --------
        >>> import beespace
        >>> follower = beespace.Follower(7, 6, 4, 0.1)
        >>> follower.restore(beespace.StoredBranch(None, promised=3, tick=40))
        >>> follower
        <beespace.Follower: agent 7 on no branch at tick 40>
        """
        error = _library.new_error()
        given = c_stored(stored)
        with self._lock:
            code = at_once.beespace_follower_restore(
                self._handle, ctypes.byref(given), ctypes.byref(error)
            )
        check_fleet(code, error)

    def setpoint(self, after: float = 0.0) -> Setpoint:
        """Where it should be, some seconds after its tick. On no branch that is an error.

        Examples
        --------
        >>> import beespace
        >>> beespace.Follower(7, 6, 4, 0.1).setpoint()
        Traceback (most recent call last):
        ...
        beespace._errors.BeespaceError: follower: the agent is on no branch, ...
        """
        since = number_of(after, "after", SECONDS)
        into = _c.CSetpoint(ctypes.sizeof(_c.CSetpoint))
        error = _library.new_error()
        with self._lock:
            code = at_once.beespace_follower_setpoint(
                self._handle, since, ctypes.byref(into), ctypes.byref(error)
            )
        check_fleet(code, error)
        return setpoint_from(into)

    @property
    def held(self) -> int:
        """The number of the branch that it is on; 0: none."""
        with self._lock:
            return int(at_once.beespace_follower_held(self._handle))

    @property
    def tick(self) -> int:
        """The latest tick that it was told."""
        with self._lock:
            return int(at_once.beespace_follower_tick(self._handle))
