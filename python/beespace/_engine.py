"""The questions about points, frame after frame."""

from __future__ import annotations

from typing import Any

from beespace._library import library
from beespace._searches import Searches
from beespace._turns import InTurn


class Engine(InTurn, Searches):
    """The questions about points, with memory and threads that are kept from call to call.

    For a swarm frame after frame: searches allocate nothing after two similar frames, besides their
    answers. Answers are those of the functions of the module. One call at a time: a thread waits
    until the call of another has ended.

    Examples
    --------
    >>> import beespace
    >>> engine = beespace.Engine()
    >>> for step in range(3):
    ...     frame = [[0, 0, 0], [10 - 4 * step, 0, 0]]
    ...     print(step, engine.at_risk(frame, 5))
    0 []
    1 []
    2 [0 1]
    >>> engine
    <beespace.Engine: 3 calls so far>
    """

    __slots__ = ("_calls",)

    def __init__(self) -> None:
        self._calls = 0
        self._begin()

    def _begin(self) -> None:
        handle = library.beespace_engine_create()
        if not handle:
            raise MemoryError("beespace: no memory for an engine")
        self._take_turns(handle, threaded=True)

    def _lose(self) -> None:
        self._begin()  # it has nothing but memory

    def __repr__(self) -> str:
        calls = "1 call" if self._calls == 1 else f"{self._calls:,} calls"
        return f"<beespace.Engine: {calls} so far{', one now' if self._is_asked() else ''}>"

    def __reduce__(self) -> tuple[type[Engine], tuple[()]]:
        """Of an engine, a copy is a new one: it has nothing but memory."""
        return (Engine, ())

    def _call(self, function: Any, arguments: tuple[Any, ...]) -> int:
        with self._lock:
            self._calls += 1
            return int(function(self._handle, *arguments))

    def release_memory(self) -> None:
        """Gives the working memory back to the system. The engine can still be used.

        Examples
        --------
        >>> import beespace
        >>> engine = beespace.Engine()
        >>> engine.count([[0, 0], [3, 4]], 6)
        array([1, 1])
        >>> engine.release_memory()
        >>> engine.count([[0, 0], [3, 4]], 6)
        array([1, 1])
        """
        with self._lock:
            library.beespace_engine_release_memory(self._handle)
