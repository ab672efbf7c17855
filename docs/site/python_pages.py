"""The reference of the package for Python: a page for each public name, whatever these are."""

from __future__ import annotations

import inspect
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))

import beespace  # noqa: E402
import beespace.compat.scipy  # noqa: E402
import beespace.spark  # noqa: E402

folder = "reference/python"
kinds = {
    "Questions": lambda thing: not inspect.isclass(thing),
    "Objects and answers": lambda thing: inspect.isclass(thing)
    and not issubclass(thing, BaseException),
    "Errors": lambda thing: inspect.isclass(thing) and issubclass(thing, BaseException),
}
modules = (beespace, beespace.compat.scipy, beespace.spark)


def public() -> dict[str, Any]:
    """All public functions and classes, by their full names. Other things have no words of their own."""
    return {
        f"{module.__name__}.{name}": getattr(module, name)
        for module in modules
        for name in module.__all__
        if inspect.isclass(value := getattr(module, name)) or inspect.isroutine(value)
    }


def members(name: str, thing: Any) -> list[str]:
    """The public methods and attributes of a class that have a description, by their full names."""
    if not inspect.isclass(thing):
        return []
    return [
        f"{name}.{member}"
        for member, value in inspect.getmembers(thing)
        if not member.startswith("_")
        and (inspect.isroutine(value) or isinstance(value, property))
        and not _is_inherited_from_python(thing, member)
        and inspect.getdoc(value)
    ]


def _is_inherited_from_python(thing: type, member: str) -> bool:
    owner = next(each for each in thing.__mro__ if member in vars(each))
    return not owner.__module__.startswith("beespace")


def pages() -> dict[str, str]:
    made = {f"{folder}/index.md": _index()}
    for name, thing in public().items():
        made[f"{folder}/{_page_name(name, thing)}.md"] = _page(name, thing)
    return made


def _page_name(name: str, thing: Any) -> str:
    """Names differ also where files are found without regard to case: `nearest`, `Nearest`."""
    return f"{name}-class" if inspect.isclass(thing) else name


def _page(name: str, thing: Any) -> str:
    module, _, short = name.rpartition(".")
    directive, options = "autofunction", ""
    if inspect.isclass(thing):
        directive = "autoexception" if issubclass(thing, BaseException) else "autoclass"
        own = [each.rpartition(".")[2] for each in members(name, thing)]
        if own:
            options = f"   :members: {', '.join(own)}\n   :inherited-members:\n"
    title = short if module == "beespace" else name.removeprefix("beespace.")
    described = f".. currentmodule:: {module}\n\n.. {directive}:: {name}\n{options}"
    return f"# {title}\n\n```{{eval-rst}}\n{described}```\n"


def _index() -> str:
    text = (
        "# The Python interface\n\n"
        "[beespace for Python](../../docs/python.md) says how to begin, what points may be, and what "
        "holds for all functions; [files](../../docs/python-files.md) how to read and show them. "
        "Arguments that most questions have are described with [`at_risk`](beespace.at_risk.md).\n"
    )
    entries = []
    for kind, belongs in kinds.items():
        text += f"\n## {kind}\n\n| name | |\n|---|---|\n"
        for name, thing in public().items():
            if not belongs(thing):
                continue
            page = _page_name(name, thing)
            entries.append(f"/{folder}/{page}")
            shown = name.removeprefix("beespace.")
            text += f"| [`{shown}`]({page}.md) | {_first_sentence(name, thing)} |\n"
    return text + "\n```{toctree}\n:hidden:\n\n" + "\n".join(entries) + "\n```\n"


def _first_sentence(name: str, thing: Any) -> str:
    described = inspect.getdoc(thing)
    if not described:
        sys.exit(f"{name} has no docstring")
    return " ".join(described.split("\n\n")[0].split()).replace("|", "\\|")
