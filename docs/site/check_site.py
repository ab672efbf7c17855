"""Proves of a built site that nothing leads nowhere, and that no public name is missing from it.

    check_site.py SITE
"""

from __future__ import annotations

import re
import sys
import zlib
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import notebooks
import python_pages

root = Path(__file__).resolve().parents[2]


class Page(HTMLParser):
    """What a page leads to, and what may lead to places in it."""

    def __init__(self, path: Path) -> None:
        super().__init__(convert_charrefs=True)
        self.targets: list[tuple[int, str]] = []
        self.places: set[str] = set()
        self.feed(path.read_text())

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        for name in ("href", "src"):
            if target := given.get(name):
                self.targets.append((self.getpos()[0], target))
        for name in ("id", "name"):
            if place := given.get(name):
                self.places.add(place)


def dead_links(site: Path) -> list[str]:
    pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}
    if not pages:
        return [f"{site} has no pages"]
    found = []
    for path, page in pages.items():
        for line, target in page.targets:
            parts = urlsplit(target)
            if parts.scheme or parts.netloc:
                continue
            to = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not to.is_file():
                found.append(f"{path}:{line}: {target} is not there")
            elif parts.fragment and to in pages and unquote(parts.fragment) not in pages[to].places:
                found.append(f"{path}:{line}: {target}: the page has no such place")
    return found


def missing_frames(site: Path) -> list[str]:
    """Notebooks that show no page of beespace, though they make one."""
    found = []
    for notebook in (root / "docs/notebooks").glob("*.ipynb"):
        if str(notebook.relative_to(root)) in notebooks.NOT_RUN:
            continue
        page = site / f"docs/notebooks/{notebook.stem}.html"
        makes = "beespace.report(" in notebook.read_text()
        if makes and '<iframe sandbox="allow-scripts' not in page.read_text():
            found.append(f"{page} does not show the page that the notebook makes")
    return found


def names_of(site: Path) -> set[str]:
    """All names that the site describes, from the index that it offers to other sites."""
    inventory = (site / "objects.inv").read_bytes()
    head = b"".join(each + b"\n" for each in inventory.split(b"\n", 4)[:4])
    lines = zlib.decompress(inventory[len(head) :]).decode().splitlines()
    return {line.split(" ", 1)[0] for line in lines}


def public_names() -> set[str]:
    """Those of Python and, as the libraries export them, of C. (Of C++, doxygen misses none.)"""
    names = set(python_pages.public())
    for name, thing in python_pages.public().items():
        names.update(python_pages.members(name, thing))
    for exported in (root / "c/beespace.map", root / "c_io/beespace_io.map"):
        listed = re.sub(r"/\*.*?\*/|#[^\n]*", "", exported.read_text(), flags=re.DOTALL)
        functions = re.findall(r"^\s*(beespace_\w+);", listed, re.MULTILINE)
        if not functions:
            sys.exit(f"{exported}: no names found")
        names.update(functions)
    return names


def main() -> int:
    site = Path(sys.argv[1]).resolve()
    problems = dead_links(site)
    problems += missing_frames(site)
    problems += [f"the site says nothing of {each}" for each in sorted(public_names() - names_of(site))]
    print("\n".join(problems), file=sys.stderr, end="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
