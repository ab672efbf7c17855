"""What is asked about: uniform points in a cube, of a mean number of neighbours."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

THRESHOLD_M = 100.0


@dataclass(frozen=True)
class Scene:
    """So many points, each of which has so many others within the threshold, but for the border."""

    points: int
    neighbours: float

    @property
    def name(self) -> str:
        return f"{self.points:,} points, λ = {self.neighbours:g}"

    @property
    def side_m(self) -> float:
        ball = 4.0 / 3.0 * math.pi * THRESHOLD_M**3
        return (self.points * ball / self.neighbours) ** (1.0 / 3.0)

    def make(self) -> NDArray[np.float64]:
        seed = (self.points, round(1000 * self.neighbours))
        return np.random.default_rng(seed).uniform(0.0, self.side_m, (self.points, 3))

    def write(self, folder: Path) -> Path:
        """The points as a file of doubles, for programs and processes of their own."""
        path = folder / f"{self.points}-{self.neighbours:g}.f64"
        if not path.exists():
            self.make().tofile(path)
        return path
