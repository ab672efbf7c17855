"""What the READMEs print in Python is what they say. (docs/python.md is run by doctest.)"""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path

import pytest

project = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("document", ["README.md", "python/README.md"])
def test_readme_says_what_is_printed(document):
    blocks = re.findall(r"```python\n(.*?)```", (project / document).read_text(), re.DOTALL)
    assert blocks
    for block in blocks:
        said = re.findall(r"^print\(.*\)  # (.*)$", block, re.MULTILINE)
        assert said
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(block, {})
        assert printed.getvalue().splitlines() == said
