"""Exact in three steps: the bands around X that each leaves open, and how many pairs they hold."""

import math
import random
import struct
from fractions import Fraction

from canvas import Picture, Plot
from cells import fraction_bits

U = 2.0 ** -53
MARGIN = 2.0 ** -20
WINDOW = 27.0  # cells around a point, whose points are compared with it
MOST_BITS, FEWEST_BITS = 22, 9


def as_float(value):
    return struct.unpack("f", struct.pack("f", value))[0]


class Limits:
    """SquaredLimits of near_pairs.hpp for a threshold of `units`."""

    def __init__(self, units):
        self.near = as_float((units - 2.0) ** 2 * (1.0 - 2.0 ** -18))
        self.far = as_float((units + 2.0) ** 2 * (1.0 + 2.0 ** -18))


def _direction(chance):
    while True:
        v = [2.0 * chance.random() - 1.0 for _ in range(3)]
        length = math.sqrt(sum(c * c for c in v))
        if 0.1 < length <= 1.0:
            return [c / length for c in v]


def left_to_doubles(bits, samples=6000):
    """The share of compared pairs that floats leave open, where a cell has 2^bits units. Pairs are
    drawn from a shell around X only, and count by its share of the window."""
    chance = random.Random(bits)
    cell = 2.0 ** bits
    units = cell / (1.0 + MARGIN)
    limits = Limits(units)
    half = 2.0 * (4.0 + units * 2.0 ** -18)
    low, high = max(units - half, 0.0), units + half
    share = 0.0
    for _ in range(samples):
        distance = low + (high - low) * chance.random()
        squared = 0.0
        for along in _direction(chance):
            start = chance.random()
            difference = math.floor(start + distance * along)  # both positions are cut down
            squared = as_float(squared + as_float(float(difference) * difference))
        if limits.near <= squared <= limits.far:
            share += 4.0 * math.pi * distance ** 2 * (high - low)
    return share / samples / (WINDOW * cell ** 3)


def left_to_expansions(samples=12_000):
    """The same for doubles, at X = 100 m in a cube of 12,800 m."""
    chance = random.Random(53)
    threshold = 100.0
    surely_near = threshold * threshold * (1.0 - 2.0 ** -50)
    surely_far = threshold * threshold * (1.0 + 2.0 ** -50)
    width = Fraction(32, 2 ** 53)  # of the shell, relative to the square
    in_shell = open_pairs = 0
    for _ in range(samples):
        p = [12_800.0 * chance.random() for _ in range(3)]
        q = [a + threshold * along for a, along in zip(p, _direction(chance))]
        exact = sum((Fraction(a) - Fraction(b)) ** 2 for a, b in zip(p, q))
        if abs(exact / Fraction(threshold) ** 2 - 1) > width:
            continue
        in_shell += 1
        dx, dy, dz = (a - b for a, b in zip(p, q))
        squared = dx * dx + dy * dy + dz * dz
        open_pairs += surely_near <= squared <= surely_far
    shell = 4.0 * math.pi * float(width) / (WINDOW * (1.0 + MARGIN) ** 3)
    return shell * open_pairs / in_shell


def _power(value):
    """A number in words fit for a label: 2.4 · 10⁻⁴."""
    exponent = math.floor(math.log10(value))
    digits = str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"{value / 10.0 ** exponent:.1f} · 10{digits}"


def _bands():
    picture = Picture(860, 392, "The bands around X")
    threshold = 100.0
    bits, _ = fraction_bits(128)
    units = 2.0 ** bits / (1.0 + MARGIN)
    limits = Limits(units)
    floats = threshold * (math.sqrt(limits.far) - math.sqrt(limits.near)) / units / 2.0
    doubles = threshold * (math.sqrt(1.0 + 8.0 * U * 1e6) - 1.0) / 1e6
    left, width, middle = 210, 620, 520
    picture.text(22, 30, "What each step leaves open", "ink", None, "strong")
    picture.lines(22, 48, ["The distance of two points, for X = 100 m and 22 bits a cell. Each "
                           "line is the open band of the one above, magnified."])
    steps = (("1  floats", "on fixed-point positions", floats, 90),
             ("2  doubles", "on the given doubles", doubles, 70),
             ("3  expansions", "without rounding", 0.0, 0))
    for k, (name, remark, half, drawn) in enumerate(steps):
        top = 92 + k * 104
        picture.text(22, top + 14, name, "ink", None, "strong")
        picture.text(22, top + 32, remark, "soft", None, "small")
        picture.box(left, top, middle - drawn - left, 36, "goodwash")
        picture.box(middle + drawn, top, left + width - middle - drawn, 36, "wash")
        picture.text(left + 14, top + 23, "closer", "good", None, "small")
        picture.text(left + width - 14, top + 23, "not closer", "soft", "end", "small")
        picture.line(middle, top - 8, middle, top + 44, "ink", 1.6)
        if drawn:
            picture.box(middle - drawn, top, 2 * drawn, 36, "hotwash", "hot", 0, 1.2)
            picture.line(middle, top - 8, middle, top + 44, "ink", 1.6)
            picture.text(middle - drawn + 8, top + 23, "open", "hot", None, "small")
            picture.text(middle + 10, top + 57, f"X ± {_power(half)} m", "hot", None, "small")
            for sign in (-1, 1):
                picture.line(middle + sign * drawn, top + 36, middle + sign * (width - middle + left
                             if sign > 0 else middle - left), top + 104, "rule", 1, dashed=True)
        else:
            picture.lines(middle + 10, top + 57, ["nothing is open: at X itself the sign is 0"])
    return picture


def _shares():
    picture = Picture(860, 400, "How many pairs reach each step")
    plot = Plot(picture, 80, 84, 560, 250, (MOST_BITS, FEWEST_BITS), (1e-17, 1.0), y_log=True)
    picture.text(22, 30, "Of all pairs compared: how many reach which step", "ink", None, "strong")
    picture.lines(22, 48, ["Simulated: pairs of points anywhere in 27 adjacent cells, with the "
                           "limits of the code."])
    bits = range(MOST_BITS, FEWEST_BITS - 1, -1)
    powers = "⁰¹²³⁴⁵⁶⁷⁸⁹"
    ticks = [(10.0 ** -k, "1" if k == 0 else "10⁻" + "".join(powers[int(d)] for d in str(k)))
             for k in (0, 3, 6, 9, 12, 15)]
    plot.axes([(b, str(b)) for b in bits],
              ticks, "fraction bits a cell (fewer, the more cells lie along the longest axis)",
              "share of pairs")
    values = [(b, left_to_doubles(b)) for b in bits]
    plot.curve([(b, 1.0) for b in bits], "good", 3)
    plot.curve(values, "cool", 2.4)
    for b, share in values:
        picture.dot(plot.x_at(b), plot.y_at(share), 3.4, "cool")
    third = left_to_expansions()
    plot.curve([(b, third) for b in bits], "hot", 2.4)
    x = plot.left + plot.width + 12
    picture.text(x, plot.y_at(1.0) + 4, "1  floats: every pair", "good", None, "small")
    picture.lines(x, plot.y_at(values[-1][1]) + 4,
                  [f"2  doubles: {_power(values[0][1])}", f"to {_power(values[-1][1])}"], "cool")
    picture.text(x, plot.y_at(third) + 4, f"3  expansions: {_power(third)}", "hot", None, "small")
    return picture


def pictures():
    yield "bands", _bands()
    yield "steps", _shares()
