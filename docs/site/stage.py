"""Lays out what Sphinx makes the site of: the documents as they are, and pages that are made here.

    stage.py FOLDER DOXYGEN_XML

Documents keep their places, so that what links one to another in the repository does so in the
site. A link to a header goes to its page in the reference; one to another file or folder of the
repository to a page that shows it.
"""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import manual
import python_pages

root = Path(__file__).resolve().parents[2]
pictures = {".svg", ".png"}
languages = {".cpp": "cpp", ".hpp": "cpp", ".h": "c", ".c": "c", ".py": "python", ".lua": "lua"}
orphan = "---\norphan: true\n---\n\n"

# A link whose text may itself be a picture, outside of code.
link = re.compile(r"(\]\()([^)\s#]+)(#[^)\s]*)?(\))")
code = re.compile(r"^```.*?^```$|`[^`\n]*`", re.DOTALL | re.MULTILINE)


class Stage:
    def __init__(self, into: Path) -> None:
        self.into = into
        self.made: set[str] = set()

    def write(self, page: str, text: str) -> None:
        """Writes where the text is another one: Sphinx reads anew what is newer."""
        self.made.add(page)
        path = self.into / page
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text() != text:
            path.write_text(text)

    def copy(self, file: str) -> None:
        self.made.add(file)
        path = self.into / file
        path.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(root / file, path)

    def document(self, file: str, before: str = "", behind: str = "") -> None:
        if file in self.made:
            return
        self.made.add(file)
        text = (root / file).read_text()
        self.write(file, before + self.with_links(text, file) + behind)

    def with_links(self, text: str, file: str) -> str:
        """The text with its links as they are in the site."""
        folder = os.path.dirname(file)

        def changed(match: re.Match[str]) -> str:
            opening, target, anchor, closing = match.groups()
            if "://" in target or target.startswith("mailto:"):
                return match[0]
            page = self.page_of(os.path.normpath(os.path.join(folder, target)))
            return f"{opening}{os.path.relpath(page, folder or '.')}{anchor or ''}{closing}"

        return outside_code(text, lambda piece: link.sub(changed, piece))

    def page_of(self, file: str) -> str:
        """Where the site shows a file or a folder of the repository, which is made where it is not."""
        if file in ("README.md", "docs/README.md"):
            return "index.md"
        if file == "include/beespace":
            return "docs/api.md"
        if file == "include/beespace.h":
            return "reference/c/index.md"
        if file in headers_of_c() + headers_of_cpp():
            return header_page(file)
        path = root / file
        if path.suffix == ".md":
            if not file.startswith("docs/") and "/" in file:
                self.document(file, orphan)
            return file
        if path.suffix in pictures or path.suffix == ".ipynb":
            self.copy(file)
            return file
        page = f"source/{file}.md"
        if page not in self.made:
            self.made.add(page)
            self.write(page, self.shown_folder(file) if path.is_dir() else self.shown_file(file))
        return page

    def shown_folder(self, folder: str) -> str:
        names = sorted(each.name for each in (root / folder).iterdir() if each.is_file())
        rows = (f"- [`{each}`]({self.link_from(folder, f'{folder}/{each}')})" for each in names)
        return f"{orphan}# `{folder}/`\n\n" + "\n".join(rows) + "\n"

    def shown_file(self, file: str) -> str:
        self.copy(file)
        language = languages.get(Path(file).suffix, "text")
        shown = f"```{{literalinclude}} /{file}\n:language: {language}\n```\n"
        return f"{orphan}# `{file}`\n\n{shown}"

    def link_from(self, folder: str, file: str) -> str:
        return os.path.relpath(self.page_of(file), os.path.dirname(f"source/{folder}"))

    def remove_what_is_gone(self) -> None:
        for path in self.into.rglob("*"):
            if path.is_file() and str(path.relative_to(self.into)) not in self.made:
                path.unlink()


def outside_code(text: str, change: Callable[[str], str]) -> str:
    pieces, at = [], 0
    for match in code.finditer(text):
        # Where doctest ends an example by an empty line, readers need none.
        shown = re.sub(r"\n\n+```$", "\n```", match[0])
        pieces += [change(text[at : match.start()]), shown]
        at = match.end()
    return "".join([*pieces, change(text[at:])])


def headers_of_cpp() -> list[str]:
    return sorted(str(each.relative_to(root)) for each in (root / "include/beespace").glob("*.hpp"))


def headers_of_c() -> list[str]:
    """In the order in which beespace.h has its parts, and then those of other libraries."""
    whole = "include/beespace.h"
    parts = re.findall(r"#include [<\"](beespace/c/[^>\"]+)", (root / whole).read_text())
    every = [str(each.relative_to(root)) for each in (root / "include/beespace/c").glob("*.h")]
    named = [f"include/{each}" for each in parts]
    other = [str(each.relative_to(root)) for each in (root / "include").glob("*.h")]
    rest = sorted(set(every + other) - {whole, *named})
    return named + rest


def header_page(file: str) -> str:
    name = Path(file).name
    return f"reference/{'cpp' if file.endswith('.hpp') else 'c'}/{name.replace('.', '_')}.md"


def brief_of(file: str) -> str:
    """What a header says first: its question."""
    words: list[str] = []
    for line in (root / file).read_text().splitlines():
        text = line.strip().removeprefix("///").removeprefix("*").strip()
        if "@brief" in text:
            words = text.partition("@brief")[2].split()
        elif words and (line == line.lstrip(" /*") or not text):
            break
        elif words:
            words += text.split()
    if not words:
        sys.exit(f"{file}: no @brief says what the header is for")
    return " ".join(words)


def without_private(described: Path) -> None:
    """Takes out of what doxygen wrote what it leaves out of its own pages."""
    for file in described.glob("*.xml"):
        tree = ElementTree.parse(file)
        gone = False
        for compound in tree.iter("compounddef"):
            for section in compound.findall("sectiondef"):
                if section.get("kind", "").startswith("private"):
                    compound.remove(section)
                    gone = True
        if gone:
            tree.write(file, encoding="utf-8", xml_declaration=True)


def write_headers(stage: Stage) -> None:
    for file in headers_of_cpp() + headers_of_c():
        path = file.removeprefix("include/")
        name = Path(file).name
        stage.write(
            header_page(file), f"# {name}\n\n```cpp\n#include <{included(path)}>\n```\n\n"
            f"```{{doxygenfile}} {name}\n```\n"
        )
    rows = "\n".join(
        f"| [`{Path(each).name}`]({Path(header_page(each)).name}) | {brief_of(each)} |"
        for each in headers_of_c()
    )
    stage.write(
        "reference/c/index.md",
        "# The C interface\n\n`#include <beespace.h>` includes all but `beespace_io.h`, which is of a "
        "library of its own. [beespace for C](../../docs/c.md) says how to begin, and what holds for "
        f"all functions.\n\n| header | |\n|---|---|\n{rows}\n" + contents([header_page(each) for each in headers_of_c()]),
    )


def included(path: str) -> str:
    """How a program includes a header: parts of beespace.h only as a whole."""
    return "beespace.h" if path.startswith("beespace/c/") else path


def documents_in(folder: str) -> list[str]:
    names = (str(each.relative_to(root)) for each in (root / folder).glob("*.md"))
    return sorted(each for each in names if not each.endswith("/README.md"))


def contents(pages: list[str]) -> str:
    """What the site's navigation has below a page."""
    entries = "\n".join("/" + each.removesuffix(".md") for each in pages)
    return f"\n```{{toctree}}\n:hidden:\n\n{entries}\n```\n"


def main() -> None:
    stage = Stage(Path(sys.argv[1]).resolve())
    without_private(Path(sys.argv[2]))
    index = (root / "docs/site/index.md").read_text()
    # Guides that it does not name stand behind those that it names.
    guides = [each.removesuffix(".md") for each in documents_in("docs")]
    others = [each for each in guides if each not in index.splitlines()]
    index = index.replace("{others}\n", "".join(f"{each}\n" for each in others))
    # Its links are those of a document in the root.
    stage.write("index.md", stage.with_links(index, "index.md"))
    readme = (root / "README.md").read_text()
    stage.write("README.txt", stage.with_links(readme, "README.md"))
    for file in ("ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"):
        stage.document(file)
    below = {
        "docs/api.md": contents([header_page(each) for each in headers_of_cpp()]),
        "docs/decisions/README.md": contents(documents_in("docs/decisions")),
    }
    for path in sorted((root / "docs").rglob("*.md")):
        file = str(path.relative_to(root))
        if file.startswith("docs/site/") or file == "docs/README.md":
            continue
        stage.document(file, behind=below.get(file, ""))
    # What notebooks read, and what the first page shows.
    read = [*(root / "examples/data").glob("*.csv"), *(root / "examples").glob("*.c*")]
    for path in [*(root / "docs").rglob("*.ipynb"), *read]:
        stage.copy(str(path.relative_to(root)))
    write_headers(stage)
    for page, text in python_pages.pages().items():
        stage.write(page, text)
    stage.write("reference/command.md", manual.page(root / "man/beespace.1"))
    stage.remove_what_is_gone()


if __name__ == "__main__":
    main()
