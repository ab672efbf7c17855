"""What a file was taken for, and why."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any

from beespace import _io_library, _library
from beespace._errors import BeespaceFileError
from beespace._file_columns import text_of


class Facts:
    """What a file was taken for, and why: what people must be told who rely on an answer.

    Attributes
    ----------
    path : str
        The file as it was given; of several, the first.
    frame : str
        "wgs84": longitude and latitude in degrees, which became metres; or "metres".
    frame_reason : str
        Why it was taken for that.
    format : str
        How the file is written: "text, comma-separated".
    heights : str
        What heights are counted from: "above mean sea level"; empty where the file does not say.
    notes : tuple of str
        Which units were taken, and what else was decided.
    skipped : tuple of BeespaceFileError
        With `skip_bad`: why records were left out, of the first 20.
    skipped_count : int
        How many were. None at risk does not mean that none of these is.
    """

    __slots__ = (
        "format",
        "frame",
        "frame_reason",
        "heights",
        "notes",
        "path",
        "skipped",
        "skipped_count",
    )

    def _take(self, path: str, facts: Any) -> None:
        at_once = _io_library.load().at_once
        self.path = path
        self.frame = text_of(at_once.beespace_io_facts_frame(facts))
        self.frame_reason = text_of(at_once.beespace_io_facts_frame_reason(facts))
        self.format = text_of(at_once.beespace_io_facts_format(facts))
        self.heights = text_of(at_once.beespace_io_facts_heights(facts))
        notes = range(at_once.beespace_io_facts_note_count(facts))
        self.notes = tuple(text_of(at_once.beespace_io_facts_note(facts, each)) for each in notes)
        self.skipped_count = int(at_once.beespace_io_facts_skipped(facts))
        self.skipped: tuple[BeespaceFileError, ...] = tuple(_skipped(facts, self.skipped_count))

    def _said(self) -> str:
        """What comes after "3 points" where this is shown."""
        said = f" of {os.path.basename(self.path)!r}, {self.frame} ({self.frame_reason})"
        if self.skipped_count:
            records = "record" if self.skipped_count == 1 else "records"
            said += f"; {self.skipped_count:,} bad {records} left out"
        return said + "".join(f"\n  {note}" for note in self.notes)


def _skipped(facts: Any, count: int) -> Iterable[BeespaceFileError]:
    at_once = _io_library.load().at_once
    for each in range(count):
        error = _io_library.new_error()
        if at_once.beespace_io_facts_skipped_error(facts, each, error) == _library.OK:
            return  # only the first ones are kept
        yield _io_library.error_of(error)
