"""Of how much of a recording it is known where its agents were."""

from __future__ import annotations

import ctypes
import math
from typing import Any

from beespace import _io_library


class Coverage:
    """Of how much of a recording of a file it is known where its agents were: what an answer about it
    is about. An agent is unknown in gaps between fixes, before its first and after its last one, and in
    records that were left out. It is what the command says as `known`.

    Attributes
    ----------
    complete : bool
        Whether it is known all the time where all agents were.
    may_hide_conflicts : bool
        Whether an agent was there, but it is not known where: that no conflict was found is then no
        all-clear.
    unknown : str
        What is not known, in words; empty where all is.
    max_gap : float
        Fixes farther apart in time, in seconds, were taken for a gap; infinity: none were.
    typical_interval : float or None
        The interval in seconds that this comes from; None where it was given, or there is none.
    gap_count, agents_with_gaps : int
        How many gaps there are, and how many agents have one.
    in_gaps : float
        How long they are, in seconds, summed over the agents.
    agents_partly_known : int
        Of how many agents the first fix is later, or the last one earlier, than those of others.
    agents_cut_off : int
        Of these: in the air then.
    agents_on_ground : int
        Of those that are partly known: on the ground by all their records, which do not reach as
        far as others fly.
    agents_alone : int
        How many drones fly while no other is known, and are compared with none.
    agents_unplaced : int
        Of those that are partly known: there then, in records without a place.
    outside : float
        How long that is, in seconds, summed over the agents.
    missing_count : int
        How many records were left out: as `FileRecording.missing_count`.
    missing_without_id, missing_agents, nowhere_count : int
        Of how many of these it is not known whose they are, of how many agents the others are, and
        how many of these agents have no known place at all.
    shared_id_count : int
        How many ids seem to be of two agents each, which are at two places in turn.
    file_count : int
        How many files and folders beside those that were read were left out.
    jumping_count : int
        How many agents jump faster than anything flies, or than they say.
    swapped_count : int
        Of how many agents longitude and latitude seem to be the other way round.
    untimed_count : int
        Of how many agents it is not known when they were where they say: their clocks do not go on
        as that of the log.
    rough_count : int
        How many agents have places that are off by kilometres, as those of Argos are, or that are
        written with so few decimals that some may be closer than the threshold after all.

    Examples
    --------
    >>> import beespace
    >>> cage = beespace.read_recording("../examples/data/cage.csv")
    >>> cage.coverage()
    <Coverage: 1 bee unknown for 4 s in all>
    >>> cage.coverage(max_gap=5)
    <Coverage: complete>
    """

    __slots__ = (
        "agents_alone",
        "agents_cut_off",
        "agents_on_ground",
        "agents_partly_known",
        "agents_unplaced",
        "agents_with_gaps",
        "beside_gaps",
        "complete",
        "file_count",
        "gap_count",
        "in_gaps",
        "jumping_count",
        "max_gap",
        "may_hide_conflicts",
        "missing_agents",
        "missing_count",
        "missing_without_id",
        "nowhere_count",
        "outside",
        "rough_count",
        "shared_id_count",
        "swapped_count",
        "typical_interval",
        "unknown",
        "untimed_count",
    )

    def __init__(self, get: Any, *arguments: Any) -> None:
        """Of what a function of the library gives for these arguments."""
        found = _io_library.CCoverage(ctypes.sizeof(_io_library.CCoverage))
        error = _io_library.new_error()
        code = get(*arguments, ctypes.byref(found), ctypes.byref(error))
        _io_library.check(code, error)
        self.complete = bool(found.complete)
        self.may_hide_conflicts = bool(found.may_hide)
        self.max_gap = float(found.max_gap_s)
        typical = float(found.typical_interval_s)
        self.typical_interval = None if math.isnan(typical) else typical
        self.gap_count, self.agents_with_gaps = int(found.gaps), int(found.agents_with_gaps)
        self.in_gaps = float(found.in_gaps_s)
        self.agents_partly_known = int(found.agents_partly)
        self.agents_cut_off = int(found.agents_cut_off)
        self.outside = float(found.outside_s)
        self.missing_count = int(found.missing)
        self.missing_without_id = int(found.missing_without_id)
        self.missing_agents = int(found.missing_agents)
        self.nowhere_count = int(found.nowhere)
        self.shared_id_count = int(found.shared_ids)
        self.file_count = int(found.files)
        self.jumping_count = int(found.jumping)
        self.swapped_count = int(found.swapped)
        self.untimed_count = int(found.untimed)
        self.rough_count = int(found.rough)
        self.agents_unplaced = int(found.agents_unplaced)
        self.agents_on_ground = int(found.agents_on_ground)
        self.agents_alone = int(found.agents_alone)
        self.unknown = _text_of(found)
        found.gaps = 0
        self.beside_gaps = _text_of(found)

    def __repr__(self) -> str:
        return f"<Coverage: {self.unknown or 'complete'}>"


def _text_of(found: _io_library.CCoverage) -> str:
    write = _io_library.load().at_once.beespace_io_coverage_text
    text = ctypes.create_string_buffer(write(ctypes.byref(found), None, 0) + 1)
    write(ctypes.byref(found), text, len(text))
    return text.value.decode(errors="replace")
