"""A picture as SVG, in colours that suit light and dark pages."""

import math
from html import escape

# Role: on light pages, on dark pages.
COLOURS = {
    "page": ("#ffffff", "#12161c"),
    "ink": ("#1f2933", "#e5e9ee"),
    "soft": ("#55606e", "#9aa5b1"),
    "rule": ("#c5ced8", "#434c58"),
    "wash": ("#eef2f6", "#1d242d"),
    "hot": ("#c2570c", "#fb923c"),
    "hotwash": ("#fce3cb", "#4a2b12"),
    "cool": ("#2563eb", "#6aa5fb"),
    "coolwash": ("#d8e5fd", "#17305a"),
    "good": ("#047857", "#34d399"),
    "goodwash": ("#cdeee0", "#0f3d30"),
    "odd": ("#7c3aed", "#b49afc"),
    "oddwash": ("#e7defd", "#33235c"),
}
FONT = "system-ui, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif"


def _rules(shade):
    return "".join(f".f-{role}{{fill:{pair[shade]}}}.s-{role}{{stroke:{pair[shade]}}}"
                   for role, pair in COLOURS.items())


STYLE = (f"text{{font-family:{FONT};font-size:13px}}.small{{font-size:11.5px}}"
         ".strong{font-weight:600;font-size:14px}.hollow{fill:none}.dashed{stroke-dasharray:5 4}"
         + _rules(0) + "@media (prefers-color-scheme: dark){" + _rules(1) + "}")


def number(value):
    """Two decimals at most, without a trailing zero or a negative one."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _attributes(pairs):
    return "".join(f' {name.replace("_", "-")}="{value}"' for name, value in pairs.items()
                   if value is not None)


def _classes(fill, stroke, extra=""):
    names = [f"f-{fill}" if fill else "hollow"]
    if stroke:
        names.append(f"s-{stroke}")
    if extra:
        names.append(extra)
    return " ".join(names)


class Picture:
    def __init__(self, width, height, title):
        self.width = width
        self.height = height
        self.title = title
        self._parts = []

    def _add(self, tag, text=None, **attributes):
        body = f">{text}</{tag}>" if text is not None else "/>"
        self._parts.append(f"<{tag}{_attributes(attributes)}{body}")

    def dot(self, x, y, radius=3.0, fill="ink", stroke=None):
        self._add("circle", cx=number(x), cy=number(y), r=number(radius),
                  **{"class": _classes(fill, stroke)})

    def circle(self, x, y, radius, stroke="soft", fill=None, width=1.2, dashed=False, opacity=None):
        self._add("circle", cx=number(x), cy=number(y), r=number(radius),
                  stroke_width=number(width), fill_opacity=opacity,
                  **{"class": _classes(fill, stroke, "dashed" if dashed else "")})

    def box(self, x, y, width, height, fill="wash", stroke=None, radius=0.0, line=1.0, opacity=None,
            dashed=False):
        self._add("rect", x=number(x), y=number(y), width=number(width), height=number(height),
                  rx=number(radius) if radius else None,
                  stroke_width=number(line) if stroke else None, fill_opacity=opacity,
                  **{"class": _classes(fill, stroke, "dashed" if dashed else "")})

    def line(self, x1, y1, x2, y2, stroke="rule", width=1.0, dashed=False):
        self._add("line", x1=number(x1), y1=number(y1), x2=number(x2), y2=number(y2),
                  stroke_width=number(width),
                  **{"class": f"s-{stroke}" + (" dashed" if dashed else "")})

    def path(self, points, stroke="ink", width=2.0, fill=None, dashed=False):
        places = " ".join(f"{number(x)},{number(y)}" for x, y in points)
        self._add("polyline", points=places, stroke_width=number(width), stroke_linejoin="round",
                  **{"class": _classes(fill, stroke, "dashed" if dashed else "")})

    def arrow(self, x1, y1, x2, y2, stroke="soft", width=1.5):
        length = math.hypot(x2 - x1, y2 - y1)
        ux, uy = (x2 - x1) / length, (y2 - y1) / length
        self.line(x1, y1, x2 - 4 * ux, y2 - 4 * uy, stroke, width)
        corners = [(x2, y2), (x2 - 8 * ux - 4 * uy, y2 - 8 * uy + 4 * ux),
                   (x2 - 8 * ux + 4 * uy, y2 - 8 * uy - 4 * ux)]
        self._add("polygon", points=" ".join(f"{number(x)},{number(y)}" for x, y in corners),
                  **{"class": f"f-{stroke}"})

    def text(self, x, y, text, fill="ink", anchor=None, size=""):
        self._add("text", escape(text), x=number(x), y=number(y),
                  text_anchor=anchor, **{"class": f"f-{fill} {size}".strip()})

    def lines(self, x, y, texts, fill="soft", anchor=None, size="small", step=16):
        for k, text in enumerate(texts):
            self.text(x, y + k * step, text, fill, anchor, size)

    def svg(self):
        return "\n".join([
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
            f'role="img">', f"<title>{escape(self.title)}</title>", f"<style>{STYLE}</style>",
            f'<rect class="f-page" width="{self.width}" height="{self.height}" rx="8"/>',
            *self._parts, "</svg>", ""])


class Plot:
    """A frame with axes inside a picture; `x_at` and `y_at` map values to places."""

    def __init__(self, picture, left, top, width, height, x_range, y_range, x_log=False,
                 y_log=False):
        self.picture = picture
        self.left, self.top, self.width, self.height = left, top, width, height
        self._x = (x_range, x_log)
        self._y = (y_range, y_log)

    @staticmethod
    def _share(value, axis):
        (low, high), log = axis
        if log:
            return (math.log(value) - math.log(low)) / (math.log(high) - math.log(low))
        return (value - low) / (high - low)

    def x_at(self, value):
        return self.left + self.width * self._share(value, self._x)

    def y_at(self, value):
        return self.top + self.height * (1.0 - self._share(value, self._y))

    def axes(self, x_ticks, y_ticks, x_name, y_name):
        """Ticks are (value, text); the names stand below and above."""
        draw = self.picture
        bottom = self.top + self.height
        for value, text in y_ticks:
            y = self.y_at(value)
            draw.line(self.left, y, self.left + self.width, y, "rule", 0.7)
            draw.text(self.left - 8, y + 4, text, "soft", "end", "small")
        for value, text in x_ticks:
            x = self.x_at(value)
            draw.line(x, bottom, x, bottom + 5, "soft")
            draw.text(x, bottom + 20, text, "soft", "middle", "small")
        draw.line(self.left, bottom, self.left + self.width, bottom, "soft")
        draw.text(self.left + self.width / 2, bottom + 40, x_name, "ink", "middle", "small")
        draw.text(self.left - 34, self.top - 12, y_name, "ink", None, "small")

    def curve(self, values, stroke, width=2.0, dashed=False):
        self.picture.path([(self.x_at(x), self.y_at(y)) for x, y in values], stroke, width,
                          dashed=dashed)
