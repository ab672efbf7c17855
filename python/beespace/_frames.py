"""In which frame points are, where they say so: those of files do."""

from __future__ import annotations

from typing import Any

from beespace._errors import invalid


def check_frames(points: Any, others: Any, vertical: Any) -> None:
    """Refuses questions that make no sense in the frames of the points."""
    frames = [_frame_of(points), _frame_of(others)]
    if vertical is not None and "wgs84" in frames:
        raise invalid(
            "these points were longitudes and latitudes, and z of their positions is not a height: "
            "ask without vertical, or ask the command, beespace detect --vertical, about the file",
            "vertical",
        )
    if None not in frames and frames[0] != frames[1]:
        raise invalid(
            f"the points are in {frames[0]} and these in {frames[1]}: say with frame= of read what "
            "both are",
            "others",
        )


def _frame_of(points: Any) -> str | None:
    frame = getattr(points, "frame", None)
    return frame if isinstance(frame, str) else None
