"""A fleet that is not exact, flown by a Guide and Followers: winds, errors, and messages that are lost,
late, doubled and shuffled. Where agents truly are is checked by NumPy alone."""

from __future__ import annotations

import pickle

import numpy as np

import beespace

FIGURES = beespace.FleetFigures(
    report_error=0.1,
    report_age=0.4,
    sensing_error=0.1,
    loop_period=0.02,
    loop_delay=0.1,
    deviation=0.3,
    clock_error=0.01,
    correction_acceleration=1.0,
    correction_speed=1.0,
)
LINK = beespace.LinkFigures(period=0.1, command_delay=2, longest_loss=3)
LIMITS = {"max_speed": 6.0, "max_acceleration": 4.0}
# Of an autopilot: as far as it ever is from its place, well within its tube, and how fast that changes.
WANDER, WANDER_RATE = 0.25, 0.15


class Channel:
    """Carries messages as bytes. Of each sender at most LINK.longest_loss are lost in a row."""

    def __init__(self, random, loss):
        self._random = random
        self._loss = loss
        self._lost = {}
        self._under_way = []

    def send(self, tick, sender, message):
        lost = self._lost.get(sender, 0)
        if lost < LINK.longest_loss and self._random.random() < self._loss:
            self._lost[sender] = lost + 1
            return
        self._lost[sender] = 0
        for _ in range(1 + (self._random.random() < 0.3)):
            late = int(self._random.integers(0, 2))
            self._under_way.append((tick + late, pickle.dumps(message)))

    def arrived(self, tick):
        here = [packed for at, packed in self._under_way if at <= tick]
        self._under_way = [each for each in self._under_way if each[0] > tick]
        self._random.shuffle(here)
        return [pickle.loads(packed) for packed in here]


class Fleet:
    """Agents around a circle, each of which wants to the opposite place, and back again."""

    def __init__(self, count, seed, loss=0.4, **options):
        self.random = np.random.default_rng(seed)
        self.guide = beespace.Guide(1.5, figures=FIGURES, link=LINK, **LIMITS, **options)
        self.ids = [1000 + 7 * k for k in range(count)]
        turn = np.arange(count) * 2 * np.pi / count
        self.places = np.stack([25 * np.cos(turn), 25 * np.sin(turn), 0 * turn + 30], axis=1)
        self.followers = {}
        for agent, place in zip(self.ids, self.places):
            assert self.guide.join(agent, place).joined
            self.guide.set_goal(agent, place * [-1, -1, 1])
            tube = self.guide.tube(agent)
            self.followers[agent] = beespace.Follower(
                agent, tube.planned_speed, tube.planned_acceleration, LINK.period
            )
        self.tube = tube.radius
        self.down = Channel(self.random, loss)
        self.up = Channel(self.random, loss)
        self.wander = {agent: np.zeros(3) for agent in self.ids}
        self.towards = {agent: np.zeros(3) for agent in self.ids}
        self.blown = {}  # metres per tick, beyond the figures
        self.replies = set()

    def where(self, agent, after=0.0):
        return np.array(self.followers[agent].setpoint(after).position) + self.wander[agent]

    def tick(self, tick):
        for message in self.up.arrived(tick):
            self.guide.take(message)
        guidance = self.guide.step(tick)
        for command in guidance.commands:
            self.down.send(tick, command.agent, command)
        for agent in self.ids:
            self.followers[agent].advance(tick)
        for command in self.down.arrived(tick):
            said = self.followers[command.agent].receive(command)
            self.replies.add(said.reply)
            self.up.send(tick, ("reply", command.agent), said)
        flying = [agent for agent in self.ids if self.followers[agent].held]
        for agent in flying:
            self._wander(agent)
            error = self.random.uniform(-0.05, 0.05, 3)
            report = beespace.AgentReport(
                agent, self.followers[agent].held, tick, tuple((self.where(agent) + error).tolist())
            )
            self.up.send(tick, agent, report)
        return guidance, flying

    def closest(self, agents):
        """The least distance of two true places within the tick."""
        least = np.inf
        for after in np.arange(6) / 5 * LINK.period:
            places = np.array([self.where(agent, after) for agent in agents])
            apart = np.linalg.norm(places[:, None] - places[None], axis=2)
            least = min(least, apart[np.triu_indices(len(agents), 1)].min())
        return least

    def _wander(self, agent):
        if self.random.random() < 0.1:
            to = self.random.normal(size=3)
            self.towards[agent] = to / np.linalg.norm(to) * WANDER
        way = self.towards[agent] - self.wander[agent]
        most = WANDER_RATE * LINK.period
        length = np.linalg.norm(way)
        self.wander[agent] = self.wander[agent] + way * min(1.0, most / max(length, 1e-12))
        self.wander[agent] = self.wander[agent] + self.blown.get(agent, 0.0)
        if agent in self.blown:
            self.towards[agent] = self.wander[agent]
