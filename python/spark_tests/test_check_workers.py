"""Workers whose Python lacks what a search needs are found before the work: what to do is said."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import beespace
import beespace.spark
import numpy as np
import pytest
from beespace.spark import _check_workers


class Python:
    """An environment with nothing but Python, and what is put into it."""

    def __init__(self, folder):
        subprocess.run([sys.executable, "-m", "venv", "--without-pip", folder], check=True)
        self.program = folder / "bin" / "python"
        (self.packages,) = folder.glob("lib/python*/site-packages")

    def add(self, name, text):
        (self.packages / f"{name}.py").write_text(text)

    def add_numpy(self):
        here = Path(np.__file__).parent
        for place in (here, here.parent / "numpy.libs"):
            if place.exists():
                (self.packages / place.name).symlink_to(place)


@pytest.fixture
def error_with(session, monkeypatch):
    """What is said where workers run another Python. Rows fail wherever they are read."""
    monkeypatch.setattr(_check_workers, "_checked", set())
    frame = session.range(3).selectExpr(
        "id", "0D AS x", "0D AS y", "cast(raise_error('read') AS double) AS z", "0D AS time"
    )

    def ask(program, question=beespace.spark.at_risk):
        monkeypatch.setattr(session.sparkContext, "pythonExec", str(program))
        with pytest.raises(beespace.BeespaceError) as caught:
            question(frame, 5)
        assert caught.value.code == "invalid_argument"
        return str(caught.value)

    return ask


def test_a_bare_python(error_with, tmp_path):
    bare = Python(tmp_path / "bare")
    for question in (beespace.spark.at_risk, beespace.spark.conflicts):
        told = error_with(bare.program, question)
        assert "Install numpy and pyarrow there" in told and str(bare.program) in told
        assert "No module named 'numpy'; No module named 'pyarrow'" in told and "PYSPARK_PYTHON" in told


def test_without_pyarrow(error_with, tmp_path):
    some = Python(tmp_path / "some")
    some.add_numpy()
    told = error_with(some.program)
    assert "Install pyarrow there" in told and "No module named 'pyarrow'" in told


def test_pyarrow_that_is_too_old(error_with, tmp_path):
    some = Python(tmp_path / "some")
    some.add_numpy()
    some.add("pyarrow", "__version__ = '1.0.0'\n")
    told = error_with(some.program)
    assert "Install pyarrow there" in told and "1.0.0" in told


def test_another_version_of_the_package(session, error_with, monkeypatch):
    monkeypatch.setattr(_check_workers, "version", lambda: "99.0")
    told = error_with(session.sparkContext.pythonExec)
    assert "do not have beespace 99.0" in told and f"its version is {beespace.__version__}" in told


def test_no_python_at_all(error_with, tmp_path):
    told = error_with(tmp_path / "no" / "python")
    assert "do not run Python as this program needs it" in told and "Cannot run program" in told


def test_workers_are_asked_once(session, monkeypatch):
    asked = []
    monkeypatch.setattr(_check_workers, "_checked", set())
    monkeypatch.setattr(_check_workers, "version", lambda: asked.append(1) or beespace.__version__)
    frame = session.range(3).selectExpr("id", "10D * id AS x", "0D AS y", "0D AS z")
    for _ in range(2):
        assert beespace.spark.at_risk(frame, 5).count() == 0
    assert len(asked) == 1
