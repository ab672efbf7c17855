"""A cluster of separate processes on this machine, and what it uses."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

MASTER = "local-cluster[2,1,2048]"  # a master, two workers with a core and an executor each


def start() -> Any:
    """A session of Spark."""
    from pyspark.sql import SparkSession

    os.environ["PYSPARK_PYTHON"] = sys.executable
    builder = (
        SparkSession.builder.master(MASTER)
        .appName("beespace comparison")
        .config("spark.ui.enabled", "false")
        .config("spark.ui.showConsoleProgress", "false")
        .config("spark.driver.bindAddress", "127.0.0.1")
        .config("spark.driver.host", "127.0.0.1")
        .config("spark.driver.memory", "2g")
        .config("spark.executor.memory", "2g")
        .config("spark.sql.shuffle.partitions", "6")
    )
    session = builder.getOrCreate()
    session.sparkContext.setLogLevel("ERROR")
    return session


def run(frame: Any) -> None:
    """Computes all rows of a data frame, and throws them away."""
    frame.write.format("noop").mode("overwrite").save()


class Used(NamedTuple):
    """Seconds: of a clock, and of processors in this process and all that it started."""

    wall_s: float
    processor_s: float


def used(work: Callable[[], Any]) -> Used:
    """What some work takes."""
    wall, processor = time.perf_counter(), processor_seconds()
    work()
    taken = Used(time.perf_counter() - wall, processor_seconds() - processor)
    if taken.processor_s < 0:
        raise RuntimeError("an executor was lost, and with it what it had used: measure again")
    return taken


def processor_seconds() -> float:
    """Of this process and all that come from it: the driver, the executors, their workers."""
    tick = os.sysconf("SC_CLK_TCK")
    children: dict[int, list[int]] = {}
    seconds: dict[int, float] = {}
    for name in os.listdir("/proc"):
        if not name.isdigit():
            continue
        try:
            fields = Path("/proc", name, "stat").read_text().rsplit(")", 1)[1].split()
        except OSError:  # it has ended meanwhile
            continue
        children.setdefault(int(fields[1]), []).append(int(name))
        # With the time of children that have ended.
        seconds[int(name)] = sum(int(each) for each in fields[11:15]) / tick
    total, waiting = 0.0, [os.getpid()]
    while waiting:
        process = waiting.pop()
        total += seconds.get(process, 0.0)
        waiting += children.get(process, [])
    return total


def shuffled_bytes(session: Any, work: Callable[[], Any]) -> int:
    """How many bytes the jobs of some work write for a shuffle."""
    context = session.sparkContext
    group = f"measured at {time.monotonic_ns()}"
    context.setJobGroup(group, group)
    work()
    context.setJobGroup("others", "others")
    tracker = context.statusTracker()
    stages = {
        stage
        for job in tracker.getJobIdsForGroup(group)
        for stage in (tracker.getJobInfo(job) or _NoJob).stageIds
    }
    store = context._jsc.sc().statusStore()
    total = 0
    for stage in stages:
        try:
            total += int(store.lastStageAttempt(stage).shuffleWriteBytes())
        except Exception:  # a stage that was skipped has no attempt
            continue
    return total


class _NoJob:
    stageIds: tuple[int, ...] = ()
