"""What is handed over to SciPy, and the count of it."""

from __future__ import annotations

import collections
import importlib
import logging
import threading
from typing import Any

handed_over: collections.Counter[tuple[str, str]] = collections.Counter()
"""How many calls were handed over to SciPy, by method and reason: ``("query", "p is not 2")``. Of all
trees since the import; ``clear()`` begins anew. The log "beespace.compat.scipy" has a line for each, at
the level DEBUG."""

answered: collections.Counter[str] = collections.Counter()
"""How many calls beespace answered, by method."""

_log = logging.getLogger("beespace.compat.scipy")
_lock = threading.Lock()  # of the counters: += is not one step


class HandOver(Exception):
    """A call that is not for beespace, and why."""


def note_answered(method: str) -> None:
    with _lock:
        answered[method] += 1


def note_handed_over(method: str, reason: str) -> None:
    with _lock:
        handed_over[method, reason] += 1
    _log.debug("%s is handed over to SciPy: %s", method, reason)


def scipy_class(name: str, reason: str) -> Any:
    """A class of scipy.spatial; also where ours was put in its place."""
    try:
        found = getattr(importlib.import_module("scipy.spatial"), name)
        if getattr(found, "__module__", "").startswith("beespace."):
            found = getattr(importlib.import_module("scipy.spatial._kdtree"), name)
    except ImportError as error:
        raise ImportError(
            f"beespace hands this to SciPy ({reason}), which is not installed: pip install scipy"
        ) from error
    return found
