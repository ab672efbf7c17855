"""Arrays and texts of what was read from a file, where they are."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import NDArray


def text_of(text: bytes) -> str:
    return text.decode(errors="replace")


def texts_of(get: Any, handle: ctypes.c_void_p, count: int) -> NDArray[Any] | None:
    """Texts that lie one behind the other; None where there are none at all."""
    offsets = ctypes.c_void_p()
    address = get(handle, ctypes.byref(offsets))
    if address is None:
        return None
    ends = array_of(handle, offsets.value, (count + 1,), np.int64)
    texts = np.empty(count, object)
    if count:
        several = ctypes.string_at(address, int(ends[-1])).decode(errors="backslashreplace")
        texts[:] = several.split("\0")[:-1]
    texts.flags.writeable = False
    return texts


class _Memory:
    """What NumPy makes an array of: it keeps this, and this keeps the handle."""

    __slots__ = ("__array_interface__", "handle")

    def __init__(
        self, handle: ctypes.c_void_p, address: int, shape: tuple[int, ...], code: str
    ) -> None:
        self.handle = handle
        self.__array_interface__ = {
            "shape": shape,
            "typestr": code,
            "data": (address, True),
            "version": 3,
        }


def array_of(
    handle: ctypes.c_void_p, address: int | None, shape: tuple[int, ...], dtype: Any
) -> NDArray[Any]:
    if address is None:
        return np.empty(shape, dtype)
    return np.asarray(_Memory(handle, address, shape, np.dtype(dtype).str))


def converted(
    positions: NDArray[np.float64], dtype: Any, copy: bool | None
) -> NDArray[Any]:
    """What NumPy is given where it asks for an array."""
    if dtype is not None and np.dtype(dtype) != positions.dtype:
        if copy is False:
            raise ValueError("positions are float64; another type is a copy")
        return positions.astype(dtype)
    return positions.copy() if copy else positions
