"""The rows of a comparison, and the figures that are read off them."""

import plan


def median(values):
    ordered = sorted(values)
    return ordered[len(ordered) // 2]


def rounded(value):
    """Three significant digits, at most two decimals, thousands apart."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    if value >= 100:
        return f"{value:,.0f}"
    if value >= 10:
        return f"{value:.1f}"
    return f"{value:.2f}" if value >= 0.1 else f"{value:.3f}"


def thousands(number):
    return f"{number:,}"


def percent(part, whole):
    if not whole:
        return "–"
    share = 100 * part / whole
    if 0 < share < 0.1:
        return f"{share:.2g} %"
    return "100 %" if part == whole else f"{min(share, 99.99):.4g} %"


def time_of(row):
    """Milliseconds of processor time; by the wall clock where several threads share the work."""
    if row is None or "failed" in row:
        return None
    two_threads = row.get("contender") == plan.TWO_THREADS.key
    return median(row["wall_ms" if two_threads else "cpu_ms"])


class Results:
    def __init__(self, rows):
        self._rows = rows
        self.machine = next(row for row in rows if row["section"] == "machine")
        self._asked = {(row["swarm"], row["question"], row["contender"]): row
                       for row in self.rows("swarms")}

    def rows(self, section):
        return [row for row in self._rows if row["section"] == section]

    def swarm_names(self):
        asked = {swarm for swarm, _, _ in self._asked}
        return [swarm.name for swarm in plan.SWARMS if swarm.name in asked]

    def versions(self):
        seen = {}
        for row in self._rows:
            if "contender" in row and row["section"] != "check":
                seen[row["contender"]] = (row["name"], row["version"], row["use"])
        order = [contender.key for contender in plan.CONTENDERS]
        return [seen[key] for key in order if key in seen]

    def name(self, contender):
        return next((row["name"] for row in self._rows if row.get("contender") == contender),
                    contender)

    def was_asked(self, swarm, question):
        return any(key[:2] == (swarm, question) for key in self._asked)

    def points(self, swarm):
        return next(row["points"] for key, row in self._asked.items()
                    if key[0] == swarm and "points" in row)

    def is_quick(self):
        return any(self.points(swarm.name) < swarm.points for swarm in plan.SWARMS
                   if swarm.name in self.swarm_names())

    def time(self, swarm, question, contender):
        return time_of(self._asked.get((swarm, question, contender)))

    def wall(self, swarm, question, contender):
        row = self._asked.get((swarm, question, contender))
        return median(row["wall_ms"]) if row and "wall_ms" in row else None

    def memory(self, swarm, question, contender):
        row = self._asked.get((swarm, question, contender))
        return row["peak_mb"] if row and "peak_mb" in row else None

    def shown_time(self, swarm, question, contender):
        row = self._asked.get((swarm, question, contender))
        if row is None:
            return "–"
        return "failed" if "failed" in row else rounded(time_of(row))

    def shown_memory(self, swarm, question, contender):
        return rounded(self.memory(swarm, question, contender))

    def best_peer(self, swarm, question):
        """(name, ms) of the quickest of Debian's libraries, or None."""
        times = [(self.time(swarm, question, key), self.name(key)) for key in plan.PEER_KEYS]
        times = [(time, name) for time, name in times if time is not None]
        return min(times)[::-1] if times else None

    def aim(self, swarm, question):
        aims = next(dict(one.aims) for one in plan.SWARMS if one.name == swarm)
        return aims.get(question)

    def _floors(self, swarm):
        return next((row for row in self.rows("floors") if row["swarm"] == swarm), None)

    def read_floor(self, swarm, question):
        """Between the runs of our own search, which finds the points in the same places."""
        row = self._asked.get((swarm, question, plan.OURS.key), {})
        return row.get("read_floor_ms")

    def warm_read_floor(self, swarm):
        """The median over all that measured it on this swarm."""
        measured = [row["warm_read_floor_ms"] for key, row in self._asked.items()
                    if key[0] == swarm and "read_floor_ms" in row]
        floors = self._floors(swarm)
        return median(measured + ([floors["warm_read_ms"]] if floors else []))

    def write_floor(self, swarm):
        floors = self._floors(swarm)
        return floors["write_pairs_ms"] if floors and floors["pairs"] else None

    def spread_sentence(self):
        """How far the runs of one measurement lie apart, relatively: what to think of a digit."""
        spreads = sorted(
            (max(row["cpu_ms"]) - min(row["cpu_ms"])) / median(row["cpu_ms"])
            for row in self._asked.values() if len(row.get("cpu_ms", ())) > 1)
        if not spreads:
            return "unknown parts apart"
        tenth = spreads[len(spreads) * 9 // 10]
        return (f"{100 * median(spreads):.0f} % apart (more than {100 * tenth:.0f} % in a tenth of "
                "the cases)")

    def read_floor_range(self):
        return self._range_a_point((self.read_floor(swarm, question), swarm)
                                   for swarm, question, contender in self._asked
                                   if contender == plan.OURS.key)

    def warm_read_floor_range(self):
        return self._range_a_point((self.warm_read_floor(swarm), swarm)
                                   for swarm in self.swarm_names())

    def _range_a_point(self, floors):
        costs = [1e6 * floor / self.points(swarm) for floor, swarm in floors if floor is not None]
        if not costs:
            return "not measured"
        low, high = rounded(min(costs)), rounded(max(costs))
        return f"{low} ns a point" if low == high else f"{low} to {high} ns a point"

    def agreement_sentence(self):
        """Of the answers that must agree with the reference: how many there were, how many did."""
        bound = [row for row in self._rows
                 if row.get("arithmetic") in ("exact", "float64") and "spurious" in row]
        wrong = sum(1 for row in bound if row["spurious"] + row["missed"])
        return (f"{thousands(len(bound))} answers of such contenders were compared for this page; "
                f"{wrong or 'none'} differed")

    def hostile_costs(self, swarm, question):
        """Nanoseconds a point, smallest swarm first."""
        rows = [row for row in self.rows("hostile")
                if row["swarm"] == swarm and row["question"] == question and "points" in row]
        return [1e6 * time_of(row) / row["points"]
                for row in sorted(rows, key=lambda row: row["points"])]
