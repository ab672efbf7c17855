"""How fast beespace is beside others: the figures of docs/benchmarks/compare.md, for the README."""

from pathlib import Path

from canvas import Picture, Plot

SOURCE = Path(__file__).resolve().parents[2] / "benchmarks" / "compare.md"
QUESTION, SWARM = "### At risk", "D3"
# As in the table: as in the picture, and its colour.
SHOWN = {
    "beespace": ("beespace", "cool"),
    "beespace, 2 threads": ("beespace, 2 threads", "cool"),
    "nanoflann, sorted": ("nanoflann, points sorted first", "soft"),
    "nanoflann": ("nanoflann", "soft"),
    "CGAL kd-tree": ("CGAL kd-tree", "soft"),
    "Boost.Geometry R-tree": ("Boost.Geometry R-tree", "soft"),
    "FLANN": ("FLANN", "soft"),
    "SciPy cKDTree": ("SciPy cKDTree", "soft"),
    "PCL kd-tree": ("PCL kd-tree", "soft"),
    "PCL octree": ("PCL octree", "soft"),
    "optimised spatial hash": ("spatial hash of Teschner et al.", "soft"),
}


def times_ms():
    """[(name, milliseconds)] of the contenders, the fastest first."""
    lines = SOURCE.read_text(encoding="utf-8").splitlines()
    begin = next(k for k, line in enumerate(lines) if line.startswith(QUESTION))
    begin = next(k for k in range(begin, len(lines)) if lines[k].startswith("|"))
    end = next(k for k in range(begin, len(lines)) if not lines[k].startswith("|"))
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[begin:end]]
    column = rows[0].index(SWARM)
    times = {row[0]: float(row[column].replace(",", "")) for row in rows[2:] if row[0] in SHOWN}
    if len(times) != len(SHOWN):
        raise ValueError(f"{SOURCE.name} has not all of {', '.join(SHOWN)}")
    return sorted(times.items(), key=lambda named: named[1])


def when_and_where():
    """The processor and the day of the measurement, as docs/benchmarks/compare.md says."""
    lines = SOURCE.read_text(encoding="utf-8").splitlines()
    begin = lines.index("## The machine") + 2
    text = " ".join(lines[begin:begin + 4])
    return text.split(" (L1d")[0].replace("(R)", ""), text.split("; ")[-1].split(".")[0]


def _speed():
    times = times_ms()
    machine, day = when_and_where()
    bar, step = 18, 26
    picture = Picture(860, 124 + step * len(times),
                      "A million points: beespace and other libraries")
    picture.text(22, 30, "Which of a million points are closer than the threshold to another one?",
                 "ink", None, "strong")
    picture.lines(22, 48, ["Points uniform in a cube, two neighbours each "
                           "(D3 of docs/benchmarks/compare.md), from memory to the answer;",
                           f"one thread, unless said. {machine}, {day}."])
    plot = Plot(picture, 210, 82, 580, step * len(times), (0.0, 3000.0), (0.0, 1.0))
    bottom = plot.top + plot.height
    for value in range(0, 3001, 500):
        x = plot.x_at(value)
        picture.line(x, plot.top, x, bottom, "rule", 0.7)
        picture.text(x, bottom + 16, f"{value:,}", "soft", "middle", "small")
    picture.text(plot.left + plot.width / 2, bottom + 34, "time in milliseconds: shorter is better",
                 "soft", "middle", "small")
    for k, (name, value) in enumerate(times):
        y = plot.top + k * step + 4
        label, colour = SHOWN[name]
        own = colour == "cool"
        picture.text(plot.left - 10, y + 13, label, "ink" if own else "soft", "end",
                     "" if own else "small")
        picture.box(plot.left, y, plot.x_at(value) - plot.left, bar, colour)
        shown = f"{value:,.0f}" if value >= 100 else f"{value:.1f}"
        picture.text(plot.x_at(value) + 6, y + 13, f"{shown} ms", "ink" if own else "soft", None,
                     "small")
    return picture


def pictures():
    yield "speed", _speed()
