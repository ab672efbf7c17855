"""A Master and two Workers of their own: one is killed, one has no room. A task is run twice, and none has
much more to do than the others."""

from __future__ import annotations

import os
import re
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import beespace
import beespace.spark
import numpy as np
import pyspark
import pytest
from test_failures import _frame

_POINTS = 300_000
_PROGRAM = """
import sys
import numpy as np
import beespace.spark
from pyspark.sql import SparkSession
_, master, count, into, tests, marks = sys.argv
sys.path.insert(0, tests)
from test_failures import _frame

def slow_at_first(batches):
    import os, time, uuid
    from pyspark import TaskContext
    context = TaskContext.get()
    if context.partitionId() == 0:
        name = f"{context.stageId()}-{context.attemptNumber()}-{uuid.uuid4().hex}"
        open(os.path.join(marks, name), "x").close()
        if context.attemptNumber() == 0:
            time.sleep(100)
    yield from batches

session = (SparkSession.builder.master(master).config("spark.ui.enabled", "false")
    .config("spark.driver.host", "127.0.0.1").config("spark.driver.bindAddress", "127.0.0.1")
    .config("spark.executor.memory", "700m").config("spark.cores.max", "2").config("spark.excludeOnFailure.enabled", "true")
    .config("spark.speculation", str(bool(marks)).lower()).config("spark.speculation.quantile", "0.5")
    .config("spark.network.timeout", "600s").getOrCreate())
session.sparkContext.setLogLevel("ERROR")
frame = _frame(session, int(count))
if marks:
    frame = frame.mapInArrow(slow_at_first, frame.schema)
asked = beespace.spark.pairs(frame, 1.0, cell_points=20_000)
print("ASKED", flush=True)
rows = asked.toPandas().sort_values(["first", "second"])
np.savez(into, **{name: rows[name].to_numpy() for name in rows.columns})
print("DONE", flush=True)
session.stop()
"""


class Cluster:
    """Processes that a test ends."""

    def __init__(self, folder):
        self.folder = folder
        self.spark_class = str(Path(pyspark.__file__).parent / "bin" / "spark-class")
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = probe.getsockname()[1]
        self.master = f"spark://127.0.0.1:{self.port}"
        self.processes = []
        self.start("master.Master", "--host", "127.0.0.1", "--port", str(self.port), "--webui-port", "0")
        self.wait_for("Master", "New state: ALIVE")

    def start(self, name, *arguments, before="", room=None):
        """A process, in a group of its own with its children; perhaps with files of so many KiB at most."""
        log = open(self.folder / f"{len(self.processes)}.log", "w")
        limit = "" if room is None else f"ulimit -f {room}; "
        command = f'{limit}exec "$0" "$@"'
        started = subprocess.Popen(
            ["bash", "-c", command, self.spark_class, f"org.apache.spark.deploy.{name}", *arguments],
            stdout=log, stderr=subprocess.STDOUT, start_new_session=True, cwd=self.folder,
            env={**os.environ, "SPARK_LOCAL_DIRS": str(self.folder / "local"), "PYSPARK_PYTHON": sys.executable},
        )
        self.processes.append(started)
        return started

    def worker(self, room=None, host="127.0.0.1"):
        number = len(self.processes)
        started = self.start(
            "worker.Worker", "--cores", "1", "--memory", "1g", "--webui-port", "0", "--host", host,
            "--work-dir", str(self.folder / f"work-{number}"), self.master, room=room,
        )
        self.wait_for("Worker", "Successfully registered with master")
        return started

    def wait_for(self, name, text):
        log = self.folder / f"{len(self.processes) - 1}.log"
        until = time.monotonic() + 120
        while text not in log.read_text():
            assert time.monotonic() < until, f"{name} did not start: {log.read_text()[-2000:]}"
            time.sleep(0.1)

    def said(self):
        """What executors wrote."""
        return "\n".join(path.read_text(errors="replace") for path in self.folder.glob("work-*/*/*/stderr"))

    def ask(self, count=_POINTS, marks=""):
        here, into = str(Path(__file__).parent), str(self.folder / "found.npz")
        return subprocess.Popen(
            [sys.executable, "-c", _PROGRAM, self.master, str(count), into, here, marks],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=self.folder,
        )

    def end(self):
        for each in self.processes:
            try:
                os.killpg(each.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            each.wait()


@pytest.fixture
def cluster(tmp_path):
    made = Cluster(tmp_path)
    yield made
    made.end()


def _wanted(session, count=_POINTS):
    rows = _frame(session, count).toPandas()
    pairs = beespace.pairs(np.ascontiguousarray(rows[["x", "y", "z"]].to_numpy()), 1.0)
    return {"first": pairs.i, "second": pairs.j, "distance": pairs.distance}


def _compare(folder, wanted):
    found = np.load(folder / "found.npz")
    for name, values in wanted.items():
        np.testing.assert_array_equal(found[name], values)


def test_a_worker_is_killed_in_the_middle(session, cluster, tmp_path):
    wanted = _wanted(session)
    assert len(wanted["first"]) > 100_000
    cluster.worker()
    victim = cluster.worker()
    asking = cluster.ask()
    said = ""
    while "ASKED" not in said:
        line = asking.stdout.readline()
        assert line, said
        said += line
    time.sleep(1.5)
    assert asking.poll() is None
    os.killpg(victim.pid, signal.SIGKILL)
    said += asking.communicate(timeout=400)[0]
    assert "DONE" in said, said[-3000:]
    _compare(tmp_path, wanted)


def test_a_worker_without_room(session, cluster, tmp_path):
    """Its files end at 200 KiB: the answer is right, or there is none, and why is said."""
    wanted = _wanted(session)
    cluster.worker()
    cluster.worker(room=200)
    said = cluster.ask().communicate(timeout=400)[0]
    assert re.search("File too large|No space left", said + cluster.said())
    if "DONE" in said:
        _compare(tmp_path, wanted)
    else:
        assert not (tmp_path / "found.npz").exists()


def test_a_task_that_is_slow_is_run_twice(session, cluster, tmp_path):
    """By speculation: the first attempt sleeps, the second does not. It needs a host of another name."""
    marks = tmp_path / "marks"
    marks.mkdir()
    cluster.worker()
    cluster.worker(host="127.0.0.2")
    said = cluster.ask(60_000, str(marks)).communicate(timeout=400)[0]
    assert "DONE" in said, said[-3000:]
    _compare(tmp_path, _wanted(session, 60_000))
    stages = [tuple(map(int, path.name.split("-")[:2])) for path in marks.iterdir()]
    # The last of them is that of the search; before it comes the survey.
    assert {0, 1} <= {attempt for stage, attempt in stages if stage == max(stages)[0]}


def test_millions_no_task_takes_much_longer_than_the_others(session):
    """Of a swarm a part of which is a thousand times denser: in processor seconds of the search."""
    from beespace.spark._questions import Counts
    from beespace.spark._search import Level, arguments_of, look, places_of, prepare, reach_of

    count = 1_500_000
    side = (count / 2) ** (1 / 3) * 10
    frame = session.range(0, count, 1, 6).selectExpr(
        "id", *[
            f"(0.5 + hash(id, {at}) / 4294967296D) * if(id % 2 = 0, {side}, {side / 10}) AS {name}"
            for at, name in ((1, "x"), (2, "y"), (3, "z"))
        ],
    )
    places = places_of("id", "x", "y", "z", None, None, None)
    level = Level(1.0, None, False)
    look_at = look(frame, places, True, 1_000_000, 8)
    prepared = prepare(frame, places, look_at, reach_of(level, places.columns), 1_000_000, 8)
    question = Counts(places.columns, "id", 1.0, arguments_of(level))

    def timed(batches):
        import pyarrow

        begin = time.process_time()
        told = near = 0
        for batch in question(batches):
            told += batch.num_rows
            near += sum(batch.column(1).to_pylist())
        columns = [[told], [near], [time.process_time() - begin]]
        yield pyarrow.RecordBatch.from_arrays([pyarrow.array(each) for each in columns], ["told", "near", "seconds"])

    asked = prepared.blocks.mapInArrow(timed, "told long, near long, seconds double")
    asked.collect()  # workers import what they need
    rows = asked.collect()
    assert len(rows) == 8 and sum(row["told"] for row in rows) == count
    assert sum(row["near"] for row in rows) > 100_000
    seconds = sorted(row["seconds"] for row in rows)
    assert seconds[-1] <= 3 * np.median(seconds), seconds


@pytest.mark.parametrize(
    ("kind", "count"), [("uniform", 1_000_000), ("clusters", 1_000_000), ("uniform", 10_000_000)]
)
def test_millions_of_points(session, kind, count):
    """Millions of points: who is at risk and how many are near each, as one machine says."""
    side = (count * 2.0) ** (1 / 3)
    shrunk = "if(id % 2 = 0, 1D, 0.1D)" if kind == "clusters" else "1D"
    frame = session.range(0, count, 1, 8).selectExpr(
        "id", *[
            f"(0.5 + hash(id, {at}) / 4294967296D) * {side} * {shrunk} AS {name}"
            for at, name in ((1, "x"), (2, "y"), (3, "z"))
        ],
    )
    rows = frame.toPandas()
    points = tuple(rows[name].to_numpy() for name in "xyz")
    found = beespace.spark.counts(frame, 1.0, cell_points=200_000).toPandas()
    counts = np.full(count, -1)
    counts[found["id"]] = found["count"]
    assert len(found) == count
    np.testing.assert_array_equal(counts, beespace.count(points, 1.0, threads=0))
    if count > 1_000_000:
        return
    # The clusters are a thousand times as dense: nearer, so that not each point has a thousand others.
    near = 0.2 if kind == "clusters" else 1.0
    found = beespace.spark.pairs(frame, near, cell_points=200_000).toPandas().sort_values(["first", "second"])
    wanted = beespace.pairs(points, near)
    assert len(wanted) > count // 2
    for name, other in (("first", wanted.i), ("second", wanted.j), ("distance", wanted.distance)):
        np.testing.assert_array_equal(found[name], other)
    found = beespace.spark.nearest(frame, 2, cell_points=200_000).toPandas().sort_values(["id", "rank"])
    wanted = beespace.nearest(points, 2)
    np.testing.assert_array_equal(found["nearest"], wanted.ids.ravel())
    np.testing.assert_array_equal(found["distance"], wanted.distances.ravel())
