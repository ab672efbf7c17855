"""Files: what `read` and `read_recording` give, against plain Python and against the command."""

from __future__ import annotations

import csv
import errno
import gc
import gzip
import json
import math
import os
import pickle
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import beespace
from tests import oracle

project = Path(__file__).resolve().parents[2]
data = project / "examples" / "data"
command = os.environ.get("BEESPACE_COMMAND")

# A build without the readers has nothing to test but that it says so; that of the command has both.
readers = pytest.mark.skipif(
    "BEESPACE_IO_LIBRARY" not in os.environ, reason="this build has no readers"
)


@pytest.fixture
def written(tmp_path):
    def write(name: str, content: str | bytes) -> Path:
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return write


@readers
def test_positions_are_the_numbers_of_the_file(written):
    random = np.random.default_rng(5)
    xyz = random.normal(0, 1000, (500, 3))
    rows = "".join(f"bee{i},{x!r},{y!r},{z!r}\n" for i, (x, y, z) in enumerate(xyz.tolist()))
    for name, content in [
        ("swarm.csv", "id,x [m],y [m],z [m]\n" + rows),
        ("swarm.csv.gz", gzip.compress(("id,x [m],y [m],z [m]\n" + rows).encode())),
    ]:
        read = beespace.read(written(name, content))
        assert np.array_equal(read.positions, xyz)
        assert read.ids.tolist() == [f"bee{i}" for i in range(500)]
        assert read.rows.tolist() == list(range(500))
        assert len(read) == 500 and read.frame == "metres" and read.degrees is None
        assert read.path.endswith(name)


@readers
def test_arrays_of_numpy_are_read_as_they_are(tmp_path):
    xyz = np.random.default_rng(6).normal(0, 1000, (50, 3))
    np.save(tmp_path / "swarm.npy", xyz)
    read = beespace.read(tmp_path / "swarm.npy", frame="metres")
    assert np.array_equal(read.positions, xyz)
    assert read.ids.dtype == np.int64 and read.ids.tolist() == list(range(50))


@readers
def test_positions_are_not_copied_and_outlive_what_was_read(written):
    path = written("swarm.csv", "id,x [m],y [m]\na,1,2\nb,3,4\n")
    read = beespace.read(path)
    first, second = read.positions, np.asarray(read)
    assert first.__array_interface__["data"] == second.__array_interface__["data"]
    assert not first.flags.writeable and np.array(read).flags.writeable
    with pytest.raises(ValueError):
        first[0, 0] = 7
    ids, rows = read.ids, read.rows
    del read, second
    gc.collect()
    path.write_text("")
    filled = [np.full((2, 3), 9.0) for _ in range(1000)]
    assert first.tolist() == [[1, 2, 0], [3, 4, 0]] and len(filled) == 1000
    assert ids.tolist() == ["a", "b"] and rows.tolist() == [0, 1]


@readers
def test_what_was_read_answers_questions(written):
    random = np.random.default_rng(7)
    xyz = random.uniform(0, 100, (120, 3)).round(1)
    rows = "".join(f"{x!r},{y!r},{z!r}\n" for x, y, z in xyz.tolist())
    read = beespace.read(written("swarm.csv", "x [m],y [m],z [m]\n" + rows))
    near = oracle.pairs(xyz, 12.0)
    assert near
    pairs = beespace.pairs(read, 12.0)
    assert list(zip(pairs.i.tolist(), pairs.j.tolist())) == near
    assert beespace.at_risk(read, 12.0).tolist() == sorted({i for pair in near for i in pair})
    higher = oracle.pairs(xyz, 12.0, vertical=5.0)
    pairs = beespace.pairs(read, 12.0, vertical=5.0)
    assert list(zip(pairs.i.tolist(), pairs.j.tolist())) == higher


def earth_centred(longitude: float, latitude: float, height: float) -> list[float]:
    """The textbook formula, of WGS84."""
    a, f = 6378137.0, 1 / 298.257223563
    e2 = f * (2 - f)
    lon, lat = math.radians(longitude), math.radians(latitude)
    n = a / math.sqrt(1 - e2 * math.sin(lat) ** 2)
    across = (n + height) * math.cos(lat)
    return [
        across * math.cos(lon),
        across * math.sin(lon),
        (n * (1 - e2) + height) * math.sin(lat),
    ]


@readers
def test_degrees_become_metres_and_are_kept():
    read = beespace.read(data / "bees-1000.csv")
    with open(data / "bees-1000.csv", newline="") as file:
        rows = [[float(field) for field in row] for row in list(csv.reader(file))[1:]]
    assert read.frame == "wgs84"
    assert read.degrees.tolist() == rows
    expected = np.array([earth_centred(*row) for row in rows])
    assert np.abs(read.positions - expected).max() < 1e-8


@readers
def test_a_vertical_threshold_needs_heights(written):
    read = beespace.read(data / "bees-1000.csv")
    metres = beespace.read(written("swarm.csv", "x [m],y [m]\n1,2\n"))
    for ask in (beespace.at_risk, beespace.pairs, beespace.neighbors, beespace.count):
        with pytest.raises(beespace.BeespaceError, match="not a height"):
            ask(read, 100, vertical=10)
        with pytest.raises(beespace.BeespaceError, match="points are in wgs84 and these in metres"):
            ask(read, 100, others=metres)
    with pytest.raises(beespace.BeespaceError, match="not a height"):
        beespace.groups(read, 100, vertical=10)
    with pytest.raises(beespace.BeespaceError, match="not a height"):
        next(iter(beespace.iter_pairs(read, 100, vertical=10)))
    with pytest.raises(beespace.BeespaceError, match="not a height"):
        beespace.nearest(read, within=100, vertical=10)
    assert len(beespace.at_risk(read, 100, others=read)) == 1000


@readers
@pytest.mark.skipif(command is None, reason="this build has no command")
@pytest.mark.parametrize(
    ("name", "threshold", "options"),
    [
        ("bees-1000.csv", 100, {}),
        ("mission.csv", 10, {}),
        ("swarm.csv", 5, {}),
        ("swarm.csv", 1, {"columns": "id=1,x=5,y=3,z=4", "units": "position=km"}),
        ("bees-1000.csv", 100, {"units": "height=ft"}),
    ],
)
def test_the_command_reads_the_same(name, threshold, options):
    arguments = [f"--{option}={value}" for option, value in options.items()]
    printed = subprocess.run(
        [command, "detect", data / name, f"--threshold={threshold}", "--json", "--quiet", *arguments],
        check=True,
        capture_output=True,
    ).stdout
    said = json.loads(printed)
    read = beespace.read(data / name, **options)
    assert len(read) == said["input"]["points"]
    assert read.format == said["input"]["format"]
    assert read.frame == said["input"]["frame"]
    assert read.frame_reason == said["input"]["reason"].replace("--columns", "columns")
    units = [f"{each['of']} in {each['unit']}: {each['reason']}" for each in said["input"]["units"]]
    expected = tuple(note.replace("--", "") for note in units + said["input"]["notes"])
    # Which the command does not say: points of Python have no velocities that anyone could miss.
    left_out = [note for note in read.notes if note.startswith("velocities, in columns")]
    assert len(left_out) == (name == "swarm.csv" and "columns" not in options)
    assert read.notes == expected + tuple(left_out)
    at_risk = beespace.at_risk(read, threshold)
    assert read.ids[at_risk].tolist() == said["at_risk"]


@readers
def test_errors_say_where(written):
    path = written("swarm.csv", "id,x [m],y [m]\na,1,2\nb,3,four\n")
    with pytest.raises(beespace.BeespaceFileError) as caught:
        beespace.read(path)
    error = caught.value
    assert not isinstance(error, OSError)
    assert (error.code, error.file, error.line, error.column, error.record, error.place) == (
        "not_a_number",
        str(path),
        3,
        3,
        1,
        None,
    )
    assert str(error).startswith(f"{path}:3:3: 'four' ") and "skip_bad" in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is type(error) and str(again) == str(error)
    assert again.__dict__ == error.__dict__


@readers
def test_files_that_cannot_be_read_are_errors_of_the_system(tmp_path):
    for ask in (beespace.read, beespace.read_recording):
        with pytest.raises(OSError) as caught:
            ask(tmp_path / "none.csv")
        error = caught.value
        assert isinstance(error, beespace.BeespaceOSError) and isinstance(error, ValueError)
        assert (error.code, error.errno) == ("cannot_open", errno.ENOENT)
        assert error.filename == error.file == str(tmp_path / "none.csv")
        assert str(error).startswith(f"{tmp_path / 'none.csv'}: ")
        again = pickle.loads(pickle.dumps(error))
        assert str(again) == str(error) and again.errno == error.errno
        assert again.filename == error.filename
    with pytest.raises(beespace.BeespaceOSError) as caught:
        beespace.read(tmp_path)
    assert caught.value.errno is None


@readers
def test_bad_records_are_left_out_and_listed(written):
    rows = "".join(f"b{i},{i},{'x' if i % 3 == 0 else i}\n" for i in range(90))
    read = beespace.read(written("swarm.csv", "id,x [m],y [m]\n" + rows), skip_bad=True)
    kept = [i for i in range(90) if i % 3]
    assert read.rows.tolist() == kept
    assert read.ids.tolist() == [f"b{i}" for i in kept]
    assert read.positions.tolist() == [[i, i, 0] for i in kept]
    assert read.skipped_count == 30
    assert [error.record for error in read.skipped] == [3 * i for i in range(20)]
    assert "30 bad records left out" in repr(read)


@readers
def test_it_shows_what_it_is(written):
    read = beespace.read(written("swarm.csv", "id,x,y,z\na,1,2,3\nb,4,5,6\na,7,8,9\n"))
    lines = repr(read).splitlines()
    assert lines[0] == "<FilePoints: 3 points of 'swarm.csv', metres (the header names x, y and z)"
    assert any("has the id of another one before" in line for line in lines[1:])
    assert repr(read).endswith(">")


@readers
def test_arguments_that_make_no_sense_are_refused(written):
    path = written("swarm.csv", "x [m],y [m]\n1,2\n")
    for options, word in [
        ({"frame": "meters"}, "frame is one of"),
        ({"units": "height=cubits"}, "cubits"),
        ({"format": "xlsx"}, "format is one of"),
        ({"heights": "high"}, "heights is one of"),
    ]:
        with pytest.raises(beespace.BeespaceFileError, match=word) as caught:
            beespace.read(path, **options)
        assert (caught.value.code, caught.value.place) == ("invalid_argument", "options")
    with pytest.raises(TypeError):
        beespace.read(path, frame=3)
    with pytest.raises(TypeError):
        beespace.read(7)
    with pytest.raises(ValueError):
        beespace.read("a\0b")
    with pytest.raises(beespace.BeespaceError):
        beespace.read(path, threads=-1)
    with pytest.raises(beespace.BeespaceFileError, match="no path"):
        beespace.read_recording([])


@readers
def test_a_dash_is_no_standard_input(tmp_path):
    program = "import beespace\ntry: beespace.read('-')\nexcept OSError as error: print(error.file)"
    ran = subprocess.run(
        [sys.executable, "-c", program],
        input=b"x [m],y [m]\n1,2\n",
        cwd=tmp_path,
        check=True,
        capture_output=True,
    )
    assert ran.stdout == b"./-\n"


@readers
def test_a_recording_stands_in_columns():
    read = beespace.read_recording(data / "cage.csv")
    with open(data / "cage.csv", newline="") as file:
        rows = list(csv.reader(file))[1:]
    names = list(dict.fromkeys(row[1] for row in rows))
    assert read.ids.tolist() == names
    by_agent = [row for name in names for row in rows if row[1] == name]
    assert len(read) == len(by_agent) == 991
    assert read.times.tolist() == [float(row[0]) for row in by_agent]
    assert read.agents.tolist() == [names.index(row[1]) for row in by_agent]
    # Millimetres: the nearest double to a thousandth of the number that was read.
    metres = [[float(Fraction(float(field)) / 1000) for field in row[2:]] for row in by_agent]
    assert read.positions.tolist() == metres
    counts = np.bincount(read.agents, minlength=len(names))
    assert read.indptr.tolist() == [0, *np.cumsum(counts).tolist()]
    assert (read.frame, read.degrees, read.since_1970, read.missing_count) == (
        "metres",
        None,
        False,
        0,
    )
    assert repr(read).startswith("<FileRecording: 991 fixes of 10 agents of 'cage.csv', metres (")


@readers
def test_a_show_is_a_recording_and_no_snapshot():
    with pytest.raises(beespace.BeespaceFileError, match="read it as a recording") as caught:
        beespace.read(data / "show.skyc")
    assert caught.value.code == "unsupported_format"
    read = beespace.read_recording(data / "show.skyc")
    assert len(read.ids) == len(read.labels) == 12
    times = [read.times[a:b] for a, b in zip(read.indptr[:-1], read.indptr[1:])]
    assert all((np.diff(each) > 0).all() for each in times)
    assert np.isfinite(read.positions).all()


@readers
def test_several_files_are_one_recording(written):
    one = written("one.csv", "time_s,x [m],y [m],z [m]\n0,1,2,3\n1,4,5,6\n")
    two = written("two.csv", "time_s,x [m],y [m],z [m]\n1,7,8,9\n")
    for paths in ([one, two], one.parent):
        read = beespace.read_recording(paths)
        assert read.ids.tolist() == ["one", "two"]
        assert read.positions.tolist() == [[1, 2, 3], [4, 5, 6], [7, 8, 9]]


def test_without_readers_it_says_so(tmp_path):
    program = "import beespace\ntry: beespace.read('a')\nexcept ImportError as error: print(error)"
    ran = subprocess.run(
        [sys.executable, "-c", program],
        env={**os.environ, "BEESPACE_IO_LIBRARY": str(tmp_path / "none.so")},
        check=True,
        capture_output=True,
    )
    assert b"cannot read files" in ran.stdout and b"make install" in ran.stdout


@readers
def test_zones_frames_and_pixels_are_as_they_are_said(written):
    dated = written("dated.csv", "id,time,x_m,y_m\na,1970-01-01 02:00:00,1,2\na,1970-01-01 02:00:01,1,2\n")
    zoned = beespace.read_recording(dated, time_zone="+02:00")
    assert zoned.since_1970 and zoned.times.tolist() == [0, 1]
    bare = beespace.read_recording(dated)
    assert not bare.since_1970 and bare.times.tolist() == [7200, 7201]
    either = written("either.csv", "id,time,x_m,y_m\na,02/01/1970 00:00:00,1,2\n")
    with pytest.raises(beespace.BeespaceFileError, match="dates day-first"):
        beespace.read_recording(either)
    ordered = beespace.read_recording(either, time_zone="UTC", dates="day-first")
    assert ordered.times.tolist() == [86400]
    video = written("video.csv", "frame,id,x,y\n0,a,200,300\n1,a,NA,NA\n2,a,201,302\n")
    filmed = beespace.read_recording(video, fps=4, scale="50cm")
    assert filmed.times.tolist() == [0, 0.5]
    assert filmed.positions.tolist() == [[100, 150, 0], [100.5, 151, 0]]
    assert any("1 record without a place" in note for note in filmed.notes)
    with pytest.raises(beespace.BeespaceFileError, match="fps 25"):
        beespace.read_recording(video)
    with pytest.raises(ValueError, match="frames there are in a second"):
        beespace.read_recording(video, fps=0)
    with pytest.raises(beespace.BeespaceError, match="time_zone"):
        beespace.read_recording(dated, time_zone="Europe/Nowhere")
