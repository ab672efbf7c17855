"""docs/benchmarks/python.md and its chart, of the rows that were measured."""

from __future__ import annotations

import json
import os
import statistics
import sys
from pathlib import Path
from typing import Any

from questions import QUESTIONS

# The charts of all comparisons are drawn by one module.
sys.path.append(str(Path(__file__).resolve().parents[2] / "bench" / "compare"))

_OURS = "beespace"
_COLOURS = {
    "beespace": ("#d97706", "#fbbf24"),
    "SciPy cKDTree": ("#2563eb", "#60a5fa"),
    "scikit-learn": ("#059669", "#34d399"),
    "pykdtree": ("#7c3aed", "#a78bfa"),
    "vesin": ("#0e7490", "#22d3ee"),
    "matscipy": ("#92400e", "#d6a56b"),
    "freud": ("#be185d", "#f472b6"),
}

Row = dict[str, Any]


def _seconds(way: Row) -> float:
    return statistics.median(way["seconds"])


def by_peer(row: Row) -> dict[str, Row]:
    """The fastest way of each peer."""
    best: dict[str, Row] = {}
    for way in row["ways"].values():
        known = best.get(way["peer"])
        if known is None or _seconds(way) < _seconds(known):
            best[way["peer"]] = way
    return best


def _fastest_peer(row: Row) -> Row | None:
    peers = [way for peer, way in by_peer(row).items() if peer != _OURS]
    return min(peers, key=_seconds, default=None)


def _short(seconds: float) -> str:
    if seconds < 0.0995:
        return f"{1000 * seconds:.3g} ms"
    return f"{seconds:.3g} s"


def _factor(factor: float) -> str:
    return f"{factor:.0f}" if factor >= 9.95 else f"{factor:.1f}"


def summary(row: Row) -> str:
    """A row, for those who wait for the next."""
    peer = _fastest_peer(row)
    ours = _seconds(by_peer(row)[_OURS])
    text = f"{_short(ours)}"
    if peer is not None:
        text += f", {peer['peer']} {_short(_seconds(peer))}, {_factor(_seconds(peer) / ours)} times"
    if "library" in row:
        text += f", C++ {_short(_seconds(row['library']))}"
    return text + ("; WRONG" if row["wrong"] else "")


def _table(rows: list[Row]) -> list[str]:
    peers = [name for name in _COLOURS if any(name in by_peer(row) for row in rows)]
    lines = [
        "| question | " + " | ".join(peers) + " | times as fast as the fastest | aim |",
        "|---|" + "---|" * (len(peers) + 2),
    ]
    for row in rows:
        best = by_peer(row)
        cells = [_short(_seconds(best[name])) if name in best else "–" for name in peers]
        peer = _fastest_peer(row)
        ratio = "–" if peer is None else f"**{_factor(_seconds(peer) / _seconds(best[_OURS]))}**"
        title, aim = QUESTIONS[row["question"]]
        aimed = f"{aim:g}" if row["neighbours"] == 2.0 else ""
        lines.append(f"| {title} | " + " | ".join(cells) + f" | {ratio} | {aimed} |")
    return lines


def _against_library(rows: list[Row]) -> list[str]:
    lines = [
        "| points | λ | question | C++ | Python | Python / C++, medians | least of each |",
        "|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        if "library" not in row:
            continue
        ours, library = by_peer(row)[_OURS], row["library"]
        least = min(ours["seconds"]) / min(library["seconds"])
        lines.append(
            f"| {row['points']:,} | {row['neighbours']:g} | {QUESTIONS[row['question']][0]} "
            f"| {_short(_seconds(library))} | {_short(_seconds(ours))} "
            f"| {_seconds(ours) / _seconds(library):.2f} | {least:.2f} |"
        )
    return lines if len(lines) > 2 else []


def _memory(rows: list[Row]) -> list[str]:
    if not rows:
        return []
    names = ["C++", *_COLOURS]
    names = [name for name in names if any(name in row["peaks"] for row in rows)]
    lines = [
        "| points | λ | question | " + " | ".join(names) + " |",
        "|---|---|---|" + "---|" * len(names),
    ]
    for row in rows:
        cells = [_megabytes(row["peaks"].get(name)) for name in names]
        title = QUESTIONS[row["question"]][0]
        lines.append(
            f"| {row['points']:,} | {row['neighbours']:g} | {title} | " + " | ".join(cells) + " |"
        )
    return lines


def _megabytes(size: int | None) -> str:
    return "–" if size is None else f"{size / 1e6:.0f}"


def _hows(rows: list[Row]) -> list[str]:
    """Which function of each peer was the fastest, by question."""
    seen: dict[str, set[str]] = {}
    for row in rows:
        for peer, way in by_peer(row).items():
            seen.setdefault(peer, set()).add(way["how"])
    return [f"- {peer}: {', '.join(sorted(seen[peer]))}" for peer in _COLOURS if peer in seen]


def _runs(rows: list[Row]) -> str:
    runs = [len(row["ways"][name]["seconds"]) for row in rows for name in list(row["ways"])[:1]]
    return f"{min(runs)} to {max(runs)}" if min(runs) < max(runs) else str(runs[0])


def _processor() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "an unknown processor"


def write(results: Path, folder: Path) -> None:
    """Writes the page and its chart."""
    first, *rest = [json.loads(line) for line in results.read_text().splitlines()]
    rows: list[Row] = [row for row in rest if "ways" in row]
    loads = [float(row["load"]) for row in rows]
    versions = ", ".join(f"{name} {version}" for name, version in first["versions"].items())
    lines = [
        "# beespace in Python, beside other packages",
        "",
        "Written by `make compare-python`. Uniform points in a cube, a threshold of 100 m; λ is the mean",
        "number of neighbours, but for the border. Processor time on one core, from the array of points to",
        "arrays of NumPy: the tree or the list of cells included, of the fastest way that a package has to",
        f"ask. Medians of {_runs(rows)} runs in turn; what took twice as long as the fastest peer was",
        "asked once. A dash is for what a package does not answer, or was not asked.",
        f"{versions}; Python {sys.version.split()[0]}; {_processor()}, {os.cpu_count()} cores, shared, "
        f"at a load of {min(loads):.1f} to {max(loads):.1f}.",
        "",
        "All answers were compared before, and agree: ids of 64-bit peers exactly, distances to the last",
        "digits. freud computes in 32 bits: pairs whose distance is the threshold but for that, and a point",
        "in a thousand, may differ.",
        "",
        "![Time of each package and question](python/chart.svg)",
    ]
    for key in dict.fromkeys((row["points"], row["neighbours"]) for row in rows):
        those = [row for row in rows if (row["points"], row["neighbours"]) == key]
        lines += ["", f"## {key[0]:,} points, λ = {key[1]:g}", "", *_table(those)]
    lines += ["", "The functions that were the fastest:", "", *_hows(rows)]
    against = _against_library(rows)
    if against:
        lines += [
            "",
            "## What Python costs over C++",
            "",
            "`answer_benchmark` asks the C++ library for vectors: `Engine::find_pairs` and",
            "`pair_distances`, ids of 32 bits. Each call has an engine of its own, as a function of the",
            "package has. Processor time. The machine is shared: look at the least of each, too.",
            "",
            *against,
        ]
    memory = _memory([row for row in rest if "peaks" in row])
    if memory:
        lines += [
            "",
            "## Memory",
            "",
            "By how many megabytes the first call raises the peak of a process beyond the answer itself,",
            "of the fastest way.",
            "",
            *memory,
        ]
    (folder / "python").mkdir(parents=True, exist_ok=True)
    (folder / "python.md").write_text("\n".join(lines) + "\n")
    (folder / "python" / "chart.svg").write_text(_chart(rows))


def _chart(rows: list[Row]) -> str:
    import dot_chart

    groups: list[tuple[str, list[Any]]] = []
    for key in dict.fromkeys((row["points"], row["neighbours"]) for row in rows):
        dots: list[Any] = []
        for row in rows:
            if (row["points"], row["neighbours"]) != key:
                continue
            best = by_peer(row)
            peer = _fastest_peer(row)
            remark = f"× {_factor(_seconds(peer) / _seconds(best[_OURS]))}" if peer else ""
            values = {name: _seconds(best[name]) for name in _COLOURS if name in best}
            dots.append(dot_chart.Row(QUESTIONS[row["question"]][0], values, remark))
        groups.append((f"{key[0]:,} points, λ = {key[1]:g}", dots))
    shown = {name for row in rows for name in by_peer(row)}
    return dot_chart.svg(
        dot_chart.DotChart(
            "Python packages, question by question",
            (
                "Processor time on one core, from an array of points to arrays of answers.",
                "On the right: how many times beespace’s time the fastest other one takes",
            ),
            _axis_text,
            {name: colour for name, colour in _COLOURS.items() if name in shown},
            groups,
        )
    )


def _axis_text(seconds: float) -> str:
    if seconds >= 0.999:
        return f"{seconds:,.0f} s"
    return f"{1000 * seconds:,.0f} ms" if seconds >= 0.000999 else f"{1e6 * seconds:,.0f} µs"
