"""What the docstrings of the package show is what comes out."""

from __future__ import annotations

import doctest
import inspect
import subprocess
import sys
from pathlib import Path

import beespace.spark
import pytest


@pytest.mark.parametrize("name", beespace.spark.__all__)
def test_the_example_is_right(session, name):
    text = inspect.getdoc(getattr(beespace.spark, name))
    test = doctest.DocTestParser().get_doctest(text, {"session": session}, name, None, 0)
    assert any(example.want for example in test.examples)
    said = []
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    runner.run(test, out=said.append)
    assert runner.failures == 0, "".join(said)


@pytest.mark.parametrize("document", ["spark.md", "tutorials/flights-on-a-cluster.md"])
def test_the_document_says_what_comes_out(session, document):
    path = Path(__file__).resolve().parents[2] / "docs" / document
    found = doctest.testfile(str(path), module_relative=False, globs={"session": session})
    assert found.attempted > 3 and found.failed == 0


@pytest.mark.parametrize("module", ["beespace", "beespace.spark"])
def test_nothing_of_spark_is_imported_before_a_function_is_called(module):
    program = f"import sys, {module}; sys.exit('pyspark' in sys.modules or 'pyarrow' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0
