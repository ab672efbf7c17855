"""What is said of recordings of files, and of how much of them is known: as the command says it. Where
`beespace replay --fail-on-risk` or `verify` end with 1, nothing here is an all-clear."""

from __future__ import annotations

import itertools
import json
import math
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import beespace

project = Path(__file__).resolve().parents[2]
command = os.environ.get("BEESPACE_COMMAND")

pytestmark = pytest.mark.skipif(
    "BEESPACE_IO_LIBRARY" not in os.environ, reason="this build has no readers"
)
beside_the_command = pytest.mark.skipif(command is None, reason="this build has no command")

HEADER = "id,time_s,x,y,z\n"
DEGREES = "id,time_s,lon,lat,height_m\n"


def rows(*fixes):
    return "".join(",".join(map(str, each)) + "\n" for each in fixes)


def meeting(place):
    """Two that meet at 4 s, of whom one is at a place from 2 to 6 s."""
    text = DEGREES
    for t in range(9):
        text += f"a,{t},8.5,47.0000{t},100\n"
        text += f"b,{t}," + (f"8.5,47.0000{8 - t},100" if t < 2 or t > 6 else place) + "\n"
    return text


def flight(id, y, lasts):
    """Up to 10 m, 1 m/s along x, and down again."""
    return rows(*(
        (id, t, min(max(0, t - 5), lasts - 10), y, 100 + min(10, 2 * t, 2 * (lasts - t)))
        for t in range(lasts + 1)
    ))


def bulge(speed):
    """Two abreast, 10 m apart, of whom one has a velocity that leads it to the other."""
    return "id,time_s,x,y,z,vx,vy,vz\n" + rows(
        ("a", 0, 0, 0, 10, 1, speed, 0), ("a", 10, 10, 0, 10, 1, -speed, 0),
        ("b", 0, 0, 10, 10, 1, 0, 0), ("b", 10, 10, 10, 10, 1, 0, 0),
    )


def shared():
    """An id of two, at two places in turn."""
    text = HEADER
    for t in range(20):
        text += f"a,{t},{t},0,5\na,{t + 0.5},{t},900,5\nb,{t},{t},30,5\n"
    return text


AWAY = rows(*(("b", t, 0, 90, 0) for t in range(5)), ("b", 40, 0, 90, 0))
FILES = {
    "fine": {"f.csv": HEADER + flight("a", 0, 30) + flight("b", 20, 30)},
    "lands_early": {"f.csv": HEADER + flight("a", 0, 30) + flight("b", 20, 20)},
    "conflict": {"f.csv": HEADER + rows(("a", 0, 0, 0, 0), ("a", 9, 90, 0, 0), ("b", 0, 90, 1, 0), ("b", 9, 0, 1, 0))},
    "gap": {"f.csv": HEADER + rows(*(("a", t, t, 0, 0) for t in range(5)), ("a", 40, 9, 0, 0)) + AWAY},
    "cut_off": {"f.csv": HEADER + flight("a", 0, 30) + "".join(flight("b", 20, 30).splitlines(True)[:16])},
    "cut_off_in_degrees": {"f.csv": DEGREES + rows(
        *(("a", t, 8, 47, 500 + min(20, t, 60 - t)) for t in range(61)),
        *(("b", t, 8, 47.001, 500 + min(20, t)) for t in range(35)),
    )},
    "comes_and_goes": {"f.csv": "id,time_s,x,y\n" + rows(
        *(("a", t, t, 0) for t in range(20)), *(("b", t, t, 9) for t in range(5, 9))
    )},
    "never_together": {"f.csv": HEADER + rows(("a", 0, 0, 0, 0), ("a", 1, 0, 0, 0), ("b", 2, 9, 0, 0), ("b", 3, 9, 0, 0))},
    "zeros": {"f.csv": meeting("0,0,0")},
    "jumps": {"f.csv": meeting("9.5,47,100")},
    "shared_id": {"f.csv": shared()},
    "bulge": {"f.csv": bulge(3.8)},
    "bulge_is_far": {"f.csv": bulge(3.0)},
    "velocities_lead_away": {"f.csv": bulge(40_000)},
    "left_out_file": {
        "1.csv": "time_s,x,y,z\n1,0,0,0\n2,1,0,0\n3,2,0,0\n",
        "2.csv": "time_s,x,y,z\n1,0,50,0\n2,1,50,0\n3,2,50,0\n",
        "3.dat": "no table",
    },
    "swapped": {
        "a.csv": "id,time_s,lon,lat\na,1,9,47\na,2,9.00001,47\na,3,9.00002,47\n",
        "b.csv": "id,time_s,lat,lon\nb,1,9.0001,47\nb,2,9.0001,47\nb,3,9.0001,47\n",
    },
    "poses": {"f.csv": "scorer,n,n,n,n,n,n\nindividuals,m,m,m,w,w,w\nbodyparts,nose,nose,nose,nose,nose,nose\n"
        "coords,x,y,likelihood,x,y,likelihood\n" + rows(*(
            (t, t, 2, 0.9 if t % 3 else 0.5, t, 40, 0.97) for t in range(12)
        ))},
}
OF_THE_PROJECT = [
    ("examples/data/show.skyc", {}),
    ("examples/data/cage.csv", {}),
    ("examples/data/swarm.csv", {}),
    ("examples/data/traffic.csv", {"units": "height=ft,speed=kt,climb=ft/min"}),
    ("tests/cli/shows/ring.skyc", {}),
    ("tests/cli/shows/ring.json", {}),
    ("tests/cli/shows/ring-csv", {"time_unit": "ms"}),
    ("tests/cli/aircraft/traffic.csv", {"heights": "geometric"}),  # of a limit in feet the command takes others
    ("tests/cli/aircraft/opensky.json", {"heights": "geometric"}),
    ("tests/cli/robotics/both.tlog", {}),
    ("tests/cli/robotics/others.tlog", {}),
    ("tests/cli/robotics/poses.csv", {}),
    ("tests/cli/animals/movebank.csv", {}),
    ("tests/cli/animals/pixels.csv", {"fps": 25.0, "scale": "0.1mm"}),
    ("tests/cli/animals/trackdf.csv", {}),
]
OPTIONS = {"poses": {"fps": 1.0, "scale": "1m"}}


@pytest.fixture
def laid_out(tmp_path):
    def lay_out(name):
        """The folder, or the file."""
        for each, text in FILES[name].items():
            (tmp_path / each).write_text(text)
        return tmp_path if len(FILES[name]) > 1 else tmp_path / "f.csv"

    return lay_out


def asked(name, path, options, *more):
    """What the command says, and how it ends; None where it does not read that."""
    words = {"frame": "crs"}
    arguments = [
        f"--{words.get(each, each).replace('_', '-')}={value}" for each, value in options.items()
    ]
    printed = subprocess.run(
        [command, name, path, "--json", "--quiet", *arguments, *more],
        capture_output=True, check=False,
    )
    if printed.returncode not in (0, 1):
        return None, printed.stderr.decode()
    return json.loads(printed.stdout), printed.returncode


def check_coverage(coverage, known):
    names = {
        "complete": "complete", "gap_count": "gap_count", "bees_with_gaps": "agents_with_gaps",
        "in_gaps_s": "in_gaps", "bees_partly_known": "agents_partly_known",
        "bees_cut_off_in_the_air": "agents_cut_off", "before_first_and_after_last_s": "outside",
        "left_out_records": "missing_count", "left_out_without_id": "missing_without_id",
        "left_out_bees": "missing_agents", "bees_known_nowhere": "nowhere_count",
        "shared_id_count": "shared_id_count", "left_out_files": "file_count",
        "jumping_count": "jumping_count", "swapped_degrees": "swapped_count",
        "rough_places": "rough_count",
        "typical_interval_s": "typical_interval",
    }
    assert {name: getattr(coverage, ours) for name, ours in names.items()} == {
        name: known[name] for name in names
    }
    assert coverage.max_gap == (math.inf if known["max_gap_s"] is None else known["max_gap_s"])
    assert bool(coverage.unknown) is not coverage.complete


def check(path, options, threshold, **arguments):
    more = [f"--threshold={threshold}m"]
    more += [
        f"--{name.replace('_', '-')}" if value is True else f"--{name.replace('_', '-')}={value}"
        for name, value in arguments.items()
    ]
    said, code = asked("replay", path, options, "--fail-on-risk", *more)
    assert said is not None, code
    read = beespace.read_recording(path, **options)
    given = {name: math.inf if value == "never" else value for name, value in arguments.items()}
    found = read.conflicts(threshold, **given)
    assert found.risky == (code == 1)
    assert len(found) == said["conflict_count"] and found.threshold == said["threshold_m"]
    told = [
        (row["first"], row["second"], row["begins_s"], row["ends_s"], row["closest_s"], row["closest_m"],
         row.get("certain", True))
        for row in said["conflicts"]
    ]
    assert [each[:7] for each in zip(*found.columns().values())] == told
    closest = said["closest"]
    if closest is None:
        assert found.closest.i is None
    else:
        assert found.closest[:4] == (
            closest["first"], closest["second"], closest["time_s"], closest["distance_m"]
        )
    check_coverage(found.coverage, said["known"])
    max_gap = given.get("max_gap")
    check_coverage(read.coverage(max_gap=max_gap), said["known"])
    assert len(found.gaps) == said["gap_count"]
    # The notes of the command are those of Python, but for the names of options.
    plain = {note.replace("_", "-") for note in read.notes}
    for note in said["input"]["notes"]:
        assert note.replace("--", "").replace("_", "-").replace("crs", "frame") in plain or "'beespace" in note
    assert read.missing_count == said["known"]["left_out_records"]
    assert read.skipped_count == said["input"]["skipped"]
    if "vertical" not in arguments:
        check_straight(read, threshold, max_gap, code)
    return found, code


def check_straight(read, threshold, max_gap, code):
    """What Recording.from_file says is no all-clear where the command says none."""
    made = beespace.Recording.from_file(read)
    found = made.conflicts(threshold, max_gap=max_gap)
    assert code == 0 or len(found) or len(found.gaps) or found.gaps.unknown
    if not len(found.gaps) and found.gaps.unknown:
        assert found.gaps.unknown in repr(found) and found.gaps.unknown in repr(made.closest(max_gap=max_gap))


def check_verdict(path, options, threshold):
    said, code = asked("verify", path, options, f"--threshold={threshold}")
    if said is None:
        return
    read = beespace.read_recording(path, **options)
    try:
        verdict = read.verify(threshold)
    except beespace.BeespaceFileError as error:
        assert error.code in ("unknown_frame", "unsupported_format")
    else:
        assert verdict.holds == said["holds"] == (code == 0)
        check_coverage(verdict.coverage, said["known"])
        assert verdict.gap_count == said["known"]["gap_count"]
        assert repr(verdict).rstrip(">;, ") and "whole: ;" not in repr(verdict)
    try:
        straight = beespace.Recording.from_file(read).verify(threshold)
    except beespace.BeespaceError:
        return
    assert read.velocities is not None or straight.holds <= (code == 0)


@beside_the_command
@pytest.mark.parametrize("name", FILES)
def test_what_is_not_known_is_said_as_the_command_says_it(name, laid_out):
    path = laid_out(name)
    options = OPTIONS.get(name, {})
    for threshold, more in itertools.product((0.5, 2.0), ({}, {"max_gap": 3.0}, {"max_gap": "never"})):
        check(path, options, threshold, **more)
    check(path, options, 2.0, vertical=1.5)
    check(path, options, 2.0, straight=True)
    check(path, options, 10.0, inclusive=True)
    check_verdict(path, options, 0.4)


@beside_the_command
@pytest.mark.parametrize(("name", "options"), OF_THE_PROJECT)
def test_files_of_the_project_are_said_to_be_what_the_command_says(name, options):
    path = project / name
    for threshold in (1.0, 30.0, 5_000.0):
        check(path, options, threshold)
    check(path, options, 3_000.0, vertical="1000ft")
    check_verdict(path, options, 1.0)


@beside_the_command
@pytest.mark.parametrize("least", [0.0, 0.5, 0.6, 0.95])
def test_places_of_poses_are_as_likely_as_is_asked(least, laid_out):
    options = {**OPTIONS["poses"], "least_likelihood": least}
    path = laid_out("poses")
    check(path, options, 2.0)
    assert len(beespace.read_recording(path, **options)) == {0.0: 24, 0.5: 24, 0.6: 20, 0.95: 12}[least]


@beside_the_command
@pytest.mark.parametrize("tolerance", [0.5, 0.001])
def test_curves_are_followed_as_closely_as_is_asked(tolerance):
    fixes = len(beespace.read_recording(project / "examples/data/show.skyc", tolerance=tolerance))
    assert (fixes < 1_000) == (tolerance == 0.5)
    check(project / "examples/data/show.skyc", {"tolerance": tolerance}, 6.0)


# The same without the command: what each of them must say.
@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("fine", ""),
        ("gap", "2 bees unknown for"),
        ("cut_off", "1 of which begins or ends in the air"),
        ("zeros", "5 records were left out"),
        ("jumps", "1 bee jumps"),
        ("shared_id", "1 id seems to be of two bees"),
        ("left_out_file", "1 file or folder was left out"),
        ("swapped", "longitude and latitude of 1 bee seem to be the other way round"),
    ],
)
def test_what_is_unknown_is_in_words(name, words, laid_out):
    read = beespace.read_recording(laid_out(name))
    found = read.conflicts(0.1)
    assert words in found.coverage.unknown and words in repr(found)
    assert found.risky == bool(words) == found.coverage.may_hide_conflicts
    assert ("all-clear" in repr(found)) == (not words)
    assert repr(read.coverage()) == f"<Coverage: {words and found.coverage.unknown or 'complete'}>"
    if words and name != "gap":
        straight = beespace.Recording.from_file(read).conflicts(0.1)
        assert words in straight.gaps.unknown and words in repr(straight)


def test_what_from_file_does_not_look_at_is_said(laid_out):
    read = beespace.read_recording(laid_out("bulge"))
    assert read.conflicts(2).certain.tolist() == [False] and not read.conflicts(2, straight=True).risky
    assert "velocities are not looked at" in repr(beespace.Recording.from_file(read).conflicts(2))
    show = beespace.read_recording(project / "tests/cli/shows/ring.skyc")
    assert "curves of the show" in repr(beespace.Recording.from_file(show).conflicts(1))


def test_nothing_compared_is_no_all_clear(laid_out):
    read = beespace.read_recording(laid_out("never_together"))
    words = "no two agents are there at the same time"
    assert read.conflicts(2).risky and words in repr(read.conflicts(2))
    assert words in beespace.Recording.from_file(read).conflicts(2).gaps.unknown
    verdict = read.verify(2)
    assert not verdict and words in repr(verdict)


def test_the_gap_of_a_file_is_that_of_the_command(laid_out):
    made = beespace.Recording.from_file(beespace.read_recording(laid_out("gap")))
    assert len(made.conflicts(0.1).gaps) == len(made.closest().gaps) == 2
    assert not len(made.conflicts(0.1, max_gap=math.inf).gaps)
    assert not made.verify(0.1) and made.verify(0.1, max_gap=math.inf).unseen == 0


def test_a_verdict_that_is_not_known_as_a_whole_says_why(tmp_path):
    path = tmp_path / "f.csv"
    # Away for good: a single place is left out, and then the times of the two differ.
    path.write_text("id,time_s,x,y,z\n" + "".join(
        f"a,{t},{t},47,100\nb,{t},{95_000_000 if t > 4 else t + 0.00006},47,100\n" for t in range(9)
    ))
    read = beespace.read_recording(path)
    verdict = read.verify(0.000001)
    assert not verdict.holds and "not seen as a whole: 1 bee jumps" in repr(verdict)
    straight = beespace.Recording.from_file(read).verify(0.000001)
    assert not straight and "not seen as a whole: 1 bee jumps" in repr(straight)


def test_arguments_that_make_no_sense_are_named(laid_out):
    read = beespace.read_recording(laid_out("fine"))

    def error_of(call):
        with pytest.raises(beespace.BeespaceError) as raised:
            call()
        return raised.value.code, raised.value.place

    assert error_of(lambda: read.conflicts()) == ("invalid_threshold", "threshold")
    assert error_of(lambda: read.conflicts(0)) == ("invalid_threshold", "threshold")
    assert error_of(lambda: read.conflicts(5, vertical="high")) == ("invalid_argument", "vertical")
    assert error_of(lambda: read.conflicts(5, max_gap=0)) == ("invalid_argument", "max_gap")
    assert error_of(lambda: read.coverage(max_gap=-1)) == ("invalid_argument", "max_gap")
    assert error_of(lambda: read.conflicts(50, max_results=0))[0] == "too_many_results"
    for name in ("least_likelihood", "tolerance"):
        for value in (-1, math.nan):
            assert error_of(lambda n=name, v=value: beespace.read_recording("none", **{n: v}))[1] == name
    assert error_of(lambda: beespace.read_recording("none", least_likelihood=1.5))[1] == "least_likelihood"
    assert error_of(lambda: beespace.report([[0, 0]], 5, least_likelihood=0.0))[1] == "least_likelihood"


def test_answers_are_those_of_any_number_of_threads(laid_out):
    show = beespace.read_recording(project / "examples/data/show.skyc")
    one, all_of = show.conflicts(6), show.conflicts(6, threads=0)
    for name, column in one.columns().items():
        np.testing.assert_array_equal(column, all_of.columns()[name])
