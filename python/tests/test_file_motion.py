"""Velocities of files: what `read_recording` gives `predict`, `verify` and `Swarm`, against the command."""

from __future__ import annotations

import json
import math
import os
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest

import beespace

project = Path(__file__).resolve().parents[2]
data = project / "examples" / "data"
command = os.environ.get("BEESPACE_COMMAND")

pytestmark = pytest.mark.skipif(
    "BEESPACE_IO_LIBRARY" not in os.environ, reason="this build has no readers"
)
beside_the_command = pytest.mark.skipif(command is None, reason="this build has no command")


def said_by(name: str, path: Path, *options: str) -> dict:
    printed = subprocess.run(
        [command, name, path, "--json", "--quiet", *options], capture_output=True, check=False
    )
    assert printed.returncode in (0, 1), printed.stderr.decode()
    return json.loads(printed.stdout)


# ---- Files ---------------------------------------------------------------------------------------


def checksum(frame: bytes, extra: int) -> bytes:
    """X.25, bit after bit, as the protocol of MAVLink says."""
    crc = 0xFFFF
    for byte in (*frame, extra):
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ 0x8408 if crc & 1 else crc >> 1
    return struct.pack("<H", crc)


def logged(time_s: float, system: int, message: int, payload: bytes) -> bytes:
    """A frame of MAVLink 1 behind the time at which it came."""
    frame = bytes([len(payload), 5, system, 1, message]) + payload
    crc = checksum(frame, {32: 185, 33: 104}[message])
    return struct.pack(">Q", round(time_s * 1e6)) + b"\xfe" + frame + crc


def metres(random: np.random.Generator) -> str:
    """A table with old and new fixes, and some without a velocity."""
    rows = []
    for bee in range(60):
        place, speed = random.uniform(0, 300, 3).round(2), random.normal(0, 8, 3).round(2)
        time = float(random.choice([0, 3.5, 7]))
        before = (place - speed * 2).round(2)
        written = ["", "", ""] if bee % 5 == 0 else speed.tolist()
        rows.append([f"b{bee}", time - 2, *before.tolist(), *speed.tolist()])
        rows.append([f"b{bee}", time, *place.tolist(), *written])
    return "id,time_s,x,y,z,vx,vy,vz\n" + "".join(",".join(map(str, row)) + "\n" for row in rows)


def degrees(random: np.random.Generator) -> str:
    rows = "".join(
        f"{bee:06x},{float(random.choice([0, 4]))},{8 + random.uniform(0, 0.4):.5f},"
        f"{47 + random.uniform(0, 0.3):.5f},{random.uniform(20000, 30000):.0f},"
        f"{random.uniform(300, 480):.0f},{random.uniform(0, 360):.1f},{random.integers(-30, 30) * 64}\n"
        for bee in range(50)
    )
    return "icao24,time_s,lon,lat,alt_ft,groundspeed_kt,track,vertical_rate_ft_min\n" + rows


def aircraft(random: np.random.Generator) -> str:
    seen = [
        {
            "hex": f"{bee:06x}",
            "lat": 47 + round(random.uniform(0, 0.3), 5),
            "lon": 8 + round(random.uniform(0, 0.4), 5),
            "alt_geom": int(random.uniform(20000, 30000)),
            "gs": round(random.uniform(300, 480), 1),
            "track": round(random.uniform(0, 360), 2),
            "geom_rate": int(random.integers(-30, 30)) * 64,
            "seen_pos": round(random.uniform(0, 10), 1),
        }
        for bee in range(50)
    ]
    return json.dumps({"now": 1000000.5, "messages": 7, "aircraft": seen})


def telemetry(random: np.random.Generator, message: int) -> bytes:
    log = b""
    for system in range(1, 31):
        if message == 33:
            place = [int(470000000 + random.uniform(0, 3000)), int(80000000 + random.uniform(0, 4000))]
            speed = [int(each) for each in random.normal(0, 500, 3)]
            payload = struct.pack(
                "<IiiiihhhH", 7, *place, int(random.uniform(400e3, 440e3)), 0, *speed, 0
            )
        else:
            payload = struct.pack("<I6f", 7, *random.uniform(-40, 40, 3), *random.normal(0, 5, 3))
        log += logged(1.7e9 + system / 100, system, message, payload)
    return log


FILES = {
    "metres.csv": (metres, 12),
    "degrees.csv": (degrees, 2000),
    "aircraft.json": (aircraft, 2000),
    "global.tlog": (lambda random: telemetry(random, 33), 8),
    "local.tlog": (lambda random: telemetry(random, 32), 12),
}


@pytest.fixture
def file_of(tmp_path):
    def write(name: str, content: str | bytes) -> Path:
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return write


# ---- Predictions ---------------------------------------------------------------------------------


@beside_the_command
@pytest.mark.parametrize("name", FILES)
def test_predictions_are_those_of_the_command(file_of, name):
    make, threshold = FILES[name]
    path = file_of(name, make(np.random.default_rng(17)))
    # Local positions of several drones are asked about.
    frame = "metres" if name == "local.tlog" else None
    asked = [] if frame is None else [f"--crs={frame}"]
    said = said_by("predict", path, f"--threshold={threshold}", "--horizon=60", *asked)
    recording = beespace.read_recording(path, frame=frame)
    now = recording.movers()
    found = beespace.predict(now, now.velocities, threshold, within=60)
    assert said["known"]["complete"] and now.known.all() and len(now) == said["movers"]
    assert now.time == said["now_s"] and now.frame == said["input"]["frame"]
    assert len(found) > 0
    expected = {
        (each["first"], each["second"]): [
            each["begins_s"], each["closest_s"], each["ends_s"], each["closest_m"],
        ]
        for each in said["conflicts"]
    }
    columns = (found.begin + now.time, found.closest_time + now.time, found.end + now.time)
    assert expected == {
        (now.ids[i], now.ids[j]): list(each)
        for i, j, *each in zip(found.i, found.j, *columns, found.closest_distance)
    }


@pytest.mark.parametrize("heights, height", [(None, 500), ("geometric", 548)])
def test_logs_of_px4_are_one_recording(heights, height):
    """Written by pyulog: two drones, each with a clock of its own, meet 20 s after 14:00."""
    folder = project / "tests" / "cli" / "robotics"
    logs = [folder / "north.ulg", folder / "south.ulg"]
    read = beespace.read_recording(logs, heights=heights)
    assert read.ids[:1].tolist() == ["north"] and len(read) == 162
    first = beespace.to_ecef(8.5, 47.25 - 80 / 111_194.926_644_558_7, float(height))
    assert np.allclose(read.positions[0], first, rtol=0, atol=1e-6)
    assert np.allclose(np.linalg.norm(read.velocities, axis=1), 4)
    found = beespace.Recording.from_file(read).conflicts(5, max_gap=1)
    assert len(found) == 1 and found.closest_time[0] == pytest.approx(1772373620, abs=1e-5)
    assert found.closest_distance[0] == pytest.approx(3, abs=1e-3)
    with pytest.raises(beespace.BeespaceFileError, match="none by pressure"):
        beespace.read_recording(logs, heights="pressure")


def test_a_file_without_times_is_the_present(file_of):
    path = file_of("st.csv", "id,x,y,z,vx,vy,vz\na,0,0,0,1,0,0\nb,50,0,0,-1,0,0\n")
    now = beespace.read_recording(path).movers()
    found = beespace.predict(now, now.velocities, 5, within=60)
    assert (found.closest_time.tolist(), found.closest_distance.tolist()) == ([25], [0])
    assert np.array_equal(np.asarray(now), now.positions)
    assert "columns 5 'vx', 6 'vy', 7 'vz', are left out" in repr(beespace.read(path))


@beside_the_command
def test_whom_nothing_is_known_of_is_refused_and_named(file_of):
    path = file_of(
        "mixed.csv",
        "id,time_s,x,y,z,vx,vy,vz\na,100,0,0,0,1,0,0\nb,100,50,0,0,-1,0,0\n"
        "old,60,20,0,0,0,0,0\nonce,99,30,0,0,,,\nlast,97,0,9,0,,,\nlast,99,2,9,0,,,\n",
    )
    said = said_by("predict", path, "--threshold=5")
    now = beespace.read_recording(path).movers()
    assert now.ids.tolist() == ["a", "b", "old", "once", "last"]
    assert now.known.tolist() == [True, True, False, False, True]
    assert now.stale.tolist() == [False, False, True, False, False]
    assert now.estimated.tolist() == [False, False, False, False, True]
    assert (said["stale"], said["without_velocity"], said["movers"]) == (1, 1, 3)
    assert now.positions.tolist() == [[0, 0, 0], [50, 0, 0], [20, 0, 0], [30, 0, 0], [3, 9, 0]]
    assert np.isnan(now.velocities[2:4]).all() and np.isfinite(now.velocities[now.known]).all()
    with pytest.raises(beespace.BeespaceError, match="finite") as caught:
        beespace.predict(now, now.velocities, 5, within=60)
    assert (caught.value.place, caught.value.record) == ("velocities", 2)
    found = beespace.predict(now.positions[now.known], now.velocities[now.known], 5, within=60)
    ids = now.ids[now.known]
    expected = [(each["first"], each["second"]) for each in said["conflicts"]]
    assert [(ids[i], ids[j]) for i, j in zip(found.i, found.j)] == expected == [("a", "b")]
    assert repr(now) == (
        "<FileMovers: 5 agents at 100 s, metres; the velocity of 1 is that of the last fixes; "
        "1 stale; of 1 no velocity is known>"
    )
    old = beespace.read_recording(path).movers(max_age=math.inf)
    assert old.known.tolist() == [True, True, True, False, True] and not old.stale.any()


def test_without_any_velocity_it_is_said_what_is_missing(file_of):
    path = file_of("still.csv", "id,time_s,x,y,z\na,0,0,0,0\nb,0,1,0,0\n")
    recording = beespace.read_recording(path)
    assert recording.velocities is None
    with pytest.raises(beespace.BeespaceFileError, match="no velocity") as caught:
        recording.movers()
    assert caught.value.code == "missing_column"
    for bad in (-1, math.nan, "long"):
        with pytest.raises((beespace.BeespaceError, TypeError)):
            recording.movers(max_age=bad)


def test_shows_fly_along_curves():
    show = beespace.read_recording(data / "show.skyc")
    assert show.velocities is None
    with pytest.raises(beespace.BeespaceFileError, match="curve of a show") as caught:
        show.movers()
    assert caught.value.code == "unsupported_format"


# ---- Velocities of fixes -------------------------------------------------------------------------


def test_velocities_stand_beside_the_fixes(file_of):
    random = np.random.default_rng(3)
    speeds = random.normal(0, 9, (40, 3)).round(3)
    rows = [(f"b{i % 4}", i // 4, i, 0, 7, *speeds[i].tolist()) for i in range(40)]
    random.shuffle(rows)
    table = "id,time_s,x,y,z,vx,vy,vz\n" + "".join(",".join(map(str, row)) + "\n" for row in rows)
    recording = beespace.read_recording(file_of("flight.csv", table))
    assert recording.velocities.shape == recording.positions.shape
    assert recording.velocities.tolist() == speeds[recording.positions[:, 0].astype(int)].tolist()
    velocities = recording.velocities
    assert not velocities.flags.writeable
    del recording
    assert np.isfinite(velocities).all()


def test_unknown_velocities_are_no_numbers_and_are_told(file_of):
    table = "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,1,2,3\na,1,0,0,0,,2,3\n"
    recording = beespace.read_recording(file_of("flight.csv", table))
    assert recording.velocities[0].tolist() == [1, 2, 3]
    assert np.isnan(recording.velocities[1]).all()
    assert recording.notes[-1] == "no velocity is known of 1 of 2 fixes: theirs are no numbers"


@beside_the_command
def test_verification_is_that_of_the_command(file_of):
    random = np.random.default_rng(11)
    rows = []
    for bee in range(12):
        place, speed = random.uniform(0, 15, 3), random.normal(0, 3, 3)
        for time in range(0, 10, 2):
            pull = random.normal(0, 1, 3)
            rows.append((f"b{bee:02}", time, *place, *speed))
            place, speed = place + 2 * speed + 2 * pull, speed + 2 * pull
    table = "id,time_s,x,y,z,vx,vy,vz\n" + "".join(",".join(map(str, row)) + "\n" for row in rows)
    path = file_of("flight.csv", table)
    said = said_by("verify", path, "--threshold=4", "--max-speed=7", "--max-acceleration=2")
    r = beespace.read_recording(path)
    verdict = beespace.verify(
        r.ids[r.agents], r.times, r.positions, 4,
        velocities=r.velocities, max_speed=7, max_acceleration=2,
    )
    losses = verdict.losses
    assert not said["straight"] and len(losses) > 3
    assert sorted(zip(losses.i, losses.j, losses.begin, losses.end, losses.distance)) == sorted(
        (each["first"], each["second"], each["begins_s"], each["ends_s"], each["value"])
        for each in said["findings"]
        if each["finding"] == "loss"
    )
    assert len(verdict.breaches) == said["breach_count"] > 0
    straight = beespace.verify(r.ids[r.agents], r.times, r.positions, 4)
    assert straight.losses.distance.tolist() != losses.distance.tolist()


def test_a_live_swarm_takes_fixes_as_they_are(file_of):
    table = (
        "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,1,0,0\nb,0,50,0,0,-1,0,0\n"
        "a,1,1,0,0,1,0,0\nb,1,49,0,0,,,\n"
    )
    r = beespace.read_recording(file_of("flight.csv", table))
    swarm = beespace.Swarm(5, horizon=60)
    swarm.update(r.agents, r.times, r.positions, r.velocities)
    events = swarm.advance(1)
    assert events.kind.tolist() == ["predicted"] and events.closest_time.tolist() == [25]


# ---- Obstacles -----------------------------------------------------------------------------------


def test_obstacles_are_those_of_the_file(file_of):
    path = file_of(
        "city.json",
        '{"obstacles": [{"kind": "sphere", "center": [1, 2, 3], "radius_m": 4},'
        '{"kind": "box", "low": [0, 1, 2], "high": [3, 4, 5]}, {"kind": "ground", "height_m": -7},'
        '{"kind": "cylinder", "center": [5, 6], "radius_m": 1, "high_m": 40},'
        '{"kind": "prism", "outline": [[0, 0], [4, 0], [0, 3]], "low_m": -1}]}',
    )
    read = beespace.read_obstacles(path)
    assert read[0] == beespace.Sphere((1, 2, 3), 4)
    assert read[1] == beespace.Box((0, 1, 2), (3, 4, 5))
    assert read[2] == beespace.Ground(-7)
    assert read[3] == beespace.Cylinder(5, 6, 1, None, 40)
    assert np.asarray(read[4].outline).tolist() == [[0, 0], [4, 0], [0, 3]]
    assert (read[4].low, read[4].high, len(read)) == (-1, None, 5)
    for ask in (beespace.read, beespace.read_recording):
        with pytest.raises(beespace.BeespaceFileError, match="read it as obstacles"):
            ask(path)


def test_what_is_no_obstacle_is_named(file_of):
    path = file_of("bad.json", '{"obstacles": [{"kind": "box", "low": [9, 0, 0], "high": [1, 1, 1]}]}')
    with pytest.raises(beespace.BeespaceFileError, match=r"obstacles\[0\]") as caught:
        beespace.read_obstacles(path)
    assert (caught.value.file, caught.value.code) == (str(path), "malformed_record")
    with pytest.raises(OSError):
        beespace.read_obstacles(path.with_name("none.json"))
    assert len(beespace.read_obstacles(file_of("none.json", '{"obstacles": []}'))) == 0


@beside_the_command
def test_obstacles_verify_as_those_of_the_command(file_of):
    table = "id,time_s,x,y,z\na,0,-60,5,10\na,60,60,5,10\nb,0,-60,30,10\nb,60,60,30,10\n"
    path = file_of("flight.csv", table)
    said = said_by(
        "verify", path, "--threshold=5", f"--obstacles={data / 'city.json'}", "--clearance=30"
    )
    r = beespace.read_recording(path)
    verdict = beespace.verify(
        r.ids[r.agents], r.times, r.positions, 5,
        obstacles=beespace.read_obstacles(data / "city.json"), clearance=30,
    )
    found = [each for each in said["findings"] if each["finding"] != "loss"]
    assert len(found) == len(verdict.clearance_losses) > 0
    assert sorted(verdict.clearance_losses.distance) == sorted(each["value"] for each in found)
