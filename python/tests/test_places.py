"""An error names the argument that it is about, as Python calls it."""

from __future__ import annotations

import inspect
import math

import numpy as np
import pytest

import beespace
from tests.test_reading import readers

two, still = [[0, 0, 0], [50, 0, 0]], [[0, 0, 0]] * 2
limits = {"max_speed": 5.0, "max_acceleration": 2.0}
none = math.nan


def recording(**more):
    return beespace.Recording([1, 2], [0, 0], two, **more)


def advise(threshold=2, **more):
    return beespace.Adviser().advise(two, still, still, threshold, **{**limits, **more})


def guide(**more):
    return beespace.Guide(2, **{**limits, **more})


def joined():
    fleet = guide()
    assert fleet.join(1, [0, 0, 0]).joined
    fleet.step(1)
    return fleet


def verify(**more):
    return beespace.verify([1, 1], [0, 1], two, 5, velocities=still, **more)


def out_of_core(**more):
    search = beespace.OutOfCore("100 MB", **more)
    search.add(two)
    return search


def advanced(*times):
    swarm = beespace.Swarm(5)
    for time in times:
        swarm.advance(time)


def index():
    return beespace.Index(two)


def walls(**more):
    return {"obstacles": beespace.Obstacles([beespace.Ground(0)]), **more}


CALLS = [
    *[
        (lambda gap=gap, ask=ask: ask(recording(), gap), "max_gap", None)
        for gap in (0, -1, none)
        for ask in (
            lambda r, gap: r.conflicts(5, max_gap=gap),
            lambda r, gap: r.closest(max_gap=gap),
            lambda r, gap: r.verify(5, max_gap=gap),
        )
    ],
    (lambda: recording(heights=[0, 1]).conflicts(5), "vertical", None),
    (lambda: recording(heights=[0, 1]).closest(), None, None),
    (lambda: recording().verify(5, max_speed=-1), "max_speed", None),
    *[
        (lambda f=f, within=within: f(two, still, 5, within=within), "within", None)
        for f in (beespace.predict, beespace.predict_pairs)
        for within in (-1, none, 1e40)
    ],
    (lambda: beespace.closest_approach(two, still, two, still, within=-1), "within", None),
    (lambda: beespace.closest_approach(two, still, two, still, vertical=5), "vertical", None),
    (lambda: beespace.nearest(two, vertical=5), "vertical", None),
    (lambda: beespace.nearest(two, inclusive=True), "inclusive", None),
    (lambda: beespace.nearest(two, within=-1), "within", None),
    (lambda: beespace.nearest(two, within="5"), "within", None),
    (lambda: beespace.nearest(two, k=2**62), "k", None),
    (lambda: beespace.pairs(two, 100, max_results=0), "max_results", None),
    (lambda: advanced(none), "now", None),
    (lambda: advanced(1e40), "now", None),
    (lambda: advanced(5, 1), "now", None),
    (lambda: beespace.Swarm(5).finish(none), "now", None),
    (lambda: beespace.Swarm(5).begin_anew(none, 0), "now", None),
    (lambda: beespace.Swarm(5).begin_anew(0, none), "then", None),
    *[
        (lambda name=name, value=value: beespace.Swarm(5, **{name: value}), name, None)
        for name in ("leave_factor", "horizon", "max_age", "max_speed", "vertical")
        for value in (-1, none, math.inf)
    ],
    (lambda: beespace.Swarm(5, heights_apart=True), "vertical", None),
    (
        lambda: beespace.Swarm(5, heights_apart=True, vertical=5).update([1, 2], 0, two),
        "heights",
        None,
    ),
    (lambda: index().insert([none, 0, 0]), "point", None),
    (lambda: index().insert([1e300, 0, 0]), "point", None),
    (lambda: index().move(0, [none, 0, 0]), "point", None),
    (lambda: index().move(9, [0, 0, 0]), "id", None),
    (lambda: index().remove(9), "id", None),
    (lambda: index()[9], "id", None),
    (lambda: index().around(two, -1), "radius", None),
    (lambda: index().around(two, none), "radius", None),
    (lambda: index().around(two, [1, -1]), "radius", 1),
    (lambda: index().around(two, 100, max_results=1), "max_results", None),
    (lambda: index().nearest(two, k=2**62), "k", None),
    *[
        (lambda name=name: verify(**{name: -1}), name, None)
        for name in ("max_speed", "max_acceleration")
    ],
    (lambda: verify(clearance=5), "clearance", None),
    (lambda: verify(**walls()), "clearance", None),
    (lambda: verify(**walls(clearance=-1)), "clearance", None),
    *[
        (lambda name=name, value=value: advise(**{name: value}), name, None)
        for name in ("max_speed", "max_acceleration", "step", "vertical", "vertical_factor",
                     "uncertainty", "clearance", "intruder_horizon", "unknown_horizon", "threshold")
        for value in (-1, none)
    ],
    (lambda: advise(**walls()), "clearance", None),
    (lambda: advise(fence_directions=[[1, 0, 0]], fence_offsets=[0]), "clearance", None),
    (lambda: advise(fence_offsets=[0], clearance=1), "fence_directions", None),
    (lambda: advise(fence_directions=[[1, 0, 0]], clearance=1), "fence_offsets", None),
    (lambda: advise(intruder_positions=two), "intruder_velocities", None),
    (
        lambda: advise(
            intruder_positions=two, intruder_velocities=still, intruder_margins=[0, -1]
        ),
        "intruder_margins",
        1,
    ),
    (lambda: beespace.velocity_to_goal(two, two, max_speed=-5), "max_speed", None),
    (lambda: beespace.velocity_to_goal(two, two, max_speed=[1, none]), "max_speed", 1),
    (lambda: beespace.velocity_to_goal(two, two, max_speed=5, step=-1), "step", None),
    *[
        (lambda name=name, value=value: guide(**{name: value}), name, None)
        for name in ("max_speed", "max_acceleration", "vertical", "vertical_factor", "clearance",
                     "intruder_horizon")
        for value in (-1, none, math.inf)
    ],
    (lambda: guide(fence_directions=[[1, 0, 0]], fence_offsets=[0]), "clearance", None),
    (lambda: guide(figures=beespace.FleetFigures(deviation=-1)), "deviation", None),
    (lambda: beespace.tube_of(beespace.FleetFigures(), max_speed=-5, max_acceleration=2),
     "max_speed", None),
    (lambda: guide(link=beespace.LinkFigures(period=-1)), "period", None),
    (lambda: guide(link=beespace.LinkFigures(command_delay=99)), "command_delay", None),
    *[
        (lambda name=name: guide().join(1, [0, 0, 0], **{name: -1}), name, None)
        for name in ("radius", "max_speed", "max_acceleration")
    ],
    *[
        (lambda name=name: guide().set_intruders(two, still, **{name: [0, -1]}), name, 1)
        for name in ("radii", "position_errors", "speed_errors")
    ],
    (lambda: guide().set_intruders([[none, 0, 0]], [[0, 0, 0]]), "positions", 0),
    (lambda: joined().step(1), "now", None),
    *[
        (lambda name=name: beespace.Follower(
            1, **{"planned_speed": 5, "planned_acceleration": 2, "period": 0.1, name: -1}
        ), name, None)
        for name in ("planned_speed", "planned_acceleration", "period")
    ],
    (lambda: beespace.OutOfCore(5), "memory", None),
    (lambda: out_of_core().add(two, heights=[0, 1]), "heights", None),
    (lambda: out_of_core().nearest(2**62), "k", None),
]  # fmt: skip


@pytest.mark.parametrize(("call", "place", "record"), CALLS)
def test_an_error_names_the_argument(call, place, record):
    with pytest.raises(beespace.BeespaceError) as caught:
        call()
    error = caught.value
    assert (error.place, error.record) == (place, record), str(error)
    assert place is None or str(error).startswith(f"{place}: " if record is None else f"{place}[")
    for name in ("options", "limits", "_bytes", "_mps", "_s must", "NULL"):
        assert name not in str(error)


@readers
def test_a_page_names_the_argument():
    for options, place in [
        ({"vertical": none}, "vertical"),
        ({"vertical": "high"}, "vertical"),
        ({"max_gap": 0}, "max_gap"),
        ({"threshold": -1}, "threshold"),
    ]:
        with pytest.raises(beespace.BeespaceError) as caught:
            beespace.report(two, **{"threshold": 5, **options})
        assert caught.value.place == place


def test_arguments_that_are_named_are_there():
    for place in {place for _, place, _ in CALLS if place is not None}:
        assert any(
            place in inspect.signature(each).parameters
            for kind in vars(beespace).values()
            if callable(kind)
            for each in [kind, *(f for f in vars(kind).values() if inspect.isfunction(f))]
        ), place


def test_the_first_of_many_that_cannot_be_is_named():
    for bad in (-1.0, math.nan, math.inf):
        speeds = np.full(1000, 5.0)
        speeds[700:] = bad
        many = np.arange(3000.0).reshape(1000, 3) * 9
        with pytest.raises(beespace.BeespaceError) as caught:
            beespace.velocity_to_goal(many, many, max_speed=speeds)
        assert (caught.value.place, caught.value.record) == ("max_speed", 700)
