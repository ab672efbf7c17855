"""One call at a time of what the library keeps, and what becomes of it in the child of a fork."""

from __future__ import annotations

import os
import threading
import weakref
from typing import Any

from beespace._errors import invalid
from beespace._library import refuse_to_copy


class InTurn:
    """What serves one call at a time: a thread waits until the call of another has ended.

    The handler of a signal does not wait for what it has interrupted: it runs where C does not.
    """

    __slots__ = ("__weakref__", "_handle", "_lock", "_threaded")

    def __reduce__(self) -> Any:
        """Refused: a copy would be another name for what C keeps, with a memory of its own."""
        return refuse_to_copy(self)

    def _take_turns(self, handle: Any, threaded: bool) -> None:
        """Begins; `threaded` where C keeps threads between calls."""
        self._handle = handle
        self._threaded = threaded
        self._lock: Any = threading.RLock()
        _all.add(self)

    @property
    def _is_lost(self) -> bool:
        return isinstance(self._lock, _Lost)

    def _is_asked(self) -> bool:
        """Whether another thread asks it now."""
        if not self._lock.acquire(blocking=False):
            return True
        self._lock.release()
        return False

    def _after_fork(self) -> None:
        """In the child of a fork, which has the memory, but not the threads: a call, or the end of the
        handle, would wait for them for ever; and a call of another thread is never over."""
        if self._is_lost or (not self._threaded and not self._is_asked()):
            return
        self._handle.value = None  # so that it is not freed
        self._lose()

    def _lose(self) -> None:
        """What cannot be made anew, as it has seen what came before."""
        self._lock = _Lost(self._called())

    def _called(self) -> str:
        """What users know it as."""
        return type(self).__name__


class _Lost:
    """The lock of what stayed with the parent."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __enter__(self) -> None:
        raise invalid(
            f"this {self._name} has stayed with the process that this one was forked from, as it works "
            "with threads: make it in this process, or with threads=1"
        )

    def __exit__(self, *_: object) -> None:
        pass


_all: weakref.WeakSet[InTurn] = weakref.WeakSet()


def _tell_all() -> None:
    for each in list(_all):
        each._after_fork()  # pyright: ignore[reportPrivateUsage]


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_tell_all)
