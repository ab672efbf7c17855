"""What the questions answer: arrays that belong together, and what they turn into."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import pandas
    import polars
    import scipy.sparse


def _plural(count: int, one: str) -> str:
    return f"{count:,} {one}" if count == 1 else f"{count:,} {one}s"


class Pairs:
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

    def __repr__(self) -> str:
        of = " x ".join(f"{size:,}" for size in self.shape) if self._between else f"{self.shape[0]:,}"
        nearest = ""
        if self.distance is not None and len(self):
            nearest = f", {self.distance.min():.6g} to {self.distance.max():.6g} m apart"
        return f"<Pairs: {_plural(len(self), 'pair')} of {of} points{nearest}>"

    def to_csr(self) -> scipy.sparse.csr_matrix:
        """As a sparse matrix of SciPy: distances, or True where there are none.

        Of one set it is symmetric. Points at one place have an entry that is stored, and zero.
        """
        from scipy.sparse import coo_matrix

        values = np.ones(len(self), bool) if self.distance is None else self.distance
        if self._between:
            return coo_matrix((values, (self.i, self.j)), self.shape).tocsr()
        rows, columns = np.concatenate([self.i, self.j]), np.concatenate([self.j, self.i])
        return coo_matrix((np.concatenate([values, values]), (rows, columns)), self.shape).tocsr()

    def _columns(self) -> dict[str, NDArray[Any]]:
        columns: dict[str, NDArray[Any]] = {"i": self.i, "j": self.j}
        if self.distance is not None:
            columns["distance"] = self.distance
        return columns

    def to_pandas(self) -> pandas.DataFrame:
        """As a data frame of pandas, which must be installed: columns i, j, distance."""
        import pandas

        return pandas.DataFrame(self._columns(), copy=False)

    def to_polars(self) -> polars.DataFrame:
        """As a data frame of Polars, which must be installed: columns i, j, distance."""
        import polars

        return polars.DataFrame(self._columns())


class _Rows:
    """Rows of ids of different lengths, one after the other."""

    __slots__ = ("indices", "indptr")

    def __init__(self, indptr: NDArray[np.int64], indices: NDArray[np.int64]) -> None:
        self.indptr = indptr
        self.indices = indices

    def __len__(self) -> int:
        return len(self.indptr) - 1

    def __getitem__(self, row: int) -> NDArray[np.int64]:
        size = len(self)
        if not -size <= row < size:
            raise IndexError(f"there are {_plural(size, 'row')}")
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
            f"<Neighbors: {_plural(len(self.indices), 'neighbour')} of "
            f"{_plural(len(self), 'point')}>"
        )

    def to_csr(self) -> scipy.sparse.csr_matrix:
        """As a sparse matrix of SciPy: distances, or True where there are none; without a copy of
        the values."""
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
    """

    __slots__ = ("_count",)

    def __init__(
        self, indptr: NDArray[np.int64], indices: NDArray[np.int64], count: int
    ) -> None:
        super().__init__(indptr, indices)
        self._count = count

    @property
    def labels(self) -> NDArray[np.int64]:
        labels = np.full(self._count, -1, np.int64)
        labels[self.indices] = np.repeat(np.arange(len(self)), np.diff(self.indptr))
        return labels

    def __repr__(self) -> str:
        return (
            f"<Groups: {_plural(len(self), 'group')} with {len(self.indices):,} of "
            f"{_plural(self._count, 'point')}>"
        )


class Nearest(NamedTuple):
    """The nearest points of each point, beginning with the nearest.

    Attributes
    ----------
    ids : ndarray of int64, shape (n, k)
        The nearest points; -1 where there are fewer.
    distances : ndarray of float64, shape (n, k)
        Their distances in metres; infinite where there are fewer.
    """

    ids: NDArray[np.int64]
    distances: NDArray[np.float64]

    def __repr__(self) -> str:
        rows, k = self.ids.shape
        return f"<Nearest: {k:,} of {_plural(rows, 'point')}>"


class ClosestPair(NamedTuple):
    """The two points that are closest to each other, and their distance in metres."""

    i: int
    j: int
    distance: float
