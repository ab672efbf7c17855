"""What the questions answer: arrays that belong together, and what they turn into."""

from __future__ import annotations

import operator
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from beespace._tables import Table, plural

if TYPE_CHECKING:
    import scipy.sparse


def _range(distances: NDArray[np.float64] | None, how: str) -> str:
    """What a `repr` says of distances; those that are infinite stand for none."""
    if distances is None:
        return ""
    found = distances[np.isfinite(distances)]
    return f", {found.min():.6g} to {found.max():.6g} m {how}" if found.size else ""


class Pairs(Table):
    """Pairs of points that are closer than the threshold, each once, in ascending order.

    Attributes
    ----------
    i : ndarray of int64, shape (m,)
        The first point of each pair. In pairs of one set it is below `j`.
    j : ndarray of int64, shape (m,)
        The second point of each pair; between two sets, a point of the other set.
    distance : ndarray of float64, shape (m,), or None
        The distance of each pair in metres; None where it was not asked for.
    shape : tuple of two ints
        How many points `i` and `j` are indices of.

    Examples
    --------
    >>> import beespace
    >>> pairs = beespace.pairs([[0, 0], [3, 4], [6, 8]], 6)
    >>> pairs
    <Pairs: 2 pairs of 3 points, 5 to 5 m apart>
    >>> len(pairs), pairs.i, pairs.j, pairs.distance
    (2, array([0, 1]), array([1, 2]), array([5., 5.]))
    >>> beespace.pairs([[0, 0], [3, 4]], 6, others=[[0, 1], [9, 9], [0, 0]], distances=False)
    <Pairs: 4 pairs of 2 x 3 points>
    """

    __slots__ = ("_between", "distance", "i", "j", "shape")

    def __init__(
        self,
        i: NDArray[np.int64],
        j: NDArray[np.int64],
        distance: NDArray[np.float64] | None,
        shape: tuple[int, int],
        between: bool,
    ) -> None:
        self.i = i
        self.j = j
        self.distance = distance
        self.shape = shape
        self._between = between

    def __len__(self) -> int:
        return len(self.i)

    @property
    def is_between(self) -> bool:
        """Whether `j` are points of another set."""
        return self._between

    def __repr__(self) -> str:
        of = " x ".join(f"{size:,}" for size in self.shape) if self._between else f"{self.shape[0]:,}"
        points = "point" if of == "1" else "points"
        return (
            f"<Pairs: {plural(len(self), 'pair')} of {of} {points}{_range(self.distance, 'apart')}>"
        )

    def to_csr(self) -> scipy.sparse.csr_matrix:
        """As a sparse matrix of SciPy: distances, or True where there are none.

        Of one set it is symmetric. Points at one place have an entry that is stored, and zero.
        SciPy must be installed.

        Returns
        -------
        scipy.sparse.csr_matrix
            Of the shape `shape`.

        Examples
        --------
        >>> import beespace
        >>> beespace.pairs([[0, 0], [3, 4], [9, 9]], 6).to_csr().toarray()
        array([[0., 5., 0.],
               [5., 0., 0.],
               [0., 0., 0.]])
        """
        from scipy.sparse import coo_matrix

        values = np.ones(len(self), bool) if self.distance is None else self.distance
        if self._between:
            return coo_matrix((values, (self.i, self.j)), self.shape).tocsr()
        rows, columns = np.concatenate([self.i, self.j]), np.concatenate([self.j, self.i])
        return coo_matrix((np.concatenate([values, values]), (rows, columns)), self.shape).tocsr()

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name: i, j, and distance where it was asked for.

        Examples
        --------
        >>> import beespace
        >>> list(beespace.pairs([[0, 0], [3, 4]], 6, distances=False).columns())
        ['i', 'j']
        """
        columns: dict[str, NDArray[Any]] = {"i": self.i, "j": self.j}
        if self.distance is not None:
            columns["distance"] = self.distance
        return columns


class _Rows:
    """Rows of ids of different lengths, one after the other."""

    __slots__ = ("indices", "indptr")

    def __init__(self, indptr: NDArray[np.int64], indices: NDArray[np.int64]) -> None:
        self.indptr = indptr
        self.indices = indices

    def __len__(self) -> int:
        return len(self.indptr) - 1

    def __getitem__(self, row: int) -> NDArray[np.int64]:
        row = operator.index(row)
        size = len(self)
        if not -size <= row < size:
            raise IndexError(f"there are {plural(size, 'row')}")
        row %= size
        return self.indices[self.indptr[row] : self.indptr[row + 1]]

    def __iter__(self) -> Iterator[NDArray[np.int64]]:
        return (self[row] for row in range(len(self)))


class Neighbors(_Rows):
    """The neighbours of each point, in compressed sparse rows. `neighbors[3]` are those of point 3.

    Attributes
    ----------
    indptr : ndarray of int64, shape (n + 1,)
        Row r is ``indices[indptr[r]:indptr[r + 1]]``.
    indices : ndarray of int64
        The neighbours of all points, ascending in each row.
    distances : ndarray of float64 or None
        The distance of each neighbour in metres; None where it was not asked for.

    Examples
    --------
    >>> import beespace
    >>> neighbors = beespace.neighbors([[0, 0], [3, 4], [6, 8]], 6)
    >>> neighbors
    <Neighbors: 4 neighbours of 3 points, 5 to 5 m away>
    >>> neighbors[1], neighbors.indptr
    (array([0, 2]), array([0, 1, 3, 4]))
    >>> [row.tolist() for row in neighbors]
    [[1], [0, 2], [1]]
    """

    __slots__ = ("_others", "distances")

    def __init__(
        self,
        indptr: NDArray[np.int64],
        indices: NDArray[np.int64],
        distances: NDArray[np.float64] | None,
        others: int,
    ) -> None:
        super().__init__(indptr, indices)
        self.distances = distances
        self._others = others

    def __repr__(self) -> str:
        return (
            f"<Neighbors: {plural(len(self.indices), 'neighbour')} of "
            f"{plural(len(self), 'point')}{_range(self.distances, 'away')}>"
        )

    def to_csr(self) -> scipy.sparse.csr_matrix:
        """As a sparse matrix of SciPy: distances, or True where there are none.

        Without a copy of the values. SciPy must be installed.

        Returns
        -------
        scipy.sparse.csr_matrix
            A row for each point, a column for each point or each of the others.

        Examples
        --------
        >>> import beespace
        >>> beespace.neighbors([[0, 0], [3, 4]], 6, others=[[0, 1]]).to_csr().toarray().round(3)
        array([[1.   ],
               [4.243]])
        """
        from scipy.sparse import csr_matrix

        values = np.ones(len(self.indices), bool) if self.distances is None else self.distances
        return csr_matrix((values, self.indices, self.indptr), shape=(len(self), self._others))


class Groups(_Rows):
    """Groups of points that are linked by steps shorter than the threshold. `groups[0]` is the one
    with the lowest id; points that are not at risk are in none.

    Attributes
    ----------
    indptr : ndarray of int64, shape (g + 1,)
        Group r is ``indices[indptr[r]:indptr[r + 1]]``.
    indices : ndarray of int64
        The members of all groups, ascending in each group.
    labels : ndarray of int64, shape (n,)
        For each point the number of its group; -1 where it is in none.

    Examples
    --------
    >>> import beespace
    >>> groups = beespace.groups([[0, 0], [3, 4], [100, 0], [6, 8]], 6)
    >>> groups
    <Groups: 1 group with 3 of 4 points, the largest of 3>
    >>> [members.tolist() for members in groups], groups.labels
    ([[0, 1, 3]], array([ 0,  0, -1,  0]))
    """

    __slots__ = ("_count",)

    def __init__(
        self, indptr: NDArray[np.int64], indices: NDArray[np.int64], count: int
    ) -> None:
        super().__init__(indptr, indices)
        self._count = count

    @property
    def labels(self) -> NDArray[np.int64]:
        """For each point the number of its group; -1 where it is in none. Made at each call."""
        labels = np.full(self._count, -1, np.int64)
        labels[self.indices] = np.repeat(np.arange(len(self)), np.diff(self.indptr))
        return labels

    def __repr__(self) -> str:
        largest = f", the largest of {np.diff(self.indptr).max():,}" if len(self) else ""
        return (
            f"<Groups: {plural(len(self), 'group')} with {len(self.indices):,} of "
            f"{plural(self._count, 'point')}{largest}>"
        )


class Nearest(NamedTuple):
    """The nearest points of each point, beginning with the nearest.

    Attributes
    ----------
    ids : ndarray of int64, shape (n, k)
        The nearest points; -1 where there are fewer.
    distances : ndarray of float64, shape (n, k)
        Their distances in metres; infinite where there are fewer.

    Examples
    --------
    >>> import beespace
    >>> nearest = beespace.nearest([[0, 0], [3, 4], [6, 9]])
    >>> nearest
    <Nearest: the nearest of each of 3 points, 5 to 5.83095 m away>
    >>> ids, distances = nearest
    >>> ids[:, 0]
    array([1, 0, 1])
    """

    ids: NDArray[np.int64]
    distances: NDArray[np.float64]

    def __repr__(self) -> str:
        rows, k = self.ids.shape
        told = f"the {f'{k:,} ' if k != 1 else ''}nearest of {'each of ' if rows != 1 else ''}"
        found = int((self.ids >= 0).sum())
        lacking = "" if found == rows * k else f", {found:,} found" if found else ", none found"
        return f"<Nearest: {told}{plural(rows, 'point')}{lacking}{_range(self.distances, 'away')}>"


class ClosestPair(NamedTuple):
    """The two points that are closest to each other, and their distance.

    Attributes
    ----------
    i, j : int
        The two points, ``i < j``; between two sets, `j` is a point of the other set.
    distance : float
        Their distance in metres.

    Examples
    --------
    >>> import beespace
    >>> i, j, distance = beespace.closest_pair([[0, 0], [3, 4], [6, 9]])
    >>> i, j, distance
    (0, 1, 5.0)
    """

    i: int
    j: int
    distance: float
