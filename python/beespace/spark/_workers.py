"""What only workers of Spark need: imported when a task runs, not before."""

from __future__ import annotations

import gc
import importlib
import sys
import zipimport
from typing import Any

# The task that was spared last.
_spared: int | None = None


def arrow() -> Any:
    """The package pyarrow."""
    package = importlib.import_module("pyarrow")
    spare()
    return package


def spare() -> None:
    """Spares the next tasks of this process what Spark does before and after each of them, which may take longer
    than the task.

    Before it, Spark has Python look again for modules: zip archives, in which Spark itself comes, are read once for
    each of their folders that is known. Unknown ones are made known when they are needed. After it, Spark collects
    garbage: among some 100,000 objects of modules, which stay. They are set aside, once.
    """
    global _spared
    context = _context()
    if context is None or context.taskAttemptId() == _spared:
        return
    for path, finder in list(sys.path_importer_cache.items()):
        if isinstance(finder, zipimport.zipimporter):
            del sys.path_importer_cache[path]
    if _spared is None:
        gc.freeze()
    _spared = context.taskAttemptId()


def partition_of_task() -> int:
    """The number of the partition that this task is of."""
    context = _context()
    return 0 if context is None else int(context.partitionId())


def threads_of_task() -> int:
    """How many processors this task may use."""
    context = _context()
    return 1 if context is None else max(int(context.cpus()), 1)


def _context() -> Any:
    return importlib.import_module("pyspark").TaskContext.get()
