"""All that is public says what it does, with an example that is run (by --doctest-modules)."""

from __future__ import annotations

import doctest
import inspect

import pytest

import beespace


def _public():
    for name in beespace.__all__:
        thing = getattr(beespace, name)
        yield name, thing
        if not inspect.isclass(thing):
            continue
        for member, value in inspect.getmembers(thing):
            if member.startswith("_") or not inspect.isfunction(value):
                continue
            yield f"{name}.{member}", value


@pytest.mark.parametrize(
    ("name", "thing"), [pytest.param(name, thing, id=name) for name, thing in _public()]
)
def test_it_has_an_example(name, thing):
    text = inspect.getdoc(thing)
    assert text, f"{name} has no docstring"
    examples = doctest.DocTestParser().get_examples(text)
    assert examples, f"{name} has no example"
    assert any(example.want for example in examples), f"the examples of {name} show no answer"
