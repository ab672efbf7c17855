"""What is asked about: points in Parquet, with ids that ascend from file to file."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

THRESHOLD_M = 1.0
_FILES = 4
_CROWDED = 100.0  # so many times as dense are clusters as what is around them


@dataclass(frozen=True)
class Scene:
    """So many points, each with so many others within the threshold, but for borders."""

    points: int
    neighbours: float
    layout: str = "uniform"  # "clusters": half of the points in ten balls, 100 times as dense

    @property
    def name(self) -> str:
        return f"{self.points:,} points, λ = {self.neighbours:g}, {self.layout}"

    @property
    def side_m(self) -> float:
        ball = 4.0 / 3.0 * math.pi * THRESHOLD_M**3
        return (self.points * ball / self.neighbours) ** (1.0 / 3.0)

    def make(self) -> NDArray[np.float64]:
        random = np.random.default_rng((self.points, round(1000 * self.neighbours)))
        points = random.uniform(0.0, self.side_m, (self.points, 3))
        if self.layout == "clusters":
            each = self.points // 20
            side = self.side_m * (each / self.points / _CROWDED) ** (1.0 / 3.0)
            for at in range(10):
                corner = random.uniform(0.0, self.side_m - side, 3)
                points[at * each : (at + 1) * each] = corner + random.uniform(0.0, side, (each, 3))
            random.shuffle(points)
        return points

    def write(self, folder: Path) -> Path:
        """The points as a folder of Parquet."""
        import pyarrow
        import pyarrow.parquet

        into = folder / f"{self.points}-{self.neighbours:g}-{self.layout}"
        if not into.exists():
            points = self.make()
            into.mkdir(parents=True)
            for at in range(_FILES):
                rows = slice(at * self.points // _FILES, (at + 1) * self.points // _FILES)
                x, y, z = points[rows].T
                table = pyarrow.table({"id": np.arange(rows.start, rows.stop), "x": x, "y": y, "z": z})
                pyarrow.parquet.write_table(table, into / f"part-{at}.parquet")
        return into
