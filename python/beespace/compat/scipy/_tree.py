"""What a tree holds, and what it leaves to SciPy."""

from __future__ import annotations

import collections
import functools
import importlib.metadata
import sys
from collections.abc import Callable
from typing import Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beespace._frames import Known, check_alike, frame_of
from beespace.compat.scipy import _handing
from beespace.compat.scipy._arguments import REFUSED
from beespace.compat.scipy._handing import HandOver, scipy_class
from beespace.compat.scipy._points import TreePoints, handing_over_what_is_outside

_Answer = TypeVar("_Answer")


class _NodesOfScipy(type):
    """SciPy's classes of nodes, which stand in the class of the tree: `KDTree.leafnode`."""

    def __getattr__(cls, name: str) -> Any:
        if name in ("node", "leafnode", "innernode"):
            try:
                return getattr(scipy_class(cls._name, name), name)
            except ImportError as error:
                raise AttributeError(str(error)) from error
        raise AttributeError(f"type object {cls.__name__!r} has no attribute {name!r}")


class Tree(metaclass=_NodesOfScipy):
    """Points, and a tree of SciPy of the same points as soon as something is handed over."""

    handed_over: ClassVar[collections.Counter[tuple[str, str]]] = _handing.handed_over
    answered: ClassVar[collections.Counter[str]] = _handing.answered
    _name: ClassVar[str]  # of SciPy's class

    def __init__(
        self,
        data: ArrayLike,
        leafsize: int,
        compact_nodes: bool,
        copy_data: bool,
        balanced_tree: bool,
        boxsize: ArrayLike | None,
    ) -> None:
        self._options = (leafsize, compact_nodes, False, balanced_tree, boxsize)
        self._frame = frame_of(data)
        self._scipy: Any = None
        self._reason = ""
        try:
            self._points = _points(data, leafsize, copy_data, boxsize)
        except HandOver as why:
            self._reason = str(why)
        if self._reason:
            # Made now, as SciPy may refuse the data.
            _handing.note_handed_over("__init__", self._reason)
            made = scipy_class(type(self)._name, self._reason)
            self._scipy = made(data, leafsize, compact_nodes, copy_data, balanced_tree, boxsize)
            self._points = TreePoints(self._scipy.data)

    # ---- What the tree holds -------------------------------------------------------------------

    @property
    def data(self) -> NDArray[np.float64]:
        """The points, shape (n, m): the caller's memory where that is of doubles in rows, unless
        `copy_data` was true. It must not change while the tree is used; here it is read-only, as from
        SciPy 1.18 on."""
        return _fixed(self._points.data)

    @property
    def n(self) -> int:
        """The number of points."""
        return len(self._points.data)

    @property
    def m(self) -> int:
        """The number of coordinates of a point."""
        return int(self._points.data.shape[1])

    @property
    def leafsize(self) -> int:
        """As given. beespace has no leaves."""
        return int(self._options[0])

    @property
    def boxsize(self) -> NDArray[np.float64] | None:
        """The sizes of a periodic box, or None."""
        return None if self._options[4] is None else self._tree_of_scipy("boxsize").boxsize

    @property
    def maxes(self) -> NDArray[np.float64]:
        """The greatest coordinates."""
        return _fixed(self.data.max(axis=0) if self.n else np.zeros(self.m))

    @property
    def mins(self) -> NDArray[np.float64]:
        """The least coordinates."""
        return _fixed(self.data.min(axis=0) if self.n else np.zeros(self.m))

    def __getattr__(self, name: str) -> Any:
        """What belongs to the tree of SciPy itself (`tree`, `size`, `indices`) is asked of one, which
        is built when first asked."""
        if name.startswith("__") or "_options" not in self.__dict__:
            raise AttributeError(name)
        try:
            known = hasattr(scipy_class(type(self)._name, name), name)
        except ImportError as error:
            raise AttributeError(str(error)) from error
        if not known:
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        _handing.note_handed_over(name, "an attribute of the tree itself")
        return getattr(self._tree_of_scipy(name), name)

    def __setattr__(self, name: str, value: Any) -> None:
        """As of a tree of SciPy, what belongs to the tree itself cannot be set."""
        if name in ("tree", "size", "indices"):
            raise AttributeError(f"attribute {name!r} of {type(self).__name__!r} objects is not writable")
        super().__setattr__(name, value)

    def __repr__(self) -> str:
        return f"<beespace.compat.scipy.{type(self).__name__}: {self.n:,} points of {self.m} axes>"

    def __getstate__(self) -> dict[str, Any]:
        return {"data": self._points.data, "options": self._options, "frame": self._frame}

    def __setstate__(self, state: dict[str, Any]) -> None:
        Tree.__init__(self, state["data"], *state["options"])
        self._frame = state["frame"]

    def to_scipy(self) -> Any:
        """The tree of SciPy itself, of the same points; for what wants one."""
        _handing.note_handed_over("to_scipy", "an attribute of the tree itself")
        return self._tree_of_scipy("to_scipy")

    # ---- How it is answered ----------------------------------------------------------------------

    def _check_frame(self, places: Any, place: str) -> None:
        """Refuses places of which it is known that they are in another frame: nothing is near them."""
        if self._frame is not None:
            check_alike(Known(frame=frame_of(places)), Known(frame=self._frame), place, "points")

    def _answer(self, method: str, ask: Callable[[], _Answer], *arguments: Any) -> _Answer:
        """The answer of beespace; of SciPy where that is not for beespace."""
        reason = self._reason
        if not reason:
            try:
                with handing_over_what_is_outside():
                    answer = ask()
                _handing.note_answered(method)
                return answer
            except HandOver as why:
                reason = str(why)
        return self._hand_over(method, reason, arguments)

    def _hand_over(self, method: str, reason: str, arguments: tuple[Any, ...]) -> Any:
        _handing.note_handed_over(method, reason)
        theirs = [
            each._tree_of_scipy(reason) if isinstance(each, Tree) else each for each in arguments
        ]
        return getattr(self._tree_of_scipy(reason), method)(*theirs)

    def _tree_of_scipy(self, reason: str) -> Any:
        if self._scipy is None:
            self._scipy = scipy_class(type(self)._name, reason)(self._points.data, *self._options)
        return self._scipy

    def _points_of(self, other: Any) -> TreePoints:
        """The points of another tree, ours or SciPy's, which have as many coordinates."""
        if isinstance(other, Tree):
            if self._frame is not None:
                check_alike(Known(frame=other._frame), Known(frame=self._frame), "other", "points")
            if other._reason or other.m != self.m:
                raise HandOver(other._reason or REFUSED)
            return other._points
        scipy = sys.modules.get("scipy.spatial._kdtree")
        if scipy is None or not isinstance(other, scipy.cKDTree) or other.m != self.m:
            raise HandOver(REFUSED)
        if other.boxsize is not None:
            raise HandOver("boxsize")
        return TreePoints(other.data)


@functools.cache
def _are_fixed() -> bool:
    """Whether the arrays of a tree of the installed SciPy are read-only; if there is none, so are ours."""
    try:
        major, minor = importlib.metadata.version("scipy").split(".")[:2]
    except importlib.metadata.PackageNotFoundError:
        return True
    return (int(major), int(minor)) >= (1, 18)


def _fixed(array: NDArray[np.float64]) -> NDArray[np.float64]:
    if not _are_fixed():
        return array
    seen = array.view()
    seen.flags.writeable = False
    return seen


def _points(data: Any, leafsize: Any, copied: bool, boxsize: Any) -> TreePoints:
    """The points of a tree that is for beespace."""
    given = np.asarray(data)
    if given.ndim != 2 or given.dtype.kind not in "fiub":
        raise HandOver(REFUSED)
    if not isinstance(leafsize, (int, np.integer)) or leafsize < 1:
        raise HandOver(REFUSED)
    if given.shape[1] not in (2, 3):
        raise HandOver(f"points of {given.shape[1]} coordinates")
    if boxsize is not None:
        raise HandOver("boxsize")
    # The array itself where it is of doubles in rows.
    held: NDArray[np.float64] = np.array(given, np.float64, order="C") if copied else np.require(
        given, np.float64, ["C", "A"]
    )
    if not np.isfinite(held).all():
        raise HandOver("coordinates that are not finite")
    return TreePoints(held)
