"""How points and recordings are read from files."""

from __future__ import annotations

import ctypes
import math
import os
from collections.abc import Iterable, Sequence
from typing import Any

from beespace import _io_library, _library
from beespace._calls import number_of, whole
from beespace._file_points import FilePoints
from beespace._file_recording import FileRecording
from beespace._errors import invalid
from beespace._ranges import above_zero
from beespace._units import METRES

PathLike = str | bytes | os.PathLike[str] | os.PathLike[bytes]


def read(
    path: PathLike,
    *,
    frame: str | None = None,
    columns: str | None = None,
    units: str | None = None,
    heights: str | None = None,
    format: str | None = None,
    skip_bad: bool = False,
    threads: int = 1,
) -> FilePoints:
    """Reads points from a file: a table of text, an array of NumPy (.npy) or raw doubles (.bin), each
    plain or gzip-compressed.

    Nothing is guessed: where the file does not say whether it holds degrees or metres, or in which
    unit, that is an error which says how to say it. A recording is an error, too, as each fix would
    count as a point: that is for `read_recording`.

    Parameters
    ----------
    path : str or path
        The file. "-" is a file of that name; standard input is "/dev/stdin".
    frame : {"wgs84", "metres"}, optional
        Whether coordinates are longitude and latitude in degrees, or metres.
    columns : str, optional
        Which columns of a table count, by number or name: "id=1,lon=2,lat=3,height=4".
    units : str, optional
        Units that the header does not name: "position=km,height=ft".
    heights : {"geometric", "pressure"}, optional
        Which heights count, of several.
    format : {"text", "npy", "bin"}, optional
        How the file is written, where its content does not tell.
    skip_bad : bool
        Whether bad records are left out and listed in `skipped`, instead of being an error.
    threads : int
        How many threads may read; 0 for one per processor.

    Returns
    -------
    FilePoints
        Positions in metres, ids, and what the file was taken for.

    Raises
    ------
    BeespaceFileError
        What is wrong with the file, with `file`, `line`, `column` and `record`.
    BeespaceOSError
        The same, and an OSError: the file is missing or cannot be read.
    ImportError
        This installation has no readers.

    Ctrl-C is heard when the file is read.

    Examples
    --------
    >>> import beespace
    >>> bees = beespace.read("../examples/data/swarm.csv")
    >>> bees.ids[beespace.at_risk(bees, 5)]
    array(['cora', 'dora'], dtype=object)
    """
    options = reading_options(
        skip_bad, False, threads, frame=frame, columns=columns, units=units, heights=heights,
        format=format,
    )
    error = _io_library.new_error()
    io = _io_library.load()
    handle = io.handles["points"]()
    code = io.unlocked.beespace_io_read_points(
        encoded_path(path), ctypes.byref(options), ctypes.byref(handle), ctypes.byref(error)
    )
    _io_library.check(code, error)
    return FilePoints(os.fsdecode(path), handle)


def read_recording(
    path: PathLike | Sequence[PathLike],
    *,
    frame: str | None = None,
    columns: str | None = None,
    units: str | None = None,
    heights: str | None = None,
    time_unit: str | None = None,
    one_clock: bool = False,
    time_zone: str | None = None,
    dates: str | None = None,
    fps: float | None = None,
    scale: str | None = None,
    least_likelihood: float | None = None,
    tolerance: float | None = None,
    skip_bad: bool = False,
    grounded: bool = False,
) -> FileRecording:
    """Reads a recording, which says where each of many agents was when: a table of fixes, or many; a
    drone show (.skyc); a MAVLink log (.tlog); PX4 logs (.ulg); DataFlash logs
    of ArduPilot (.bin); reports of aircraft.

    No fix is interpolated. Curves of drone shows become straight lines between fixes.

    Parameters
    ----------
    path : str or path, or a sequence of them
        A file or a folder; or files that are read as one recording.
    frame, columns, units, heights, skip_bad
        As in `read`; columns may have a time, "id=1,time=2,x=3,y=4,z=5".
    time_unit : {"s", "ms", "us", "ns"}, optional
        Of times, where the file does not say.
    one_clock : bool
        Of several files whose times do not say since when they count: whether all have one clock.
    time_zone : str, optional
        Of dates and times that name none: "UTC", "Europe/Madrid", "+02:00". Without it, such times
        count from a midnight of their clock, and `since_1970` is False.
    dates : {"day-first", "month-first"}, optional
        Of dates as 05/06/2024, where none of the column tells which number is the day.
    fps : float, optional
        Where a column counts the frames of a video: how many there are in a second.
    scale : str, optional
        Of positions in pixels, how long one is: "0.1mm".
    least_likelihood : float, optional
        Of tables of poses (DeepLabCut, SLEAP): places less likely than this, from 0 to 1, count as
        unknown; without it those less likely than 0.6.
    tolerance : float, optional
        Of shows, how far straight lines may be from the curve that they follow, in metres; without it
        0.001.
    grounded : bool
        Whether drones and aircraft on the ground count, too.

    Returns
    -------
    FileRecording
        Columns of agents, times and positions, ids, and what the file was taken for.

    Raises
    ------
    BeespaceFileError, BeespaceOSError, ImportError
        As `read`.

    Examples
    --------
    >>> import beespace
    >>> cage = beespace.read_recording("../examples/data/cage.csv")
    >>> cage.indptr[:2], cage.agents[:2]
    (array([  0, 101]), array([0, 0]))
    """
    options = reading_options(
        skip_bad, grounded, 1, one_clock=one_clock, frame=frame, columns=columns, units=units,
        heights=heights, time_unit=time_unit, time_zone=time_zone, dates=dates, scale=scale,
    )
    set_numbers(options, fps, least_likelihood, tolerance)
    paths = paths_of(path)
    error = _io_library.new_error()
    io = _io_library.load()
    handle = io.handles["recording"]()
    code = io.unlocked.beespace_io_read_recording(
        paths, len(paths), ctypes.byref(options), ctypes.byref(handle), ctypes.byref(error)
    )
    _io_library.check(code, error)
    return FileRecording(os.fsdecode(paths[0]), handle)


def paths_of(path: PathLike | Iterable[PathLike]) -> ctypes.Array[ctypes.c_char_p]:
    """One path, or several, as an array of C."""
    several = [path] if isinstance(path, (str, bytes, os.PathLike)) else list(path)
    return (ctypes.c_char_p * len(several))(*(encoded_path(each) for each in several))


def encoded_path(path: PathLike) -> bytes:
    encoded = os.fsencode(path)
    if b"\0" in encoded:
        raise ValueError("a path has no zero byte in it")
    return encoded


def set_numbers(
    options: _io_library.COptions,
    fps: float | None,
    least_likelihood: float | None,
    tolerance: float | None,
) -> None:
    """What is said of recordings in numbers."""
    if fps is not None:
        if not 0.0 < fps < math.inf:
            raise ValueError("fps is how many frames there are in a second, above 0")
        options.fps = float(fps)
    if least_likelihood is not None:
        least = number_of(least_likelihood, "least_likelihood", None)
        if not 0.0 <= least <= 1.0:
            raise invalid(f"this is a number from 0 to 1, and not {least:g}", "least_likelihood")
        options.least_likelihood = least
        if least == 0.0:  # which would be the default
            options.flags |= _io_library.ANY_LIKELIHOOD
    if tolerance is not None:
        options.tolerance_m = above_zero(number_of(tolerance, "tolerance", METRES), "tolerance")


def reading_options(
    skip_bad: bool, grounded: bool, threads: Any, *, one_clock: bool = False, **texts: str | None
) -> _io_library.COptions:
    options = _io_library.COptions(ctypes.sizeof(_io_library.COptions))
    if skip_bad:
        options.flags |= _io_library.SKIP_BAD
    if grounded:
        options.flags |= _io_library.GROUNDED
    if one_clock:
        options.flags |= _io_library.ONE_CLOCK
    number = whole(threads, "threads")
    options.threads = _library.ALL_PROCESSORS if number == 0 else min(number, 256)
    for name, text in texts.items():
        setattr(options, name, _io_library.encoded(text))
    return options
