"""No argument loses its unit or its mask, whatever it is an argument of."""

from __future__ import annotations

import datetime

import numpy as np
import pytest

import beespace
from arrays_with_units import Pint, Unyt, Xarray, in_kilometres

flown = [[0, 0, 50], [300, 0, 50]]
still = np.zeros((2, 3))
place = [0, 0, 30]
outline = [(0, 0), (40, 0), (0, 30)]
limits = {"max_speed": 6, "max_acceleration": 4}
onboard = beespace.Follower(7, 6, 4, 0.1)


def advise(**changed):
    return beespace.Adviser().advise(flown, still, still, 2, **{**limits, **changed})


def guide(**changed):
    return beespace.Guide(2, **{**limits, **changed})


def joined(agent=7):
    fleet = guide()
    assert fleet.join(agent, place).joined
    return fleet


def verify(**changed):
    return beespace.verify([1, 1], [0, 1], flown, 5, velocities=still, **changed)


def follower(**changed):
    figures = {"planned_speed": 6, "planned_acceleration": 4, "period": 0.1, **changed}
    return beespace.Follower(7, **figures)


def swarm(**changed):
    return beespace.Swarm(5, **changed)


def with_heights(**given):
    swarm(heights_apart=True, vertical=5).update([1, 2], 0, flown, still, **given)


# What takes one number, and the argument that the error names.
NUMBERS = [
    (lambda x: beespace.at_risk(flown, x), "threshold"),
    (lambda x: beespace.at_risk(flown, 5, vertical=x), "vertical"),
    (lambda x: beespace.nearest(flown, within=x), "within"),
    (lambda x: beespace.predict(flown, still, 5, within=x), "within"),
    (lambda x: beespace.closest_approach(*flown, *flown, within=x), "within"),
    (lambda x: beespace.Recording([1, 2], [0, 0], flown).conflicts(5, max_gap=x), "max_gap"),
    (lambda x: beespace.Recording([1, 2], [0, 0], flown).conflicts(x), "threshold"),
    (lambda x: beespace.Recording([1], [0], flown[:1], heights=[0], height_unit=x), "height_unit"),
    (lambda x: swarm().advance(x), "now"),
    (lambda x: swarm().finish(x), "now"),
    (lambda x: swarm().begin_anew(0, x), "then"),
    (lambda x: swarm().movers(x), "time"),
    (lambda x: swarm().update([1, 2], x, flown), "times"),
    *[
        (lambda x, name=name: swarm(**{name: x}), name)
        for name in ("vertical", "height_unit", "leave_factor", "horizon", "max_age", "max_speed")
    ],
    *[
        (lambda x, name=name: advise(**{name: x}), name)
        for name in ("max_speed", "max_acceleration", "step", "vertical", "vertical_factor",
                     "uncertainty", "clearance", "intruder_horizon", "unknown_horizon")
    ],
    *[
        (lambda x, name=name: verify(**{name: x}), name)
        for name in ("max_speed", "max_acceleration", "clearance", "max_gap")
    ],
    (lambda x: beespace.Verifier(5, straight=True).add(x, flown), "time"),
    *[
        (lambda x, name=name: guide(**{name: x}), name)
        for name in ("max_speed", "max_acceleration", "vertical", "clearance", "intruder_horizon")
    ],
    *[
        (lambda x, name=name: guide().join(7, place, **{name: x}), name)
        for name in ("radius", "max_speed", "max_acceleration")
    ],
    *[
        (lambda x, name=name: guide(figures=beespace.FleetFigures(**{name: x})), name)
        for name in ("report_error", "report_age", "sensing_error", "loop_period", "loop_delay",
                     "deviation", "clock_error", "correction_acceleration", "correction_speed")
    ],
    (lambda x: guide(link=beespace.LinkFigures(period=x)), "period"),
    *[
        (lambda x, name=name: follower(**{name: x}), name)
        for name in ("planned_speed", "planned_acceleration", "period")
    ],
    (lambda x: onboard.setpoint(x), "after"),
    (lambda x: guide().take(beespace.AgentReport(7, 1, 1, tuple(place), after=x)), "after"),
    (lambda x: beespace.Obstacles([beespace.Sphere(place, x)]), "obstacles"),
    (lambda x: beespace.Obstacles([beespace.Ground(x)]), "obstacles"),
    (lambda x: beespace.Obstacles([beespace.Cylinder(x, 0, 1)]), "obstacles"),
    (lambda x: beespace.Obstacles([beespace.Cylinder(0, 0, 1, high=x)]), "obstacles"),
    (lambda x: beespace.Obstacles([beespace.Prism(outline, low=x)]), "obstacles"),
    (lambda x: beespace.to_ecef([1, 1], [1, 1], x), "height"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "argument"), NUMBERS)
def test_a_number_in_another_unit_is_refused(call, argument):
    others = [*in_kilometres(5.0), np.ma.masked, np.ma.array(5.0, mask=True)]
    for number in [*others, np.timedelta64(5, "ns")]:
        with pytest.raises(beespace.BeespaceError) as caught:
            call(number)
        assert caught.value.place == argument, str(caught.value)


# What takes an array, the argument, and what it takes.
ARRAYS = [
    (lambda x: beespace.closest_approach(x, still[0], flown, still), "positions", place),
    (lambda x: beespace.closest_approach(place, x, flown, still), "velocities", place),
    (lambda x: beespace.closest_approach(place, place, x, place), "other_positions", place),
    (lambda x: beespace.velocity_to_goal(x, place, max_speed=5), "positions", place),
    (lambda x: beespace.velocity_to_goal(flown, x, max_speed=5), "goals", place),
    (lambda x: advise(max_speed=x), "max_speed", [5, 5]),
    (lambda x: advise(max_acceleration=x), "max_acceleration", [5, 5]),
    *[
        (lambda x, name=name: advise(**{name: x}), name, [5, 5]) for name in ("radii", "tubes")
    ],
    (lambda x: beespace.Adviser().advise(flown, still, x, 2, **limits), "preferred", flown),
    (lambda x: advise(fence_directions=[[1, 0, 0]], fence_offsets=x), "fence_offsets", [5]),
    (lambda x: advise(fence_directions=x, fence_offsets=[0]), "fence_directions", [[1, 0, 0]]),
    (lambda x: advise(intruder_positions=x), "intruder_positions", flown),
    (lambda x: advise(unknown_centers=flown, unknown_radii=x), "unknown_radii", [5, 5]),
    (lambda x: joined().set_intruders(flown, still, radii=x), "radii", [5, 5]),
    (lambda x: joined().set_intruders(flown, still, speed_errors=x), "speed_errors", [5, 5]),
    (lambda x: guide().join(7, x), "position", place),
    (lambda x: joined().set_goal(7, x), "goal", place),
    (lambda x: joined().set_preferred(7, x), "velocity", place),
    (lambda x: guide().take(beespace.AgentReport(7, 1, 1, x)), "position", place),
    (lambda x: beespace.Obstacles([beespace.Sphere(x, 1)]), "obstacles", place),
    (lambda x: beespace.Obstacles([beespace.Box(place, x)]), "obstacles", [9, 9, 90]),
    (lambda x: beespace.Obstacles([beespace.Prism(x)]), "obstacles", outline),
    (lambda x: with_heights(heights=x), "heights", [5, 5]),
    (lambda x: with_heights(heights=[5, 5], climbs=x), "climbs", [5, 5]),
    (lambda x: beespace.Recording([1, 2], [0, 0], flown, heights=x), "heights", [5, 5]),
    (lambda x: beespace.at_risk(x, 5), "points", flown),
    (lambda x: beespace.at_risk((x, [0, 0]), 5), "points", [0, 1]),
]


@pytest.mark.parametrize(("call", "argument", "numbers"), ARRAYS)
def test_an_array_in_another_unit_is_refused(call, argument, numbers):
    array = np.asarray(numbers, np.float64)
    masked = np.ma.array(array, mask=np.arange(array.size).reshape(array.shape) == array.size - 1)
    # A list, too, may be one of quantities.
    several = [np.asarray(each).view(Unyt) for each in array]
    lists = [several, [*array[:-1], several[-1]]]
    for given in [*in_kilometres(array), masked, *lists]:
        with pytest.raises(beespace.BeespaceError) as caught:
            call(given)
        assert caught.value.place == argument, str(caught.value)


def test_numbers_in_the_unit_that_is_taken_are_read():
    metres, speed = Pint(np.asarray(320.0), "meter"), Xarray(6, "m/s")
    assert beespace.at_risk(flown, metres).tolist() == [0, 1]
    assert beespace.at_risk(flown, Xarray(320, "metres")).tolist() == [0, 1]
    assert advise(max_speed=speed).certified.all()
    assert advise(max_speed=Pint(np.ones(2), "meter / second")).certified.all()
    assert beespace.velocity_to_goal(Xarray(place, "m"), place, max_speed=speed).shape == (1, 3)
    assert guide().join(7, Xarray(place, "m")).joined
    # Of heights in another unit of length it is not known what it is called.
    feet = beespace.Recording([1, 2], [0, 0], flown, heights=[0, 9], height_unit=0.3048)
    assert len(feet.conflicts(500, vertical=Pint(np.asarray(10.0), "foot"))) == 1


@pytest.mark.parametrize("call", [
    lambda t: beespace.Swarm(5).advance(t),
    lambda t: beespace.Swarm(5).update([1], t, [[0, 0]]),
    lambda t: beespace.Recording([1], [t], [[0, 0]]),
    lambda t: beespace.predict([[0, 0]], [[1, 0]], 5, within=t),
])  # fmt: skip
def test_dates_are_refused_with_what_to_do(call):
    moment = datetime.datetime(2026, 5, 1, tzinfo=datetime.timezone.utc)
    for date in (moment, moment - moment, np.datetime64("2026-05-01"), np.timedelta64(5, "s")):
        with pytest.raises(beespace.BeespaceError, match="subtract a moment"):
            call(date)


def test_dates_of_pandas_are_refused_with_what_to_do():
    pandas = pytest.importorskip("pandas")
    for dates in (
        pandas.Series(pandas.to_datetime(["2026-05-01", "2026-05-02"], utc=True)),
        pandas.Series(pandas.period_range("2026-05", periods=2, freq="M")),
    ):
        with pytest.raises(beespace.BeespaceError, match="subtract a moment"):
            beespace.Recording([1, 2], dates, flown)
