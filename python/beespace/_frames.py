"""In which frame positions are, where they say so, and how many axes they have: those that are
compared are alike."""

from __future__ import annotations

from typing import Any, Protocol

from beespace._errors import invalid

DEGREES = "wgs84"


class Described(Protocol):
    """What has a number of axes and a frame; None of either where it is not known."""

    @property
    def axes(self) -> int | None: ...
    @property
    def frame(self) -> str | None: ...


class Known:
    """The axes and the frame of all positions that something has been given, as far as they say."""

    __slots__ = ("axes", "frame")

    def __init__(self, axes: int | None = None, frame: str | None = None) -> None:
        self.axes = axes
        self.frame = frame

    def take(self, given: Described) -> None:
        """Remembers these, too. What says nothing takes nothing away."""
        self.axes = self.axes or given.axes
        self.frame = self.frame or given.frame

    def forget(self) -> None:
        self.axes = self.frame = None


def frame_of(given: Any) -> str | None:
    """The frame that points say they are in: those of files do."""
    frame = getattr(given, "frame", None)
    return frame if isinstance(frame, str) else None


def check_alike(given: Described, others: Described, place: str, of: str) -> None:
    """Refuses positions that have another number of axes than those that they are compared with, as
    heights of 0 would be made up; and those of another frame, which are anywhere in it."""
    if None not in (others.axes, given.axes) and others.axes != given.axes:
        raise invalid(
            f"these have {given.axes} axes, and the {of} {others.axes}: give all of them heights, or none",
            place,
        )
    if None not in (others.frame, given.frame) and others.frame != given.frame:
        raise invalid(
            f"the {of} are in {others.frame} and these in {given.frame}: say with frame= of read what "
            "both are",
            place,
        )


def check_upright(given: Described, asked: object, place: str) -> None:
    """Refuses a question that takes z for the height, about points whose z is none."""
    if asked is None or asked is False or given.frame != DEGREES:
        return
    raise invalid(
        "these points were longitudes and latitudes, and z of their positions is not a height: "
        f"ask without {place}; or give heights apart (OutOfCore, Recording and Swarm take them); or "
        "ask the command, beespace detect --vertical, about the file",
        place,
    )
