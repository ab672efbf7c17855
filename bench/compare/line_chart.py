"""A line chart with logarithmic axes as SVG, for light and dark pages, without any library."""

import math
from dataclasses import dataclass, field
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 960, 560
LEFT, RIGHT, TOP, BOTTOM = 98, 282, 112, 66
LABEL_GAP = 19

STYLE = """
text { font-family: system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; fill: #475569; }
.page { fill: #ffffff; } .title { font-size: 21px; font-weight: 650; fill: #0f172a; }
.subtitle { font-size: 14px; } .tick { font-size: 13px; } .axis { font-size: 14px; }
.grid { stroke: #e2e8f0; stroke-width: 1; } .minor { stroke: #f1f5f9; stroke-width: 1; }
.leader { stroke: #cbd5e1; stroke-width: 1; fill: none; }
.line { fill: none; stroke-width: 2; stroke-linejoin: round; stroke-linecap: round; }
.dashed { stroke-dasharray: 6 5; } .label { font-size: 14px; }
.hero { stroke-width: 4.5; } .heroLabel { font-size: 15.5px; font-weight: 700; }
"""
DARK_STYLE = """
text { fill: #94a3b8; } .page { fill: #0f172a; } .title { fill: #f1f5f9; }
.grid { stroke: #27344a; } .minor { stroke: #1a2438; } .leader { stroke: #475569; }
"""


@dataclass
class Series:
    name: str
    points: list  # (x, y), ascending
    colour: tuple  # on light pages, on dark pages
    hero: bool = False
    dashed: bool = False
    remark: str = ""  # behind the name, at the end of the line


@dataclass
class Chart:
    title: str
    subtitle: tuple  # of lines
    x_title: str
    y_title: str
    x_text: callable
    y_text: callable
    series: list = field(default_factory=list)


class LogScale:
    """From a value to a place on the page; whole decades unless they leave much room."""

    def __init__(self, values, start, end):
        low, high = math.log10(min(values)), math.log10(max(values))
        self.low, self.high = math.floor(low + 1e-9), math.ceil(high - 1e-9)
        # A decade of which little is used begins at 2 or 3, or ends at 2 or 5.
        self.low += max((step for step in (0, math.log10(2), math.log10(3), math.log10(5))
                         if self.low + step <= low - 0.04), default=0)
        self.high -= max((step for step in (0, math.log10(2), math.log10(5))
                          if self.high - step >= high + 0.04), default=0)
        self.start, self.end = start, end

    def __call__(self, value):
        share = (math.log10(value) - self.low) / (self.high - self.low)
        return self.start + share * (self.end - self.start)

    def ticks(self, multiples):
        for decade in range(math.floor(self.low) - 1, math.ceil(self.high) + 1):
            for multiple in multiples:
                exponent = decade + math.log10(multiple)
                if self.low - 1e-9 <= exponent <= self.high + 1e-9:
                    yield multiple * 10.0**decade


def spread_out(wanted, gap, lowest, highest):
    """Places near the wanted ones, at least `gap` apart, in the same order."""
    order = sorted(range(len(wanted)), key=lambda i: wanted[i])
    places = [0.0] * len(wanted)
    groups = []  # [sum of wanted tops, members]
    for i in order:
        groups.append([[i], wanted[i]])
        while len(groups) > 1:
            (above, above_at), (below, below_at) = groups[-2:]
            if above_at + gap * len(above) / 2 <= below_at - gap * len(below) / 2:
                break
            members = above + below
            at = (above_at * len(above) + below_at * len(below)) / len(members)
            groups[-2:] = [[members, at]]
    for members, at in groups:
        half = gap * (len(members) - 1) / 2
        at = min(max(at, lowest + half), highest - half)
        for k, i in enumerate(members):
            places[i] = at - half + k * gap
    return places


def _grid(chart, x, y):
    parts = []
    bottom, right = HEIGHT - BOTTOM, WIDTH - RIGHT
    for value in y.ticks(range(2, 10)):
        parts.append(f'<path class="minor" d="M{LEFT} {y(value):.1f}H{right}"/>')
    for value in x.ticks((1,)):
        parts.append(f'<path class="grid" d="M{x(value):.1f} {TOP}V{bottom}"/>')
        parts.append(f'<text class="tick" x="{x(value):.1f}" y="{bottom + 22}" '
                     f'text-anchor="middle">{escape(chart.x_text(value))}</text>')
    for value in y.ticks((1,)):
        parts.append(f'<path class="grid" d="M{LEFT} {y(value):.1f}H{right}"/>')
        parts.append(f'<text class="tick" x="{LEFT - 10}" y="{y(value) + 4.5:.1f}" '
                     f'text-anchor="end">{escape(chart.y_text(value))}</text>')
    return parts


def _lines(chart, x, y):
    parts = []
    # The hero is drawn last, above the others.
    for number, series in sorted(enumerate(chart.series), key=lambda entry: entry[1].hero):
        places = [(x(across), y(up)) for across, up in series.points]
        kinds = f"line s{number}" + " hero" * series.hero + " dashed" * series.dashed
        path = "M" + "L".join(f"{across:.1f} {up:.1f}" for across, up in places)
        parts.append(f'<path class="{kinds}" d="{path}"/>')
        radius = 5.5 if series.hero else 3.5
        parts += [f'<circle class="d{number}" cx="{across:.1f}" cy="{up:.1f}" r="{radius}"/>'
                  for across, up in places]
    return parts


def _labels(chart, x, y):
    """Names at the ends of the lines, pushed apart, with a thin line to where they belong."""
    ends = [(x(series.points[-1][0]), y(series.points[-1][1])) for series in chart.series]
    heights = spread_out([up for _, up in ends], LABEL_GAP, TOP, HEIGHT - BOTTOM)
    left = WIDTH - RIGHT + 26
    parts = []
    for number, (series, (across, up), height) in enumerate(zip(chart.series, ends, heights)):
        bend = max(WIDTH - RIGHT + 8, across + 7)
        parts.append(f'<path class="leader" d="M{across + 7:.1f} {up:.1f}L{bend:.1f} {up:.1f}'
                     f'L{left - 4} {height:.1f}"/>')
        kind = "heroLabel" if series.hero else "label"
        remark = f'  <tspan dx="5">{escape(series.remark)}</tspan>' if series.remark else ""
        parts.append(f'<text x="{left}" y="{height + 5:.1f}" class="{kind}">'
                     f'<tspan class="d{number}">{escape(series.name)}</tspan>{remark}</text>')
    return parts


def _colours(chart, page):
    return "".join(f".s{number} {{ stroke: {series.colour[page]}; }} "
                   f".d{number} {{ fill: {series.colour[page]}; }}\n"
                   for number, series in enumerate(chart.series))


def svg(chart):
    """The whole picture as text."""
    x = LogScale([across for series in chart.series for across, _ in series.points],
                 LEFT + 8, WIDTH - RIGHT)
    y = LogScale([up for series in chart.series for _, up in series.points], HEIGHT - BOTTOM, TOP)
    middle = (LEFT + WIDTH - RIGHT) / 2
    half_way = (TOP + HEIGHT - BOTTOM) / 2
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" '
        f'aria-label="{escape(chart.title)}">',
        f"<style>{STYLE}{_colours(chart, 0)}@media (prefers-color-scheme: dark) {{{DARK_STYLE}"
        f"{_colours(chart, 1)}}}</style>",
        f'<rect class="page" width="{WIDTH}" height="{HEIGHT}" rx="10"/>',
        f'<text class="title" x="24" y="38">{escape(chart.title)}</text>',
        *(f'<text class="subtitle" x="24" y="{62 + 20 * number}">{escape(line)}</text>'
          for number, line in enumerate(chart.subtitle)),
        *_grid(chart, x, y), *_lines(chart, x, y), *_labels(chart, x, y),
        f'<text class="axis" x="{middle}" y="{HEIGHT - 16}" text-anchor="middle">'
        f'{escape(chart.x_title)}</text>',
        f'<text class="axis" transform="translate(22 {half_way}) rotate(-90)" '
        f'text-anchor="middle">{escape(chart.y_title)}</text>', "</svg>\n"]
    return "\n".join(parts)
