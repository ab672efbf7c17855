"""What dies in the middle is done again, and the answer is the same; what cannot go on says so."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
import zipfile
from pathlib import Path

import beespace
import beespace.spark
import numpy as np
import pytest


def _frame(session, count):
    """A swarm of which each task takes a while to read its part."""
    return session.range(0, count, 1, 6).selectExpr(
        "id", f"(hash(id, 1) / 4294967296D) * {count ** (1 / 3) * 1.3} AS x",
        f"(hash(id, 2) / 4294967296D) * {count ** (1 / 3) * 1.3} AS y",
        f"(hash(id, 3) / 4294967296D) * {count ** (1 / 3) * 1.3} AS z",
    )


def _executors():
    """The executors that descend from this process."""
    found = []
    parents, commands = {}, {}
    for place in Path("/proc").iterdir():
        if not place.name.isdigit():
            continue
        try:
            stat = (place / "stat").read_text()
            commands[int(place.name)] = (place / "cmdline").read_bytes()
            parents[int(place.name)] = int(stat.rpartition(")")[2].split()[1])
        except OSError:
            continue
    for process, command in commands.items():
        ancestor = process
        while ancestor in parents and ancestor != os.getpid():
            ancestor = parents[ancestor]
        if ancestor == os.getpid() and b"CoarseGrainedExecutorBackend" in command:
            found.append(process)
    return found


def test_an_executor_is_killed_in_the_middle(session):
    frame = _frame(session, 400_000)
    rows = frame.toPandas()
    wanted = beespace.pairs(np.ascontiguousarray(rows[["x", "y", "z"]].to_numpy()), 1.0)
    asked = beespace.spark.pairs(frame, 1.0, cell_points=20_000)
    answer = {}
    tracker = session.sparkContext.statusTracker()

    def ask():
        answer["pairs"] = asked.toPandas()

    asking = threading.Thread(target=ask)
    asking.start()
    while not tracker.getActiveStageIds() and asking.is_alive():
        time.sleep(0.02)
    time.sleep(0.3)
    victims = _executors()
    assert victims and asking.is_alive()
    os.kill(victims[0], signal.SIGKILL)
    asking.join(240)
    found = answer["pairs"].sort_values(["first", "second"])
    np.testing.assert_array_equal(found["first"], rows["id"].to_numpy()[wanted.i])
    np.testing.assert_array_equal(found["second"], rows["id"].to_numpy()[wanted.j])
    np.testing.assert_array_equal(found["distance"], wanted.distance)


_PROGRAM = """
import sys
sys.path.insert(0, sys.argv[1])
import beespace, beespace.spark
from pyspark.sql import SparkSession
builder = (SparkSession.builder.master("local-cluster[1,1,1024]").config("spark.ui.enabled", "false")
    .config("spark.executorEnv.BEESPACE_LIBRARY", "").config("spark.driver.host", "127.0.0.1")
    .config("spark.driver.bindAddress", "127.0.0.1").config("spark.executorEnv.PYTHONPATH", "shipped"))
if sys.argv[2:]:
    builder = builder.config("spark.archives", sys.argv[2] + "#shipped")
session = builder.getOrCreate()
frame = session.createDataFrame([(1, 0.0, 0.0), (2, 3.0, 4.0)], "id long, x double, y double")
try:
    print("FOUND", beespace.spark.at_risk(frame, 6, z=None).count())
except beespace.BeespaceError as error:
    print("TOLD", error)
session.stop()
"""


def _run(tmp_path, *more):
    package = str(Path(beespace.__file__).parents[1])
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    done = subprocess.run(
        [sys.executable, "-c", _PROGRAM, package, *more],
        env=environment, cwd=tmp_path, capture_output=True, text=True, timeout=240, check=False,
    )
    return done.stdout + done.stderr[-3000:]


def test_workers_without_the_package_are_told_before_the_work(tmp_path):
    told = _run(tmp_path)
    assert "TOLD the workers of Spark do not have beespace" in told, told
    assert "--archives" in told and "No module named 'beespace'" in told


def test_the_package_is_shipped_as_an_archive(tmp_path):
    folder = Path(beespace.__file__).parent
    archive = tmp_path / "beespace.zip"
    with zipfile.ZipFile(archive, "w") as into:
        for file in folder.rglob("*.py"):
            into.write(file, Path("beespace") / file.relative_to(folder))
        library = os.environ.get("BEESPACE_LIBRARY") or folder / "libbeespace.so"
        into.write(library, "beespace/libbeespace.so")
    told = _run(tmp_path, str(archive))
    assert "FOUND 2" in told, told


def test_a_task_that_fails_once_is_run_again(session, tmp_path):
    """Its second run gives the same rows; nothing is found twice."""
    mark = tmp_path / "failed"

    def fail_once(batches):
        import os

        for batch in batches:
            yield batch
        try:
            os.mkdir(str(mark))
        except FileExistsError:
            return
        raise RuntimeError("once")

    frame = _frame(session, 50_000)
    broken = frame.mapInArrow(fail_once, frame.schema)
    found = beespace.spark.at_risk(broken, 1.0, cell_points=5_000, check_ids=False)
    if mark.exists():  # by the survey; the search is to fail, too
        os.rmdir(mark)
    rows = frame.toPandas()
    wanted = beespace.at_risk(np.ascontiguousarray(rows[["x", "y", "z"]].to_numpy()), 1.0)
    ids = np.sort(found.toPandas()["id"].to_numpy())
    assert mark.exists()
    np.testing.assert_array_equal(ids, rows["id"].to_numpy()[wanted])


@pytest.mark.parametrize("count", [60_000])
def test_no_task_has_much_more_than_the_others(session, count):
    """Of a swarm a part of which is a thousand times denser, as the cut estimates it and as it is."""
    rng = np.random.default_rng(8)
    points = np.concatenate([rng.random((count // 2, 3)) * 900, 100 + rng.random((count // 2, 3)) * 90])
    import pandas

    frame = session.createDataFrame(pandas.DataFrame({"id": np.arange(count), **dict(zip("xyz", points.T))}))
    from beespace.spark._search import look, places_of, prepare

    places = places_of("id", "x", "y", "z", None, None, None)
    blocks = prepare(frame, places, look(frame, places, True, 3_000, 6), [2.0] * 3, 3_000, 6).blocks
    rows = blocks.selectExpr("spark_partition_id() AS at", "length(points) / 32 AS n")
    loads = [row["sum(n)"] for row in rows.groupBy("at").sum("n").collect()]
    assert len(loads) == 6
    assert max(loads) <= 1.5 * np.median(loads)
