"""What the docstrings of the package show is what comes out."""

from __future__ import annotations

import doctest
import inspect
import subprocess
import sys

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


@pytest.mark.parametrize("module", ["beespace", "beespace.spark"])
def test_nothing_of_spark_is_imported_before_a_function_is_called(module):
    program = f"import sys, {module}; sys.exit('pyspark' in sys.modules or 'pyarrow' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0
