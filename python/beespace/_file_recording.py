"""A recording out of a file."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace import _io_library
from beespace._checks import gap_of
from beespace._coverage import Coverage
from beespace._file_columns import array_of, text_of, texts_of
from beespace._file_conflicts import FileConflicts, conflicts_of
from beespace._file_facts import Facts
from beespace._file_movers import FileMovers
from beespace._file_verify import verify_recording
from beespace._flight_verdict import FlightVerdict
from beespace._obstacles import Obstacles
from beespace._placed_array import placed


class FileRecording(Facts):
    """The recording of a file, as `read_recording` gives it: fixes in columns, agent by agent, those
    of each in ascending order of time.

    Besides the attributes of what the file was taken for (`frame`, `notes`, ...) it has these:

    Attributes
    ----------
    ids : ndarray of str objects, shape (a,)
        What the file calls each agent.
    labels : tuple of str
        What each is called beside that, as the flight of an aircraft; or empty.
    indptr : ndarray of int64, shape (a + 1,)
        The fixes of agent a are ``indptr[a]`` to ``indptr[a + 1] - 1``.
    agents : ndarray of int64, shape (n,)
        Whose each fix is: an index of `ids`.
    times : ndarray of float64, shape (n,)
        Seconds: since 1970 in UTC where `since_1970`, otherwise from a zero of the file's.
    positions : ndarray of float64, shape (n, 3)
        Metres; of degrees those of ECEF, whose z is not a height. Rows of it know the frame, too.
    velocities : ndarray of float64, shape (n, 3), or None
        Metres per second, along the axes of the positions, whatever the file has: speed, track and
        climb rate, too. All three are NaN where that of a fix is not known as a whole; None where no
        fix has one.
    degrees : ndarray of float64, shape (n, 3), or None
        Longitude and latitude in degrees and the height in metres; None of those in metres.
    since_1970 : bool
        Whether times are seconds since 1970.
    missing_count : int
        How many records are left out since their place, height or time is missing or bad. No
        conflict does not mean that there is none with these: `coverage` says what else is not known.

    The arrays are read-only, and not copied.

    Examples
    --------
    >>> import beespace
    >>> cage = beespace.read_recording("../examples/data/cage.csv")
    >>> cage.ids[:3].tolist(), cage.times[:3]
    (['b01', 'b02', 'b03'], array([0. , 0.2, 0.4]))
    """

    __slots__ = ("_handle", "_sizes", "ids", "labels", "missing_count", "since_1970")

    def __init__(self, path: str, handle: ctypes.c_void_p) -> None:
        at_once = _io_library.load().at_once
        self._handle = handle
        agents = int(at_once.beespace_io_recording_agents(handle))
        self._sizes = agents, int(at_once.beespace_io_recording_fixes(handle))
        self._take(path, at_once.beespace_io_recording_facts(handle))
        ids = texts_of(at_once.beespace_io_recording_ids, handle, agents)
        self.ids: NDArray[Any] = np.empty(0, object) if ids is None else ids
        self.labels = tuple(
            text_of(at_once.beespace_io_recording_label(handle, each)) for each in range(agents)
        )
        self.since_1970 = bool(at_once.beespace_io_recording_since_1970(handle))
        self.missing_count = int(at_once.beespace_io_recording_missing(handle))

    def __len__(self) -> int:
        return self._sizes[1]

    def _column(self, name: str, shape: tuple[int, ...], dtype: Any) -> NDArray[Any]:
        get = getattr(_io_library.load().at_once, f"beespace_io_recording_{name}")
        return array_of(self._handle, get(self._handle), shape, dtype)

    @property
    def indptr(self) -> NDArray[np.int64]:
        return self._column("offsets", (self._sizes[0] + 1,), np.int64)

    @property
    def agents(self) -> NDArray[np.int64]:
        return self._column("agent", (len(self),), np.int64)

    @property
    def times(self) -> NDArray[np.float64]:
        return self._column("times_s", (len(self),), np.float64)

    @property
    def positions(self) -> NDArray[np.float64]:
        return placed(self._column("xyz", (len(self), 3), np.float64), self.frame)

    @property
    def velocities(self) -> NDArray[np.float64] | None:
        address = _io_library.load().at_once.beespace_io_recording_velocities(self._handle)
        if address is None:
            return None
        return array_of(self._handle, address, (len(self), 3), np.float64)

    @property
    def degrees(self) -> NDArray[np.float64] | None:
        if self.frame != "wgs84":
            return None
        return self._column("degrees", (len(self), 3), np.float64)

    def movers(self, *, max_age: float = 30.0) -> FileMovers:
        """Where all agents are at the last time of the recording, and how fast they fly: what is
        about to happen is a question of `predict`.

        An agent without a velocity has that of its last two fixes; one that was last heard of before
        is brought to that time in a straight line. This is what the command `beespace predict` takes.

        Parameters
        ----------
        max_age : float
            Of an agent that was last heard of longer ago than this, in seconds, or whose last two
            fixes are farther apart where it has no velocity, it is not known where it goes: its
            velocity is NaN, which `predict` refuses.

        Returns
        -------
        FileMovers

        Raises
        ------
        BeespaceFileError
            "missing_column" where it is known of no agent how fast it flies; "unsupported_format" of
            drone shows, whose curves say where each is.

        Examples
        --------
        >>> import beespace
        >>> now = beespace.read_recording("../examples/data/swarm.csv").movers()
        >>> conflicts = beespace.predict(now, now.velocities, 5, within=60)
        >>> for i, j, begin in zip(now.ids[conflicts.i], now.ids[conflicts.j], conflicts.begin):
        ...     print(f"{i} and {j} in {begin:.1f} s")
        anna and bert in 0.9 s
        anna and cora in 6.9 s
        anna and dora in 7.2 s
        cora and dora in 0.0 s
        """
        return FileMovers(self._handle, self.ids, self.frame, max_age)

    def coverage(self, *, max_gap: float | None = None) -> Coverage:
        """Of how much of the recording is it known where its agents were?

        Parameters
        ----------
        max_gap : float, optional
            Fixes farther apart in time, in seconds, are a gap: without it those that are five times as
            far apart as is typical. Shows have none.

        Returns
        -------
        Coverage

        Examples
        --------
        >>> import beespace
        >>> cage = beespace.read_recording("../examples/data/cage.csv")
        >>> cage.coverage().max_gap, cage.coverage().unknown
        (1.0, '1 bee unknown for 4 s in all')
        """
        longest = 0.0 if max_gap is None else gap_of(max_gap)
        get = _io_library.load().at_once.beespace_io_recording_coverage
        return Coverage(get, self._handle, longest)

    def conflicts(
        self,
        threshold: float | None = None,
        *,
        vertical: float | str | None = None,
        inclusive: bool = False,
        max_gap: float | None = None,
        straight: bool = False,
        ignore_below: float | None = None,
        max_results: int | None = None,
        threads: int = 1,
    ) -> FileConflicts:
        """Which agents came closer than the threshold to each other, and when? Is that an all-clear?

        This is what the command `beespace replay` says: along straight lines from fix to fix; along
        the curves of a show, also with drones that stand on the ground; and, as possible conflicts,
        along curves that have the velocities of the fixes. `Recording.from_file` looks along straight
        lines only.

        Parameters
        ----------
        threshold : float, optional
            How close is too close, in metres; without it what the show declares, else 2 m. Of what is
            no show it must be given.
        vertical : float or str, optional
            A vertical threshold, in metres, or a text with its unit: "1000ft". The threshold is then
            horizontal. Heights of degrees are compared with it as the file has them.
        inclusive : bool
            Whether exactly the threshold apart counts as closer.
        max_gap
            As of `coverage`. In a gap an agent is compared with none.
        straight : bool
            Whether agents fly in straight lines whatever velocities they have.
        ignore_below : float, optional
            Conflicts of two that are both lower than this, in metres, above where they took off are
            left out, and counted, as in a take-off grid; without it none is.
        max_results : int, optional
            More conflicts than this are an error, "too_many_results". An answer is never cut.
        threads : int
            How many threads may work; 0: one for each processor. The answer is always the same.

        Returns
        -------
        FileConflicts
            Whose `risky` is False where it is an all-clear.

        Raises
        ------
        BeespaceFileError
            "invalid_threshold" where there is none; "too_many_results".

        Examples
        --------
        >>> import beespace
        >>> show = beespace.read_recording("../examples/data/show.skyc")
        >>> found = show.conflicts(6)
        >>> len(found), found.risky, found.closest.i, found.closest.j
        (16, True, 'drone 02', 'drone 03')
        >>> show.conflicts(4)
        <FileConflicts: 0 conflicts of 12 agents; what is known is an all-clear>
        """
        return conflicts_of(
            self,
            threshold,
            vertical,
            inclusive,
            max_gap,
            straight,
            ignore_below,
            max_results,
            threads,
        )

    def verify(
        self,
        threshold: float | None = None,
        *,
        max_speed: float | None = None,
        max_horizontal: float | None = None,
        max_climb: float | None = None,
        max_descent: float | None = None,
        max_acceleration: float | None = None,
        max_height: float | None = None,
        obstacles: Obstacles | None = None,
        clearance: float | None = None,
        max_gap: float | None = None,
        straight: bool = False,
        skip_limits: Iterable[str] = (),
        ignore_below: float | None = None,
        threads: int = 1,
    ) -> FlightVerdict:
        """Did all keep apart, clear of obstacles and within their limits, each with times of its own?

        Drones of a show fly along its curves, and these are looked at, not `positions` on them; others
        on the curves that have the velocities of their fixes, or in straight lines where not all fixes
        have one. This is what the command `beespace verify` says of shows. Recordings in degrees, as logs
        of drones, are looked at in straight lines, and along curves with the velocities that there are.

        Parameters
        ----------
        threshold : float, optional
            How close is too close, in metres; without it what the show declares, else 2 m. Of what is
            no show it must be given.
        max_speed, max_horizontal, max_climb, max_descent : float, optional
            The limits of each agent, in metres per second; max_climb and max_descent up and down.
        max_acceleration : float, optional
            In metres per second squared. Where a path turns at a point, the acceleration is that which
            turns within half of the pieces beside it, and within 0.5 m of the path.
        max_height : float, optional
            Of z, in metres. Of limits that are not given those count that the show declares; infinity
            for none.
        obstacles, clearance
            As of `Verifier`.
        max_gap : float, optional
            Fixes farther apart in time, in seconds, are a gap: without it those that are five times as
            far apart as is typical. Shows have none.
        straight : bool
            Whether agents fly in straight lines whatever velocities they have.
        skip_limits : names of limits
            Those that the show declares and that need not be looked at where that is not done, as
            ["minNavAltitude"]; without it such a show does not hold.
        ignore_below : float, optional
            As of `conflicts`, of losses of separation.
        threads : int
            How many threads may work; 0: one for each processor. The verdict is always the same.

        Returns
        -------
        FlightVerdict

        Raises
        ------
        BeespaceFileError
            "unknown_frame" of obstacles beside degrees; "missing_column" where an acceleration is limited
            and velocities are missing; "unsupported_format" of an agent with a single fix.

        Examples
        --------
        >>> import beespace
        >>> show = beespace.read_recording("../examples/data/show.skyc")
        >>> show.verify(0.5, max_speed=100, max_height=1000).holds
        True
        """
        limits = {
            "max_speed": max_speed,
            "max_horizontal": max_horizontal,
            "max_climb": max_climb,
            "max_descent": max_descent,
            "max_acceleration": max_acceleration,
            "max_height": max_height,
        }
        return verify_recording(
            self,
            threshold,
            limits,
            obstacles,
            clearance,
            max_gap,
            straight,
            skip_limits,
            ignore_below,
            threads,
        )

    @property
    def is_show(self) -> bool:
        """For the package's own use: whether it has curves."""
        return bool(_io_library.load().at_once.beespace_io_recording_is_show(self._handle))

    @property
    def handle(self) -> ctypes.c_void_p:
        """For the package's own use."""
        return self._handle

    def __repr__(self) -> str:
        agents, fixes = self._sizes
        return (
            f"<FileRecording: {fixes:,} {'fix' if fixes == 1 else 'fixes'} of {agents:,} "
            f"{'agent' if agents == 1 else 'agents'}{self._said()}>"
        )
