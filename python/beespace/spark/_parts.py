"""Which cells are searched by one task, so that tasks have equally much to do."""

from __future__ import annotations

import heapq

import numpy as np
from numpy.typing import NDArray


def pack(sizes: list[float], parts: int) -> list[int]:
    """The part of each cell: the largest cells first, each to the part that has least so far."""
    heap = [(0.0, part) for part in range(parts)]
    belongs = [0] * len(sizes)
    for cell in sorted(range(len(sizes)), key=lambda cell: (-sizes[cell], cell)):
        load, part = heapq.heappop(heap)
        belongs[cell] = part
        heapq.heappush(heap, (load + sizes[cell], part))
    return belongs


def keys_of_parts(parts: int) -> list[int]:
    """For each part a number that Spark's hash partitioning sends there, so that no two parts meet.

    If Spark hashed otherwise, tasks would be uneven, and answers the same.
    """
    keys = np.full(parts, -1, np.int64)
    begin, count = 0, 16 * parts + 64
    while (keys < 0).any():
        candidates = np.arange(begin, begin + count, dtype=np.uint32)
        sent = hashed(candidates).astype(np.int32) % np.int32(parts)
        where, first = np.unique(sent, return_index=True)
        new = keys[where] < 0
        keys[where[new]] = candidates[first[new]]
        begin += count
    return keys.tolist()


def hashed(numbers: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """What Spark's `hash` says of integers of 32 bits: Murmur3 with the seed 42."""
    mixed = _turned(numbers * np.uint32(0xCC9E2D51), 15) * np.uint32(0x1B873593)
    state = _turned(np.uint32(42) ^ mixed, 13) * np.uint32(5) + np.uint32(0xE6546B64)
    state = state ^ np.uint32(4)
    state = (state ^ (state >> np.uint32(16))) * np.uint32(0x85EBCA6B)
    state = (state ^ (state >> np.uint32(13))) * np.uint32(0xC2B2AE35)
    return state ^ (state >> np.uint32(16))


def _turned(bits: NDArray[np.uint32], by: int) -> NDArray[np.uint32]:
    return (bits << np.uint32(by)) | (bits >> np.uint32(32 - by))
