"""Examples that need a library which is not there are skipped, and said to be."""

from __future__ import annotations

import importlib.util

import pytest

_needs = {"to_pandas": "pandas", "to_polars": "polars"}


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        needed = _needs.get(item.name.rpartition(".")[2])
        if needed is not None and importlib.util.find_spec(needed) is None:
            item.add_marker(pytest.mark.skip(reason=f"{needed} is not installed"))
