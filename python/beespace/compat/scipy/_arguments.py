"""Arguments as SciPy takes them; what beespace does not do, or SciPy refuses, is handed over."""

from __future__ import annotations

import math
import operator
import os
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from beespace.compat.scipy._handing import HandOver

REFUSED = "arguments that SciPy refuses, or knows better"
RADIUS = "a radius that is negative, infinite or no number"

_numbers = (float, int)
_array: type[Any] = np.ndarray


def check_norm(p: Any, eps: Any) -> None:
    """Goes on with the Euclidean norm alone, and with exact answers."""
    if number(p) != 2.0:
        raise HandOver("p is not 2")
    if number(eps) != 0.0:
        raise HandOver("eps is not 0")


def one_place(x: Any, m: int, p: Any, eps: Any, workers: Any) -> list[float] | None:
    """The coordinates of one place where arguments are as most calls give them: an array of doubles,
    the Euclidean norm, one thread. None where they need a closer look."""
    if (
        type(x) is _array
        and x.shape == (m,)
        and x.dtype == np.float64
        and type(p) in _numbers
        and p == 2
        and type(eps) in _numbers
        and eps == 0
        and (workers is None or type(workers) is int and workers == 1)
    ):
        coordinates: list[float] = x.tolist()
        return coordinates
    return None


def plain_radius(r: Any) -> float | None:
    """A radius as most calls give it; None of one that needs a closer look."""
    return float(r) if type(r) in _numbers and 0 <= r < math.inf else None


def number(value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise HandOver(REFUSED) from None


def radius(value: Any) -> float:
    """A radius of zero or more."""
    found = number(value)
    if not 0.0 <= found < math.inf:
        raise HandOver(RADIUS)
    return found


def threads(workers: Any) -> int:
    """How many threads `workers` is to the library."""
    if workers is None:
        return 1
    try:
        count = int(operator.index(workers))
    except TypeError:
        raise HandOver(REFUSED) from None
    if count == -1 and os.cpu_count() is not None:
        return 0
    if count < 1:
        raise HandOver(REFUSED)
    return count


class Places(NamedTuple):
    """Points that are asked about: in rows, and the shape that their answers have."""

    rows: NDArray[Any]
    shape: tuple[int, ...]


def places(x: Any, m: int) -> Places:
    given = np.asarray(x)
    if given.dtype.kind not in "fiub" or given.ndim == 0 or given.shape[-1] != m:
        raise HandOver(REFUSED)
    if given.dtype.kind != "f" or given.dtype.itemsize not in (4, 8):
        given = given.astype(np.float64)
    return Places(given.reshape(-1, m), given.shape[:-1])


def radii(r: Any, shape: tuple[int, ...]) -> float | NDArray[np.float64]:
    """One radius for all places, or one for each."""
    given = np.asarray(r)
    if given.dtype.kind not in "fiub":
        raise HandOver(REFUSED)
    if given.ndim == 0:
        return radius(given)
    try:
        each = np.broadcast_to(given, shape).astype(np.float64).reshape(-1)
    except ValueError:
        raise HandOver(REFUSED) from None
    if not ((each >= 0.0) & (each < np.inf)).all():
        raise HandOver(RADIUS)
    return each


class Ranks(NamedTuple):
    """Which of the nearest are asked for, counted from 1."""

    highest: int
    chosen: NDArray[np.intp] | None  # None: all up to the highest
    squeezed: bool  # the answer has no axis for them


def ranks(k: Any) -> Ranks:
    if type(k) not in (list, tuple, np.ndarray):
        try:
            count = int(operator.index(k))
        except TypeError:
            raise HandOver(REFUSED) from None
        if count < 1:
            raise ValueError(f"k counts the nearest neighbours from 1: {count} is none")
        return Ranks(count, None, count == 1)
    given: NDArray[Any] = np.asarray(k)
    if given.size == 0 or given.dtype.kind in "fiu" and not (given >= 1).all():
        # Some versions of SciPy read outside of their arrays where there is a rank of 0.
        raise ValueError(f"k counts the nearest neighbours from 1: not so {k}")
    if given.ndim != 1 or given.dtype.kind not in "iu":
        raise HandOver(REFUSED)
    chosen = given.astype(np.intp)
    return Ranks(int(chosen.max()), chosen, False)
