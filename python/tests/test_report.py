"""Pages: `report`, against the page of the command, and against the format that documents say."""

from __future__ import annotations

import base64
import json
import os
import re
import signal
import subprocess
import sys
import time
import zlib
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

import beespace
from tests import oracle

project = Path(__file__).resolve().parents[2]
data = project / "examples" / "data"
command = os.environ.get("BEESPACE_COMMAND")


def has_pages() -> bool:
    if "BEESPACE_IO_LIBRARY" not in os.environ:
        return False
    try:
        beespace.report([[0, 0, 0], [1, 1, 1]], 1)
    except beespace.BeespaceError as error:
        assert "this build has no page" in str(error)
        return False
    return True


pytestmark = pytest.mark.skipif(not has_pages(), reason="this build has no pages")


def content_of(page: str):
    """What a page says in JSON, and a function that unpacks its columns of texts."""
    scripts = dict(re.findall(r'<script type="[^"]*" id="(beespace-\w+)">(.*?)</script>', page, re.S))
    said = json.loads(scripts["beespace-page"])

    def texts(column):
        assert column["type"] == "json"
        packed = base64.b64decode(scripts[f"beespace-{column['at']}"])
        found = json.loads(zlib.decompress(packed))
        assert len(found) == column["count"]
        return found

    return said["swarms"][0], texts


@pytest.mark.skipif(command is None, reason="this build has no command")
@pytest.mark.parametrize(
    ("name", "threshold", "arguments", "options"),
    [
        ("swarm.csv", 5, [], {}),
        ("bees-1000.csv", 100, ["--vertical=100ft"], {"vertical": "100ft"}),
        ("bees-1000.csv", 100, ["--vertical=30", "--inclusive"], {"vertical": 30, "inclusive": True}),
        ("cage.csv", 0.05, ["--max-gap=never"], {"max_gap": float("inf")}),
        ("show.skyc", 2, ["--grounded"], {"grounded": True}),
        (
            "traffic.csv",
            5000,
            ["--units=height=ft,speed=kt,climb=ft/min"],
            {"units": "height=ft,speed=kt,climb=ft/min"},
        ),
    ],
)
def test_the_page_of_a_file_is_that_of_the_command(tmp_path, name, threshold, arguments, options):
    subprocess.run(
        [
            command, "report", data / name, f"--threshold={threshold}", "--quiet", *arguments,
            "--output", tmp_path / "command.html",
        ],
        check=True,
    )
    made = beespace.report(data / name, threshold, **options)
    by_command, _ = content_of((tmp_path / "command.html").read_text())
    by_python, _ = content_of(made.html)
    # Options are called otherwise in notes.
    worded = [re.sub("--[a-z-]+", lambda word: word[0][2:].replace("-", "_"), note)
              for note in by_command.pop("notes")]
    assert by_python.pop("notes") == worded == list(made.notes)
    assert by_python == by_command
    # The checksum at the end is that of the data, whose notes are worded otherwise.
    data_or_checksum = r'<script type="application/json".*?</script>|beespace-end">[^<]*<'
    before, after = (re.sub(data_or_checksum, "", page, flags=re.S)
                     for page in ((tmp_path / "command.html").read_text(), made.html))
    assert before == after


def test_the_page_of_points_is_of_these_points():
    xyz = np.random.default_rng(11).uniform(0, 60, (90, 3))
    near = oracle.pairs(xyz, 8.0)
    assert near
    made = beespace.report(xyz, 8.0, title="Swarm <1>", ids=[f"bee {i}" for i in range(90)])
    swarm, texts = content_of(made.html)
    assert (swarm["title"], swarm["count"], swarm["kind"]) == ("Swarm <1>", 90, "snapshot")
    assert swarm["risk"]["pairs"] == len(near)
    assert swarm["risk"]["at_risk"] == len({i for pair in near for i in pair})
    assert texts(swarm["names"]["texts"]) == [f"bee {i}" for i in range(90)]
    assert made.risky
    assert "names" not in content_of(beespace.report(xyz, 8.0).html)[0]
    assert not beespace.report(xyz, 1e-3).risky


def test_the_page_of_what_was_read_has_its_ids(tmp_path):
    path = tmp_path / "swarm.csv"
    path.write_text("id,x [m],y [m]\nanna,0,0\nbert,oops,1\n,3,4\ncora,90,0\n")
    read = beespace.read(path, skip_bad=True)
    path.unlink()
    made = beespace.report(read, 6)
    swarm, texts = content_of(made.html)
    assert texts(swarm["names"]["texts"]) == ["anna", "2", "cora"]
    assert swarm["title"] == "swarm.csv"
    assert "1" in swarm["risk"]["unknown"]
    assert any("bad records left out: 1" in note for note in made.notes)
    assert repr(made).startswith("<Report: a danger is shown\n")
    # None of the others is at risk, but of one it is not known.
    assert beespace.report(read, 1).risky


def test_it_is_written_whole_and_not_over_its_input(tmp_path):
    path = tmp_path / "swarm.csv"
    path.write_text("x [m],y [m]\n0,0\n3,4\n")
    made = beespace.report(path, 6, output=tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text() == made.html
    with pytest.raises(beespace.BeespaceFileError, match="was made of this file"):
        made.save(path)
    assert path.read_text().startswith("x [m]")
    with pytest.raises(OSError) as caught:
        made.save(tmp_path / "none" / "page.html")
    assert caught.value.code == "write_failed"
    assert sorted(each.name for each in tmp_path.iterdir()) == ["page.html", "swarm.csv"]


class Frames(HTMLParser):
    def __init__(self):
        super().__init__()
        self.frames = []

    def handle_starttag(self, tag, attributes):
        self.frames.append((tag, dict(attributes)))


def test_a_notebook_shows_it_in_a_frame_of_its_own():
    made = beespace.report([[0, 0, 0], [3, 4, 0]], 6, ids=['"><b>', "&amp;"])
    parser = Frames()
    parser.feed(made._repr_html_())
    [(tag, attributes)] = parser.frames
    assert tag == "iframe" and attributes["srcdoc"] == made.html
    assert "allow-same-origin" not in attributes["sandbox"]
    swarm, texts = content_of(made.html)
    assert texts(swarm["names"]["texts"]) == ['"><b>', "&amp;"]


def test_arguments_that_make_no_sense_are_refused(tmp_path):
    points = [[0, 0, 0], [3, 4, 0]]
    degrees = beespace.read(data / "bees-1000.csv")
    for call, code, place in [
        (lambda: beespace.report(points, 0), "invalid_threshold", "threshold"),
        (lambda: beespace.report(points, float("nan")), "invalid_threshold", "threshold"),
        (lambda: beespace.report(points, 1, vertical="high"), "invalid_argument", "vertical"),
        (lambda: beespace.report(points, 1, vertical=-1), "invalid_argument", "vertical"),
        (lambda: beespace.report(points, 1, max_gap=0), "invalid_argument", "max_gap"),
        (lambda: beespace.report(points, 1, ids=["a"]), "invalid_argument", "ids"),
        (lambda: beespace.report(points, 1, ids=["a", "b\0"]), "invalid_argument", "ids"),
        (lambda: beespace.report(points, 1, frame="metres"), "invalid_argument", "frame"),
        (lambda: beespace.report(degrees, 1, skip_bad=True), "invalid_argument", "skip_bad"),
        (lambda: beespace.report(degrees, 1, vertical=5), "invalid_argument", "vertical"),
        (lambda: beespace.report(degrees, 1, ids=range(1000)), "invalid_argument", "ids"),
        (lambda: beespace.report(data / "swarm.csv", 1, ids="a"), "invalid_argument", "ids"),
        (lambda: beespace.report([[0, 0, float("nan")]], 1), "not_finite", "points"),
        (lambda: beespace.report(tmp_path / "none", 1), "cannot_open", None),
    ]:
        with pytest.raises(beespace.BeespaceError) as caught:
            call()
        assert (caught.value.code, caught.value.place) == (code, place)


_interrupted = """
import signal, sys, time, numpy, beespace
crowd = numpy.random.default_rng(5).uniform(0, 1, (100_000, 3))
moves = numpy.repeat(crowd, 2, axis=0) + numpy.tile([[0, 0, 0], [1, 1, 1]], (100_000, 1))
with open(sys.argv[1], "w") as file:
    file.write("id,time_s,x [m],y [m],z [m]\\n")
    file.writelines(f"{{i // 2}},{{i % 2}},{{x}},{{y}},{{z}}\\n" for i, (x, y, z) in enumerate(moves.tolist()))
print("ready", flush=True)
began = time.monotonic()
try:
    while True: beespace.report({what}, 0.9)
except KeyboardInterrupt:
    print("ended", time.monotonic() - began < 20)
"""


@pytest.mark.parametrize("what", ["crowd", "sys.argv[1]"])
def test_ctrl_c_ends_the_search_for_a_page(tmp_path, what):
    program = subprocess.Popen(
        [sys.executable, "-c", _interrupted.format(what=what), tmp_path / "moves.csv"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert program.stdout.readline() == "ready\n"
    time.sleep(1)  # by then the file is read
    program.send_signal(signal.SIGINT)
    printed, complaint = program.communicate(timeout=60)
    assert printed == "ended True\n", complaint
