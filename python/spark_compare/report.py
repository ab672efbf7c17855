"""The section of docs/benchmarks/scale.md about Spark, of the rows that were measured."""

from __future__ import annotations

import json
import math
import statistics
from pathlib import Path
from typing import Any

import cost
import ways
from beespace.spark._sample import CellSize

_BEGIN = "<!-- made by scripts/compare-spark: what follows -->"
_END = "<!-- made by scripts/compare-spark: until here -->"
_CLUSTER = (ways.OURS, ways.HALF, ways.HALO)
_ALL = (*_CLUSTER, ways.ONE_PROCESS, ways.OUT_OF_CORE)

Row = dict[str, Any]


def _median(row: Row, name: str, what: int) -> float:
    return statistics.median(run[what] for run in row["ways"][name])


def _ratio(row: Row, what: int) -> float:
    """How many times as long the better grid join takes."""
    best = min(_median(row, name, what) for name in _CLUSTER[1:] if name in row["ways"])
    return best / _median(row, ways.OURS, what)


def _short(seconds: float) -> str:
    return f"{seconds:.2g} s" if seconds < 9.95 else f"{seconds:.0f} s"


def _rate(points: float) -> str:
    return f"{points:,.0f}" if points < 9_950 else f"{points / 1000:,.0f} k"


def summary(row: Row) -> str:
    """A row, for those who wait for the next."""
    told = ", ".join(f"{name} {_short(_median(row, name, 1))}" for name in _ALL if name in row["ways"])
    wrong = "; WRONG" if row["wrong"] else ""
    return f"{row['scene']}, {row['question']}: {told} of processors; {_ratio(row, 1):.1f} times{wrong}"


def write(results: Path, document: Path) -> None:
    """Puts the section between its markers."""
    told = [json.loads(line) for line in results.read_text().splitlines()]
    machine = next(each["machine"] for each in told if "machine" in each)
    rows = [each["row"] for each in told if "row" in each]
    costs = [each["cost"] for each in told if "cost" in each]
    lines = [_BEGIN, "", *_introduction(machine, rows), *_throughput(rows)]
    # A run that was ended has no model: there are constants for as many scenes as are fitted, and more.
    if len(costs) >= cost.SCENES:
        lines += _model(costs)
    else:
        lines += ["The run was ended before the model of cost was measured, and before all scenes were.", ""]
    lines += [_END]
    text = document.read_text()
    before, _, rest = text.partition(_BEGIN)
    _, _, after = rest.partition(_END)
    document.write_text(before.rstrip() + "\n\n" + "\n".join(lines) + (after or "\n"))


def _introduction(machine: Row, rows: list[Row]) -> list[str]:
    loads = [row["load"] for row in rows]
    runs = max(len(row["ways"][ways.OURS]) for row in rows)
    return [
        "## On a cluster of processes",
        "",
        f"Made by `make compare-spark`, in one run. Spark {machine['spark']}, Java {machine['java']}, Python {machine['python']}; a",
        f"master, two workers and two executors with a core each, on one machine: {machine['processor']}, {machine['cores']} cores,",
        f"{machine['memory_gib']} GiB. So this shows what a search costs, not how it grows with machines. Other work ran beside it, at a load of",
        f"{min(loads):.0f} to {max(loads):.0f}: look at processor seconds, of all processes together, rather than at the clock's.",
        "",
        "Points lie in Parquet; the answer is computed and thrown away (`noop`). λ is the mean number of neighbours; of the clusters, half of the",
        "points are in ten boxes 100 times as dense. Answers were compared before, with those of one process: ids exactly. All was asked at least once",
        f"before, of 20,000 points. Medians of up to {runs} runs, in turn; what took 3 times as long as `beespace.spark` once.",
        "The grid joins are plain Spark SQL, written for speed: cells as numbers, one side goes to half of the neighbours; or larger cells, and",
        "one side goes to all that it may touch. One process has two threads, and reads the same Parquet.",
        "",
        "Apache Sedona was not measured: the jar that its distance join needs could not be had from Maven Central.",
        "",
    ]


def _throughput(rows: list[Row]) -> list[str]:
    lines = [
        "| points | λ | layout | question | " + " | ".join(_ALL) + " | the better grid join / beespace.spark | by the clock |",
        "|---|---|---|---|" + "---|" * (len(_ALL) + 2),
    ]
    for row in rows:
        cells = [
            f"{_short(_median(row, name, 1))}, {_rate(row['points'] / _median(row, name, 1))}/s"
            if name in row["ways"]
            else "–"
            for name in _ALL
        ]
        lines.append(
            f"| {row['points']:,} | {row['neighbours']:g} | {row['layout']} | {row['question']} | "
            + " | ".join(cells)
            + f" | **{_ratio(row, 1):.1f}** | {_ratio(row, 0):.1f} |"
        )
    reached = sum(_ratio(row, 1) >= 10 for row in rows)
    return [
        *lines,
        "",
        f"Processor seconds, and points for each of them. Aimed at: 10 times the grid join; reached in {reached} of {len(rows)} rows.",
        "",
    ]


def _model(costs: list[Row]) -> list[str]:
    parts = cost.fitted(costs)
    bytes_sent = statistics.median(row["bytes"] / (row["points"] * row["halo"]) for row in costs)
    lines = [
        "### What it costs: a model",
        "",
        "| part | for being run | for a point | for a row of the answer |",
        "|---|---|---|---|",
    ]
    told = {
        "survey": "survey, of the points",
        "cut": "cutting and sending, of the points that are sent",
        "search": "search, of the points that are sent",
    }
    for name, part in parts.items():
        lines.append(
            f"| {told[name]} | {part.fixed_s:.2f} s | {part.point_s * 1e9:,.0f} ns | "
            + (f"{part.row_s * 1e9:,.0f} ns |" if name == "search" else "– |")
        )
    lines += [
        "",
        f"Processor seconds. {bytes_sent:.0f} bytes a point that is sent, as Spark counts them. Sent are n · (1 + 2r/L)³ at most, as cells at the",
        "border have no halo there. Fitted on the scenes that say so; the others check it:",
        "",
        "| scene | question | | cells | halo factor | (1 + 2r/L)³ | measured | predicted | off by |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    worst = 0.0
    for row in costs:
        formula = cost.halo_of(row["points"], row["neighbours"], row["cells"])
        for question, answers in (("pairs", row["rows"]), ("at_risk", row["at_risk_rows"])):
            measured = row["survey_s"] + row[question + "_s"]
            expected = cost.predicted(parts, row["points"], row["halo"], answers)
            off = expected / measured - 1.0
            if not row["fit"]:
                worst = max(worst, abs(off))
            clustered = "clusters" in row["scene"]
            lines.append(
                f"| {row['scene']} | {question} | {'fitted' if row['fit'] else 'checked'} | {row['cells']} | {row['halo']:.3f} | "
                f"{'–' if clustered else f'{formula:.3f}'} | {measured:.2f} s | {expected:.2f} s | {100 * off:+.0f} % |"
            )
    lines += ["", f"The farthest off of those that check it: {100 * worst:.0f} %. Aimed at: 20 %.", ""]
    return lines + _on_paper(parts, bytes_sent, costs[0]["plane_s"])


def _on_paper(parts: dict[str, cost.Part], bytes_sent: float, plane_s: float) -> list[str]:
    points, machines, cores, cell, neighbours = 1e11, 100, 16, 1e6, 2.0
    halo = cost.halo_of(points, neighbours, points / cell)
    tasks = points / cell
    in_parts = cost.predicted(parts, points, halo, points * neighbours / 2)
    size = CellSize(round(cell), machines * cores)
    partitions = math.ceil(points * 32 / (128 << 20))
    each = round(points / partitions)
    sample = sum(each * size.share(at, each) for at in range(partitions))
    driver = sample * plane_s * 17
    sent = points * halo * bytes_sent
    network = sent / machines / 1.25e9
    disk = 2 * sent / machines / 0.5e9
    return [
        "### 10¹¹ points on 100 machines: on paper",
        "",
        "Not measured, but reckoned with the constants above, for machines with 16 such cores, 10 Gbit/s and disks of 500 MB/s each, uniform",
        f"points, λ = 2, cells of a million points (halo factor {halo:.3f}), all pairs:",
        "",
        f"- processors: {in_parts:,.0f} s, on 1,600 cores **{in_parts / machines / cores / 60:.0f} min**;",
        f"- the shuffle: {sent / 1e12:.1f} TB, {sent / machines / 1e9:.0f} GB a machine: {network / 60:.1f} min on the network, {disk / 60:.1f} min on the disks, partly beside",
        "  the processors;",
        f"- the driver: a sample of {sample / 1e6:.0f} million points ({sample * 32 / 1e9:.1f} GB; Spark's usual `spark.driver.maxResultSize` is 1 GB),",
        f"  cut in {driver / 60:.1f} min by one core, while the cluster waits.",
        "",
        "What such a sum leaves out: stragglers, failed machines, other people's jobs, the input's own reading from afar.",
    ]
