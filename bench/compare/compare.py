"""Compares beespace with other libraries and methods, and writes tables and charts about it.

Every answer is compared before anything is timed. Results are rows of JSON in
build/compare/results.jsonl; docs/benchmarks/compare.md and its charts are made of them.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import plan
from machine import describe_machine
from programs import Programs
from report import write_report

PROJECT = Path(__file__).resolve().parents[2]
CHECKED_POINTS = 2_000
PAPER_SECONDS = 10
QUICK_PART = 20


def described(description):
    """What the report needs of a description."""
    return {key: description[key] for key in ("name", "version", "arithmetic", "use")}


class Comparison:
    """Measures section by section; every row goes to the file as soon as it is known."""

    def __init__(self, programs, rows_file, quick, only):
        self._programs = programs
        self._rows_file = rows_file
        self._quick = quick
        self._only = only
        self.wrong = []

    def _swarms(self):
        for swarm in plan.SWARMS:
            if not is_one_of(swarm.name, self._only):
                continue
            if not self._quick:
                yield swarm
            elif swarm.points <= 1_000_000:
                yield swarm.scaled(swarm.points // QUICK_PART)

    def _keep(self, section, **row):
        self._rows_file.write(json.dumps({"section": section, **row}) + "\n")
        self._rows_file.flush()

    def _ask_all(self, section, swarm, questions, contenders, **more):
        """Asks all contenders about one swarm; the first one sets the reference answer."""
        points = self._programs.make_points(swarm)
        rows = {}
        for question in questions:
            mode = "keep"
            for contender in contenders:
                description = self._programs.description(contender)
                if description is None or not plan.is_asked(contender, swarm, question,
                                                            description["questions"]):
                    continue
                row = self._programs.measure(contender, mode, question, points, swarm)
                mode = "ask"
                self._note(section, swarm, question, contender, description, row)
                self._keep(section, swarm=swarm.name, question=question, contender=contender.key,
                           **described(description), **more, **row)
                rows[question, contender.key] = row
        return points, rows

    def _note(self, section, swarm, question, contender, description, row):
        where = f"{section}: {swarm.name}, {swarm.points:,} points, {question}, {contender.key}"
        if "failed" in row:
            self.wrong.append(f"{where}: {row['failed']}")
        elif row["spurious"] + row["missed"] and description["arithmetic"] in ("exact", "float64"):
            self.wrong.append(f"{where}: wrong: {row['spurious']} too many, {row['missed']} missed")
        else:
            middle = sorted(row["cpu_ms"])[len(row["cpu_ms"]) // 2]
            print(f"{where}: {middle:.2f} ms", flush=True)
            return
        print(self.wrong[-1], file=sys.stderr, flush=True)

    def check(self):
        """All contenders against brute force, on a small swarm of each kind."""
        for swarm in self._swarms():
            self._ask_all("check", swarm.scaled(CHECKED_POINTS), plan.QUESTIONS,
                          (plan.BRUTE_FORCE,) + plan.CONTENDERS)
        for swarm in () if self._only else plan.HOSTILE:
            self._ask_all("check", replace(swarm, points=CHECKED_POINTS), plan.QUESTIONS,
                          (plan.BRUTE_FORCE, plan.OURS, plan.ENGINE, plan.TWO_THREADS))

    def swarms(self):
        for swarm in self._swarms():
            points, rows = self._ask_all("swarms", swarm, plan.QUESTIONS, plan.CONTENDERS)
            pairs = max((row.get("found", 0) for (question, _), row in rows.items()
                         if question == "pairs"), default=0)
            floors = json.loads(self._programs.run("floors", [points, pairs]))
            self._keep("floors", swarm=swarm.name, pairs=pairs, **floors)
        if not self._quick and is_one_of(plan.HUGE.name, self._only):
            self._ask_all("swarms", plan.HUGE, ["at_risk"], [plan.OURS])

    def sizes(self):
        charted = [contender for contender in plan.CONTENDERS if contender.charted]
        for swarm in self._swarms():
            for size in plan.SIZES:
                if size < swarm.points < plan.OWN_SIZE:
                    self._ask_all("sizes", swarm.scaled(size), ["at_risk"], charted)
            if not self._quick and swarm.points < plan.OWN_SIZE:
                self._ask_all("sizes", swarm.scaled(plan.OWN_SIZE), ["at_risk"], [plan.OURS])

    def densities(self):
        charted = [contender for contender in plan.CONTENDERS if contender.charted
                   and contender.program not in ("pcl_kdtree", "pcl_octree", "flann")]
        points = plan.DENSITY_POINTS // (QUICK_PART if self._quick else 1)
        for neighbours in plan.NEIGHBOURS:
            self._ask_all("densities", plan.cube_of_density(points, neighbours), ["at_risk"],
                          charted, neighbours=neighbours)

    def hostile(self):
        for swarm in plan.HOSTILE:
            for size in plan.HOSTILE_SIZES[:1] if self._quick else plan.HOSTILE_SIZES:
                self._ask_all("hostile", replace(swarm, points=size), ["at_risk", "nearest"],
                              [plan.OURS])

    def paper(self):
        for bees, widening, published in plan.PAPER_FILES[:2] if self._quick else plan.PAPER_FILES:
            text = self._programs.make_text(bees, widening)
            for method in plan.PAPER_METHODS:
                seconds = 1 if self._quick else PAPER_SECONDS
                row = json.loads(self._programs.run("paper_table", [method, text, seconds]))
                print(f"paper: {bees:,} bees, {method}: find {row['find_ms']['mean']:.3f} ms",
                      flush=True)
                self._keep("paper", bees=bees, method=method, published=published, **row)


SECTIONS = ("check", "swarms", "sizes", "densities", "hostile", "paper")


def parse_arguments():
    parser = argparse.ArgumentParser(prog="scripts/compare", description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true",
                        help="a twentieth of the points; writes to build/compare/quick")
    parser.add_argument("--only", nargs="+", default=[], metavar="SWARM",
                        help="these swarms only (D1, D2, ...); writes to build/compare/partly, "
                             "or with --sections anew into the whole")
    parser.add_argument("--sections", nargs="+", default=[], choices=SECTIONS, metavar="SECTION",
                        help="these sections only (%(choices)s); the rows of the others are kept")
    parser.add_argument("--render", action="store_true", help="measure nothing, write anew")
    parser.add_argument("--build", default=PROJECT / "build" / "compare", type=Path,
                        help="where the programs are")
    return parser.parse_args()


def is_one_of(swarm_name, only):
    return not only or any(swarm_name.startswith(name) for name in only)


def kept_rows(path, sections, only):
    if not path.exists():
        return []
    # The floors belong to the swarms.
    measured = set(sections) | ({"floors"} if "swarms" in sections else set())
    lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
    rows = [(line, json.loads(line)) for line in lines]
    # Other sections measure all of theirs, whatever swarms are asked for.
    by_swarm = {"check", "swarms", "floors", "sizes"}
    return [line for line, row in rows if row["section"] != "machine" and not
            (row["section"] in measured and
             (row["section"] not in by_swarm or is_one_of(row["swarm"], only)))]


def check_all_are_here(programs):
    """A table without the best of the others would praise us for nothing."""
    missing = [contender.key for contender in plan.CONTENDERS
               if programs.description(contender) is None]
    if missing:
        sys.exit(f"compare: without {', '.join(missing)} nothing is written: "
                 "scripts/install-packages compare brings them")


def measure(options, rows_path):
    sections = options.sections or SECTIONS
    kept = kept_rows(rows_path, sections, options.only) if options.sections else []
    unfinished = rows_path.with_suffix(".unfinished")
    with tempfile.TemporaryDirectory(dir=rows_path.parent) as workspace, \
            open(unfinished, "w", encoding="utf-8") as rows_file:
        rows_file.writelines(kept)
        rows_file.write(json.dumps({"section": "machine", **describe_machine()}) + "\n")
        programs = Programs(options.build, workspace)
        if not (options.quick or options.only):
            check_all_are_here(programs)
        comparison = Comparison(programs, rows_file, options.quick, options.only)
        for section in sections:
            getattr(comparison, section)()
    unfinished.replace(rows_path)
    return comparison.wrong


def main():
    options = parse_arguments()
    partly = options.only and not options.sections
    part = "quick" if options.quick else "partly" if partly else ""
    rows_path = options.build / part / "results.jsonl"
    rows_path.parent.mkdir(parents=True, exist_ok=True)
    output = options.build / part if part else PROJECT / "docs" / "benchmarks"
    wrong = []
    try:
        if not options.render:
            wrong = measure(options, rows_path)
    except subprocess.CalledProcessError as error:
        sys.exit(f"compare: {error.cmd[0]} failed: {error.stderr.strip()}")
    rows = [json.loads(line) for line in rows_path.read_text(encoding="utf-8").splitlines()]
    print(f"written: {write_report(rows, output)}")
    if wrong:
        sys.exit("compare: these answers are wrong, or not there:\n" + "\n".join(wrong))


if __name__ == "__main__":
    main()
