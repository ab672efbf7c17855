"""Examples that need a library which is not there are skipped, and said to be. Ctrl-C is what it is at a
terminal."""

from __future__ import annotations

import importlib.util
import os
import signal

import pytest

_needs = {"to_pandas": "pandas", "to_polars": "polars", "plot": "matplotlib"}
_readers = (
    "_coverage.", "_file_conflicts.", "_file_movers.", "_file_obstacles.", "_file_points.",
    "_file_recording.", "_files.", "_flight_verdict.", "_report.", ".from_file", "FileError", "OSError",
)

# A shell starts what runs in its background deaf to Ctrl-C.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        needed = _needs.get(item.name.rpartition(".")[2])
        if needed is not None and importlib.util.find_spec(needed) is None:
            item.add_marker(pytest.mark.skip(reason=f"{needed} is not installed"))
        of_files = type(item).__name__ == "DoctestItem" and any(each in item.name for each in _readers)
        if of_files and "BEESPACE_IO_LIBRARY" not in os.environ:
            item.add_marker(pytest.mark.skip(reason="there is no library that reads files"))
