"""Arrays of positions that say in which frame they are, as long as they are positions."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


class PlacedArray(np.ndarray[Any, np.dtype[np.float64]]):
    """An array of NumPy whose rows, slices and copies have its `frame`. What is computed of it has
    none: differences, or positions that were turned, are in whatever frame the caller made."""

    frame: str | None

    def __array_finalize__(self, of: Any) -> None:
        self.frame = getattr(of, "frame", None)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        out = options.get("out")
        if out is not None:
            options["out"] = tuple(_plain(each) for each in out)
        return getattr(ufunc, method)(*(_plain(each) for each in inputs), **options)

    def __reduce__(self) -> Any:
        return placed, (_plain(self), self.frame)

    def __repr__(self) -> str:
        return repr(_plain(self))


def placed(positions: NDArray[np.float64], frame: str | None) -> NDArray[np.float64]:
    """The same memory, and the frame."""
    array = positions.view(PlacedArray)
    array.frame = frame
    return array


def _plain(given: Any) -> Any:
    return np.asarray(given) if isinstance(given, PlacedArray) else given
