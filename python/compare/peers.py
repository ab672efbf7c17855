"""All peers, as far as they are installed."""

from __future__ import annotations

import importlib.metadata
from collections.abc import Callable

import lists
import own
import trees
from ways import Way

_PEERS: dict[str, Callable[[], list[Way]]] = {
    "scipy": trees.of_scipy,
    "scikit-learn": trees.of_scikit_learn,
    "pykdtree": trees.of_pykdtree,
    "vesin": lists.of_vesin,
    "matscipy": lists.of_matscipy,
    "freud-analysis": lists.of_freud,
}


def versions() -> dict[str, str]:
    """Of what is installed, of those that are compared and of NumPy."""
    found: dict[str, str] = {}
    for package in (*_PEERS, "numpy"):
        try:
            found[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            continue
    return found


def ways_of(question: str) -> list[Way]:
    """All ways to ask a question; beespace's is the first."""
    installed = versions()
    found = own.ways()
    for package, ways in _PEERS.items():
        if package in installed:
            found += ways()
    return [way for way in found if way.question == question]
