"""The manual page of the command as a page of the site, by mandoc."""

from __future__ import annotations

import html
import re
import subprocess
from pathlib import Path

heading = re.compile(r'<h([12]) class="S[hs]" id="([^"]*)">(.*?)</h\1>', re.DOTALL)
frame = re.compile(r'</?section[^>]*>|<table class="(?:head|foot)">.*?</table>', re.DOTALL)


def page(source: Path) -> str:
    """The page in Markdown: its headings as such, what is below them as HTML."""
    made = subprocess.run(
        ["mandoc", "-T", "html", "-O", "fragment", str(source)],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    opening, *parts = heading.split(frame.sub("", made))
    text = (
        "# beespace(1)\n\nThe manual page of the command, with all options; `man beespace` shows the "
        "same. [Commands](../docs/commands.md) shows them at work.\n"
    )
    for level, anchor, title, body in zip(*[iter(parts)] * 4, strict=True):
        words = html.unescape(re.sub(r"<[^>]*>", "", title)).split()
        name = " ".join(words)
        if level == "1":
            name = name.capitalize()
        text += f"\n#{'#' * int(level)} {name}\n\n"
        text += f'```{{raw}} html\n<div class="manual-text" id="{anchor}">\n{_closed(body)}\n</div>\n```\n'
    return text


def _closed(body: str) -> str:
    """The HTML of one section alone: the frame around all of them ends in the last."""
    missing = body.count("<div") - body.count("</div>")
    while missing < 0:
        body = "".join(body.rpartition("</div>")[::2])
        missing += 1
    return body.strip()
