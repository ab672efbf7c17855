"""What only workers of Spark need: imported when a task runs, not before."""

from __future__ import annotations

import importlib
from typing import Any


def arrow() -> Any:
    """The package pyarrow."""
    return importlib.import_module("pyarrow")


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
