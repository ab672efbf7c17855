"""A way to ask a package one question."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from questions import Answer

Points = NDArray[np.float64]


@dataclass(frozen=True)
class Way:
    """`ask(points, threshold)` is what is timed, from the array of points to arrays of NumPy, a
    structure of the package's own included. `read(what it returned, points)` brings it into the form
    in which answers are compared, which is not timed."""

    peer: str
    how: str  # the function, as a user calls it
    question: str
    ask: Callable[[Points, float], Any]
    read: Callable[[Any, Points], Answer]
    floats: bool = False  # computes in 32 bits

    @property
    def name(self) -> str:
        return f"{self.peer}: {self.how}"

    def off_m(self, side_m: float) -> float:
        """How far a distance may be off: some roundings of coordinates of this size."""
        return side_m * (2.0**-20 if self.floats else 2.0**-46)


def flags_of_ids(ids: Any, points: Points) -> Answer:
    flags = np.zeros(len(points), bool)
    flags[np.asarray(ids).astype(np.int64)] = True
    return Answer(flags)


def as_it_is(array: Any, points: Points) -> Answer:
    return Answer(np.asarray(array).astype(np.int64))


def as_flags(array: Any, points: Points) -> Answer:
    return Answer(np.asarray(array))


def of_nearest(found: Any, points: Points) -> Answer:
    """Of distances and ids in rows of one or many."""
    distances, ids = found
    n = len(points)
    return Answer(
        np.asarray(ids).reshape(n, -1).astype(np.int64),
        np.asarray(distances, np.float64).reshape(n, -1),
    )
