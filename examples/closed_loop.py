#!/usr/bin/env python3
"""Robots that fly as `beespace watch --advise` tells them: two streams that cross.

  examples/closed_loop.py COMMAND FLOWN.csv

COMMAND is the beespace command. FLOWN.csv is what was flown, for `beespace verify`.
"""

import json
import subprocess
import sys

STEP_S, STEPS, SPEED_MPS = 0.1, 250, 6.0


class Robot:
    def __init__(self, name, position, velocity):
        self.name = name
        self.position = list(position)
        self.velocity = list(velocity)

    def report(self, step):
        place = [f"{value!r}" for value in self.position + self.velocity]
        return f"{step * STEP_S!r},{self.name}," + ",".join(place) + "\n"

    def fly(self, wanted):
        """One step: the velocity changes evenly to the one that is wanted."""
        for axis in range(3):
            self.position[axis] += (self.velocity[axis] + wanted[axis]) / 2 * STEP_S
        self.velocity = list(wanted)


def advice_for(lines, effective_s):
    """What the command says from effective_s on: velocities by name, and how many are certified.
    Lines of events between robots are passed over."""
    velocities = {}
    for line in lines:
        event = json.loads(line)
        if event["event"] == "advice" and abs(event["effective_s"] - effective_s) < STEP_S / 2:
            velocity = event.get("velocity")
            if velocity:
                velocities[event["id"]] = [velocity["vx"], velocity["vy"], velocity["vz"]]
        if event["event"] == "advised" and abs(event["effective_s"] - effective_s) < STEP_S / 2:
            return velocities, event["certified"]
    sys.exit("beespace watch has ended too early")


def main():
    command, flown = sys.argv[1:]
    robots = [Robot(f"east-{k + 1}", (-60.0, 5.0 * k, 20.0), (SPEED_MPS, 0.0, 0.0)) for k in range(6)]
    robots += [Robot(f"north-{k + 1}", (5.0 * k, -60.0, 20.0), (0.0, SPEED_MPS, 0.0)) for k in range(6)]
    watch = subprocess.Popen(
        [command, "watch", "--advise", "--threshold", "2", "--max-speed", "8", "--max-acceleration",
         "4", "--step", str(STEP_S), "--horizon", "0", "--quiet"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)
    header = "time_s,id,x,y,z,vx,vy,vz\n"
    watch.stdin.write(header)
    # How many are told in all depends on how fast this machine is: where reports come late by the
    # clock of the wall, the command does not wait for them.
    told, certified = 0, []
    with open(flown, "w", encoding="utf-8") as recording:
        recording.write(header)
        for step in range(STEPS):
            for robot in robots:
                watch.stdin.write(robot.report(step))
                recording.write(robot.report(step))
            # The advice that takes effect now was made from the reports of the step before.
            velocities = {}
            if step >= 2:
                velocities, count = advice_for(watch.stdout, step * STEP_S)
                told += len(velocities)
                certified.append(count)
            for robot in robots:
                robot.fly(velocities.get(robot.name, robot.velocity))
    watch.stdin.close()
    watch.stdout.read()
    print(f"robots {len(robots)}, steps {STEPS}, {'some' if told else 'none'} told to change")
    print(f"certified from step {certified.index(len(robots)) + 2} on: "
          f"{min(certified[certified.index(len(robots)):])} of {len(robots)}")
    return watch.wait()


if __name__ == "__main__":
    sys.exit(main())
