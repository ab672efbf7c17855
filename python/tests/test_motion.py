"""Movers: which pairs are in conflict, as fractions say; when and how close, nearly so."""

from __future__ import annotations

import math
from fractions import Fraction

import motion_oracle
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import beespace


def lattice(random: np.random.Generator, count: int, axes: int = 3):
    """Small whole numbers: whatever can be at the edge of a conflict is."""
    positions = random.integers(-9, 10, (count, axes)).astype(float)
    velocities = random.integers(-3, 4, (count, axes)).astype(float)
    return positions, velocities


def beside(threshold: float):
    return [math.nextafter(threshold, 0.0), threshold, math.nextafter(threshold, math.inf)]


def is_near(found, expected):
    """Of passes one ulp inside the threshold, times are roots of some roundings: 1e-8."""
    return np.allclose(found, expected, rtol=1e-12, atol=1e-7)


@pytest.mark.parametrize("axes", [2, 3])
@pytest.mark.parametrize("vertical", [None, 2.0])
@pytest.mark.parametrize("inclusive", [False, True])
def test_predictions_are_those_of_fractions(axes, vertical, inclusive):
    random = np.random.default_rng(5)
    grazes = 0
    for within in (0.0, 1.5, 40.0):
        for threshold in beside(3.0) + beside(math.sqrt(2)):
            positions, velocities = lattice(random, 25, axes)
            found = beespace.predict(
                positions,
                velocities,
                threshold,
                within=within,
                vertical=vertical,
                inclusive=inclusive,
            )
            expected = motion_oracle.predicted(
                positions, velocities, threshold, within, inclusive, vertical
            )
            assert list(zip(found.i, found.j)) == list(expected)
            columns = [found.begin, found.closest_time, found.end, found.closest_distance]
            assert is_near(np.array(columns).T, np.array([*expected.values()]).reshape(-1, 4))
            pairs = beespace.predict_pairs(
                positions,
                velocities,
                threshold,
                within=within,
                vertical=vertical,
                inclusive=inclusive,
            )
            assert list(zip(pairs.i, pairs.j)) == list(expected)
            other = motion_oracle.predicted(
                positions, velocities, threshold, within, not inclusive, vertical
            )
            grazes += len(expected) != len(other)
    assert grazes  # or the lattice would show nothing about passes at exactly the threshold


def test_a_pass_at_exactly_the_threshold_and_one_ulp_beside_it():
    # Past each other at 30 m, far from where they are now.
    positions, velocities = [[0, 0], [1e6, 30]], [[5, 0], [-5, 0]]
    for threshold, inclusive, expected in [
        (30, False, 0),
        (30, True, 1),
        (math.nextafter(30, 0), True, 0),
        (math.nextafter(30, 31), False, 1),
    ]:
        found = beespace.predict(
            positions, velocities, threshold, within=2e5, inclusive=inclusive
        )
        assert len(found) == expected
        approach = beespace.closest_approach(
            positions[0],
            velocities[0],
            positions[1],
            velocities[1],
            threshold=threshold,
            inclusive=inclusive,
        )
        assert not math.isnan(approach.begin[0]) == expected
        assert (approach.closest_time[0], approach.closest_distance[0]) == (1e5, 30)


numbers = st.floats(-1e6, 1e6, width=32) | st.integers(-5, 5).map(float)
vectors = st.tuples(numbers, numbers, numbers)


@settings(max_examples=200, deadline=None)
@given(
    st.lists(st.tuples(vectors, vectors, vectors, vectors), min_size=1, max_size=4),
    st.sampled_from([0.0, 0.1, 7.0, 1e9, None]),
    st.sampled_from([1.0, 5.0, 1e3, 1e6]),
    st.sampled_from([None, 2.0]),
    st.booleans(),
    st.sampled_from([np.float64, np.float32]),
)
def test_approaches_are_those_of_fractions(twos, within, threshold, vertical, inclusive, dtype):
    given = np.array(twos, dtype)  # two, which of the four, axis
    found = beespace.closest_approach(
        *(given[:, which] for which in range(4)),
        within=within,
        threshold=threshold,
        vertical=vertical,
        inclusive=inclusive,
    )
    span = (Fraction(0), Fraction(2.0**100 if within is None else within))
    for each, (p, v, q, w) in enumerate(given):
        apart = motion_oracle.minus(motion_oracle.vector(q), motion_oracle.vector(p))
        speed = motion_oracle.minus(motion_oracle.vector(w), motion_oracle.vector(v))
        closest = motion_oracle.closest_time(apart, speed, span)
        # Differences, products of vectors and quotients round a few times each.
        roundings = 16 * 2.0**-53
        far, fast = math.hypot(*apart), math.hypot(*speed)
        late = roundings * far / fast if fast else 0.0
        assert abs(found.closest_time[each] - float(closest)) <= late + roundings * float(closest)
        distance = float(motion_oracle.root(motion_oracle.squared_at(apart, speed, closest)))
        reach = far + fast * float(closest)
        assert abs(found.closest_distance[each] - distance) <= roundings * reach
        conflict = motion_oracle.in_conflict(apart, speed, span, threshold, vertical, inclusive)
        assert math.isnan(found.begin[each]) != conflict
        assert math.isnan(found.end[each]) != conflict


def test_one_mover_serves_for_all_and_any_layout_is_read():
    random = np.random.default_rng(7)
    positions, velocities = lattice(random, 40)
    one, still = positions[3], velocities[3]
    whole = beespace.closest_approach(
        positions, velocities, np.tile(one, (40, 1)), np.tile(still, (40, 1)), within=9, threshold=4
    )
    for other in [
        (one, still),
        (one.tolist(), tuple(still)),
        (one[np.newaxis].astype(np.float32), still.astype(int)),
        (tuple(positions[3:4].T), tuple(velocities[3:4].T)),
    ]:
        for mine in [
            (positions, velocities),
            (tuple(positions.T), np.asfortranarray(velocities)),
            (positions[::-1][::-1], velocities.astype(np.float32)),
        ]:
            found = beespace.closest_approach(*mine, *other, within=9, threshold=4)
            for name in ("closest_time", "closest_distance", "begin", "end"):
                assert np.array_equal(getattr(found, name), getattr(whole, name), equal_nan=True)
    assert len(beespace.closest_approach(positions, still, one, still)) == 40
    assert len(beespace.closest_approach(np.empty((0, 3)), np.empty((0, 3)), one, still)) == 0


def test_an_engine_predicts_the_same():
    random = np.random.default_rng(8)
    positions, velocities = lattice(random, 200)
    engine = beespace.Engine()
    expected = beespace.predict(positions, velocities, 3, within=5)
    for threads in (1, 2):
        found = engine.predict(positions, velocities, 3, within=5, threads=threads)
        for name in ("i", "j", "begin", "end", "closest_time", "closest_distance"):
            assert np.array_equal(getattr(found, name), getattr(expected, name))
    assert len(engine.predict(np.empty((0, 3)), np.empty((0, 3)), 3, within=5)) == 0


def test_errors_say_which_array_and_which_of_it():
    positions, velocities = lattice(np.random.default_rng(9), 20)
    bad = positions.copy()
    bad[4, 1] = np.nan
    great = velocities * 1e40
    great[0] = 0
    approach = beespace.closest_approach
    predict = beespace.predict
    mine = (positions, velocities)
    for call, code, place, record in [
        (lambda: predict(bad, velocities, 1, within=1), "not_finite", "positions", 4),
        (lambda: predict(positions, bad, 1, within=1), "not_finite", "velocities", 4),
        (
            lambda: beespace.predict_pairs(positions, great, 1, within=1),
            "outside_domain",
            "velocities",
            1,
        ),
        (lambda: approach(*mine, bad, velocities), "not_finite", "other_positions", 4),
        (lambda: approach(*mine, positions, bad), "not_finite", "other_velocities", 4),
        (lambda: approach(*mine, bad[:3], bad[:3]), "invalid_argument", "other_positions", None),
        (
            lambda: predict(positions, velocities[:3], 1, within=1),
            "invalid_argument",
            "velocities",
            None,
        ),
        (
            lambda: predict(positions, velocities[:, :2], 1, within=1),
            "invalid_argument",
            "velocities",
            None,
        ),
        (
            lambda: predict(positions, velocities[:1], 1, within=1),
            "invalid_argument",
            "velocities",
            None,
        ),
        (lambda: predict(*mine, 1, within=-1), "invalid_argument", "within", None),
        (lambda: predict(*mine, 1, within="soon"), "invalid_argument", "within", None),
        (lambda: predict(*mine, 0, within=1), "invalid_threshold", "threshold", None),
        (lambda: predict(*mine, 9, within=9, max_results=1), "too_many_results", "max_results", None),
        (lambda: approach(*mine, *mine, inclusive=True), "invalid_argument", "inclusive", None),
    ]:
        with pytest.raises(beespace.BeespaceError) as caught:
            call()
        error = caught.value
        assert (error.code, error.place, error.record) == (code, place, record), str(error)


def test_answers_tell_what_is_in_them():
    found = beespace.predict([[0, 0], [9, 0], [0, 99]], [[1, 0], [0, 0], [0, 0]], 2, within=60)
    assert repr(found) == (
        "<Conflicts: 1 conflict of 3 movers, from 7 to 11 s, closest 0 and 1: 0 m at 9 s>"
    )
    none = beespace.predict([[0, 0]], [[1, 0]], 2, within=60)
    assert repr(none) == "<Conflicts: 0 conflicts of 1 mover>"


def test_answers_become_frames():
    pandas = pytest.importorskip("pandas")
    found = beespace.predict([[0, 0], [9, 0], [0, 99]], [[1, 0], [0, 0], [0, 0]], 2, within=60)
    frame = found.to_pandas()
    assert isinstance(frame, pandas.DataFrame)
    assert frame.to_dict("records") == [
        {"i": 0, "j": 1, "begin": 7, "end": 11, "closest_time": 9, "closest_distance": 0}
    ]
    approach = beespace.closest_approach([0, 0], [1, 0], [9, 1], [0, 0])
    assert approach.to_pandas().to_dict("records") == [{"closest_time": 9, "closest_distance": 1}]


def exact_ecef(lon, lat, height):
    """In long doubles, with the functions of the system."""
    lon, lat, height = (np.longdouble(each) for each in (lon, lat, height))
    a, f = np.longdouble(6378137), 1 / np.longdouble("298.257223563")
    e2 = f * (2 - f)
    pi = np.longdouble("3.14159265358979323846264338327950288")
    lam, phi = lon * pi / 180, lat * pi / 180
    n = a / np.sqrt(1 - e2 * np.sin(phi) ** 2)
    return np.array(
        [
            (n + height) * np.cos(phi) * np.cos(lam),
            (n + height) * np.cos(phi) * np.sin(lam),
            (n * (1 - e2) + height) * np.sin(phi),
        ]
    ).T


def test_degrees_become_metres():
    random = np.random.default_rng(4)
    lon = random.uniform(-360, 360, 500)
    lat = random.uniform(-90, 90, 500)
    height = random.uniform(-12_000, 1_000_000, 500)
    xyz = beespace.to_ecef(lon, lat, height)
    assert np.abs(xyz - exact_ecef(lon, lat, height)).max() < 1e-8
    one_height = beespace.to_ecef(lon, lat, 30)
    assert np.array_equal(one_height, beespace.to_ecef(lon, lat, np.full(500, 30)))
    assert np.array_equal(beespace.to_ecef(lon[::-2], lat[::-2], height[::-2]), xyz[::-2])
    assert beespace.to_ecef(13.4, 52.5, 0).shape == (3,)
    assert beespace.to_ecef([], [], 0).shape == (0, 3)
    assert beespace.to_ecef([13], [52], 0).shape == (1, 3)


def test_velocities_turn_as_the_places_do():
    # Against the places a little earlier and later, in long doubles.
    random = np.random.default_rng(5)
    lon, lat = random.uniform(-180, 180, 200), random.uniform(-80, 80, 200)
    height = random.uniform(0, 20_000, 200)
    speeds = random.uniform(-300, 300, (200, 3))
    xyz, velocities = beespace.to_ecef(lon, lat, height, velocities=speeds)
    assert np.array_equal(xyz, beespace.to_ecef(lon, lat, height))
    rad, e2 = np.pi / 180, 6.69437999014e-3
    sine = np.sin(lat * rad) ** 2
    normal = 6378137 / np.sqrt(1 - e2 * sine)
    meridian = normal * (1 - e2) / (1 - e2 * sine)
    turned = speeds[:, 0] / ((normal + height) * np.cos(lat * rad)) / rad
    raised = speeds[:, 1] / (meridian + height) / rad
    s = 1e-3
    ends = [
        exact_ecef(lon + t * turned, lat + t * raised, height + t * speeds[:, 2]) for t in (-s, s)
    ]
    assert np.abs(velocities - (ends[1] - ends[0]) / (2 * s)).max() < 1e-4
    assert np.allclose(np.linalg.norm(velocities, axis=1), np.linalg.norm(speeds, axis=1))
    level = beespace.to_ecef(lon, lat, 0, tuple(speeds[:, :2].T))[1]
    assert np.array_equal(level, beespace.to_ecef(lon, lat, 0, speeds * [1, 1, 0])[1])
    one = beespace.to_ecef(lon[3], lat[3], height[3], speeds[3])
    assert np.array_equal(one[1], velocities[3]) and one[1].shape == (3,)
    for wrong, code, place, record in [
        (speeds[1:], "invalid_argument", "velocities", None),
        (np.where(speeds == speeds[7, 1], np.nan, speeds), "not_finite", "velocities", 7),
    ]:
        with pytest.raises(beespace.BeespaceError) as caught:
            beespace.to_ecef(lon, lat, height, wrong)
        error = caught.value
        assert (error.code, error.place, error.record) == (code, place, record)


def test_degrees_that_cannot_be_are_refused():
    lon, lat, height = [13.0, 14.0], [52.0, 53.0], [0.0, 0.0]
    for given, code, place, record in [
        ((lon, [52, 91], height), "invalid_latitude", "lat", 1),
        (([-361, 0], lat, height), "invalid_longitude", "lon", 0),
        ((lon, lat, 1e7), "invalid_height", "height", 0),
        ((lon, [52, np.nan], height), "not_finite", "lat", 1),
        ((lon, lat, [0, np.inf]), "not_finite", "height", 1),
        ((lon, lat, [0]), "invalid_argument", None, None),
        ((lon, [lat], 0), "invalid_argument", "lat", None),
        ((lon, lat, None), "invalid_argument", "height", None),
    ]:
        with pytest.raises(beespace.BeespaceError) as caught:
            beespace.to_ecef(*given)
        error = caught.value
        assert (error.code, error.place, error.record) == (code, place, record), str(error)
