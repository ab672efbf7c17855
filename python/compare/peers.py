"""All peers, as far as they are installed."""

from __future__ import annotations

import importlib.metadata
from collections.abc import Callable

import lists
import own
import trees
from ways import Way

# By the name that their ways have.
_PEERS: dict[str, tuple[str, Callable[[], list[Way]]]] = {
    "SciPy cKDTree": ("scipy", trees.of_scipy),
    "scikit-learn": ("scikit-learn", trees.of_scikit_learn),
    "pykdtree": ("pykdtree", trees.of_pykdtree),
    "vesin": ("vesin", lists.of_vesin),
    "matscipy": ("matscipy", lists.of_matscipy),
    "freud": ("freud-analysis", lists.of_freud),
}


def versions() -> dict[str, str]:
    """Of what is installed, of those that are compared and of NumPy."""
    found: dict[str, str] = {}
    for package in (*(package for package, _ in _PEERS.values()), "numpy"):
        try:
            found[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            continue
    return found


def ways_of(question: str, only: str | None = None) -> list[Way]:
    """All ways to ask a question, or those of one peer; beespace's is the first."""
    installed = versions()
    found = own.ways()
    for name, (package, ways) in _PEERS.items():
        if package in installed and only in (None, name):
            found += ways()
    return [way for way in found if way.question == question and only in (None, way.peer)]
