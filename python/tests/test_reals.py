"""Numbers are taken as the real numbers that they are. What would be rounded, or is none, is refused."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import beespace
from tests.test_units import NUMBERS

apart = [[0, 0], [3, 4]]
# Longer than a double on x86-64; elsewhere it may be one.
longer = np.longdouble(5) + np.longdouble(2) ** -60
too_long = [longer] if float(longer) != longer else []

ROUNDED = [
    2**53 + 1, -(2**53) - 1, 10**400, 10**5000, np.int64(2**53 + 1), np.uint64(2**63 + 1),
    np.array(2**53 + 1), Fraction(1, 3), Decimal("0.1"), Decimal("5.0000000000000000001"), *too_long,
]  # fmt: skip
OTHERS = [
    True, np.True_, np.array(True), 6 + 1j, 6 + 0j, np.complex128(6 + 1j), np.clongdouble(6),
    np.array(6j), "6", b"6", np.str_("6"), np.array("6"), [6], np.array([6.0]), None, object(),
]  # fmt: skip
SAME = [
    6, 6.0, np.float64(6), np.float32(6), np.longdouble(6), np.int8(6), np.uint64(6), np.array(6.0),
    np.array(6), Fraction(12, 2), Decimal("6.0"),
]  # fmt: skip


def tell(number):
    return type(number).__name__


@pytest.mark.parametrize("number", [*ROUNDED, *OTHERS], ids=tell)
@pytest.mark.parametrize(("call", "argument"), NUMBERS)
def test_what_is_no_double_is_refused(call, argument, number):
    one_only = argument not in ("times", "height", "max_speed", "max_acceleration")
    if number is None or (np.ndim(number) and not one_only):
        return  # which stand for no number, or for many
    with pytest.raises(beespace.BeespaceError) as caught:
        call(number)
    assert caught.value.place == argument, str(caught.value)


@pytest.mark.parametrize("number", OTHERS, ids=tell)
def test_a_threshold_is_a_real_number(number):
    for ask in (beespace.at_risk, beespace.pairs, beespace.Index(apart).around):
        if ask.__name__ == "around" and np.ndim(number):
            continue
        with pytest.raises(beespace.BeespaceError, match="one number") as caught:
            ask(apart, number)
        assert caught.value.code == "invalid_threshold"


def test_what_would_be_rounded_says_what_to_do():
    for number in ROUNDED:
        for ask in (beespace.at_risk, beespace.Index(apart).around):
            with pytest.raises(beespace.BeespaceError, match=r"give float\(\.\.\.\)") as caught:
                ask(apart, number)
            assert caught.value.code == "invalid_threshold" and len(str(caught.value)) < 200


@pytest.mark.parametrize("number", SAME, ids=tell)
def test_numbers_of_all_kinds_are_the_doubles_that_they_are(number):
    assert beespace.at_risk(apart, number).tolist() == [0, 1]
    assert beespace.at_risk(apart, number, vertical=number).tolist() == [0, 1]
    assert [ids.tolist() for ids in beespace.Index(apart).around(apart, number)] == [[0, 1]] * 2
    swarm = beespace.Swarm(number, horizon=number)
    swarm.update([1, 2], number, apart)
    assert swarm.advance(number).kind.tolist() == ["entered"] or len(swarm.movers(number)) == 2


def test_the_largest_integers_that_are_doubles_are_taken():
    far = [[0.0, 0.0], [2.0**53, 0.0]]
    assert beespace.at_risk(far, 2**53).tolist() == []
    assert beespace.at_risk(far, 2**53 + 2).tolist() == [0, 1]
    assert beespace.at_risk(far, np.uint64(2**53 + 2)).tolist() == [0, 1]


@pytest.mark.parametrize("number", [True, np.True_, 2.0, "2", None, 2j], ids=tell)
def test_whole_numbers_are_integers(number):
    for call, argument in [
        (lambda: beespace.nearest(apart, number), "k"),
        (lambda: beespace.Index(apart).nearest(apart, number), "k"),
        (lambda: beespace.Index(apart).remove(number), "id"),
        (lambda: beespace.Swarm(5, max_agents=number), "max_agents"),
        (lambda: next(beespace.iter_pairs(apart, 6, chunk=number)), "chunk"),
        (lambda: beespace.Follower(number, 6, 4, 0.1), "agent"),
    ]:
        with pytest.raises(beespace.BeespaceError, match="whole number") as caught:
            call()
        assert caught.value.place == argument


@pytest.mark.parametrize(
    "radii",
    [
        np.array([5, 5], "m8[ms]"),
        np.array(["2026-01-01"] * 2, "M8[D]"),
        ["5", "6"],
        [b"5", b"6"],
        [5j, 6],
        [True, False],
        np.array([True, False]),
        np.array([5, 5], np.longdouble),
        [2**53 + 1, 1],
        [2**53 + 1, 1.5],
        [2**63, -1],
        np.array([2**53 + 1, 1]),
        np.array([2**63 + 1, 1], np.uint64),
        [Fraction(1, 3), 5],
        [Decimal("5"), 5],
        [[1], [1, 2]],
        [1, 2, 3],
        [[1, 2]],
    ],
)
def test_radii_are_numbers_as_all_others(radii):
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.Index(apart).around(apart, radii)
    assert (caught.value.code, caught.value.place) == ("invalid_argument", "radius")


def test_integers_that_would_be_rounded_are_refused_in_all_columns():
    big = 2**53 + 1
    for call, argument in [
        (lambda n: beespace.at_risk([[0, 0], n], 1), "points"),
        (lambda n: beespace.at_risk(([0, 0], n), 1), "points"),
        (lambda n: beespace.Recording([1, 1], n, apart), "times"),
        (lambda n: beespace.Recording([1, 1], [0, 1], apart, heights=n), "heights"),
        (lambda n: beespace.Swarm(5).update([1, 2], n, apart), "times"),
        (lambda n: beespace.Index(apart).insert(n), "point"),
        (lambda n: beespace.to_ecef([1, 1], [1, 1], n), "height"),
        (lambda n: beespace.velocity_to_goal(apart, apart, max_speed=n), "max_speed"),
        (lambda n: beespace.Obstacles([beespace.Sphere([0, *n], 1)]), "obstacles"),
        (lambda n: beespace.Obstacles([beespace.Prism([(0, 0), (1, 0), n])]), "obstacles"),
    ]:
        for given in ([0, big], [0.5, big], [-1, 2**63], np.array([0, big])):
            with pytest.raises(beespace.BeespaceError, match=r"2\*\*53") as caught:
                call(given)
            assert caught.value.place == argument
    # Floats are what they are.
    assert beespace.at_risk([[0, 0], [0.5, 2.0**60]], 1).tolist() == []
