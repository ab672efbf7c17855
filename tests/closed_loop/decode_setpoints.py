#!/usr/bin/env python3
"""Decodes what `beespace guide --format mavlink` writes, by the published layout and a checksum of
its own; and with pymavlink as well, where that is installed.

  tests/closed_loop/decode_setpoints.py COMMAND
"""

import json
import struct
import subprocess
import sys

START = [1.0, 2.0, 30.0]


def checksum(data):
    """CRC-16/MCRF4XX, bit by bit."""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x8408 if crc & 1 else 0)
    return crc


def frames_of(data):
    while data:
        magic, length, incompatible, compatible, sequence, system, component = data[:7]
        message = int.from_bytes(data[7:10], "little")
        end = 10 + length
        assert (magic, length, incompatible, compatible) == (0xFD, 53, 0, 0), data[:10]
        assert (system, component, message) == (255, 190, 84), data[:10]
        crc = int.from_bytes(data[end:end + 2], "little")
        assert crc == checksum(data[1:end] + bytes([143])), "checksum"
        yield sequence, struct.unpack("<I11fHBBB", data[10:end])
        data = data[end + 2:]


def flown(command, options):
    lines = [{"event": "join", "id": 7, "position": START},
             {"event": "goal", "id": 7, "position": [41.0, 2.0, 32.0]}]
    for tick in range(1, 301):
        lines.append({"event": "tick", "tick": tick})
        # It stays where it began: what matters is what it is told.
        lines.append({"event": "measured", "id": 7, "tick": tick, "position": START})
    run = subprocess.run([command, "guide", "--threshold", "2", "--max-speed", "10",
                          "--max-acceleration", "5", "--ticks-from-input", "--format", "mavlink",
                          "--quiet", *options], check=True, capture_output=True,
                         input="\n".join(map(json.dumps, lines)).encode())
    return run.stdout


def main():
    command = sys.argv[1]
    data = flown(command, ["--report-error", "100", "--sensing-error", "100", "--deviation", "0.1",
                           "--correction-acceleration", "4.5", "--correction-speed", "9.5"])
    frames = list(frames_of(data))
    assert [sequence for sequence, _ in frames] == [i % 256 for i in range(len(frames))]
    first, last = frames[0][1], frames[-1][1]
    assert first[1:4] == (2.0, 1.0, -30.0), first  # north, east, down
    assert all(values[12:] == (0x0DC0, 7, 1, 1) for _, values in frames)
    assert last[2] >= first[2] and abs(last[1] - 2.0) < 1e-3, last  # east; never sideways
    data = flown(command, ["--loop", "ground", "--deviation", "0.1", "--correction-acceleration",
                           "1", "--correction-speed", "1.5"])
    ground = [values for _, values in frames_of(data)]
    assert all(values[12] == 0x0DC7 and values[1:4] == (0, 0, 0) for values in ground)
    said = f"{len(frames)} and {len(ground)} frames"
    try:
        from pymavlink.dialects.v20 import common
    except ImportError:
        print(said + "; pymavlink is not installed")
        return
    messages = common.MAVLink(None).parse_buffer(data)
    assert {message.get_type() for message in messages} == {"SET_POSITION_TARGET_LOCAL_NED"}
    assert len(messages) == len(ground)
    print(said + "; pymavlink reads the same")


if __name__ == "__main__":
    main()
