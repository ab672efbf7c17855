"""How many points of each partition go into the sample: as many as the cells need, and hardly more.

The driver collects the sample of all partitions, before anyone knows how many rows there are. A partition knows its
own rows and its number p, so that there are at least p + 1 partitions. If all are alike, there are at least p + 1
times its rows, and cells are as large as so many rows want them, or larger. So each partition takes the share of its
points that is needed for cells of that size: the later ones, of many, that for cells of the limit.

In all that is `POINTS_A_CELL` for each cell of the limit, and (`LEAST` + 2 · `POINTS_A_CELL` · the cells that give all
processors work) · (1 + ln(partitions)) besides, or a few of each partition, however many rows there are. The sample in
the end is that of the lowest share.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

# So many points of the sample tell how large a cell is, to about a tenth.
POINTS_A_CELL = 128
# The sample has at least so many points, of fewer rows all.
LEAST = 1 << 15
# Tasks for each of the processors, so that a slow one does not keep the others waiting for long.
TASKS_A_PROCESSOR = 3
# A cell is not cut for the sake of other processors below this.
_WORTH_A_CELL = 200_000
# A partition gives so many at least, so that there are some where others are empty.
_LEAST_OF_PARTITION = 16
_SPARE = 1024
_ALL_KEYS = 2**64 - 1


class CellSize(NamedTuple):
    """How large cells are: what is asked for, and what the cluster has."""

    most: int  # points of a cell
    at_once: int  # tasks

    def wanted(self, rows: int) -> float:
        """How many of so many points a cell is to have, so that all processors have work."""
        return min(self.most, max(rows / (TASKS_A_PROCESSOR * self.at_once), _WORTH_A_CELL))

    def share(self, partition: int, rows: int) -> float:
        """Of the points of a partition, which has so many: this share goes into the sample. The more rows,
        the lower."""
        in_all = rows * (partition + 1)
        needed = max(LEAST / max(in_all, 1), POINTS_A_CELL / self.wanted(in_all))
        return min(1.0, max(needed, _LEAST_OF_PARTITION / max(rows, 1)))


class Sampler:
    """The points of a partition with the lowest keys, as they come."""

    def __init__(self, size: CellSize, partition: int, width: int) -> None:
        self.size = size
        self.partition = partition
        self.rows = 0
        self.below = _ALL_KEYS  # all points whose keys are not above this are there
        self.keys: list[NDArray[np.uint64]] = [np.empty(0, np.uint64)]
        self.points: list[NDArray[np.float64]] = [np.empty((0, width))]
        self.count = 0

    def add(self, keys: NDArray[np.uint64], points: NDArray[np.float64]) -> None:
        """The points that come next. Keys look random."""
        self.rows += len(keys)
        share = self.size.share(self.partition, self.rows)
        self.below = min(self.below, int(share * 2.0**64))
        some = keys <= np.uint64(self.below)
        self.keys.append(keys[some])
        self.points.append(points[some])
        self.count += len(self.keys[-1])
        if self.count > 2 * share * self.rows + _SPARE:
            self._drop(int(share * self.rows) + 1)

    def _drop(self, expected: int) -> None:
        keys, points = self.take()
        if len(keys) > 2 * expected + _SPARE:  # ids come again and again, so their keys are not random
            self.below = int(np.partition(keys, expected)[expected])
            order = np.argsort(keys, kind="stable")[:expected]
            keys, points = keys[order], points[order]
        self.keys, self.points, self.count = [keys], [points], len(keys)

    def take(self) -> tuple[NDArray[np.uint64], NDArray[np.float64]]:
        """What is in the sample of this partition."""
        keys, points = np.concatenate(self.keys), np.concatenate(self.points)
        some = keys <= np.uint64(self.below)
        return keys[some], points[some]
