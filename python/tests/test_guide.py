"""Fleets that are not exact keep their distance, whatever becomes of messages, and none is named that
keeps its figures; one that does not is named. What makes no sense is an error that says where."""

from __future__ import annotations

import gc
import pickle
import threading

import numpy as np
import pytest
from fleet_flight import FIGURES, LIMITS, LINK, Fleet

import beespace


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_fleet_keeps_its_distance_whatever_becomes_of_messages(seed):
    fleet = Fleet(8, seed)
    assert fleet.tube > 0.4
    moved = np.zeros(8)
    all_certified = 0
    for tick in range(1, 400):
        if tick == 200:
            for agent, place in zip(fleet.ids, fleet.places):
                fleet.guide.set_goal(agent, place)
        guidance, flying = fleet.tick(tick)
        assert (guidance.contract == "kept").all(), (tick, guidance.reason)
        assert len(guidance.too_close) == 0
        all_certified += bool(guidance.certified.all())
        if len(flying) < 8:
            continue
        assert fleet.closest(flying) > 1.5
        now = np.array([fleet.where(agent) for agent in fleet.ids])
        moved = np.maximum(moved, np.linalg.norm(now - fleet.places, axis=1))
    assert all_certified > 380
    assert (moved > 10).all() and moved.mean() > 20
    assert {"taken", "older"} <= fleet.replies


def test_one_that_is_blown_away_is_named_and_no_other():
    fleet = Fleet(8, 5)
    lost = fleet.ids[3]
    named = None
    for tick in range(1, 200):
        if tick == 60:
            fleet.blown[lost] = np.array([0.0, 0.0, 0.12])  # upwards, four times as fast as it may
        guidance, flying = fleet.tick(tick)
        others = guidance.agents != lost
        assert (guidance.contract[others] == "kept").all()
        assert fleet.closest([agent for agent in flying if agent != lost] or [lost, lost]) > 1.5 or (
            len(flying) < 8
        )
        if tick < 60:
            assert (guidance.contract == "kept").all()
        elif named is None and guidance.contract[~others][0] == "out":
            named = tick
            assert guidance.reason[~others][0] in ("rate", "deviation")
            assert "1 out" in repr(guidance)
    assert named is not None and named < 100
    assert guidance.deviation[~others][0] > fleet.tube


def test_one_that_falls_silent_is_doubted():
    fleet = Fleet(4, 6, loss=0.0)
    silent = fleet.ids[1]
    send = fleet.up.send
    for tick in range(1, 60):
        if tick == 30:
            fleet.up.send = lambda at, sender, message: (
                None if message.agent == silent else send(at, sender, message)
            )
        guidance, _ = fleet.tick(tick)
    which = guidance.agents == silent
    assert guidance.contract[which].tolist() == ["doubted"]
    assert guidance.reason[which].tolist() == ["silent"]
    assert (guidance.contract[~which] == "kept").all()


def test_messages_are_what_they_were_after_a_pickle():
    fleet = Fleet(3, 7)
    for tick in range(1, 30):
        guidance, _ = fleet.tick(tick)
    follower = fleet.followers[fleet.ids[0]]
    stored = follower.stored()
    for message in (*guidance.commands, stored, FIGURES, LINK, fleet.guide.tube(fleet.ids[0])):
        assert pickle.loads(pickle.dumps(message)) == message
    tube = fleet.guide.tube(fleet.ids[0])
    again = beespace.Follower(
        fleet.ids[0], tube.planned_speed, tube.planned_acceleration, LINK.period
    )
    again.restore(pickle.loads(pickle.dumps(stored)))
    assert (again.held, again.stored(), again.setpoint()) == (
        follower.held,
        stored,
        follower.setpoint(),
    )
    # A planner that is started anew adopts it.
    other = beespace.Guide(1.5, figures=FIGURES, link=LINK, epoch=2, **LIMITS)
    other.expect(fleet.ids)
    assert follower.promise(2) and not follower.promise(1)
    other.adopt(fleet.ids[0], follower.stored())
    for agent in fleet.ids[1:]:
        other.leave(agent)
    guidance = other.step(31)
    assert guidance.agents.tolist() == fleet.ids[:1]


def test_fences_intruders_and_own_figures_count():
    guide = beespace.Guide(
        2, fence_directions=[[0, 0, 1]], fence_offsets=[0.0], clearance=3, link=LINK, **LIMITS
    )
    assert guide.join(1, [0, 0, 1]).fences == (0,)
    city = beespace.Obstacles([beespace.Ground(0), beespace.Sphere((0, 0, 20), 5)])
    among = beespace.Guide(2, obstacles=city, clearance=3, link=LINK, **LIMITS)
    del city
    gc.collect()
    assert among.join(1, [0, 0, 13]).obstacles == (1,)
    assert guide.join(1, [0, 0, 10], figures=FIGURES, max_speed=3).joined
    assert guide.tube(1) == beespace.tube_of(FIGURES, LINK, max_speed=3, max_acceleration=4)
    assert not guide.may_join(2, [0, 1, 10]) and guide.may_join(-2, [0, 30, 10])
    assert guide.join(-2, [0, 30, 10], radius=0.5).joined
    guide.set_intruders([[-40, 30, 10]], [[20, 0, 0]], radii=[0.5], position_errors=[1])
    guidance = guide.step(1)
    assert guidance.agents.tolist() == [-2, 1]
    assert guidance.clear_of_intruders.tolist() == [False, True]
    assert guidance.intruder_conflicts.first.tolist() == [-2]
    assert guide.claim(-2).shape[1] == 3
    assert (guide.claim(-2) == [0, 30, 10]).all()
    # One that may be anywhere clears none.
    with pytest.raises(beespace.BeespaceError) as raised:
        guide.set_intruders([[np.nan, 0, 0]], [[0, 0, 0]])
    assert (raised.value.code, raised.value.record) == ("not_finite", 0)
    assert not guide.step(2).clear_of_intruders.any()


@pytest.mark.parametrize("agent", [3, -5, -1, -(2**63), 2**63 - 1])
def test_an_error_about_an_agent_has_its_number(agent):
    guide = beespace.Guide(2, **LIMITS)
    for call in (
        lambda: guide.leave(agent),
        lambda: guide.set_goal(agent, (0, 0, 0)),
        lambda: guide.claim(agent),
        lambda: guide.take(beespace.AgentReport(agent, 1, 1, (0, 0, 0))),
    ):
        with pytest.raises(beespace.BeespaceError, match=f"agent {agent} is not") as raised:
            call()
        assert (raised.value.place, raised.value.record) == ("agents", agent)
    # A follower, too, knows itself by that number.
    follower = beespace.Follower(agent, 6, 4, 0.1)
    other = beespace.Command(agent ^ 1, (1 << 32) + 1, 0, (beespace.BranchState((0, 0, 0), (0, 0, 0)),))
    with pytest.raises(beespace.BeespaceError, match=f"of agent {agent} with") as raised:
        follower.restore(beespace.StoredBranch(other, 1, 0))
    assert raised.value.record == agent


def _refused(call, code, place):
    with pytest.raises(beespace.BeespaceError) as raised:
        call()
    assert (raised.value.code, raised.value.place) == (code, place)


def test_what_makes_no_sense_is_refused():
    invalid = "invalid_argument"
    for change, place in (
        ({"max_acceleration": float("inf")}, "max_acceleration"),
        ({"max_speed": "fast"}, "max_speed"),
        ({"epoch": 0}, "epoch"),
        ({"threads": -1}, "threads"),
        ({"figures": beespace.FleetFigures(loop="air")}, "loop"),
        ({"figures": beespace.FleetFigures(deviation=-1)}, "deviation"),
        ({"link": beespace.LinkFigures(period=0)}, "link"),
        ({"link": beespace.LinkFigures(command_delay=33)}, "command_delay"),
        ({"fence_offsets": [0]}, "fence_directions"),
        ({"fence_directions": [[1, 0, 0]]}, "fence_offsets"),
        ({"clearance": 0}, "clearance"),
    ):
        _refused(lambda: beespace.Guide(2, **{**LIMITS, **change}), invalid, place)
    _refused(lambda: beespace.Guide(0, **LIMITS), "invalid_threshold", "threshold")
    guide = beespace.Guide(2, **LIMITS)
    _refused(lambda: guide.join(2**63, [0, 0, 0]), invalid, "agent")
    _refused(lambda: guide.join("one", [0, 0, 0]), invalid, "agent")
    _refused(lambda: guide.join(1, [0, 0, 0, 0]), invalid, "position")
    _refused(lambda: guide.join(1, [0, np.inf, 0]), "not_finite", "agents")
    assert guide.join(1, [0, 0]).joined
    _refused(lambda: guide.join(1, [9, 9, 0]), invalid, "agents")
    _refused(lambda: guide.leave(2), invalid, "agents")
    _refused(lambda: guide.set_goal(1, [np.nan, 0, 0]), "not_finite", "agents")
    _refused(lambda: guide.take(beespace.Acknowledgement(1, 5, "taken")), invalid, "agents")
    _refused(lambda: guide.take(beespace.Acknowledgement(1, 5, "maybe")), invalid, "reply")
    _refused(lambda: guide.take(beespace.AgentReport(1, -1, 0, (0, 0, 0))), invalid, "held")
    root = guide.step(5).commands[0].number
    guide.take(beespace.Acknowledgement(1, root, "taken", held=root, tick=5))
    guide.step(6)
    _refused(lambda: guide.take(beespace.AgentReport(1, 5, 6, (0, 0, 0))), invalid, "agents")
    named = guide.step(7)
    assert (named.contract.tolist(), named.reason.tolist()) == (["out"], ["no_branch"])
    _refused(lambda: guide.step(7), "time_order", "now")
    _refused(lambda: guide.step(10**18 + 1), invalid, "now")
    _refused(lambda: guide.step(0.5), invalid, "now")
    follower = beespace.Follower(1, 6, 4, 0.1)
    state = beespace.BranchState((0, 0, 0), (0, 0, 0))
    _refused(lambda: guide.take("a report"), invalid, "message")
    _refused(lambda: guide.take(beespace.Command(1, 5, 0, (state,))), invalid, "message")
    _refused(lambda: guide.adopt(1, None), invalid, "stored")
    _refused(lambda: guide.expect(5), invalid, "agents")
    _refused(lambda: follower.restore(None), invalid, "stored")
    _refused(lambda: follower.restore(beespace.StoredBranch(state, 1, 0)), invalid, "command")
    _refused(lambda: beespace.Guide(2, **LIMITS, figures=(1, 2)), invalid, "figures")
    _refused(lambda: beespace.Guide(2, **LIMITS, link=(1, 2)), invalid, "link")
    _refused(lambda: beespace.Obstacles(None), invalid, "obstacles")
    _refused(lambda: beespace.Follower(1, 6, 0, 0.1), invalid, "planned_acceleration")
    _refused(lambda: follower.setpoint(-1), invalid, "after")
    _refused(
        lambda: follower.restore(beespace.StoredBranch(None, -1, 0)), invalid, "promised"
    )


def test_whatever_comes_instead_of_a_command_is_invalid():
    state = beespace.BranchState((0, 0, 0), (0, 0, 0))
    follower = beespace.Follower(1, 6, 4, 0.1)
    follower.advance(3)
    for number, states in [
        (5, ()), (5, (state,) * 37), (2**64, (state,)), (-5, (state,)), ("5", (state,)), (5, None),
        (5, (1, 2)), (5, ((1, 2),)), (5, (("a", (0, 0, 0), (0, 0, 0)),)), (5, "states"),
    ]:  # fmt: skip
        said = follower.receive(beespace.Command(1, number, 0, states))
        assert said == beespace.Acknowledgement(1, 5 if number == 5 else 0, "invalid", 0, 3)
    for command in (None, "a command", beespace.Command(1, 5, 0.5, (state,))):
        assert follower.receive(command).reply == "invalid"


def test_errors_name_figures_as_python_does():
    for figures, said in [
        ({"deviation": 2, "correction_speed": 1, "correction_acceleration": 1},
         "deviation 2 needs correction_speed"),
        ({"deviation": 2, "correction_speed": 3}, "needs correction_acceleration above"),
        ({"report_error": -1}, "report_error: this is -1"),
        ({"correction_speed": 9}, "must be below max_speed"),
    ]:  # fmt: skip
        with pytest.raises(beespace.BeespaceError, match=said) as raised:
            beespace.tube_of(beespace.FleetFigures(**figures), max_speed=6, max_acceleration=4)
        assert "_m" not in str(raised.value).replace("must", "")


def test_threads_share_a_guide():
    guide = beespace.Guide(2, **LIMITS)
    wrong = []

    def join(first):
        for k in range(first, first + 25):
            if not guide.join(k, [10.0 * k, 0, 30]).joined or guide.claim(k)[0, 0] != 10.0 * k:
                wrong.append(k)

    threads = [threading.Thread(target=join, args=(25 * k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong and len(guide) == 100
    kept = guide.step(1).positions
    del guide
    gc.collect()
    assert kept[:, 0].tolist() == [10.0 * k for k in range(100)]
