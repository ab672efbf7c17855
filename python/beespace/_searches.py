"""The questions about points, asked once or again and again."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

from beespace import _library
from beespace._answers import ClosestPair, Groups, Nearest, Neighbors, Pairs
from beespace._asking import nearest_of, neighbours_of, refuse_self, sets_of
from beespace._calls import search_of, whole
from beespace._errors import invalid
from beespace._library import library
from beespace._motion import Predictions
from beespace._points import PointsLike
from beespace._visits import Visit


class Searches(Predictions):
    """The questions about points, with arguments as `at_risk` has them. Each call stands alone: any
    number of threads may ask at once.
    """

    __slots__ = ()

    @overload
    def at_risk(
        self,
        points: PointsLike,
        threshold: float,
        *,
        others: PointsLike | None = None,
        vertical: float | None = None,
        inclusive: bool = False,
        mask: Literal[False] = False,
        threads: int = 1,
        copy: bool = False,
    ) -> NDArray[np.int64]: ...
    @overload
    def at_risk(
        self,
        points: PointsLike,
        threshold: float,
        *,
        others: PointsLike | None = None,
        vertical: float | None = None,
        inclusive: bool = False,
        mask: Literal[True],
        threads: int = 1,
        copy: bool = False,
    ) -> NDArray[np.bool_]: ...
    @overload
    def at_risk(
        self,
        points: PointsLike,
        threshold: float,
        *,
        others: PointsLike | None = None,
        vertical: float | None = None,
        inclusive: bool = False,
        mask: bool,
        threads: int = 1,
        copy: bool = False,
    ) -> NDArray[np.int64] | NDArray[np.bool_]: ...

    def at_risk(
        self,
        points: PointsLike,
        threshold: float,
        *,
        others: PointsLike | None = None,
        vertical: float | None = None,
        inclusive: bool = False,
        mask: bool = False,
        threads: int = 1,
        copy: bool = False,
    ) -> NDArray[np.int64] | NDArray[np.bool_]:
        """Which points are closer than the threshold to any other point?

        Time and memory grow with the number of points, whatever their density.

        Parameters
        ----------
        points : array of shape (n, 3) or (n, 2), tuple of two or three arrays, or data frame
            Positions in metres. float64 and float32 of any strides are read without a copy, in NumPy,
            pandas, Polars and what speaks DLPack; integers and halves are converted. In two
            dimensions heights are 0. Ids are indices of these points. They must not change during the
            call, unless `copy` is true.
        threshold : float
            How close is too close, in metres. Exactly the threshold apart is not closer.
        others : as points, optional
            The points of another set. If they are given, only points of different sets are compared.
        vertical : float, optional
            A vertical threshold in metres: two points conflict when they are closer than `threshold`
            in x and y, and closer than this in z.
        inclusive : bool
            Whether exactly the threshold apart counts as closer.
        mask : bool
            Whether to return one flag a point, instead of ids.
        threads : int
            How many threads may work; 0 for one per processor. The answer is always the same. Ctrl-C
            ends a long search.
        copy : bool
            Whether points are copied first, because another thread changes them meanwhile.

        Returns
        -------
        ndarray
            The ids of the points at risk, ascending, as int64; or with `mask` a bool for each point.

        Raises
        ------
        BeespaceError
            What makes no sense, with `code`, `place` and, as `record`, the point.
        MemoryError
            The system gives no more.

        Examples
        --------
        >>> import beespace
        >>> drones = [[0, 0, 50], [80, 60, 50], [300, 0, 50], [300, 0, 149.9]]
        >>> beespace.at_risk(drones, 100)
        array([2, 3])
        >>> beespace.at_risk(drones, 100, mask=True)
        array([False, False,  True,  True])
        >>> beespace.at_risk(drones, 100, others=[[0, 0, 0]])
        array([0])
        """
        first, second = sets_of(points, others, copy, vertical)
        search = search_of(threshold, vertical, inclusive)
        result = self._ask(
            library.beespace_at_risk, first, second, (ctypes.byref(search),), threads
        )
        ids = result.ids()
        if not mask:
            return ids
        flags = np.zeros(first.count, bool)
        flags[ids] = True
        return flags

    def pairs(
        self,
        points: PointsLike,
        threshold: float,
        *,
        others: PointsLike | None = None,
        distances: bool = True,
        vertical: float | None = None,
        inclusive: bool = False,
        max_results: int | None = None,
        threads: int = 1,
        copy: bool = False,
    ) -> Pairs:
        """Which pairs of points are closer than the threshold?

        Time and memory grow with the number of points and of pairs: 24 bytes a pair, 16 without
        distances, and 8 while it runs.

        Parameters
        ----------
        points, threshold, others, vertical, inclusive, threads, copy
            As `at_risk` says.
        distances : bool
            Whether to compute the distance of each pair, too.
        max_results : int, optional
            More pairs than this are an error, "too_many_results". An answer is never cut.

        Returns
        -------
        Pairs
            Each pair once, with ``i < j`` or, between two sets, `j` of `others`.

        Examples
        --------
        >>> import beespace
        >>> drones = [[0, 0, 50], [80, 60, 50], [300, 0, 50], [300, 0, 149.9]]
        >>> pairs = beespace.pairs(drones, 100, inclusive=True)
        >>> pairs
        <Pairs: 2 pairs of 4 points, 99.9 to 100 m apart>
        >>> pairs.i, pairs.j
        (array([0, 2]), array([1, 3]))
        """
        first, second = sets_of(points, others, copy, vertical)
        search = search_of(threshold, vertical, inclusive, max_results, distances)
        result = self._ask(library.beespace_pairs, first, second, (ctypes.byref(search),), threads)
        return Pairs(
            result.first(),
            result.second(),
            result.distances() if distances else None,
            (first.count, first.count if second is None else second.count),
            second is not None,
        )

    def iter_pairs(
        self,
        points: PointsLike,
        threshold: float,
        *,
        chunk: int = 1_000_000,
        distances: bool = True,
        vertical: float | None = None,
        inclusive: bool = False,
        threads: int = 1,
        copy: bool = False,
    ) -> Iterator[Pairs]:
        """Shows all pairs that are closer than the threshold, in pieces: for more pairs than memory.

        A search on a thread of its own goes on as pieces are taken; at most three pieces are in
        memory. Points must not change before the last piece, unless `copy` is true.

        Parameters
        ----------
        points, threshold, vertical, inclusive, threads, copy
            As `at_risk` says.
        chunk : int
            The most pairs of one piece.
        distances : bool
            Whether to compute the distance of each pair, too.

        Yields
        ------
        Pairs
            Each pair in one of the pieces, in no particular order.

        Examples
        --------
        >>> import beespace
        >>> points = [[x, 0, 0] for x in range(1000)]
        >>> sum(len(piece) for piece in beespace.iter_pairs(points, 2, chunk=100))
        999
        """
        # Checked here, not when the first piece is asked for.
        first, _ = sets_of(points, None, copy, vertical)
        most = whole(chunk, "chunk")
        if most == 0:
            raise invalid("a piece has at least one pair", "chunk")
        search = search_of(threshold, vertical, inclusive, distances=distances)
        number = whole(threads, "threads")
        threads = _library.ALL_PROCESSORS if number == 0 else min(number, 256)

        def ask(*arguments: Any) -> int:
            given = ctypes.byref(first.struct), ctypes.byref(search)
            return int(library.beespace_visit_pairs(None, *given, *arguments))

        return Visit(ask, first.count, distances, threads, most).pieces()

    def neighbors(
        self,
        points: PointsLike,
        threshold: float,
        *,
        others: PointsLike | None = None,
        include_self: bool = False,
        distances: bool = True,
        vertical: float | None = None,
        inclusive: bool = False,
        max_results: int | None = None,
        threads: int = 1,
        copy: bool = False,
    ) -> Neighbors:
        """Which points are closer than the threshold to each point?

        Time and memory grow with the number of points and of neighbours: 16 bytes a neighbour, 8
        without distances, and 4 while it runs.

        Parameters
        ----------
        points, threshold, others, vertical, inclusive, threads, copy
            As `at_risk` says.
        include_self : bool
            Whether each point is a neighbour of itself. Not with `others`.
        distances : bool
            Whether to compute the distance of each neighbour, too.
        max_results : int, optional
            More neighbours of all points than this are an error, "too_many_results".

        Returns
        -------
        Neighbors
            A row for each point, in compressed sparse rows.

        Examples
        --------
        >>> import beespace
        >>> neighbors = beespace.neighbors([[0, 0], [3, 4], [6, 8]], 6)
        >>> neighbors[1], neighbors.distances
        (array([0, 2]), array([5., 5., 5., 5.]))
        >>> beespace.neighbors([[0, 0], [3, 4], [6, 8]], 6, include_self=True)[1]
        array([0, 1, 2])
        """
        refuse_self(include_self, others)
        first, second = sets_of(points, others, copy, vertical)
        search = search_of(threshold, vertical, inclusive, max_results, distances, include_self)
        result = self._ask(
            library.beespace_neighbors, first, second, (ctypes.byref(search),), threads
        )
        return Neighbors(
            result.offsets(),
            result.ids(),
            result.distances() if distances else None,
            first.count if second is None else second.count,
        )

    def count(
        self,
        points: PointsLike,
        threshold: float,
        *,
        others: PointsLike | None = None,
        include_self: bool = False,
        vertical: float | None = None,
        inclusive: bool = False,
        threads: int = 1,
        copy: bool = False,
    ) -> NDArray[np.int64]:
        """How many points are closer than the threshold to each point?

        The lengths of the rows of `neighbors`, without the rows.

        Parameters
        ----------
        points, threshold, others, vertical, inclusive, threads, copy
            As `at_risk` says.
        include_self : bool
            Whether each point counts itself. Not with `others`.

        Returns
        -------
        ndarray of int64, shape (n,)
            A count for each point.

        Examples
        --------
        >>> import beespace
        >>> beespace.count([[0, 0], [3, 4], [6, 8]], 6)
        array([1, 2, 1])
        """
        refuse_self(include_self, others)
        first, second = sets_of(points, others, copy, vertical)
        search = search_of(threshold, vertical, inclusive, with_self=include_self)
        return self._ask(
            library.beespace_count, first, second, (ctypes.byref(search),), threads
        ).counts()

    def groups(
        self,
        points: PointsLike,
        threshold: float,
        *,
        vertical: float | None = None,
        inclusive: bool = False,
        threads: int = 1,
        copy: bool = False,
    ) -> Groups:
        """Which points are linked by steps shorter than the threshold?

        Time and memory grow with the number of points, in crowds too.

        Parameters
        ----------
        points, threshold, vertical, inclusive, threads, copy
            As `at_risk` says.

        Returns
        -------
        Groups
            The members of each group, ascending; groups in the order of their lowest member. Points
            that are not at risk are in no group.

        Examples
        --------
        >>> import beespace
        >>> groups = beespace.groups([[0, 0], [3, 4], [100, 0], [6, 8]], 6)
        >>> groups[0], groups.labels
        (array([0, 1, 3]), array([ 0,  0, -1,  0]))
        """
        first, _ = sets_of(points, None, copy, vertical)
        search = search_of(threshold, vertical, inclusive)
        result = self._ask(
            library.beespace_groups, first, None, (ctypes.byref(search),), threads, two_sets=False
        )
        return Groups(result.offsets(), result.ids(), first.count)

    def nearest(
        self,
        points: PointsLike,
        k: int = 1,
        *,
        others: PointsLike | None = None,
        within: float | None = None,
        vertical: float | None = None,
        inclusive: bool = False,
        threads: int = 1,
        copy: bool = False,
    ) -> Nearest:
        """Which are the k nearest points of each point?

        However far, or the nearest one of those that are closer than `within`. A point is not its
        own neighbour. One to three hundred nanoseconds a point for up to eight neighbours.

        Parameters
        ----------
        points, others, threads, copy
            As `at_risk` says.
        k : int
            How many to find for each point.
        within : float, optional
            Looks only among points that are closer than this, in metres; for one neighbour.
        vertical, inclusive
            As `at_risk` says, of `within`.

        Returns
        -------
        Nearest
            ids and distances, of the shape (n, k), in the order of distances; equally near ones in
            the order of ids. Where there are fewer: -1 and infinity.

        Examples
        --------
        >>> import beespace
        >>> nearest = beespace.nearest([[0, 0], [3, 4], [6, 9]], k=2)
        >>> nearest.ids
        array([[1, 2],
               [0, 2],
               [1, 0]])
        >>> beespace.nearest([[0, 0], [3, 4], [6, 9]], within=5.5).distances[:, 0]
        array([ 5.,  5., inf])
        """
        first, second = sets_of(points, others, copy, vertical)
        number = neighbours_of(k)
        if within is not None:
            if number != 1:
                raise invalid("within a threshold, one neighbour of each point is found", "k")
            search = search_of(within, vertical, inclusive, place="within")
            result = self._ask(
                library.beespace_nearest_within,
                first,
                second,
                (ctypes.byref(search),),
                threads,
                places={"threshold": "within"},
            )
            return Nearest(result.ids()[:, np.newaxis], result.distances()[:, np.newaxis])
        if vertical is not None or inclusive:
            place = "vertical" if vertical is not None else "inclusive"
            raise invalid("this needs a threshold, `within`", place)
        result = self._ask(library.beespace_nearest, first, second, (number,), threads)
        return nearest_of(result, first.count, number)

    def closest_pair(
        self,
        points: PointsLike,
        *,
        others: PointsLike | None = None,
        threads: int = 1,
        copy: bool = False,
    ) -> ClosestPair | None:
        """Which two points are closest to each other?

        A few tens of nanoseconds a point, expected.

        Parameters
        ----------
        points, others, threads, copy
            As `at_risk` says.

        Returns
        -------
        ClosestPair or None
            Of equally close pairs the lowest; None where there are too few points.

        Examples
        --------
        >>> import beespace
        >>> beespace.closest_pair([[0, 0], [3, 4], [6, 9]])
        ClosestPair(i=0, j=1, distance=5.0)
        """
        first, second = sets_of(points, others, copy)
        result = self._ask(library.beespace_closest_pair, first, second, (), threads)
        i = result.first()
        if not len(i):
            return None
        return ClosestPair(int(i[0]), int(result.second()[0]), float(result.distances()[0]))


def _name_as_called(kind: type) -> None:
    """Lets Python's own errors say "at_risk() takes ...", and not the name of a class inside."""
    for name, function in vars(kind).items():
        if not name.startswith("_"):
            function.__qualname__ = name


for _kind in (Predictions, Searches):
    _name_as_called(_kind)
