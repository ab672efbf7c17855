"""More points than fit into memory."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace import _library
from beespace import _out_of_core_library as _c
from beespace._answers import ClosestPair, Nearest, Pairs
from beespace._asking import neighbours_of
from beespace._calls import check, whole
from beespace._columns import Result, column
from beespace._errors import invalid
from beespace._library import library
from beespace._out_of_core_store import Store
from beespace._points import PointsLike
from beespace._visits import Visit


class OutOfCoreFacts(NamedTuple):
    """How the last search of an `OutOfCore` was cut.

    Attributes
    ----------
    cells : int
        Cells with points.
    copies : int
        Points near borders, which other cells need too: how many more were written than there are.
    crowded_cells : int
        Cells that are too full for the memory: searched in pieces, which takes longer.
    largest_cell : int
        The points of the fullest cell, with those that it needs of others.

    Examples
    --------
    >>> import beespace
    >>> search = beespace.OutOfCore("16 MiB")
    >>> search.add([[0, 0, 0], [3, 4, 0]])
    >>> search.at_risk(6)
    array([0, 1])
    >>> search.facts
    OutOfCoreFacts(cells=1, copies=0, crowded_cells=0, largest_cell=2)
    """

    cells: int
    copies: int
    crowded_cells: int
    largest_cell: int


class OutOfCore(Store):
    """The questions about more points than fit into memory.

    Points come in parts, and have the ids 0, 1, 2, ... in that order. A question cuts space into cells
    that fit into the memory, writes points to a temporary file, and searches one cell after the other;
    answers are those of the functions of the module. The file has no name: nothing is left of it,
    however the program ends. One question at a time. Ctrl-C ends a long one.

    Parameters
    ----------
    memory : str or int
        How much the search may use, besides its answers and points that are referred to: "2GB",
        "500 MiB", or bytes. At least 16 MiB a thread.
    folder : str or path, optional
        Where the temporary file goes, with room for some 30 bytes a point and another 24 of each that
        is added; by default that of the environment variable TMPDIR, or /var/tmp.
    threads : int
        How many threads may work; 0 for one per processor. The answer is always the same.
    height_unit : float
        The length in metres of one unit of `heights`, and then of `vertical`: 0.3048 for feet.
    progress : callable, optional
        Called some times a second as ``progress(phase, done, of)``, with "distributing" or
        "searching" and numbers of points. What it raises ends the question.

    Raises
    ------
    BeespaceError
        What makes no sense. Questions: as those of the module, with the id as `record`; and
        "write_failed" where the folder has too little room, "corrupt" where the disk returned another
        thing than was written.

    Examples
    --------
    >>> import beespace
    >>> search = beespace.OutOfCore("100 MB")
    >>> search.add([[0, 0, 50], [80, 60, 50]])
    >>> search.add([[300, 0, 50], [300, 0, 149.9]])
    >>> search.at_risk(100)
    array([2, 3])
    >>> search
    <beespace.OutOfCore: 4 points, 100,000,000 bytes of memory>
    """

    __slots__ = ()

    def __init__(
        self,
        memory: str | int,
        folder: str | os.PathLike[str] | None = None,
        *,
        threads: int = 1,
        height_unit: float = 1.0,
        progress: Callable[[str, int, int], object] | None = None,
    ) -> None:
        super().__init__(memory, folder, threads, height_unit, progress)

    def __repr__(self) -> str:
        count = len(self)
        return (
            f"<beespace.OutOfCore: {count:,} point{'' if count == 1 else 's'}, "
            f"{self._memory:,} bytes of memory>"
        )

    def __reduce__(self) -> Any:
        """Refused: points that wait on the disk are not taken along."""
        return self._handle.__reduce__()

    @property
    def facts(self) -> OutOfCoreFacts:
        """How the last search was cut.

        Examples
        --------
        >>> import beespace
        >>> beespace.OutOfCore("100 MB").facts.cells
        0
        """
        told = _c.CFacts(ctypes.sizeof(_c.CFacts))
        error = _library.new_error()
        with self._alone():
            code = library.beespace_out_of_core_facts_of(
                self._handle, ctypes.byref(told), ctypes.byref(error)
            )
        check(code, error)
        return OutOfCoreFacts(told.cells, told.copies, told.crowded_cells, told.largest_cell)

    def add(self, points: PointsLike, *, heights: ArrayLike | None = None) -> None:
        """Adds points, which are copied to the disk.

        Parameters
        ----------
        points : array of shape (n, 3) or (n, 2), tuple of arrays, or data frame
            Positions in metres.
        heights : array of shape (n,), optional
            A height for each, apart from its position, which is then horizontal. All points have them,
            or none.

        Raises
        ------
        BeespaceError
            What is no position, with its row as `record`; a full disk. None was added.

        Examples
        --------
        >>> import beespace
        >>> search = beespace.OutOfCore("100 MB")
        >>> search.add([[0, 0], [3, 4], [0, 1]], heights=[100, 105, 190])
        >>> search.at_risk(6, vertical=10)
        array([0, 1])
        """
        self._take(library.beespace_out_of_core_add, points, heights)

    def refer(self, points: PointsLike, *, heights: ArrayLike | None = None) -> None:
        """Adds points that stay where they are, as in a file that is mapped into memory.

        They are kept alive, and must not change. float64 and float32 of any strides are not copied.

        Parameters
        ----------
        points, heights
            As of `add`. Coordinates are checked by the questions.

        Raises
        ------
        BeespaceError
            What is no array of positions.

        Examples
        --------
        >>> import numpy as np, beespace
        >>> points = np.array([[0, 0, 0], [3, 4, 0], [9, 9, 9.0]])
        >>> search = beespace.OutOfCore("100 MB")
        >>> search.refer(points)
        >>> search.closest_pair()
        ClosestPair(i=0, j=1, distance=5.0)
        """
        self._kept.append(self._take(library.beespace_out_of_core_refer, points, heights))

    def iter_at_risk(
        self, threshold: float, *, vertical: float | None = None, inclusive: bool = False
    ) -> Iterator[NDArray[np.int64]]:
        """The points that are closer than the threshold to any other point, cell by cell.

        The search is over before the first piece is there; only the ids are held.

        Parameters
        ----------
        threshold, vertical, inclusive
            As of `at_risk`.

        Returns
        -------
        iterator of ndarray of int64
            Ids, ascending in each piece.

        Examples
        --------
        >>> import beespace
        >>> search = beespace.OutOfCore("100 MB")
        >>> search.add([[0, 0], [3, 4], [100, 0]])
        >>> [ids.tolist() for ids in search.iter_at_risk(6)]
        [[0, 1]]
        """
        return iter(self._at_risk(threshold, vertical, inclusive))

    def at_risk(
        self, threshold: float, *, vertical: float | None = None, inclusive: bool = False
    ) -> NDArray[np.int64]:
        """Which points are closer than the threshold to any other point?

        Parameters
        ----------
        threshold : float
            How close is too close, in metres. Exactly the threshold apart is not closer.
        vertical : float, optional
            Two points conflict when they are closer than `threshold` in x and y, and closer than this
            in z; of points with heights apart, closer in position and in height.
        inclusive : bool
            Whether exactly the threshold apart counts as closer.

        Returns
        -------
        ndarray of int64
            Their ids, ascending.

        Examples
        --------
        >>> import beespace
        >>> search = beespace.OutOfCore("100 MB")
        >>> search.add([[0, 0], [3, 4], [100, 0]])
        >>> search.at_risk(6)
        array([0, 1])
        """
        pieces = self._at_risk(threshold, vertical, inclusive)
        ids = np.concatenate(pieces) if pieces else np.empty(0, np.int64)
        ids.sort()
        return ids

    def iter_pairs(
        self,
        threshold: float,
        *,
        vertical: float | None = None,
        inclusive: bool = False,
        distances: bool = True,
        chunk: int = 1_000_000,
    ) -> Iterator[Pairs]:
        """All pairs of points that are closer than the threshold, in pieces.

        The search goes on as pieces are taken; who does not take them all closes the iterator.

        Parameters
        ----------
        threshold, vertical, inclusive
            As of `at_risk`.
        distances : bool
            Whether their distances are wanted, too.
        chunk : int
            How many pairs a piece has, but for the last.

        Returns
        -------
        iterator of Pairs
            Each pair once, in no particular order.

        Examples
        --------
        >>> import beespace
        >>> search = beespace.OutOfCore("100 MB")
        >>> search.add([[x, 0, 0] for x in range(1000)])
        >>> sum(len(piece) for piece in search.iter_pairs(2, chunk=100))
        999
        """
        search = self._search_of(threshold, vertical, inclusive, distances)
        most = whole(chunk, "chunk")
        if most == 0:
            raise invalid("a piece has at least one pair", "chunk")

        def ask(run: Any, *more: Any) -> int:
            problem = self._new_problem(run._obj.stop)
            code = self._ask(
                library.beespace_out_of_core_pairs, ctypes.byref(search), run, *more, problem=problem
            )
            if problem.raised is not None:
                raise problem.raised
            return code

        return Visit(ask, len(self), distances, self._threads, most).pieces()

    def count(
        self, threshold: float, *, vertical: float | None = None, inclusive: bool = False
    ) -> NDArray[np.int64]:
        """How many points are closer than the threshold to each point?

        Parameters
        ----------
        threshold, vertical, inclusive
            As of `at_risk`.

        Returns
        -------
        ndarray of int64, shape (n,)
            A number for each point.

        Examples
        --------
        >>> import beespace
        >>> search = beespace.OutOfCore("100 MB")
        >>> search.add([[0, 0], [3, 4], [100, 0]])
        >>> search.count(6)
        array([1, 1, 0])
        """
        counts = np.empty(len(self), np.int64)

        def see(_data: int | None, ids: int, found: int, count: int) -> None:
            counts[column(None, ids, count, "<i8")] = column(None, found, count, "<i8")

        search = self._search_of(threshold, vertical, inclusive, False)
        self._call(
            library.beespace_out_of_core_count, (ctypes.byref(search),), _c.COUNTS_VISITOR, see
        )
        return counts

    def nearest(self, k: int = 1) -> Nearest:
        """Which are the k nearest other points of each point, however far?

        Parameters
        ----------
        k : int
            How many to find for each point.

        Returns
        -------
        Nearest
            As of `beespace.nearest`.

        Examples
        --------
        >>> import beespace
        >>> search = beespace.OutOfCore("100 MB")
        >>> search.add([[0, 0], [3, 4], [6, 9]])
        >>> search.nearest().ids[:, 0]
        array([1, 0, 1])
        """
        shape = (len(self), neighbours_of(k))
        all_ids, distances = np.full(shape, -1, np.int64), np.full(shape, np.inf)

        def see(
            _data: int | None, ids: int, rows: int, near: int, metres: int, length: int
        ) -> None:
            of = column(None, ids, rows, "<i8")
            all_ids[of, :length] = column(None, near, rows * length, "<i8").reshape(rows, length)
            distances[of, :length] = column(None, metres, rows * length, "<f8").reshape(rows, length)

        self._call(library.beespace_out_of_core_nearest, (shape[1],), _c.NEAREST_VISITOR, see)
        return Nearest(all_ids, distances)

    def closest_pair(self) -> ClosestPair | None:
        """Which two points are closest to each other?

        Returns
        -------
        ClosestPair or None
            Of equally close pairs the lowest; None where there are too few points.

        Examples
        --------
        >>> import beespace
        >>> search = beespace.OutOfCore("100 MB")
        >>> search.add([[0, 0], [3, 4], [6, 9]])
        >>> search.closest_pair()
        ClosestPair(i=0, j=1, distance=5.0)
        """
        result = Result()
        self._run(library.beespace_out_of_core_closest_pair, (), (result.handle,))
        i = result.first()
        if not len(i):
            return None
        return ClosestPair(int(i[0]), int(result.second()[0]), float(result.distances()[0]))
