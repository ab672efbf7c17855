"""What a guide says in one tick."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace import _advice_library as _advice
from beespace import _fleet_library as _c
from beespace._advice_answers import Findings, findings_of, kinds_of
from beespace._columns import column
from beespace._library import at_once
from beespace._messages import Command, command_from
from beespace._tables import Table, plural

_contracts = np.array(_c.CONTRACTS)
_reasons = np.array(_c.REASONS)


@dataclass(frozen=True)
class JoinAnswer:
    """Whether an agent has joined. One that has not is not planned for, and not counted.

    Attributes
    ----------
    joined : bool
        Whether its place is reserved: it is in the fleet.
    touches : tuple of ints
        Whose claims it would touch.
    obstacles, fences : tuples of ints
        Which obstacles and fences it is too close to, by index.

    Examples
    --------
    >>> import beespace
    >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
    >>> guide.join(1, [0, 0, 30])
    JoinAnswer(joined=True, touches=(), obstacles=(), fences=())
    >>> guide.join(2, [2, 0, 30])
    JoinAnswer(joined=False, touches=(1,), obstacles=(), fences=())
    """

    joined: bool
    touches: tuple[int, ...]
    obstacles: tuple[int, ...]
    fences: tuple[int, ...]


class Guidance(Table):
    """What a guide says in one tick: commands to be sent, and what is known of each agent.

    Attributes
    ----------
    tick : int
        The tick.
    commands : tuple of Command
        To be sent, in ascending order of agents.
    agents : ndarray of int64, shape (n,)
        The agents, in ascending order; so all that follows.
    contract : ndarray of str, shape (n,)
        Whether its figures hold: "kept" as far as reports tell, "doubted", or "out": it surely has
        left its tube.
    reason : ndarray of str, shape (n,)
        Why not: "none", "deviation", "rate", "silent", "no_branch" or "future".
    certified : ndarray of bool, shape (n,)
        The all-clear: `keeps_apart`, `clear_of_intruders`, and a contract that is kept.
    keeps_apart : ndarray of bool, shape (n,)
        Proven: as long as all keep the contract, it keeps the threshold from all others that keep
        it, and the clearance, for ever. Of one whose contract is doubted or out that condition does
        not hold.
    clear_of_intruders : ndarray of bool, shape (n,)
        Predicted: no intruder comes too close, if all fly straight on, and the agent on its newest
        branch and as it is told now.
    kind : ndarray of str, shape (n,)
        As of `Advice`.
    commanded : ndarray of bool, shape (n,)
        Whether there is a command for it.
    branches : ndarray of int32, shape (n,)
        On how many branches it can be.
    positions, velocities : ndarrays of float64, shape (n, 3)
        Its nominal state now, on the newest branch.
    tube, deviation : ndarrays of float64, shape (n,)
        The radius of its tube, and how far from its place it was by its last report, in metres.
    too_close : Findings
        Pairs of agents without a certificate.
    near_obstacle, near_fence, intruder_conflicts : Findings
        As of `Advice`, of agents by their numbers; without times.

    Examples
    --------
    >>> import beespace
    >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
    >>> joined = guide.join(7, [0, 0, 30]), guide.join(8, [20, 0, 30])
    >>> guidance = guide.step(1)
    >>> guidance
    <Guidance: tick 1, 2 agents, 0 certified; 2 commands>
    >>> guidance.agents, guidance.contract.tolist(), guidance.positions[1]
    (array([7, 8]), ['kept', 'kept'], array([20.,  0., 30.]))
    """

    __slots__ = (
        "agents",
        "branches",
        "certified",
        "clear_of_intruders",
        "commanded",
        "commands",
        "contract",
        "deviation",
        "intruder_conflicts",
        "keeps_apart",
        "kind",
        "near_fence",
        "near_obstacle",
        "positions",
        "reason",
        "tick",
        "too_close",
        "tube",
        "velocities",
    )

    def __init__(self, handle: Any) -> None:
        size = int(at_once.beespace_guidance_size(handle))

        def numbers(getter: Any, code: str, each: int = 1) -> NDArray[Any]:
            return column(handle, getter(handle), each * size, code)

        def findings(what: int) -> Findings:
            return findings_of(handle, at_once.beespace_guidance_findings, what)

        self.tick = int(at_once.beespace_guidance_tick(handle))
        self.commands: tuple[Command, ...] = tuple(
            command_from(at_once.beespace_guidance_command(handle, k).contents)
            for k in range(int(at_once.beespace_guidance_command_count(handle)))
        )
        self.agents: NDArray[np.int64] = numbers(at_once.beespace_guidance_agents, "<i8")
        self.contract: NDArray[np.str_] = _contracts[
            numbers(at_once.beespace_guidance_contracts, "<i4")
        ]
        self.reason: NDArray[np.str_] = _reasons[numbers(at_once.beespace_guidance_reasons, "<i4")]
        self.certified: NDArray[np.bool_] = numbers(at_once.beespace_guidance_certified, "|b1")
        self.keeps_apart: NDArray[np.bool_] = numbers(
            at_once.beespace_guidance_keeps_apart, "|b1"
        )
        self.clear_of_intruders: NDArray[np.bool_] = numbers(
            at_once.beespace_guidance_clear_of_intruders, "|b1"
        )
        self.kind: NDArray[np.str_] = kinds_of(numbers(at_once.beespace_guidance_kinds, "<i4"))
        self.commanded: NDArray[np.bool_] = numbers(at_once.beespace_guidance_commanded, "|b1")
        self.branches: NDArray[np.int32] = numbers(at_once.beespace_guidance_branches, "<i4")
        self.positions: NDArray[np.float64] = numbers(
            at_once.beespace_guidance_positions, "<f8", 3
        ).reshape(size, 3)
        self.velocities: NDArray[np.float64] = numbers(
            at_once.beespace_guidance_velocities, "<f8", 3
        ).reshape(size, 3)
        self.tube: NDArray[np.float64] = numbers(at_once.beespace_guidance_tubes_m, "<f8")
        self.deviation: NDArray[np.float64] = numbers(at_once.beespace_guidance_deviations_m, "<f8")
        self.too_close = findings(_advice.TOO_CLOSE)
        self.near_obstacle = findings(_advice.NEAR_OBSTACLE)
        self.near_fence = findings(_advice.NEAR_FENCE)
        self.intruder_conflicts = findings(_advice.INTRUDER_CONFLICTS)

    def __len__(self) -> int:
        return len(self.agents)

    def __repr__(self) -> str:
        certified = int(self.certified.sum())
        parts = [f"tick {self.tick}, {plural(len(self), 'agent')}, {certified:,} certified"]
        for contract in ("doubted", "out"):
            count = int((self.contract == contract).sum())
            if count:
                parts.append(f"{count:,} {contract}")
        if self.commands:
            parts.append(plural(len(self.commands), "command"))
        for found, what in (
            (self.too_close, "too close"),
            (self.near_obstacle, "near obstacles"),
            (self.near_fence, "near fences"),
            (self.intruder_conflicts, "with intruders"),
        ):
            if len(found):
                parts.append(f"{len(found):,} {what}")
        return f"<Guidance: {'; '.join(parts)}>"

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array of one entry an agent by its name; positions and velocities by axis.

        Examples
        --------
        >>> import beespace
        >>> guide = beespace.Guide(3, max_speed=6, max_acceleration=4)
        >>> joined = guide.join(7, [0, 0, 30])
        >>> list(guide.step(1).columns())[:5]
        ['agent', 'contract', 'reason', 'certified', 'keeps_apart']
        """
        return {
            "agent": self.agents,
            "contract": self.contract,
            "reason": self.reason,
            "certified": self.certified,
            "keeps_apart": self.keeps_apart,
            "clear_of_intruders": self.clear_of_intruders,
            "kind": self.kind,
            "commanded": self.commanded,
            "branches": self.branches,
            **dict(zip("xyz", self.positions.T)),
            **{f"v{axis}": speeds for axis, speeds in zip("xyz", self.velocities.T)},
            "tube": self.tube,
            "deviation": self.deviation,
        }
