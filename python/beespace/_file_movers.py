"""Where the agents of a file are at its last time, and how fast they fly."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace import _io_library
from beespace._calls import seconds
from beespace._file_columns import converted
from beespace._placed_array import placed
from beespace._tables import plural


class FileMovers:
    """Where all agents of a recording are at its last time, and how fast they fly: what
    `FileRecording.movers` gives, for `predict`. They are its positions, too:
    ``beespace.predict(movers, movers.velocities, 50, within=60)``. Rows are agents of the recording,
    so `i` and `j` of an answer are indices of `ids`.

    Attributes
    ----------
    time : float
        The last time of the recording, in seconds.
    ids : ndarray of str objects, shape (a,)
        What the file calls each agent.
    positions : ndarray of float64, shape (a, 3)
        Metres; of degrees those of ECEF, whose z is not a height. An agent that was last heard of
        before `time` is brought there in a straight line, where it is `known` how fast it flies;
        otherwise this is where it was last heard of, NaN of one that has no fix.
    velocities : ndarray of float64, shape (a, 3)
        Metres per second, along the axes of the positions; NaN where they are not `known`, which
        `predict` refuses.
    known : ndarray of bool, shape (a,)
        Whether it is known where each is and how fast it flies. Who leaves the others out asks about
        those that are known: no conflict does not mean that there is none with the others.
    estimated : ndarray of bool, shape (a,)
        Whether the velocity is that of the last two fixes, as the last one has none. Of aircraft the
        climb rate alone may be, of the last seconds, as their heights go in steps.
    stale : ndarray of bool, shape (a,)
        Whether it was last heard of longer ago than `max_age`.
    frame : str
        "wgs84": longitude and latitude in degrees, which became metres; or "metres".

    Examples
    --------
    >>> import beespace
    >>> now = beespace.read_recording("../examples/data/swarm.csv").movers()
    >>> now
    <FileMovers: 5 agents at 0 s, metres>
    >>> now.velocities[0]
    array([8., 0., 0.])
    """

    __slots__ = ("estimated", "frame", "ids", "known", "positions", "stale", "time", "velocities")

    def __init__(
        self, recording: ctypes.c_void_p, ids: NDArray[Any], frame: str, max_age: float
    ) -> None:
        self.ids = ids
        self.frame = frame
        self.positions: NDArray[np.float64] = placed(np.empty((len(ids), 3)), frame)
        self.velocities: NDArray[np.float64] = np.empty((len(ids), 3))
        how = np.empty(len(ids), np.uint8)
        time = ctypes.c_double()
        error = _io_library.new_error()
        code = _io_library.load().unlocked.beespace_io_recording_movers(
            recording,
            seconds(max_age, "max_age"),
            self.positions.ctypes.data,
            self.velocities.ctypes.data,
            how.ctypes.data,
            ctypes.byref(time),
            ctypes.byref(error),
        )
        _io_library.check(code, error)
        self.time = time.value
        self.known: NDArray[np.bool_] = how >= _io_library.ESTIMATED
        self.estimated: NDArray[np.bool_] = how == _io_library.ESTIMATED
        self.stale: NDArray[np.bool_] = how == _io_library.STALE

    def __len__(self) -> int:
        return len(self.ids)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return converted(self.positions, dtype, copy)

    def __repr__(self) -> str:
        told = f"{plural(len(self), 'agent')} at {self.time:.17g} s, {self.frame}"
        estimated, stale = np.count_nonzero(self.estimated), np.count_nonzero(self.stale)
        unknown = len(self) - np.count_nonzero(self.known) - stale
        if estimated:
            told += f"; the velocity of {estimated:,} is that of the last fixes"
        if stale:
            told += f"; {stale:,} stale"
        if unknown:
            told += f"; of {unknown:,} no velocity is known"
        return f"<FileMovers: {told}>"
