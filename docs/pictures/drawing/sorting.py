"""The two-step sort: one scatter into buckets, then each bucket in the nearest cache."""

import random
import struct

from canvas import Picture

TINTS = ("cool", "hot", "good", "odd")
RECORD_BYTES = struct.calcsize("iiiI")  # three positions and an id


def buckets_for(points):
    """As in bucket_sort.cpp, with enough bits in the key."""
    return 1 << min(max(points.bit_length() - 9, 0), 12)


def _steps():
    picture = Picture(860, 400, "Sorting in two steps")
    key_bits, bucket_bits, count = 8, 3, 200
    chance = random.Random(12)
    given = [int(chance.random() * (1 << key_bits)) for _ in range(count)]
    scattered = sorted(given, key=lambda key: key >> (key_bits - bucket_bits))  # a stable sort
    ordered = sorted(given)
    million = 1_000_000
    buckets = buckets_for(million)
    kib = million / buckets * RECORD_BYTES / 1024
    names = (
        ("As given", "Each bar is a point; its height is the place in the grid where it belongs."),
        ("After one scatter by the high bits of the key",
         f"Drawn: {1 << bucket_bits} buckets. A million points go to {buckets:,}, of "
         f"{million / buckets:.0f} points or {kib:.1f} KiB each: a bucket fits the nearest cache."),
        ("After sorting each bucket", "Counting sorts, bucket by bucket: each reads and writes a "
         "small piece of memory."))
    left, width, height = 22, 816, 62
    for k, (keys, (name, remark)) in enumerate(zip((given, scattered, ordered), names)):
        top = 60 + k * 128
        picture.text(left, top - 30, name, "ink", None, "strong")
        picture.text(left, top - 12, remark, "soft", None, "small")
        bottom = top + height
        step = width / count
        for i, key in enumerate(keys):
            tall = height * (key + 1) / (1 << key_bits)
            tint = TINTS[(key >> (key_bits - bucket_bits)) % len(TINTS)]
            picture.box(left + i * step, bottom - tall, step - 0.8, tall, tint)
        picture.line(left, bottom + 1, left + width, bottom + 1, "soft")
    return picture


def pictures():
    yield "sort", _steps()
