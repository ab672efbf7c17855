"""Shows that are verified along their curves: what is found is what arithmetic says of the drones of
tests/cli/shows/make-shows, and what the command says."""

from __future__ import annotations

import json
import math
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import beespace

project = Path(__file__).resolve().parents[2]
shows = project / "tests" / "cli" / "shows"
command = os.environ.get("BEESPACE_COMMAND")

pytestmark = pytest.mark.skipif(
    "BEESPACE_IO_LIBRARY" not in os.environ, reason="this build has no readers"
)


@pytest.fixture(params=["ring.skyc", "ring.json"])
def ring(request):
    return beespace.read_recording(shows / request.param)


# Half way along the sides of a square of 5 m two drones are 2.5 times the square root of 2 apart; the
# show promises 4 m, and 2.4 m/s downwards, of which one drone has 2.5.
def test_a_show_is_held_against_what_it_declares(ring):
    verdict = beespace.verify(ring)
    assert not verdict and verdict.motion == "show" and verdict.threshold == 4
    assert verdict.closest == ("Drone 1", "Drone 2")
    assert math.isclose(verdict.closest_distance, 2.5 * math.sqrt(2), rel_tol=1e-6)
    assert math.isclose(verdict.closest_at, 15, rel_tol=1e-6)
    assert verdict.limits == {"horizontal": 8, "climb": 3, "descent": 2.4, "height": 120}
    assert verdict.declared == ("horizontal", "climb", "descent", "height")
    losses = verdict.losses
    assert len(losses) == 4 and np.allclose(losses.distance, 2.5 * math.sqrt(2), rtol=1e-6)
    assert np.allclose(losses.at, 15)
    assert list(zip(losses.i, losses.j))[0] == ("Drone 1", "Drone 2")
    (row,) = zip(*verdict.breaches.columns().values())
    assert row[:4] == ("Drone 1", "descent", 20, 26)
    assert math.isclose(row[4], 2.5, rel_tol=1e-8) and row[5] == 2.4
    assert math.isclose(row[6], 23, rel_tol=1e-6)
    climb = verdict.greatest["climb"]
    assert climb.id == "Drone 1" and math.isclose(climb.value, 2.5, rel_tol=1e-8)
    assert "4 losses of separation, 1 breach of limits" in repr(verdict)


def test_what_is_asked_for_counts_before_what_is_declared(ring):
    asked = beespace.verify(ring, threshold=3.5, max_descent=2.5, max_acceleration=1.667)
    assert asked and asked.declared == ("horizontal", "climb", "height")
    assert not len(asked.losses) and not len(asked.breaches) and repr(asked).startswith(
        "<FlightVerdict: holds; threshold 3.5 m"
    )
    assert not ring.verify(3.5, max_descent=2.5, max_acceleration=1.66)
    assert beespace.verify(ring, threshold=3.5, max_descent=math.inf)


# 0.5 m beside the first side.
def test_drones_keep_clear_of_obstacles_along_their_curves(ring):
    pillar = beespace.Obstacles([beespace.Cylinder(0, -3.5, 0.5, high=20)])
    near = ring.verify(3, max_descent=3, obstacles=pillar, clearance=0.6)
    (row,) = zip(*near.clearance_losses.columns().values())
    assert row[:4] == ("Drone 1", 0, 12, 18) and math.isclose(row[4], 0.5, rel_tol=1e-6)
    assert ring.verify(3, max_descent=3, obstacles=pillar, clearance=0.49)


@pytest.mark.skipif(command is None, reason="this build has no command")
@pytest.mark.parametrize("name", ["tests/cli/shows/ring.skyc", "examples/data/show.skyc"])
@pytest.mark.parametrize("threshold", [None, 4.7, 6.0])
def test_it_is_what_the_command_says(name, threshold):
    options = [] if threshold is None else ["--threshold", str(threshold)]
    printed = subprocess.run(
        [command, "verify", project / name, "--json", "--quiet", "--max-speed", "2", *options],
        capture_output=True,
        check=False,
    )
    said = json.loads(printed.stdout)
    verdict = beespace.verify(
        beespace.read_recording(project / name), threshold=threshold, max_speed=2
    )
    assert verdict.holds == said["holds"] and verdict.threshold == said["threshold_m"]
    assert len(verdict.losses) == said["loss_count"]
    assert len(verdict.breaches) == said["breach_count"]
    told = {name: (peak.value, peak.id, peak.at) for name, peak in verdict.greatest.items()}
    assert told == {
        name: (peak["value"], peak["id"], peak["at_s"]) for name, peak in said["greatest"].items()
    }
    assert verdict.closest_distance == said["closest"]["distance_m"]
    rows = [row for row in said["findings"] if row["finding"] == "loss"]
    assert verdict.losses.distance.tolist() == [row["value"] for row in rows]
    assert verdict.losses.begin.tolist() == [row["begins_s"] for row in rows]


def written(tmp_path, text):
    path = tmp_path / "flight.csv"
    path.write_text(text)
    return beespace.read_recording(path)


def test_a_gap_does_not_hold(tmp_path):
    flown = written(tmp_path, "id,t_s,x,y,z\na,0,0,0,0\na,10,100,0,0\nb,1,0,3,0\nb,9,0,3,0\n")
    assert beespace.verify(flown, threshold=1, max_gap=math.inf)
    verdict = beespace.verify(flown, threshold=1, max_gap=8)
    assert not verdict and verdict.gap_count == 1
    assert repr(verdict).startswith("<FlightVerdict: not seen as a whole: 1 bee unknown for 10 s in all; ")


def test_what_cannot_be_is_named(ring, tmp_path):
    def error_of(call):
        with pytest.raises(beespace.BeespaceError) as raised:
            call()
        return raised.value.code, raised.value.place

    assert error_of(lambda: beespace.verify(ring, [0])) == ("invalid_argument", "times")
    assert error_of(lambda: ring.verify(0)) == ("invalid_threshold", "threshold")
    assert error_of(lambda: ring.verify(max_climb=-1)) == ("invalid_argument", "max_climb")
    assert error_of(lambda: ring.verify(clearance=1)) == ("invalid_argument", "clearance")
    assert error_of(lambda: ring.verify(straight=True))[0] == "invalid_argument"
    flown = written(tmp_path, "id,t_s,x,y,z\na,0,0,0,0\na,10,100,0,0\n")
    assert error_of(lambda: beespace.verify(flown)) == ("invalid_threshold", "threshold")
    limited = error_of(lambda: beespace.verify(flown, threshold=1, max_acceleration=1))
    assert limited[0] == "missing_column"
    degrees = written(tmp_path, "id,t_s,lon,lat,height_m\na,0,19,47,0\na,9,19,47,9\n")
    beside = beespace.Obstacles([beespace.Box([0, 0, 0], [1, 1, 1])])
    assert error_of(lambda: beespace.verify(degrees, threshold=1, obstacles=beside, clearance=1))[
        0
    ] == "unknown_frame"
    assert error_of(lambda: ring.verify(ignore_below=0)) == ("invalid_argument", "ignore_below")
    columns = ["a", "a"], [0, 1], [[0, 0], [1, 0]], 5
    assert error_of(lambda: beespace.verify(*columns, max_height=1)) == (
        "invalid_argument",
        "max_height",
    )
    with pytest.raises(TypeError, match="threshold"):
        beespace.verify(*columns[:3])


# As the command does, also of those that take off beside each other.
def test_flights_in_degrees_and_low_conflicts(tmp_path):
    degrees = written(
        tmp_path,
        "id,t_s,lon,lat,height_m\na,0,8,47,100\na,10,8.001,47,100\n"
        "b,0.5,8.0005,47.0005,100\nb,10.5,8.0005,46.9995,100\n",
    )
    assert beespace.verify(degrees, threshold=1).motion == "straight"
    assert len(beespace.verify(degrees, threshold=10).losses) == 1
    show = written(
        tmp_path,
        "id,time_s,x [m],y [m],z [m],red,green,blue\na,0,0,0,0,1,1,1\na,4,0,0,2,1,1,1\n"
        "a,8,-20,0,2,1,1,1\nb,0,1,0,0,1,1,1\nb,4,1,0,0,1,1,1\nb,8,1,0,9,1,1,1\n",
    )
    assert show.conflicts(2).risky
    found = show.conflicts(2, ignore_below=3)
    assert not found.risky and found.ignored_count == 1 and found.takeoff_unknown_count == 0
    assert "1 left out" in repr(found)
    verdict = beespace.verify(show, threshold=2, ignore_below=3)
    assert verdict.ignored_count == 1 and not len(verdict.losses)


# What is not looked at may be left out by name, and nothing else.
def test_limits_that_are_not_looked_at_may_be_skipped(tmp_path):
    text = (shows / "ring.json").read_text().replace(
        '"maxAltitude": 120', '"maxAltitude": 120, "minNavAltitude": 12'
    )
    (tmp_path / "ring.json").write_text(text)
    show = beespace.read_recording(tmp_path / "ring.json")
    asked = {"threshold": 3.5, "max_descent": 2.5}
    verdict = beespace.verify(show, **asked)
    assert not verdict and verdict.not_looked_at == verdict.undecided == ("minNavAltitude",)
    assert "skip_limits=['minNavAltitude']" in repr(verdict)
    skipping = beespace.verify(show, skip_limits=["minNavAltitude"], **asked)
    assert skipping and skipping.not_looked_at == ("minNavAltitude",) and not skipping.undecided
    assert show.verify(skip_limits="minNavAltitude", **asked)
    for mistyped in (["minAltitude"], ["minNavAltitude,x"], [3]):
        with pytest.raises(beespace.BeespaceError, match=r"limit"):
            show.verify(skip_limits=mistyped, **asked)
    with pytest.raises(beespace.BeespaceError, match="read_recording"):
        beespace.verify([1], [0.0], [[0.0, 0.0]], 1, skip_limits=["minNavAltitude"])
