"""The same points in every layout that a caller may have them in."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np


def _backwards(points: Any) -> Any:
    return np.ascontiguousarray(points[::-1])[::-1]


def _mirrored(points: Any) -> Any:
    return np.ascontiguousarray(points[:, ::-1])[:, ::-1]


def _spread(points: Any) -> Any:
    rows, axes = points.shape
    wide = np.full((3 * rows + 1, 2 * axes + 1), np.nan, points.dtype)
    wide[1::3, 1::2] = points
    return wide[1::3, 1::2]


def _axes(points: Any) -> Any:
    return tuple(np.ascontiguousarray(axis) for axis in points.T)


def _axes_of_a_table(points: Any) -> Any:
    names = "xyz"[: points.shape[1]]
    table = np.zeros(len(points), [("name", "S5"), *((name, points.dtype) for name in names)])
    for axis, name in enumerate(names):
        table[name] = points[:, axis]
    return tuple(table[name] for name in names)


def _axes_there_and_back(points: Any) -> Any:
    axes = list(_axes(points))
    axes[0] = np.ascontiguousarray(axes[0][::-1])[::-1]
    axes[-1] = np.repeat(axes[-1], 2)[::2]
    return tuple(axes)


def _unaligned(points: Any) -> Any:
    flat = np.zeros(points.nbytes + 1, np.uint8)[1:]
    moved = flat.view(points.dtype).reshape(points.shape)
    moved[...] = points
    return moved


def _read_only(points: Any) -> Any:
    copy = points.copy()
    copy.flags.writeable = False
    return copy


def _of_the_other_bytes(points: Any) -> Any:
    return points.astype(points.dtype.newbyteorder())


# Each gives the same coordinates; of NaNs around them, none may be read.
layouts: dict[str, Callable[[Any], Any]] = {
    "rows": lambda points: points,
    "columns": np.asfortranarray,
    "backwards": _backwards,
    "mirrored": _mirrored,
    "spread": _spread,
    "axes": _axes,
    "axes of a table": _axes_of_a_table,
    "axes there and back": _axes_there_and_back,
    "unaligned": _unaligned,
    "read only": _read_only,
    "of the other bytes": _of_the_other_bytes,
    "lists": lambda points: points.tolist() if len(points) else points,
}
