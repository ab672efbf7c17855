"""Do workers have what a search needs? Asked before the long work."""

from __future__ import annotations

import importlib
from typing import Any

from beespace._errors import BeespaceError
from beespace._library import version

# What says more in an error of Spark than its first line.
_TELLING = ("PYTHON_VERSION_MISMATCH", "Cannot run program", "ModuleNotFoundError", "ImportError")
_LONGEST = 400
# Applications of Spark whose workers were found to have everything.
_checked: set[str] = set()


def check_workers(session: Any) -> None:
    """A tiny job, once for each application of Spark: do workers have the packages, and this version?"""
    application = application_of(session)
    if application in _checked:
        return
    functions: Any = importlib.import_module("pyspark.sql.functions")
    # Rows are pickled: nothing of what is looked for is needed for that.
    probe = functions.udf(_probe_for(version()), "string", useArrow=False)
    tasks = processors_of(session)
    try:
        rows = session.range(0, tasks, 1, tasks).select(probe("id").alias("told")).collect()
    except Exception as error:
        raise BeespaceError(
            f"the workers of Spark do not run Python as this program needs it: {_telling(str(error))}",
            "invalid_argument",
        ) from error
    wrong = sorted({row["told"] for row in rows if row["told"]})
    if wrong:
        raise BeespaceError(wrong[0], "invalid_argument")
    if application:
        _checked.add(application)


def _probe_for(expected: str) -> Any:
    # Defined here, it is sent as it is: workers without the package can run it.
    def probe(_: int) -> str:
        import importlib
        import socket
        import sys

        at = f"on {socket.gethostname()}, for {sys.executable}"
        lacking: list[str] = []
        reasons: list[str] = []
        for name in ("numpy", "pyarrow"):
            try:
                importlib.import_module(name)
                if name == "pyarrow":
                    importlib.import_module("pyspark.sql.pandas.utils").require_minimum_pyarrow_version()
            except Exception as error:  # one that is broken says so in ways of its own
                lacking.append(name)
                reasons.append(f"{error}")
        if lacking:
            return (
                f"the workers of Spark cannot hand points to a search: {at}: {'; '.join(reasons)}. Install "
                f"{' and '.join(lacking)} there, or name a Python that has them, with spark.pyspark.python or "
                "PYSPARK_PYTHON"
            )
        try:
            importlib.import_module("beespace.spark._questions")
            there = importlib.import_module("beespace").__version__
            wrong = "" if there == expected else f"its version is {there}"
        except Exception as error:
            wrong = f"{error}"
        if not wrong:
            return ""
        return (
            f"the workers of Spark do not have beespace {expected}, as this program has: {at}: {wrong}. "
            "Install it there for the Python of spark.pyspark.python, or ship it with --archives"
        )

    return probe


def _telling(text: str) -> str:
    """The line of an error that says most, without the stack of Java around it."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    some = [line for word in _TELLING for line in lines if word in line]
    return (some or lines or ["it is not said why"])[0][:_LONGEST]


def application_of(session: Any) -> str | None:
    """What Spark calls this application, where it says so."""
    try:
        return str(session.sparkContext.applicationId)
    except Exception:  # Spark Connect has no context, and says so in ways of its own
        return None


def processors_of(session: Any) -> int:
    """How many tasks run at a time, about."""
    try:
        return max(int(session.sparkContext.defaultParallelism), 1)
    except Exception:  # Spark Connect has no context, and says so in ways of its own
        return max(int(session.conf.get("spark.sql.shuffle.partitions")), 1)
