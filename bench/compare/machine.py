"""The machine that measures, in a few lines for the report."""

import platform
import re
import subprocess
from datetime import date
from pathlib import Path


def _read(path):
    try:
        return Path(path).read_text(encoding="utf-8")
    except OSError:
        return ""


def _first(pattern, text, otherwise="unknown"):
    found = re.search(pattern, text, re.MULTILINE)
    return found.group(1).strip() if found else otherwise


def _caches():
    """ "L1d 48 KiB, L2 2 MiB, ..." of the first processor."""
    caches = []
    for index in sorted(Path("/sys/devices/system/cpu/cpu0/cache").glob("index*")):
        kind = _read(index / "type").strip()
        if kind == "Instruction":
            continue
        size = _read(index / "size").strip()
        kibibytes = int(size[:-1]) if size.endswith("K") else 0
        shown = f"{kibibytes // 1024} MiB" if kibibytes >= 1024 else f"{kibibytes} KiB"
        letter = "d" if kind == "Data" else ""
        caches.append(f"L{_read(index / 'level').strip()}{letter} {shown}")
    return ", ".join(caches) or "unknown"


def _compiler():
    try:
        done = subprocess.run(["c++", "--version"], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return "unknown"
    return done.stdout.splitlines()[0]


def describe_machine():
    processors = _read("/proc/cpuinfo")
    flags = _first(r"^flags\s*:(.*)$", processors, "").split()
    sets = [name for flag, name in (("avx2", "AVX2"), ("avx512f", "AVX-512")) if flag in flags]
    memory_kib = int(_first(r"^MemTotal:\s*(\d+)", _read("/proc/meminfo"), "0"))
    return {
        "date": date.today().isoformat(),
        "processor": _first(r"^model name\s*:(.*)$", processors),
        "processors": len(re.findall(r"^processor\s*:", processors, re.MULTILINE)),
        "instruction_sets": ", ".join(sets),
        "caches": _caches(),
        "memory_gb": round(memory_kib * 1024 / 1e9, 1),
        "system": _first(r'^PRETTY_NAME="?([^"\n]*)', _read("/etc/os-release")),
        "kernel": _first(r"^([0-9.]*[0-9])", platform.release()),
        "compiler": _compiler(),
    }
