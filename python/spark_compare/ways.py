"""Ways to ask which pairs are closer than the threshold, and who is at risk."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import beespace
import beespace.spark

OURS = "beespace.spark"
ONE_PROCESS = "beespace, one process"
OUT_OF_CORE = "OutOfCore, one process"
HALF = "grid join, half of the neighbours"
HALO = "grid join, cells of 3 thresholds"


class Way(NamedTuple):
    """A way to ask on the cluster: a data frame of positions to one of answers."""

    name: str
    ask: Callable[[Any, str, float], Any]


def on_the_cluster() -> list[Way]:
    return [Way(OURS, ours), Way(HALF, grid_of_half), Way(HALO, grid_with_halos)]


def ours(frame: Any, question: str, threshold: float) -> Any:
    return getattr(beespace.spark, question)(frame, threshold)


def one_process(folder: Path, question: str, threshold: float) -> Any:
    """In memory, with as many threads as the cluster has cores; reading included."""
    points = _read(folder)
    return getattr(beespace, question)(points, threshold, threads=2)


def out_of_core(folder: Path, question: str, threshold: float) -> Any:
    search = beespace.OutOfCore("256 MiB", threads=2)
    search.add(_read(folder))
    if question == "at_risk":
        return search.at_risk(threshold)
    return [len(piece) for piece in search.iter_pairs(threshold)]


def _read(folder: Path) -> NDArray[np.float64]:
    import pyarrow.parquet

    table = pyarrow.parquet.read_table(folder, columns=["x", "y", "z"])
    return np.column_stack([table.column(name).to_numpy() for name in ("x", "y", "z")])


def grid_of_half(frame: Any, question: str, threshold: float) -> Any:
    """Cells as wide as the threshold, in one number; one side goes to its own cell and to half of the
    26 around it, so that each pair meets once."""
    steps = [
        (x << 42) + (y << 21) + z
        for x in (-1, 0, 1)
        for y in (-1, 0, 1)
        for z in (-1, 0, 1)
        if (x, y, z) >= (0, 0, 0)
    ]
    frame.createOrReplaceTempView("positions")
    pairs = frame.sparkSession.sql(
        f"""
        WITH cells AS (SELECT id, x, y, z, {_key(threshold)} AS cell FROM positions),
        spread AS (
          SELECT id, x, y, z, cell AS own,
                 explode(transform(array({", ".join(f"{step}L" for step in steps)}), s -> s + cell)) AS cell
          FROM cells
        )
        SELECT least(a.id, b.id) AS first, greatest(a.id, b.id) AS second, {_DISTANCE} AS distance
        FROM spread a JOIN cells b ON a.cell = b.cell
        WHERE (a.own <> b.cell OR a.id < b.id) AND {_SQUARE} < {threshold * threshold}D
        """
    )
    return _answer(pairs, question)


def grid_with_halos(frame: Any, question: str, threshold: float) -> Any:
    """Larger cells: one side goes to all cells that its ball may touch, the other to its own."""
    width = 3.0 * threshold
    frame.createOrReplaceTempView("positions")

    def touched(axis: str) -> str:
        low, high = (_cell(f"{axis} {sign} {threshold}D", width) for sign in "-+")
        return f"explode(sequence({low}, {high}))"

    pairs = frame.sparkSession.sql(
        f"""
        WITH cells AS (SELECT id, x, y, z, {_key(width)} AS cell FROM positions),
        across AS (SELECT id, x, y, z, {touched("x")} AS i FROM positions),
        along AS (SELECT *, {touched("y")} AS j FROM across),
        up AS (SELECT *, {touched("z")} AS k FROM along),
        spread AS (SELECT id, x, y, z, shiftleft(i, 42) + shiftleft(j, 21) + k AS cell FROM up)
        SELECT a.id AS first, b.id AS second, {_DISTANCE} AS distance
        FROM cells a JOIN spread b ON a.cell = b.cell
        WHERE a.id < b.id AND {_SQUARE} < {threshold * threshold}D
        """
    )
    return _answer(pairs, question)


_SQUARE = "((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z))"
_DISTANCE = f"sqrt{_SQUARE}"


def _cell(value: str, width: float) -> str:
    return f"(bigint(floor(({value}) / {width}D)) + 10)"


def _key(width: float) -> str:
    x, y, z = (_cell(axis, width) for axis in "xyz")
    return f"shiftleft({x}, 42) + shiftleft({y}, 21) + {z}"


def _answer(pairs: Any, question: str) -> Any:
    if question == "pairs":
        return pairs
    return pairs.selectExpr("explode(array(first, second)) AS id").distinct()
