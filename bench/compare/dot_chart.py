"""Rows of dots along one logarithmic axis as SVG: the time of each contender, at a glance."""

from dataclasses import dataclass
from xml.sax.saxutils import escape

from line_chart import DARK_STYLE, STYLE, LogScale

WIDTH = 960
LEFT, RIGHT, TOP = 222, 100, 136
ROW, GROUP = 30, 44
LEGEND_STEP = 24

ROW_STYLE = """
.row { stroke: #e2e8f0; stroke-width: 2; }
.group { font-size: 15px; font-weight: 650; fill: #0f172a; }
.ratio { font-size: 14px; font-weight: 650; } .ring { stroke: #ffffff; stroke-width: 1.5; }
"""
DARK_ROW_STYLE = ".row { stroke: #27344a; } .group { fill: #f1f5f9; } .ring { stroke: #0f172a; }"


@dataclass
class Row:
    name: str
    values: dict  # what the dots are called: their value
    remark: str = ""


@dataclass
class DotChart:
    title: str
    subtitle: str
    text_of: callable  # of a value on the axis
    colours: dict  # name: (on light pages, on dark pages); the first is the hero
    groups: list  # (title, rows)


def _dots(chart, row, x, height):
    names = list(chart.colours)
    parts = [f'<path class="row" d="M{LEFT} {height}H{WIDTH - RIGHT}"/>',
             f'<text class="tick" x="{LEFT - 14}" y="{height + 4.5}" text-anchor="end">'
             f'{escape(row.name)}</text>',
             f'<text class="ratio d0" x="{WIDTH - RIGHT + 16}" y="{height + 5}">'
             f'{escape(row.remark)}</text>']
    for number in reversed(range(len(names))):
        if names[number] in row.values:
            radius = 9 if number == 0 else 5.5
            parts.append(f'<circle class="ring d{number}" cx="{x(row.values[names[number]]):.1f}" '
                         f'cy="{height}" r="{radius}"/>')
    return parts


def _groups(chart, x):
    """All rows below their titles, and how far down they reach."""
    parts = []
    height = TOP
    for title, rows in chart.groups:
        height += GROUP - ROW // 2
        parts.append(f'<text class="group" x="24" y="{height}">{escape(title)}</text>')
        height += ROW - 4
        for row in rows:
            parts += _dots(chart, row, x, height)
            height += ROW
    return parts, height - ROW // 2


def _grid(chart, x, bottom):
    parts = []
    for value in x.ticks((1,)):
        parts.append(f'<path class="grid" d="M{x(value):.1f} {TOP}V{bottom}"/>')
        parts.append(f'<text class="tick" x="{x(value):.1f}" y="{TOP - 10}" text-anchor="middle">'
                     f'{escape(chart.text_of(value))}</text>')
    return parts


def _legend(chart, top):
    parts = []
    columns = 4
    for number, name in enumerate(chart.colours):
        across = 36 + (number % columns) * ((WIDTH - 40) // columns)
        height = top + (number // columns) * LEGEND_STEP
        parts.append(f'<circle class="d{number}" cx="{across}" cy="{height}" '
                     f'r="{8 if number == 0 else 5.5}"/>'
                     f'<text class="label" x="{across + 14}" y="{height + 5}">'
                     f'{escape(name)}</text>')
    return parts


def svg(chart):
    """The whole picture as text."""
    values = [value for _, rows in chart.groups for row in rows for value in row.values.values()]
    x = LogScale(values, LEFT + 12, WIDTH - RIGHT - 12)
    parts, bottom = _groups(chart, x)
    lines = (len(chart.colours) + 3) // 4
    legend_top = bottom + 36
    height = legend_top + lines * LEGEND_STEP
    colours = ["".join(f".d{number} {{ fill: {pair[page]}; }}\n"
                       for number, pair in enumerate(chart.colours.values())) for page in (0, 1)]
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" role="img" '
        f'aria-label="{escape(chart.title)}">',
        f"<style>{STYLE}{ROW_STYLE}{colours[0]}@media (prefers-color-scheme: dark) {{{DARK_STYLE}"
        f"{DARK_ROW_STYLE}{colours[1]}}}</style>",
        f'<rect class="page" width="{WIDTH}" height="{height}" rx="10"/>',
        f'<text class="title" x="24" y="38">{escape(chart.title)}</text>',
        *(f'<text class="subtitle" x="24" y="{62 + 20 * number}">{escape(line)}</text>'
          for number, line in enumerate(chart.subtitle)),
        *_grid(chart, x, bottom), *parts, *_legend(chart, legend_top), "</svg>\n"])
