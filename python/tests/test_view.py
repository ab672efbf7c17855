"""`view`: what a browser fetches is the page; a notebook shows it itself."""

from __future__ import annotations

import sys
import threading
import types
import urllib.error
import urllib.request
import webbrowser

import pytest

import beespace
from beespace import _view
from tests.test_report import has_pages

pytestmark = pytest.mark.skipif(not has_pages(), reason="this build has no pages")
points = [[0, 0, 0], [3, 4, 0]]


class Browser:
    """Fetches what it is asked to open, as a browser does: later, and on its own."""

    def __init__(self, monkeypatch, fetches=True):
        self.fetches = fetches
        self.url = None
        self.pages = []
        monkeypatch.setattr(webbrowser, "open", self.open)

    def open(self, url):
        self.url = url
        if self.fetches:
            threading.Timer(0.05, self.fetch).start()
        return True

    def fetch(self):
        with urllib.request.urlopen(self.url, timeout=20) as answer:
            self.pages.append((answer.headers["Content-Type"], answer.read().decode()))


def test_a_browser_fetches_the_page_and_may_load_it_anew(monkeypatch):
    browser = Browser(monkeypatch)
    page = beespace.report(points, 6, title="Two")
    assert page.view() is None
    browser.fetch()
    assert browser.pages[-1] == ("text/html; charset=utf-8", page.html)
    assert browser.url.startswith("http://127.0.0.1:")
    # Only who knows the address sees it.
    with pytest.raises(urllib.error.HTTPError) as caught:
        urllib.request.urlopen(browser.url.rsplit("/", 1)[0] + "/", timeout=20)
    assert caught.value.code == 404
    caught.value.close()


def test_view_takes_what_report_takes(monkeypatch):
    browser = Browser(monkeypatch)
    beespace.view(points, 6, ids=["anna", "bert"], title="Two")
    while not browser.pages:
        pass
    assert "Two" in browser.pages[0][1]
    with pytest.raises(TypeError):
        beespace.view(points, 6, tilte="Two")


def test_no_browser_is_an_error(monkeypatch):
    page = beespace.report(points, 6)
    monkeypatch.setattr(webbrowser, "open", lambda url: False)
    with pytest.raises(beespace.BeespaceError, match="`save`"):
        page.view()
    monkeypatch.setattr(_view, "_patience", 0.1)
    silent = Browser(monkeypatch, fetches=False)
    with pytest.raises(beespace.BeespaceError, match="no browser"):
        page.view()
    with pytest.raises(OSError):
        urllib.request.urlopen(silent.url, timeout=5)


def test_a_notebook_shows_it_itself(monkeypatch):
    shown = []
    shell = types.SimpleNamespace(kernel=object())
    ipython = types.ModuleType("IPython")
    ipython.get_ipython = lambda: shell
    display = types.ModuleType("IPython.display")
    display.display = shown.append
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    browser = Browser(monkeypatch)
    page = beespace.report(points, 6)
    page.view()
    assert shown == [page] and browser.url is None
    del shell.kernel  # a terminal
    page.view()
    assert shown == [page] and browser.url is not None
