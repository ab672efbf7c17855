"""The C++ library, asked by a program of its own: what the layers above it are measured against."""

from __future__ import annotations

import json
import subprocess
from dataclasses import dataclass
from pathlib import Path

from scenes import THRESHOLD_M


@dataclass
class OfLibrary:
    """What `bench/answer_benchmark.cpp` says: vectors of the C++ library."""

    seconds: list[float]
    peak_bytes: int  # beyond the answer, of the first call


def ask_library(program: Path | None, question: str, points: Path, runs: int) -> OfLibrary | None:
    """None where the program was not built."""
    if program is None or not program.exists():
        return None
    command = [str(program), question, str(points), str(THRESHOLD_M), str(runs)]
    said = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    return OfLibrary(said["seconds"], said["peak_bytes"])
