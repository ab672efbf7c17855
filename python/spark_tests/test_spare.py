"""What workers set aside for the tasks that follow is not lost."""

from __future__ import annotations

import gc
import importlib
import sys
import zipfile
import zipimport

import pytest
from beespace.spark import _workers


class Context:
    """A task of Spark."""

    def __init__(self, number):
        self.number = number

    def taskAttemptId(self):
        return self.number


@pytest.fixture
def archive(tmp_path, monkeypatch):
    """A zip archive of modules, some of which have been imported."""
    with zipfile.ZipFile(tmp_path / "some.zip", "w") as into:
        into.writestr("beelib/__init__.py", "")
        for name in ("first", "second", "third"):
            into.writestr(f"beelib/{name}/__init__.py", f"name = {name!r}\n")
    monkeypatch.syspath_prepend(str(tmp_path / "some.zip"))
    assert importlib.import_module("beelib.first").name == "first"
    yield str(tmp_path / "some.zip")
    for name in [name for name in sys.modules if name.startswith("beelib")]:
        del sys.modules[name]


def finders(archive):
    return [
        path for path, finder in sys.path_importer_cache.items()
        if isinstance(finder, zipimport.zipimporter) and path.startswith(archive)
    ]


def test_archives_are_read_again_where_they_are_needed_only(archive, monkeypatch):
    monkeypatch.setattr(_workers, "_spared", None)
    task = Context(7)
    monkeypatch.setattr(_workers, "_context", lambda: task)
    assert len(finders(archive)) == 2
    try:
        _workers.arrow()
        assert not finders(archive) and gc.get_freeze_count() > 1000
        importlib.invalidate_caches()
        assert importlib.import_module("beelib.second").name == "second"
        known = finders(archive)
        assert known
        _workers.arrow()  # the same task
        assert finders(archive) == known
        task.number = 8
        _workers.arrow()
        assert not finders(archive)
        assert importlib.import_module("beelib.third").name == "third"
    finally:
        gc.unfreeze()


def test_nothing_is_set_aside_where_no_task_runs(archive, monkeypatch):
    monkeypatch.setattr(_workers, "_spared", None)
    monkeypatch.setattr(_workers, "_context", lambda: None)
    _workers.arrow()
    assert len(finders(archive)) == 2 and not gc.get_freeze_count()
