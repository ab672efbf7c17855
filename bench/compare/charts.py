"""The charts of the comparison: everything at a glance, time against size, cost against density."""

import dot_chart
import plan
from line_chart import Chart, Series, svg
from results import time_of

# On light pages, on dark pages.
COLOURS = {
    "beespace": ("#d97706", "#fbbf24"),
    "nanoflann:sorted": ("#2563eb", "#60a5fa"),
    "cgal": ("#059669", "#34d399"),
    "boost_rtree": ("#7c3aed", "#a78bfa"),
    "scipy_kdtree.py": ("#0e7490", "#22d3ee"),
    "flann": ("#64748b", "#94a3b8"),
    "pcl_kdtree": ("#92400e", "#d6a56b"),
    "pcl_octree": ("#4d7c0f", "#a3e635"),
    "teschner_hash": ("#be185d", "#f472b6"),
    "paper_methods:hash": ("#dc2626", "#f87171"),
}
BEHIND_THE_NAMES = "Behind the names: how many times beespace’s time, where the line ends"
METHODS = ("teschner_hash", "paper_methods:hash")


def time_text(milliseconds):
    for unit, size in (("s", 1e3), ("ms", 1.0), ("µs", 1e-3)):
        if milliseconds >= 0.999 * size:
            return f"{milliseconds / size:,.0f} {unit}"
    return f"{milliseconds * 1e6:,.0f} ns"


def nanoseconds_text(nanoseconds):
    return time_text(nanoseconds * 1e-6)


def count_text(number):
    if number >= 999_999:
        return f"{number / 1e6:,.0f} million"
    return f"{number:,.0f}" if number >= 0.999 else f"{number:g}"


def factor_text(factor):
    return f"{factor:,.0f}" if factor >= 9.95 else f"{factor:.1f}"


def _series(results, rows, x_of, y_of):
    """A series for each contender that was asked, ours first, with how it compares at the end."""
    lines = {}
    for row in rows:
        if "failed" not in row:
            lines.setdefault(row["contender"], []).append((x_of(row), y_of(row)))
    ours = dict(lines.get(plan.OURS.key, []))
    series = []
    for key, colour in COLOURS.items():
        points = sorted(lines.get(key, []))
        if not points:
            continue
        last, time = points[-1]
        remark = ""
        if key != plan.OURS.key and last in ours:
            remark = f"× {factor_text(time / ours[last])}"
        series.append(Series(results.name(key), points, colour, hero=key == plan.OURS.key,
                             dashed=key in METHODS, remark=remark))
    return series


def chart_of_sizes(results, swarm):
    rows = [row for row in results.rows("sizes") + results.rows("swarms")
            if row["swarm"] == swarm.name and row["question"] == "at_risk"]
    series = _series(results, rows, lambda row: row["points"], time_of)
    return Chart(f"At risk in {swarm.name}: time against the number of points",
                 (f"One thread, at the density of {swarm.name}: {swarm.neighbours} neighbours "
                  "within X on average.", BEHIND_THE_NAMES),
                 "points", "processor time, build and query", count_text, time_text, series)


def chart_of_densities(results):
    def cost(row):
        return 1e6 * time_of(row) / row["points"]

    series = _series(results, results.rows("densities"), lambda row: row["neighbours"], cost)
    points = max(row["points"] for row in results.rows("densities"))
    return Chart("At risk: cost of a point against density",
                 (f"{points:,} uniform points, one thread.", BEHIND_THE_NAMES),
                 "neighbours within X on average", "processor time a point", count_text,
                 nanoseconds_text, series)


QUESTION_NAMES = {"at_risk": "Who is at risk?", "pairs": "Which pairs?",
                  "nearest": "Who is nearest?", "counts": "How many neighbours?"}


def _overview_row(results, swarm, question):
    costs = {}
    for key in COLOURS:
        time = results.time(swarm, question, key)
        if time is not None:
            costs[results.name(key)] = 1e6 * time / results.points(swarm)
    ours = results.time(swarm, question, plan.OURS.key)
    best = results.best_peer(swarm, question)
    remark = f"× {factor_text(best[1] / ours)}" if ours and best else ""
    caption = next(one.caption for one in plan.SWARMS if one.name == swarm)
    return dot_chart.Row(caption, costs, remark)


def overview(results):
    groups = []
    for question, title in QUESTION_NAMES.items():
        rows = [_overview_row(results, swarm, question) for swarm in results.swarm_names()
                if results.time(swarm, question, plan.OURS.key) is not None]
        if rows:
            groups.append((title, rows))
    shown = {name for _, rows in groups for row in rows for name in row.values}
    colours = {results.name(key): colour for key, colour in COLOURS.items()
               if results.name(key) in shown}
    subtitle = ("Processor time a point, build and query, one thread; farther left is better.",
                "At the right: the best of Debian’s libraries, as so many times beespace’s time")
    return dot_chart.DotChart("What a point costs", subtitle, nanoseconds_text, colours, groups)


def write_all(results, folder):
    """Writes all charts there are rows for; returns (title, file name) of each."""
    pictures = []
    folder.mkdir(parents=True, exist_ok=True)

    def write(name, chart, to_svg=svg):
        (folder / name).write_text(to_svg(chart), encoding="utf-8")
        pictures.append((chart.title, name))

    if results.swarm_names():
        write("overview.svg", overview(results), dot_chart.svg)
    asked = {row["swarm"] for row in results.rows("sizes")}
    for swarm in plan.SWARMS:
        if swarm.name in asked:
            name = swarm.name.lower().replace(",", "").replace(" = ", "").replace(" ", "-")
            write(f"time-{name}.svg", chart_of_sizes(results, swarm))
    if results.rows("densities"):
        write("cost-against-density.svg", chart_of_densities(results))
    return pictures
