"""Points by id, for questions about any position."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace import _library
from beespace._answers import Nearest, Neighbors
from beespace._asking import nearest_of, neighbours_of
from beespace._calls import check, run_of, search_of, whole
from beespace._columns import Result
from beespace._fixes import numbers_of
from beespace._frames import Known, frame_of
from beespace._library import library
from beespace._points import Points, PointsLike, position
from beespace._units import METRES


class Index:
    """Which points are around any position, and which are nearest to it?

    Built once and asked often; points can be inserted, moved and removed. Some 80 nanoseconds and 50
    bytes a point to build. Any number of threads may ask at the same time; a thread that changes the
    points must be alone.

    Parameters
    ----------
    points : array of shape (n, 3) or (n, 2), tuple of arrays, or data frame
        Positions in metres, copied; their ids are 0, 1, 2, ...
    threads : int
        How many threads may work; 0 for one per processor.

    Examples
    --------
    >>> import beespace
    >>> index = beespace.Index([[0, 0], [3, 4], [6, 9]])
    >>> index.around([[3, 3]], 4)[0]
    array([1])
    >>> index.nearest([[3, 3]], k=2).ids
    array([[1, 0]])
    >>> index.insert([3, 3])
    3
    >>> index
    <beespace.Index: 4 points>
    """

    __slots__ = ("_handle", "_known")

    def __init__(self, points: PointsLike, *, threads: int = 1) -> None:
        self._handle = _library.CIndex()
        given = Points(points, "points")
        self._known = Known(given.axes, given.frame)
        error = _library.new_error()
        run = run_of(threads, given.count)
        check(
            library.beespace_index_create(
                ctypes.byref(given.struct),
                None if run is None else ctypes.byref(run),
                ctypes.byref(self._handle),
                ctypes.byref(error),
            ),
            error,
        )

    def __len__(self) -> int:
        return int(library.beespace_index_size(self._handle))

    def __repr__(self) -> str:
        count = len(self)
        return f"<beespace.Index: {count:,} point{'' if count == 1 else 's'}>"

    def __reduce__(self) -> Any:
        """Refused: a copy would be another name for the same points."""
        return _library.refuse_to_copy(self)

    def __getitem__(self, id: int) -> NDArray[np.float64]:
        """The position of a point, as three coordinates.

        Examples
        --------
        >>> import beespace
        >>> beespace.Index([[0, 0], [3, 4]])[1]
        array([3., 4., 0.])
        """
        coordinates = (ctypes.c_double * 3)()
        error = _library.new_error()
        code = library.beespace_index_position(
            self._handle, whole(id, "id"), coordinates, ctypes.byref(error)
        )
        check(code, error, {"": "id"})
        return np.array(coordinates)

    def around(
        self,
        places: PointsLike,
        radius: float | ArrayLike,
        *,
        inclusive: bool = False,
        max_results: int | None = None,
        threads: int = 1,
    ) -> Neighbors:
        """Which points are closer than the radius to each of many positions?

        Some hundred nanoseconds a position, and a few a point that is found.

        Parameters
        ----------
        places : array of shape (m, 3) or (m, 2), tuple of arrays, or data frame
            Positions in metres.
        radius : float, or array of shape (m,)
            In metres; zero or more. One for all positions, or one for each.
        inclusive : bool
            Whether exactly the radius away counts as closer.
        max_results : int, optional
            More points around all positions than this are an error, "too_many_results".
        threads : int
            How many threads may work; 0 for one per processor.

        Returns
        -------
        Neighbors
            A row of ids, ascending, for each position; without distances.

        Raises
        ------
        BeespaceError
            A radius or positions that make no sense; more than `max_results`.

        Examples
        --------
        >>> import beespace
        >>> index = beespace.Index([[0, 0], [3, 4], [6, 9]])
        >>> [ids.tolist() for ids in index.around([[3, 3], [50, 50]], 4)]
        [[1], []]
        """
        given = self._places_of(places)
        if _is_one(radius):
            search = search_of(radius, None, inclusive, max_results, place="radius")
            result = self._ask(
                library.beespace_index_around, given, (ctypes.byref(search),), threads
            )
        else:
            search = search_of(0.0, None, inclusive, max_results)
            radii = numbers_of(radius, given.count, "radius", METRES)
            result = self._ask(
                library.beespace_index_around_each,
                given,
                (_address_of(radii), ctypes.byref(search)),
                threads,
            )
        ids = result.ids()
        # Ids of removed points are not used again, so there may be higher ones than points.
        others = max(len(self), int(ids.max()) + 1 if len(ids) else 0)
        return Neighbors(result.offsets(), ids, None, others)

    def nearest(self, places: PointsLike, k: int = 1, *, threads: int = 1) -> Nearest:
        """Which are the k nearest points of each of many positions?

        Some hundred nanoseconds a position, and about a hundred a point.

        Parameters
        ----------
        places : array of shape (m, 3) or (m, 2), tuple of arrays, or data frame
            Positions in metres.
        k : int
            How many to find for each position.
        threads : int
            How many threads may work; 0 for one per processor.

        Returns
        -------
        Nearest
            As of `beespace.nearest`.

        Examples
        --------
        >>> import beespace
        >>> index = beespace.Index([[0, 0], [3, 4], [6, 9]])
        >>> index.nearest([[3, 3]], k=4)
        <Nearest: the 4 nearest of 1 point, 3 found, 1 to 6.7082 m away>
        >>> index.nearest([[3, 3]], k=4).ids
        array([[ 1,  0,  2, -1]])
        """
        number = neighbours_of(k)
        given = self._places_of(places)
        result = self._ask(library.beespace_index_nearest, given, (number,), threads)
        return nearest_of(result, given.count, number)

    def insert(self, point: ArrayLike) -> int:
        """Adds a point.

        Parameters
        ----------
        point : array of shape (3,) or (2,)
            Its position in metres.

        Returns
        -------
        int
            Its id, which was never used before.

        Raises
        ------
        BeespaceError
            What is no position. The index is as it was.

        Examples
        --------
        >>> import beespace
        >>> index = beespace.Index([[0, 0], [3, 4]])
        >>> index.insert([9, 9])
        2
        """
        id = ctypes.c_int64()
        error = _library.new_error()
        where = position(point, self._known)
        code = library.beespace_index_insert(
            self._handle, where, ctypes.byref(id), ctypes.byref(error)
        )
        check(code, error, {"": "point"})
        self._known.take(Known(np.size(point), frame_of(point)))
        return id.value

    def move(self, id: int, point: ArrayLike) -> None:
        """Moves a point.

        Parameters
        ----------
        id : int
            The id of the point.
        point : array of shape (3,) or (2,)
            Where it is now, in metres.

        Raises
        ------
        BeespaceError
            There is no such point, or this is no position. The index is as it was.

        Examples
        --------
        >>> import beespace
        >>> index = beespace.Index([[0, 0], [3, 4]])
        >>> index.move(1, [9, 9])
        >>> index[1]
        array([9., 9., 0.])
        """
        error = _library.new_error()
        code = library.beespace_index_move(
            self._handle, whole(id, "id"), position(point, self._known), ctypes.byref(error)
        )
        of_point = library.beespace_code_name(error.code) in (b"not_finite", b"outside_domain")
        check(code, error, {"": "point" if of_point else "id"})

    def remove(self, id: int) -> None:
        """Removes a point; its id is not used again.

        Parameters
        ----------
        id : int
            The id of the point.

        Raises
        ------
        BeespaceError
            There is no such point.

        Examples
        --------
        >>> import beespace
        >>> index = beespace.Index([[0, 0], [3, 4]])
        >>> index.remove(0)
        >>> index
        <beespace.Index: 1 point>
        >>> index.insert([1, 1])
        2
        """
        error = _library.new_error()
        code = library.beespace_index_remove(self._handle, whole(id, "id"), ctypes.byref(error))
        check(code, error, {"": "id"})

    def _places_of(self, places: Any) -> Points:
        given = Points(places, "places")
        given.check_alike(self._known, "places", "points")
        return given

    def _ask(
        self, function: Any, given: Points, arguments: tuple[Any, ...], threads: int
    ) -> Result:
        error = _library.new_error()
        result = Result()
        run = run_of(threads, given.count)
        code = function(
            self._handle,
            ctypes.byref(given.struct),
            *arguments,
            None if run is None else ctypes.byref(run),
            result.handle,
            ctypes.byref(error),
        )
        check(code, error, {"radii": "radius", "threshold": "radius"})
        return result


def _is_one(radius: Any) -> bool:
    try:
        return np.ndim(radius) == 0
    except ValueError:  # a list of lists of several lengths
        return False


def _address_of(numbers: NDArray[np.float64]) -> Any:
    return numbers.ctypes.data_as(ctypes.POINTER(ctypes.c_double))
