#!/usr/bin/env python3
"""Runs the k-d tree tests of the SciPy that is installed, with its trees replaced by ours.

    run_scipy_tests.py [ARGUMENT OF PYTEST...]

Needs NumPy, SciPy with its tests, and pytest. Afterwards it says how many calls beespace answered, how
many tests these were of, and what was handed over to SciPy and why. The exit status is that of pytest;
it is an error, too, if beespace answered nothing.
"""

from __future__ import annotations

import collections
import importlib
import importlib.util
import sys
from pathlib import Path
from typing import Any

import numpy
import pytest
import scipy
import scipy.spatial

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
sys.dont_write_bytecode = True

from beespace.compat.scipy import KDTree, answered, cKDTree, handed_over  # noqa: E402

TESTS = "scipy.spatial.tests.test_kdtree"


class Tally:
    """Sorts the tests by who answered them."""

    def __init__(self) -> None:
        self.calls: collections.Counter[str] = collections.Counter()
        self.handed: collections.Counter[tuple[str, str]] = collections.Counter()
        self.tests: collections.Counter[str] = collections.Counter()

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item: Any) -> Any:
        answered.clear()
        handed_over.clear()
        yield
        self.calls.update(answered)
        self.handed.update(handed_over)
        if answered and handed_over:
            who = "beespace and SciPy, call by call"
        elif answered:
            who = "beespace alone"
        elif handed_over:
            who = "SciPy alone, handed over"
        else:
            who = "no tree"
        self.tests[who] += 1

    def show(self) -> None:
        print(f"\nSciPy {scipy.__version__}, NumPy {numpy.__version__}: tests by who answered")
        for who, count in sorted(self.tests.items()):
            print(f"{count:7}  {who}")
        print(f"calls answered by beespace: {sum(self.calls.values())}")
        for method, count in sorted(self.calls.items()):
            print(f"{count:7}  {method}")
        print(f"calls handed over to SciPy: {sum(self.handed.values())}")
        for (method, reason), count in sorted(self.handed.items()):
            print(f"{count:7}  {method}: {reason}")


def main() -> int:
    if importlib.util.find_spec(TESTS) is None:
        print(f"The SciPy here has no tests ({TESTS}): install one that has them", file=sys.stderr)
        return 1
    scipy.spatial.KDTree, scipy.spatial.cKDTree = KDTree, cKDTree
    tests = importlib.import_module(TESTS)
    assert tests.KDTree is KDTree and tests.cKDTree is cKDTree
    tally = Tally()
    options = ["-q", "-p", "no:cacheprovider", "-W", "ignore::pytest.PytestUnknownMarkWarning"]
    code = pytest.main([*options, "--pyargs", TESTS, *sys.argv[1:]], plugins=[tally])
    tally.show()
    if code == 0 and not tally.calls:
        print("beespace answered nothing", file=sys.stderr)
        return 1
    return int(code)


if __name__ == "__main__":
    sys.exit(main())
