"""Movers that fly straight on: when are they closest, and which come too close?"""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np

from beespace import _library
from beespace._answers import Pairs
from beespace._asking import Asking
from beespace._calls import check, run_of, search_of, seconds
from beespace._columns import Result
from beespace._conflicts import Approaches, Conflicts
from beespace._errors import invalid
from beespace._frames import check_upright
from beespace._library import library
from beespace._points import Points, PointsLike

# As far ahead as the library looks: some 4e22 years.
_for_ever = 2.0**100


class Predictions(Asking):
    """The questions about movers that an engine answers, too."""

    __slots__ = ()

    def predict(
        self,
        positions: PointsLike,
        velocities: PointsLike,
        threshold: float,
        *,
        within: float,
        vertical: float | None = None,
        inclusive: bool = False,
        max_results: int | None = None,
        threads: int = 1,
        copy: bool = False,
    ) -> Conflicts:
        """Which movers come closer than the threshold to each other, when, and how close?

        Each moves on in a straight line at constant velocity. No pair is missed, however fast; which
        pairs there are is decided as real numbers, so that a pass at exactly the threshold is none.
        Times and distances are rounded, for reading. Of positions and velocities, less than 2**-100
        counts as 0, and more than 2**100 is an error.

        Parameters
        ----------
        positions : array of shape (n, 3) or (n, 2), tuple of arrays, or data frame
            Where the movers are, in metres.
        velocities : as positions
            Their velocities in metres per second, along the axes of the positions.
        threshold, vertical, inclusive, threads, copy
            As `at_risk` says.
        within : float
            How far to look ahead, in seconds.
        max_results : int, optional
            More pairs than this are an error, "too_many_results". An answer is never cut.

        Returns
        -------
        Conflicts
            Each pair once, with ``i < j``. `begin` is 0 where they are too close already, `end` is
            `within` where they still are then.

        Examples
        --------
        >>> import beespace
        >>> positions = [[0, 0, 50], [100, 0, 50], [0, 300, 50]]
        >>> velocities = [[5, 0, 0], [-5, 0, 0], [0, 0, 0]]
        >>> conflicts = beespace.predict(positions, velocities, 20, within=60)
        >>> conflicts
        <Conflicts: 1 conflict of 3 movers, from 8 to 12 s, closest 0 and 1: 0 m at 10 s>
        >>> conflicts.begin, conflicts.end
        (array([8.]), array([12.]))
        """
        search = search_of(threshold, vertical, inclusive, max_results)
        result, count = self._predict(
            library.beespace_predict, positions, velocities, search, vertical, within, threads, copy
        )
        return conflicts_of(result, count)

    def predict_pairs(
        self,
        positions: PointsLike,
        velocities: PointsLike,
        threshold: float,
        *,
        within: float,
        vertical: float | None = None,
        inclusive: bool = False,
        max_results: int | None = None,
        threads: int = 1,
        copy: bool = False,
    ) -> Pairs:
        """Which movers come closer than the threshold to each other?

        The pairs of `predict`, without when and how close: over a short time little more work than
        `pairs`.

        Parameters
        ----------
        positions, velocities, threshold, within, vertical, inclusive, max_results, threads, copy
            As of `predict`.

        Returns
        -------
        Pairs
            Each pair once, with ``i < j``; without distances.

        Examples
        --------
        >>> import beespace
        >>> beespace.predict_pairs([[0, 0], [100, 0]], [[5, 0], [-5, 0]], 20, within=8.5)
        <Pairs: 1 pair of 2 points>
        """
        search = search_of(threshold, vertical, inclusive, max_results)
        result, count = self._predict(
            library.beespace_predict_pairs,
            positions,
            velocities,
            search,
            vertical,
            within,
            threads,
            copy,
        )
        return Pairs(result.first(), result.second(), None, (count, count), False)

    def _predict(
        self,
        function: Any,
        positions: Any,
        velocities: Any,
        search: _library.CSearch,
        vertical: Any,
        within: Any,
        threads: int,
        copy: bool,
    ) -> tuple[Result, int]:
        places, speeds = movers_of(positions, velocities, "positions", "velocities", copy)
        check_upright(places, vertical, "vertical")
        error = _library.new_error()
        result = Result()
        run = run_of(threads, places.count, moving=True)
        code = self._call(
            function,
            (
                ctypes.byref(places.struct),
                ctypes.byref(speeds.struct),
                ctypes.byref(search),
                seconds(within, "within"),
                None if run is None else ctypes.byref(run),
                result.handle,
                ctypes.byref(error),
            ),
        )
        check(code, error, {"": "within"})
        return result, places.count


def closest_approach(
    positions: PointsLike,
    velocities: PointsLike,
    other_positions: PointsLike,
    other_velocities: PointsLike,
    *,
    within: float | None = None,
    threshold: float | None = None,
    vertical: float | None = None,
    inclusive: bool = False,
    copy: bool = False,
) -> Approaches:
    """When are two movers closest, and how close? Of many twos: each mover and its other one.

    Each moves on in a straight line at constant velocity. The air traffic literature calls that
    instant the closest point of approach (CPA).

    Parameters
    ----------
    positions : array of shape (n, 3) or (n, 2), tuple of arrays, data frame, or one position
        Where the movers are, in metres. One position, or an array of one, serves for all.
    velocities : as positions
        Their velocities in metres per second.
    other_positions, other_velocities : as positions
        Those of the other movers.
    within : float, optional
        How far to look ahead, in seconds; without it for ever.
    threshold : float, optional
        How close is too close, in metres: then `begin` and `end` say from when to when the two are.
        That they are is decided as real numbers; the times are rounded, for reading.
    vertical, inclusive
        As `at_risk` says, of the threshold.
    copy : bool
        Whether arrays are copied first, because another thread changes them meanwhile.

    Returns
    -------
    Approaches
        An entry for each two.

    Examples
    --------
    >>> import beespace
    >>> found = beespace.closest_approach([0, 0], [5, 0], [100, 30], [-5, 0], threshold=50)
    >>> found
    <Approaches: 1 approach, 1 in conflict, closest 30 m at 10 s>
    >>> found.begin, found.end
    (array([6.]), array([14.]))
    """
    search = None
    if threshold is not None:
        search = search_of(threshold, vertical, inclusive)
    elif vertical is not None or inclusive:
        raise invalid(
            "this needs a threshold", "vertical" if vertical is not None else "inclusive"
        )
    given = [
        *movers_of(rows_of(positions), rows_of(velocities), "positions", "velocities", copy, True),
        *movers_of(
            rows_of(other_positions),
            rows_of(other_velocities),
            "other_positions",
            "other_velocities",
            copy,
            True,
        ),
    ]
    places = ("positions", "velocities", "other_positions", "other_velocities")
    given[2].check_alike(given[0], "other_positions", "positions")
    for each in (given[0], given[2]):
        check_upright(each, vertical, "vertical")
    count = spread(list(zip(given, places)))
    error = _library.new_error()
    result = Result()
    run = run_of(1, count)
    code = library.beespace_closest_approach(
        *(ctypes.byref(each.struct) for each in given),
        None if search is None else ctypes.byref(search),
        _for_ever if within is None else seconds(within, "within"),
        None if run is None else ctypes.byref(run),
        result.handle,
        ctypes.byref(error),
    )
    check(code, error, {"": "within"})
    return Approaches(
        result.closest_times(),
        result.distances(),
        None if search is None else result.begins(),
        None if search is None else result.ends(),
    )


def conflicts_of(result: Result, count: int) -> Conflicts:
    """The columns of a result that has conflicts."""
    return Conflicts(
        result.first(),
        result.second(),
        result.begins(),
        result.ends(),
        result.closest_times(),
        result.distances(),
        count,
    )


def movers_of(
    positions: Any,
    velocities: Any,
    positions_name: str,
    velocities_name: str,
    copy: bool,
    one_for_all: bool = False,
) -> tuple[Points, Points]:
    places = Points(positions, positions_name, copy)
    speeds = Points(velocities, velocities_name, copy)
    speeds.check_alike(places, velocities_name, "positions")
    if places.count != speeds.count and not (one_for_all and 1 in (places.count, speeds.count)):
        raise invalid(
            f"there are {speeds.count:,} velocities for {places.count:,} positions", velocities_name
        )
    return places, speeds


def rows_of(given: Any) -> Any:
    """One position as a list of one: what it says of units and masks is still to be heard."""
    if isinstance(given, _SEQUENCES):
        return [given] if given and np.ndim(given[0]) == 0 else given
    return [given] if getattr(given, "ndim", 0) == 1 and len(given) else given


_SEQUENCES: Any = (list, tuple)


def spread(given: list[tuple[Points, str]]) -> int:
    """Repeats what there is one of; says how many there are."""
    count = next((points.count for points, _ in given if points.count != 1), 1)
    for points, place in given:
        if points.count not in (1, count):
            raise invalid(f"there are {points.count:,} here and {count:,} elsewhere", place)
        if points.count == 1:
            struct = points.struct
            struct.count = count
            struct.x_stride = struct.y_stride = struct.z_stride = 0
    return count
