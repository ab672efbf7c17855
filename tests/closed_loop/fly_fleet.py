#!/usr/bin/env python3
"""Flies a fleet of real processes: one `beespace guide`, a `beespace follow` for each agent, and
between them a relay that delays, loses, doubles and reorders lines in both directions. Followers
and the guide are killed on the way and started again. Checks from where the followers say to be
that no two come closer than the threshold and twice the tube, and that all arrive.

  tests/closed_loop/fly_fleet.py COMMAND [--agents 12] [--ticks 400] [--seed 1] [--loss 0.2] ...

Time is that of tick messages, so that a seed flies the same way again; with --wall it is the clock.
With --record the flight and what the guide said are kept, to be looked at:

  beespace view FOLDER/flown.csv --fleet-log FOLDER/fleet.ndjson --threshold 2

Exit status 0: all holds; 1: it does not, and what is said.
"""

import argparse
import heapq
import itertools
import json
import math
import os
import random
import select
import subprocess
import sys
import tempfile
import time

PERIOD_S = 0.1
THRESHOLD_M = 2.0


class Process:
    """A program at the two ends of its pipes."""

    def __init__(self, words):
        self.words = words
        self.program = subprocess.Popen(
            words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
        os.set_blocking(self.program.stderr.fileno(), False)
        os.set_blocking(self.program.stdout.fileno(), False)
        self.buffer = b""
        self.errors = b""

    def send(self, text):
        self.program.stdin.write(text.encode())
        self.program.stdin.flush()

    def read_errors(self):
        self.errors += self.program.stderr.read() or b""

    def lines_there_are(self, patience_s=0.0):
        select.select([self.program.stdout], [], [], patience_s)
        block = self.program.stdout.read()
        self.read_errors()
        if block == b"":
            raise RuntimeError(f"{self.words[1]} ended: {self.errors.decode()}")
        *whole, self.buffer = (self.buffer + (block or b"")).split(b"\n")
        return whole

    def lines_until(self, is_last):
        """All lines up to and with the one that ends a tick."""
        found = []
        until = time.monotonic() + 30.0
        while time.monotonic() < until:
            for line in self.lines_there_are(1.0):
                message = json.loads(line)
                found.append((line, message))
                if is_last(message):
                    return found
        raise RuntimeError(f"{self.words[1]} says nothing: {self.errors.decode()}")

    def kill(self):
        self.program.kill()
        self.program.wait()
        for end in (self.program.stdin, self.program.stdout, self.program.stderr):
            try:
                end.close()
            except BrokenPipeError:
                pass

    def finish(self):
        self.program.stdin.close()
        os.set_blocking(self.program.stdout.fileno(), True)
        os.set_blocking(self.program.stderr.fileno(), True)
        self.program.stdout.read()
        self.errors += self.program.stderr.read() or b""
        return self.program.wait(timeout=60)


class Relay:
    """Lines on their way: lost, doubled, late, and so out of order."""

    def __init__(self, chance, loss, most_delay, longest_loss):
        self.chance = chance
        self.loss = loss
        self.most_delay = most_delay
        self.longest_loss = longest_loss
        self.on_the_way = []
        self.lost_in_a_row = {}
        self.count = itertools.count()
        self.lost = self.doubled = self.passed = 0

    def put(self, now, key, line):
        run = self.lost_in_a_row.get(key, 0)
        if run < self.longest_loss and self.chance.random() < self.loss:
            self.lost_in_a_row[key] = run + 1
            self.lost += 1
            return
        self.lost_in_a_row[key] = 0
        copies = 2 if self.chance.random() < 0.1 else 1
        self.doubled += copies - 1
        for _ in range(copies):
            due = now + self.chance.randint(0, self.most_delay)
            heapq.heappush(self.on_the_way, (due, self.chance.random(), next(self.count), key, line))
        self.passed += 1

    def due(self, now):
        while self.on_the_way and self.on_the_way[0][0] <= now:
            _, _, _, key, line = heapq.heappop(self.on_the_way)
            yield key, line


class Record:
    """What was flown, as the followers say, and what the guide said; or nothing, without a folder."""

    def __init__(self, folder):
        self.flown = self.said = None
        if not folder:
            return
        os.makedirs(folder, exist_ok=True)
        self.flown = open(os.path.join(folder, "flown.csv"), "w", encoding="ascii")
        self.said = open(os.path.join(folder, "fleet.ndjson"), "wb")
        self.flown.write("time_s,id,x,y,z,vx,vy,vz\n")

    def fly(self, name, setpoint):
        if self.flown and setpoint["held"] is not None:
            numbers = [*setpoint["position"], *setpoint["velocity"]]
            time_s = f"{setpoint['tick'] * PERIOD_S:.1f}"
            self.flown.write(",".join([time_s, name, *map(repr, numbers)]) + "\n")

    def say(self, line):
        if self.said:
            self.said.write(line + b"\n")

    def close(self):
        for file in filter(None, (self.flown, self.said)):
            file.close()


class Fleet:
    def __init__(self, options, folder):
        self.options = options
        self.record = Record(options.record)
        self.folder = folder
        self.chance = random.Random(options.seed)
        self.names = [f"bee-{i}" for i in range(options.agents)]
        self.places = self.lattice()
        goals = list(self.places)
        self.chance.shuffle(goals)
        self.goals = dict(zip(self.names, goals))
        most = options.most_delay
        self.down = Relay(self.chance, options.loss, most, options.longest_loss)
        self.up = Relay(self.chance, options.loss, most, options.longest_loss)
        self.at = {}
        self.closest_m = math.inf
        self.statuses = {}
        self.named = set()
        self.joined = set()
        self.guide = None
        self.tube_m = 0.0
        self.planned = (0.0, 0.0)
        self.start_guide()
        self.followers = {name: self.start_follower(name) for name in self.names}

    def lattice(self):
        side = math.ceil(self.options.agents ** (1 / 3))
        places = itertools.product(range(side), repeat=3)
        gap_m = 3.0 * THRESHOLD_M
        return [[gap_m * c for c in place] for place in itertools.islice(places, self.options.agents)]

    def start_guide(self):
        o = self.options
        words = [o.command, "guide", "--threshold", str(THRESHOLD_M), "--period", str(PERIOD_S)]
        words += ["--max-speed", "10", "--max-acceleration", "5"]
        words += ["--command-delay", str(o.command_delay), "--longest-loss", str(o.longest_loss)]
        words += ["--report-age", str((o.most_delay + 2) * PERIOD_S)]
        words += ["--deviation", "0.2", "--sensing-error", "0.05", "--report-error", "0.05"]
        words += ["--correction-acceleration", "1.5", "--correction-speed", "1.5"]
        words += ["--store", os.path.join(self.folder, "fleet.ndjson")]
        words += [] if o.wall else ["--ticks-from-input"]
        words += ["--status", "all"] if o.record else []
        self.guide = Process(words)
        text = b""
        while b"--planned-acceleration" not in text:
            select.select([self.guide.program.stderr], [], [], 10.0)
            block = self.guide.program.stderr.read()
            if block == b"":
                raise RuntimeError(f"guide ended: {text.decode()}")
            text += block or b""
        said = text.decode().split()
        self.intro = text.decode()
        self.planned = (said[said.index("--planned-speed") + 1],
                        said[said.index("--planned-acceleration") + 1])

    def start_follower(self, name):
        place = self.places[self.names.index(name)]
        words = [self.options.command, "follow", "--agent", name, "--period", str(PERIOD_S)]
        words += ["--planned-speed", self.planned[0], "--planned-acceleration", self.planned[1]]
        words += ["--start", ",".join(map(str, place)), "--simulated", "--setpoints"]
        words += ["--store", os.path.join(self.folder, name + ".json")]
        words += [] if self.options.wall else ["--ticks-from-input"]
        return Process(words)

    def tell_goals(self):
        for name, goal in self.goals.items():
            self.guide.send(json.dumps({"event": "goal", "id": name, "position": goal}) + "\n")

    def note_from_follower(self, now, name, line, message):
        if message["event"] == "setpoint":
            self.record.fly(name, message)
            if message["held"] is not None:
                self.at[name] = message["position"]
        else:
            self.up.put(now, (name, "up"), line.decode() + "\n")

    def note_from_guide(self, now, line, message):
        event = message["event"]
        self.record.say(line)
        if event in ("command", "hello"):
            self.down.put(now, (message["id"], "down"), line.decode() + "\n")
        elif event == "joined":
            self.tube_m = max(self.tube_m, message["tube_m"])
            # An agent that has not joined is not known to the guide: until then all stand.
            if message["joined"]:
                self.joined.add(message["id"])
                if len(self.joined) == len(self.names):
                    self.tell_goals()
        elif event == "status":
            self.statuses[message["id"]] = message
            if message["contract"] == "out":
                self.named.add((message["id"], message["reason"]))
        elif event == "refused" and self.options.verbose:
            print(line.decode())

    def check(self):
        for one, other in itertools.combinations(self.at.values(), 2):
            self.closest_m = min(self.closest_m, math.dist(one, other))

    def tick(self, now):
        tick = json.dumps({"event": "tick", "tick": now}) + "\n"
        for (name, _), line in self.down.due(now):
            if name in self.followers:
                self.followers[name].send(line)
        for follower in self.followers.values():
            follower.send(tick)
        for name, follower in self.followers.items():
            last = lambda m: m["event"] == "setpoint" and m["tick"] == now
            for line, message in follower.lines_until(last):
                self.note_from_follower(now, name, line, message)
        self.check()
        if self.guide is None:
            list(self.up.due(now))
            return
        for _, line in self.up.due(now):
            self.guide.send(line)
        self.guide.send(tick)
        last = lambda m: m["event"] == "ticked" and m["tick"] == now
        for line, message in self.guide.lines_until(last):
            self.note_from_guide(now, line, message)

    def arrived(self):
        return sum(name in self.at and math.dist(self.at[name], self.goals[name]) < 0.5
                   for name in self.names)

    def fly(self):
        """Kills on the way: a follower, for a few ticks; the guide, for some more."""
        killed = self.names[0]
        for now in range(1, self.options.ticks + 1):
            if self.options.kills and now == 75:
                self.followers.pop(killed).kill()
                self.at.pop(killed, None)
            if self.options.kills and now == 80:
                self.followers[killed] = self.start_follower(killed)
            if self.options.kills and now == 95:
                self.guide.kill()
                self.guide = None
            if self.options.kills and now == 101:
                self.joined.clear()
                self.start_guide()
            self.tick(now)
            if now > 120 and self.arrived() == len(self.names):
                return now
        return self.options.ticks

    def fly_by_clock(self, seconds):
        """The same by the clock: lines pass as they come, after their delays."""
        begin = time.monotonic()
        goal_at = 0.0
        while (now_s := time.monotonic() - begin) < seconds:
            now = int(now_s / PERIOD_S)
            for name, follower in self.followers.items():
                for line in follower.lines_there_are():
                    self.note_from_follower(now, name, line, json.loads(line))
            for line in self.guide.lines_there_are(0.005):
                self.note_from_guide(now, line, json.loads(line))
            for (name, _), line in self.down.due(now):
                self.followers[name].send(line)
            for _, line in self.up.due(now):
                self.guide.send(line)
            self.check()
            if now_s > goal_at and self.arrived() == len(self.names):
                goal_at = now_s + 5.0
                goals = list(self.goals.values())
                self.chance.shuffle(goals)
                self.goals = dict(zip(self.names, goals))
                self.tell_goals()
        return int(seconds / PERIOD_S)

    def finish(self):
        codes = [process.finish() for process in [self.guide, *self.followers.values()]]
        self.record.close()
        return codes


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("command")
    parser.add_argument("--agents", type=int, default=12)
    parser.add_argument("--ticks", type=int, default=600)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--loss", type=float, default=0.2)
    parser.add_argument("--longest-loss", type=int, default=4)
    parser.add_argument("--most-delay", type=int, default=2)
    parser.add_argument("--command-delay", type=int, default=4)
    parser.add_argument("--kills", action="store_true")
    parser.add_argument("--wall", type=float, default=0.0, help="seconds by the clock")
    parser.add_argument("--record", metavar="FOLDER", help="where to keep the flight")
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()

    with tempfile.TemporaryDirectory() as folder:
        fleet = Fleet(options, folder)
        begin = time.monotonic()
        ticks = fleet.fly_by_clock(options.wall) if options.wall else fleet.fly()
        took_s = time.monotonic() - begin
        codes = fleet.finish()
        errors = fleet.guide.errors.decode()

    needed_m = THRESHOLD_M + 2.0 * fleet.tube_m
    problems = []
    # Between ticks of the clock, positions that are compared are of different moments.
    slack_m = 2.5 if options.wall else 1e-9
    if fleet.closest_m < needed_m - slack_m:
        problems.append(f"two came to {fleet.closest_m} m, nominal, and {needed_m} m were promised")
    if not options.wall and fleet.arrived() < options.agents:
        problems.append(f"{fleet.arrived()} of {options.agents} arrived")
    if fleet.named:
        problems.append(f"named, and none broke its contract: {sorted(fleet.named)}")
    if any(codes):
        problems.append(f"exit statuses {codes}")
    if options.verbose:
        print(fleet.intro + errors, end="")
    print(f"{options.agents} agents, {ticks} ticks, {took_s:.1f} s: {fleet.arrived()} arrived, "
          f"closest {fleet.closest_m:.3f} m (needed {needed_m:.3f}), tube {fleet.tube_m:.3f} m; "
          f"down {fleet.down.lost} lost of {fleet.down.lost + fleet.down.passed}, "
          f"{fleet.down.doubled} doubled; up {fleet.up.lost} of "
          f"{fleet.up.lost + fleet.up.passed}; named {sorted(fleet.named)}")
    for problem in problems:
        print("fly_fleet: " + problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
