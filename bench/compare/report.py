"""Tables in Markdown, and the page that holds them and the charts."""

import re

import charts
import plan
from results import Results, percent, rounded, thousands

QUESTION_TITLES = {
    "at_risk": "At risk: which bees have another within X?",
    "pairs": "Pairs: which two are within X of each other?",
    "nearest": "Nearest: which other is nearest to each?",
    "counts": "Counts: how many are within X of each?",
}


def table(header, rows):
    """Columns of figures are right-aligned."""
    def is_figures(column):
        return all(re.match(r"[\d–*]|$|failed", row[column]) for row in rows)

    marks = ["---:" if i and is_figures(i) else "---" for i in range(len(header))]
    lines = ["| " + " | ".join(header) + " |", "|" + "|".join(marks) + "|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def machine_section(results):
    machine = results.machine
    peers = results.versions()
    return f"""## The machine

{machine["processor"]}, {machine["processors"]} processors ({machine["caches"]};
{machine["instruction_sets"] or "no vector extensions"}), {machine["memory_gb"]} GB of memory,
{machine["system"]}, Linux {machine["kernel"]}, {machine["compiler"]}; {machine["date"]}.

The others are compiled for this very processor (-O3 -march=native; of PCL and SciPy, what Debian
has compiled is used as it is), beespace for any: it chooses its instructions at run time.

{table(("contender", "version", "how it is used"), peers)}"""


def summary_section(results):
    rows = []
    for swarm in results.swarm_names():
        for question in plan.QUESTIONS:
            ours = results.time(swarm, question, plan.OURS.key)
            if ours is None:
                continue
            floor = results.read_floor(swarm, question)
            best = results.best_peer(swarm, question)
            aim = results.aim(swarm, question)
            rows.append((
                swarm, question.replace("_", " "), rounded(ours),
                rounded(1e6 * ours / results.points(swarm)),
                rounded_ratio(ours, floor) + (f" (aim ≤ {aim})" if aim else ""),
                rounded_ratio(ours, results.warm_read_floor(swarm)),
                f"{best[0]}: {rounded(best[1])}" if best else "–",
                f"**{rounded(best[1] / ours)}**" if best else "–",
                rounded_ratio(results.wall(swarm, question, plan.ENGINE.key),
                              results.wall(swarm, question, plan.TWO_THREADS.key))))
    header = ("swarm", "question", "beespace, ms", "ns a point", "× floor", "× warm floor",
              "best Debian peer, ms", "peer ÷ beespace", "two threads")
    return f"""## In short

One thread, from the points in memory to the answer, nothing prepared. *Two threads* is how many
times as fast an Engine is with two as with one, by the clock on the wall.

*The floor* is a plain scalar loop that sums all input doubles in order, one pass after every timed
run of the same search, which finds the points as that search does: {results.read_floor_range()}.
*The warm floor* is the same loop many times in a row: {results.warm_read_floor_range()}. There are
two because a loop by itself still has in the caches what it read before, while the working memory
of a search has evicted its input since the last run, unless both fit into the caches. The aims are
multiples of the floor, set on a machine where it was 2.5 ns a point.

{table(header, rows)}"""


def rounded_ratio(above, below):
    return rounded(above / below) if above and below else "–"


def question_table(results, question):
    swarms = [name for name in results.swarm_names() if results.was_asked(name, question)]
    rows = []
    for contender in plan.CONTENDERS:
        times = [results.shown_time(swarm, question, contender.key) for swarm in swarms]
        if any(text != "–" for text in times):
            rows.append((results.name(contender.key), *times))
    remark = PAIRS_REMARK if question == "pairs" else ""
    rows.append(("*read floor, between the runs*",
                 *(rounded(results.read_floor(swarm, question)) for swarm in swarms)))
    rows.append(("*read floor, warm*",
                 *(rounded(results.warm_read_floor(swarm)) for swarm in swarms)))
    if question == "pairs":
        rows.append(("*writing as many pairs*",
                     *(rounded(results.write_floor(swarm)) for swarm in swarms)))
    return f"### {QUESTION_TITLES[question]}\n\n{remark}" + table(("milliseconds", *swarms), rows)


def questions_section(results):
    swarms = table(("swarm", "points", "", "neighbours"),
                   [(swarm.name, thousands(results.points(swarm.name)), swarm.description,
                     swarm.neighbours)
                    for swarm in plan.SWARMS if swarm.name in results.swarm_names()])
    tables = "\n".join(question_table(results, question) for question in plan.QUESTIONS)
    return f"""## All times

Build and query together; medians of the processor time of several fresh runs (five for most, more
for short ones, fewer for those that take seconds; two threads: wall time). The runs of one
measurement lie {results.spread_sentence()}. A dash means
not asked: the contender does not answer it, or would take minutes.

{swarms}
{tables}"""


def memory_section(results):
    swarms = results.swarm_names()
    rows = []
    for contender in plan.CONTENDERS:
        shown = [results.shown_memory(swarm, "at_risk", contender.key) for swarm in swarms]
        if any(text != "–" for text in shown):
            rows.append((results.name(contender.key), *shown))
    return f"""## Memory

How far resident memory rises above the input during the first at-risk answer, the answer included,
in MB (10⁶ bytes).

{table(("MB", *swarms), rows)}"""


def exactness_section(results):
    rows = []
    for row in results.rows("swarms"):
        wrong = row.get("spurious", 0) + row.get("missed", 0)
        if not wrong:
            continue
        exact = row["found"] - row["spurious"] + row["missed"]
        exact = row["points"] if row["question"] in ("nearest", "counts") else exact
        rows.append((row["name"], row["arithmetic"], row["swarm"],
                     row["question"].replace("_", " "), thousands(exact),
                     thousands(row["spurious"]), thousands(row["missed"]),
                     percent(wrong, exact)))
    header = ("contender", "arithmetic", "swarm", "question", "right answer", "too many or wrong",
              "missed", "off by")
    text = table(header, rows) if rows else "None of them.\n"
    return f"""## Methods that are not exact

Every answer is compared with beespace's, and on small swarms with brute force in exact arithmetic,
before anything is timed. Contenders in float64 must agree, or the comparison fails:
{results.agreement_sentence()}. Those that differ, by their arithmetic
or their method:

{text}"""


def growth_section(results):
    rows = []
    first = None
    for name in ("D3", "D5", plan.HUGE.name):
        time = results.time(name, "at_risk", plan.OURS.key)
        if time is None:
            continue
        cost = 1e6 * time / results.points(name)
        first = first or cost
        memory = results.memory(name, "at_risk", plan.OURS.key)
        rows.append((thousands(results.points(name)), rounded(time), rounded(cost),
                     rounded(cost / first), rounded(memory),
                     rounded(1e6 * memory / results.points(name))))
    header = ("points", "ms", "ns a point", "× the first row", "MB beyond the input",
              "bytes a point")
    return f"""## Growth

At risk, two neighbours on average, X = 100 m, one thread, a plain call.

{table(header, rows)}"""


def hostile_section(results):
    rows = []
    for swarm in plan.HOSTILE:
        for question in ("at_risk", "nearest"):
            costs = results.hostile_costs(swarm.name, question)
            if costs:
                rows.append((swarm.name, swarm.description, question.replace("_", " "),
                             *(rounded(cost) for cost in costs)))
    sizes = [f"{thousands(size)} points" for size in plan.HOSTILE_SIZES][:len(rows[0]) - 3]
    return f"""## Swarms that ruin a search

Nanoseconds a point, beespace, one thread. What grew with the square of the points would be ten
times as dear in the last column as in the one before it.

{table(("swarm", "", "question", *sizes), rows)}"""


def paper_section(results):
    times = []
    answers = []
    names = {"hash": "the paper's hash, rebuilt", "kdtree": "textbook kd-tree",
             "octree": "textbook octree", "beespace": "beespace"}
    for bees, _, published in plan.PAPER_FILES:
        rows = [row for row in results.rows("paper") if row["bees"] == bees]
        if not rows:
            continue
        times.append((thousands(bees), "*as published*", f"{rounded(published[0])}",
                      f"{rounded(published[1])}", rounded(published[0] + published[1]), "",
                      rounded(published[2]),
                      rounded(published[3])))
        for row in rows:
            times.append(("", names[row["method"]], spread(row["parse_ms"]),
                          spread(row["find_ms"]),
                          rounded(row["parse_ms"]["mean"] + row["find_ms"]["mean"]),
                          str(row["repetitions"]),
                          rounded(row["parse_mb"] * 1e6 / 2**20),
                          rounded(row["find_mb"] * 1e6 / 2**20)))
            if row["method"] in ("hash", "beespace"):
                answers.append((thousands(bees), names[row["method"]], thousands(row["found"]),
                                *quality(row["found"], row["own_metres"]),
                                *quality(row["found"], row["earth"])))
    return f"""## The paper's table

Files of longitude, latitude and height: the first two and the last in the region of the course
files, the third in one 20 times as wide, deep and high. *Parse* reads the text and fills the data
structure, *find* gives the bees at risk at 100 m; mean (least … most) in milliseconds of processor
time, memory of the whole process in MiB after each. As published: on a 2 GHz AMD A10-9700. Each of
our repetitions starts from nothing. The paper's method hands out whole cells, without naming the
bees in them one by one; the others name them.

{table(("bees", "method", "parse, ms", "find, ms", "both", "repetitions", "MiB parsed",
        "MiB found"), times)}
The paper's method takes 111,111 m for a degree of longitude and of latitude, and decides by boxes.
Precision is the share of the named bees that are at risk, recall the share of the bees at risk that it
names: first on its own metres, so that only the method counts, then on the Earth (WGS84).

{table(("bees", "method", "found", "right", "precision", "recall", "right on Earth", "precision",
        "recall"), answers)}"""


def quality(found, against):
    """What is right, precision, recall."""
    hits = found - against["spurious"]
    return thousands(against["right"]), percent(hits, found), percent(hits, against["right"])


def spread(times):
    return f"{rounded(times['mean'])} ({rounded(times['min'])} … {rounded(times['max'])})"


def write_report(rows, folder):
    """Writes compare.md and the charts into `folder`; returns the path of the page."""
    results = Results(rows)
    folder.mkdir(parents=True, exist_ok=True)
    pictures = charts.write_all(results, folder / "compare")
    sections = [QUICK_REMARK] if results.is_quick() else []
    sections += [machine_section(results)]
    if results.swarm_names():
        sections += [summary_section(results)]
    if pictures:
        sections += ["## Pictures\n\n" + "\n\n".join(
            f"![{title}](compare/{name})" for title, name in pictures) + "\n"]
    if results.swarm_names():
        sections += [questions_section(results), memory_section(results),
                     exactness_section(results), growth_section(results)]
    if results.rows("hostile"):
        sections += [hostile_section(results)]
    if results.rows("paper"):
        sections += [paper_section(results)]
    page = folder / "compare.md"
    page.write_text("\n".join([INTRODUCTION, *sections]), encoding="utf-8")
    return page


PAIRS_REMARK = "beespace returns them in ascending order, the others as they come.\n\n"

QUICK_REMARK = "A quick look: fewer points than planned, in a space that is smaller by as much.\n"

INTRODUCTION = """# beespace beside the others

Made by `scripts/compare` (`make compare`), which measures all of this anew on your machine; nothing
here is typed by hand. Every contender is a program of its own in `bench/compare`, used as its
competent user would use it.
"""
