"""The trees of SciPy, by name, arguments and answers."""

from __future__ import annotations

import math
from typing import Any, ClassVar, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace.compat.scipy import _arguments
from beespace.compat.scipy._arguments import REFUSED, check_norm
from beespace.compat.scipy._counting import count_pairs
from beespace.compat.scipy._handing import HandOver, note_answered
from beespace.compat.scipy._points import in_lists
from beespace.compat.scipy._tree import Tree

# From so many neighbours on it is worth to look first how many there are within the upper bound.
_MANY = 8


class cKDTree(Tree):
    """`scipy.spatial.cKDTree`, run by beespace: as `KDTree`, but leaves have 16 points, `tree` is a
    `cKDTreeNode`, and a single index is an int."""

    _name: ClassVar[str] = "cKDTree"

    def __init__(
        self,
        data: ArrayLike,
        leafsize: int = 16,
        compact_nodes: bool = True,
        copy_data: bool = False,
        balanced_tree: bool = True,
        boxsize: ArrayLike | None = None,
    ) -> None:
        super().__init__(data, leafsize, compact_nodes, copy_data, balanced_tree, boxsize)

    def query(
        self,
        x: ArrayLike,
        k: Any = 1,
        eps: float = 0.0,
        p: float = 2.0,
        distance_upper_bound: float = math.inf,
        workers: int | None = 1,
    ) -> tuple[Any, Any]:
        """Which are the k nearest points of each place?

        Parameters
        ----------
        x : array of shape (..., m)
            The places.
        k : int or list of ints
            How many, or which of them: 1 is the nearest.
        eps, p
            Other than 0 and 2, it is handed over.
        distance_upper_bound : float
            Leaves out neighbours whose distance is not below it.
        workers : int
            How many threads may work; -1 for one per processor.

        Returns
        -------
        d : float or ndarray of float64, shape (..., k)
            The distances, in ascending order; infinite where there are fewer points. Without the last
            axis where `k` is 1.
        i : int or ndarray of intp, of the same shape
            The indices of the points; of equally far ones the lower first, `n` where there are fewer.
        """

        self._check_frame(x, "x")
        if type(k) is int and 1 <= k <= self.n and type(distance_upper_bound) is float:
            place = _arguments.one_place(x, self.m, p, eps, workers)
            if place is not None and distance_upper_bound == math.inf:
                one = self._nearest_of_one(place, k)
                if one is not None:
                    return one

        def ask() -> tuple[Any, Any]:
            check_norm(p, eps)
            bound = _arguments.number(distance_upper_bound)
            if not bound >= 0.0:
                raise HandOver("an upper bound that is negative or no number")
            wanted = _arguments.ranks(k)
            places = _arguments.places(x, self.m)
            i, d = self._nearest(places.rows, wanted.highest, bound, _arguments.threads(workers))
            if wanted.chosen is not None:
                i, d = i[:, wanted.chosen - 1], d[:, wanted.chosen - 1]
            if not wanted.squeezed:
                shape = (*places.shape, i.shape[1])
                return d.reshape(shape), i.reshape(shape)
            if places.shape:
                return d.reshape(places.shape), i.reshape(places.shape)
            return float(d[0, 0]), self._single(int(i[0, 0]))

        return self._answer("query", ask, x, k, eps, p, distance_upper_bound, workers)

    def query_ball_point(
        self,
        x: ArrayLike,
        r: ArrayLike,
        p: float = 2.0,
        eps: float = 0.0,
        workers: int | None = 1,
        return_sorted: bool | None = None,
        return_length: bool = False,
    ) -> Any:
        """Which points are within r of each place?

        Parameters
        ----------
        x : array of shape (..., m)
            The places.
        r : float or array that broadcasts to the shape (...)
            The radius, or one for each place. Points exactly as far belong to it.
        p, eps
            Other than 2 and 0, it is handed over.
        workers : int
            How many threads may work; -1 for one per processor.
        return_sorted : bool, optional
            Rows are ascending in any case.
        return_length : bool
            Whether to return how many they are instead.

        Returns
        -------
        list of ints, or ndarray of lists of the shape (...)
            The indices of the points. With `return_length` their number, as intp.
        """

        self._check_frame(x, "x")
        place = None if return_length else _arguments.one_place(x, self.m, p, eps, workers)
        radius_of_one = _arguments.plain_radius(r)
        if place is not None and radius_of_one is not None and not self._reason:
            index = self._points.index_or_none()
            one = None if index is None else index.around_one(place, radius_of_one)
            if one is not None:
                note_answered("query_ball_point")
                return one

        def ask() -> Any:
            check_norm(p, eps)
            places = _arguments.places(x, self.m)
            radius = _arguments.radii(r, places.shape)
            threads = _arguments.threads(workers)
            if return_length:
                counts = self._points.count_around(places.rows, radius, threads)
                return counts.reshape(places.shape) if places.shape else np.intp(counts[0])
            rows = in_lists(self._points.around(places.rows, radius, threads))
            if not places.shape:
                return rows[0]
            lists = np.empty(len(rows), object)
            for row, ids in enumerate(rows):
                lists[row] = ids
            return lists.reshape(places.shape)

        return self._answer(
            "query_ball_point", ask, x, r, p, eps, workers, return_sorted, return_length
        )

    def query_ball_tree(
        self, other: Any, r: float, p: float = 2.0, eps: float = 0.0
    ) -> list[list[int]]:
        """Which points of another tree are within r of each point?

        Parameters
        ----------
        other : KDTree
            The other tree, of this class or SciPy's; or this one.
        r : float
            The radius. Points exactly as far belong to it.
        p, eps
            Other than 2 and 0, it is handed over.

        Returns
        -------
        list of lists of ints
            For each point the indices of those of `other`, ascending.
        """

        def ask() -> list[list[int]]:
            check_norm(p, eps)
            return in_lists(self._points.rows(self._points_of(other), _arguments.radius(r)))

        return self._answer("query_ball_tree", ask, other, r, p, eps)

    @overload
    def query_pairs(
        self, r: float, p: float = 2.0, eps: float = 0.0, output_type: Literal["set"] = "set"
    ) -> set[tuple[int, int]]: ...
    @overload
    def query_pairs(
        self, r: float, p: float = 2.0, eps: float = 0.0, *, output_type: Literal["ndarray"]
    ) -> NDArray[np.intp]: ...
    @overload
    def query_pairs(
        self, r: float, p: float, eps: float, output_type: Literal["ndarray"]
    ) -> NDArray[np.intp]: ...

    def query_pairs(
        self, r: float, p: float = 2.0, eps: float = 0.0, output_type: str = "set"
    ) -> set[tuple[int, int]] | NDArray[np.intp]:
        """Which pairs of points are within r of each other?

        Parameters
        ----------
        r : float
            The distance. Pairs exactly as far apart belong to it.
        p, eps
            Other than 2 and 0, it is handed over.
        output_type : "set" or "ndarray"
            What to return. A set takes many times as long as the search.

        Returns
        -------
        set of pairs of ints, or ndarray of intp, shape (pairs, 2)
            Each pair once, the lower index first; the array in ascending order.
        """

        def ask() -> Any:
            check_norm(p, eps)
            if output_type not in ("set", "ndarray"):
                raise HandOver(REFUSED)
            i, j = self._points.pairs(_arguments.radius(r))
            if output_type == "set":
                return set(zip(i.tolist(), j.tolist()))
            pairs = np.empty((len(i), 2), np.intp)
            pairs[:, 0] = i
            pairs[:, 1] = j
            return pairs

        return self._answer("query_pairs", ask, r, p, eps, output_type)

    def count_neighbors(
        self,
        other: Any,
        r: ArrayLike,
        p: float = 2.0,
        weights: Any = None,
        cumulative: bool = True,
    ) -> Any:
        """How many pairs of a point and one of another tree are within r of each other?

        Parameters
        ----------
        other : KDTree
            The other tree, of this class or SciPy's; or this one, of which each point counts itself
            once and each pair twice.
        r : float or array of one dimension
            The distance, or many. Pairs exactly as far apart belong to it.
        p, weights
            Other than 2 and None, it is handed over.
        cumulative : bool
            False to count for each of the ascending distances only those pairs that the one before it
            did not count.

        Returns
        -------
        int, or ndarray of intp of the shape of r
            The number of pairs.
        """

        def ask() -> Any:
            check_norm(p, 0.0)
            if weights is not None:
                raise HandOver("weights")
            return count_pairs(self._points, self._points_of(other), r, cumulative)

        return self._answer("count_neighbors", ask, other, r, p, weights, cumulative)

    def sparse_distance_matrix(
        self, other: Any, max_distance: float, p: float = 2.0, output_type: str = "dok_matrix"
    ) -> Any:
        """The distances between points and those of another tree, as far as they are within a maximum.

        Parameters
        ----------
        other : KDTree
            The other tree, of this class or SciPy's; or this one.
        max_distance : float
            The greatest distance. It belongs to the matrix.
        p : float
            Other than 2, it is handed over.
        output_type : "dok_matrix", "coo_matrix", "dict" or "ndarray"
            What to return; SciPy must be installed for the first two.

        Returns
        -------
        dok_matrix, coo_matrix, dict or ndarray
            A matrix of the shape (n, other.n), with an entry of 0 for points at one place; or
            ``{(i, j): distance}``; or a record array of the fields i, j, v.
        """

        def ask() -> Any:
            check_norm(p, 0.0)
            if output_type not in ("dok_matrix", "coo_matrix", "dict", "ndarray"):
                raise HandOver(REFUSED)
            others = self._points_of(other)
            i, j, v = self._points.between(others, _arguments.radius(max_distance), True)
            if output_type == "dict":
                return dict(zip(zip(i.tolist(), j.tolist()), v.tolist()))
            if output_type == "ndarray":
                fields = [("i", np.intp), ("j", np.intp), ("v", np.float64)]
                records = np.empty(len(i), np.dtype(fields, align=True))
                records["i"], records["j"], records["v"] = i, j, v
                return records
            from scipy.sparse import coo_matrix

            matrix = coo_matrix((v, (i, j)), shape=(len(self._points), len(others)))
            return matrix if output_type == "coo_matrix" else matrix.todok()

        return self._answer("sparse_distance_matrix", ask, other, max_distance, p, output_type)

    def _nearest(
        self, places: NDArray[Any], k: int, bound: float, threads: int
    ) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
        """The k nearest of each place, as SciPy fills up where there are fewer."""
        n = self.n
        found = min(k, n)
        if found > _MANY and bound < math.inf:
            found = self._points.most_within(places, bound, found, threads)
        i, d = self._points.nearest(places, found, threads)
        if bound < math.inf:
            far = d >= bound
            i[far], d[far] = n, math.inf
        if found == k:
            return i, d
        all_i = np.full((len(places), k), n, np.int64)
        all_d = np.full((len(places), k), math.inf)
        all_i[:, :found], all_d[:, :found] = i, d
        return all_i, all_d

    def _nearest_of_one(self, place: list[float], k: int) -> tuple[Any, Any] | None:
        """The same of one place and no bound, without what only many places need. None where it is
        for SciPy, or an error."""
        index = None if self._reason else self._points.index_or_none()
        if index is None:
            return None
        if k == 1:
            one = index.nearest_of_one(place)
            answer = None if one is None else (one[1], self._single(one[0]))
        else:
            many = index.k_nearest_of_one(place, k)
            answer = None if many is None else (many[1], many[0])
        if answer is not None:
            note_answered("query")
        return answer

    def _single(self, i: int) -> Any:
        return i


class KDTree(cKDTree):
    """`scipy.spatial.KDTree`, run by beespace where that has an answer, else by SciPy.

    Points of two or three coordinates, the norm ``p=2``, ``eps=0`` and no `boxsize` are for beespace;
    everything else is handed over to the SciPy that is installed, which is imported when it is needed.
    `handed_over` counts what was handed over and why, `answered` what beespace answered.

    It is no subclass of SciPy's; `to_scipy` makes one.

    Parameters
    ----------
    data : array of shape (n, m)
        The points. Not copied where they are doubles in rows, unless `copy_data` is true, and must not
        change while the tree is used.
    leafsize, compact_nodes, balanced_tree
        For SciPy; beespace builds no tree.
    copy_data : bool
        Whether to copy the points.
    boxsize : float or array, optional
        A periodic box: everything is handed over.

    Attributes
    ----------
    data, n, m, leafsize, boxsize, maxes, mins
        As of SciPy's.
    tree, size, indices
        Of a tree of SciPy, which is built when they are first asked for.
    handed_over : Counter
        Calls that were handed over to SciPy, by method and reason, of all trees.
    answered : Counter
        Calls that beespace answered, by method, of all trees.

    Raises
    ------
    ValueError, TypeError
        As SciPy; and for a `k` of 0 or less.
    ImportError
        Where something must be handed over and SciPy is not installed.

    Examples
    --------
    >>> from beespace.compat.scipy import KDTree
    >>> tree = KDTree([[0.0, 0.0], [3.0, 4.0], [6.0, 9.0]])
    >>> tree.query([[3.0, 3.0], [7.0, 9.0]], k=[1, 2])[1]
    array([[1, 0],
           [2, 1]])
    >>> tree.query_ball_point([[3.0, 3.0], [6.0, 8.0]], [1.0, 5.0])
    array([list([1]), list([1, 2])], dtype=object)
    >>> tree.count_neighbors(tree, [0, 5, 10])
    array([3, 5, 7])
    """

    _name: ClassVar[str] = "KDTree"

    def __init__(
        self,
        data: ArrayLike,
        leafsize: int = 10,
        compact_nodes: bool = True,
        copy_data: bool = False,
        balanced_tree: bool = True,
        boxsize: ArrayLike | None = None,
    ) -> None:
        super().__init__(data, leafsize, compact_nodes, copy_data, balanced_tree, boxsize)

    def _single(self, i: int) -> Any:
        return np.intp(i)
