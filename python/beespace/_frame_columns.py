"""Columns by name, of whatever holds them: data frames, tables, structured arrays, dictionaries."""

from __future__ import annotations

from typing import Any

import numpy as np

from beespace._errors import BeespaceError, invalid

_LISTS: Any = (list, tuple)


def column_of(frame: Any, name: str, role: str) -> Any:
    """The one column of that name, which plays this role."""
    names = _names_of(frame)
    if names.count(name) != 1:
        problem = "has no column" if name not in names else "has several columns"
        told = ", ".join(map(str, names))
        raise BeespaceError(
            f"the frame {problem} {name!r} for {role}; it has: {told}", "missing_column", role
        )
    column: Any = frame[name]
    # Of a list, each id is looked at.
    as_it_is: bool = hasattr(column, "shape") or isinstance(column, _LISTS)
    return column if as_it_is else np.asarray(column)


def _names_of(frame: Any) -> list[Any]:
    fields: Any = getattr(getattr(frame, "dtype", None), "names", None)
    if isinstance(fields, tuple):  # structured arrays
        return [*fields]
    names: Any = getattr(frame, "column_names", None)
    if isinstance(names, list):  # Arrow, whose `columns` are arrays
        return [*names]
    if hasattr(frame, "data_vars"):  # xarray: coordinates are columns, too
        return list(frame.variables)
    if hasattr(frame, "columns"):
        return list(frame.columns)
    if hasattr(frame, "keys"):
        return list(frame.keys())
    raise invalid(f"this has no columns by name: {type(frame).__name__}", "frame")
