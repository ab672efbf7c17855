"""Runs the programs of the comparison, one process a measurement, and reads their JSON."""

import json
import subprocess
import sys
from pathlib import Path

import plan

LONGEST_RUN_S = 600


class Programs:
    def __init__(self, build, workspace):
        self._build = Path(build)
        self._workspace = Path(workspace)
        self._descriptions = {}

    def _command(self, contender):
        if contender.program.endswith(".py"):
            return [plan.PYTHON, str(Path(__file__).parent / contender.program)]
        return [str(self._build / f"compare_{contender.program}")]

    def description(self, contender):
        """What the contender says of itself, or None when it was not built or does not run."""
        if contender.key not in self._descriptions:
            self._descriptions[contender.key] = self._ask_description(contender)
        return self._descriptions[contender.key]

    def _ask_description(self, contender):
        command = self._command(contender) + ["describe"]
        if contender.variant:
            command.append(contender.variant)
        try:
            done = subprocess.run(command, capture_output=True, text=True, check=True)
        except (OSError, subprocess.CalledProcessError):
            print(f"compare: {contender.key} is not here: left out", file=sys.stderr)
            return None
        return json.loads(done.stdout)

    def make_points(self, swarm):
        """Writes the swarm's points to a file, and returns its path."""
        path = self._workspace / "points.bin"
        self.run("scene", [path, swarm.points, *swarm.scene])
        return path

    def make_text(self, bees, widening):
        path = self._workspace / "bees.csv"
        self.run("scene", [path, bees, "degrees", widening])
        return path

    def run(self, program, arguments):
        """Runs compare_<program> and returns its output; raises when it fails."""
        command = [str(self._build / f"compare_{program}"), *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    def measure(self, contender, mode, question, points, swarm):
        """One contender on one question: its row, or a row that says how it failed.

        `mode` is "keep" for the contender that sets the reference answer, "ask" for all others.
        """
        reference = self._workspace / f"{question}.reference"
        command = self._command(contender) + [
            mode, question, str(points), repr(swarm.threshold_m), str(reference)]
        if contender.variant:
            command.append(contender.variant)
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=LONGEST_RUN_S,
                                  check=False)
        except subprocess.TimeoutExpired:
            return {"failed": f"no answer within {LONGEST_RUN_S} s"}
        if done.returncode != 0:
            reason = done.stderr.strip().splitlines()
            return {"failed": reason[-1] if reason else f"ended with {done.returncode}"}
        return json.loads(done.stdout)
