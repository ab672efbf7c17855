"""What is compared: the swarms, the contenders, and which contender is asked what about which swarm."""

import math
from dataclasses import dataclass, replace

QUESTIONS = ("at_risk", "pairs", "nearest", "counts")

# Debian's Python: the one that Debian's SciPy belongs to.
PYTHON = "/usr/bin/python3"


@dataclass(frozen=True)
class Contender:
    program: str
    variant: str = ""
    # The largest swarm it is asked about, and the largest for anything else than at-risk.
    most_points: int = 1_000_000
    most_points_beyond_at_risk: int = 1_000_000
    # Whether it may be asked where a point has a thousand neighbours: their number, their pairs.
    counts_crowds: bool = False
    lists_crowds: bool = False
    # Whether the line charts show it.
    charted: bool = False

    @property
    def key(self):
        return f"{self.program}:{self.variant}" if self.variant else self.program


EVERY_SIZE = 1_000_000_000

OURS = Contender("beespace", "", EVERY_SIZE, EVERY_SIZE, True, True, True)
ENGINE = Contender("beespace", "engine", EVERY_SIZE, EVERY_SIZE, True, True)
TWO_THREADS = Contender("beespace", "two_threads", EVERY_SIZE, EVERY_SIZE, True, True)
PEERS = (
    Contender("nanoflann", "sorted", 10_000_000, 10_000_000, True, True, True),
    Contender("nanoflann", "", 10_000_000, counts_crowds=True),
    Contender("cgal", "", 10_000_000, counts_crowds=True, charted=True),
    Contender("boost_rtree", counts_crowds=True, charted=True),
    Contender("scipy_kdtree.py", counts_crowds=True, charted=True),
    Contender("flann", charted=True),
    Contender("pcl_kdtree", charted=True),
    Contender("pcl_octree", "", 1_000_000, 200_000, charted=True),
)
METHODS = (
    Contender("teschner_hash", counts_crowds=True, charted=True),
    Contender("paper_methods", "hash", charted=True),
    Contender("paper_methods", "kdtree"),
    Contender("paper_methods", "octree"),
)
CONTENDERS = (OURS, ENGINE, TWO_THREADS) + PEERS + METHODS
BRUTE_FORCE = Contender("brute_force")
PEER_KEYS = tuple(peer.key for peer in PEERS)


@dataclass(frozen=True)
class Swarm:
    name: str
    description: str
    points: int
    scene: tuple  # the name and numbers that compare_scene takes
    threshold_m: float
    neighbours: str = ""
    caption: str = ""  # for the pictures
    crowded: bool = False
    nearest_elsewhere: bool = False  # another swarm has the same points
    aims: tuple = ()  # (question, at most so many read floors)

    def scaled(self, points):
        """As many points as said, at the same density."""
        factor = points / self.points
        stretch = factor ** (1 / 3)
        name, *numbers = self.scene
        if name == "clusters":
            clusters, sigma, side = numbers
            numbers = [max(1, round(clusters * factor)), sigma, side * stretch]
        else:
            numbers = [number * stretch for number in numbers]
        return replace(self, points=points, scene=(name, *numbers))


MILLION = 1_000_000
SWARMS = (
    Swarm("D1, X = 100", "uniform in 3,300 × 2,300 × 480 m, X = 100 m", MILLION,
          ("uniform", 3300, 2300, 480), 100.0, "1,150", "D1: 1,150 neighbours", True, True,
          (("at_risk", 5),)),
    Swarm("D1, X = 10", "the same points, X = 10 m", MILLION, ("uniform", 3300, 2300, 480), 10.0,
          "1.1", "D1, X = 10: 1.1 neighbours", aims=(("at_risk", 18),)),
    Swarm("D2", "uniform in 66,000 × 46,000 × 9,600 m, X = 100 m", 150_000,
          ("uniform", 66000, 46000, 9600), 100.0, "0.02", "D2: sparse, 0.02",
          aims=(("at_risk", 16),)),
    Swarm("D3", "uniform in a cube of 12,800 m, X = 100 m", MILLION,
          ("uniform", 12800, 12800, 12800), 100.0, "2", "D3: 2 neighbours",
          aims=(("at_risk", 14), ("pairs", 36), ("counts", 34), ("nearest", 48))),
    Swarm("D4", "in 1,000 Gaussian clusters (sigma 200 m) in a cube of 100 km, X = 20 m",
          MILLION, ("clusters", 1000, 200, 100000), 20.0, "0.09", "D4: clusters",
          aims=(("at_risk", 16),)),
    Swarm("D5", "uniform in a cube of 27,577 m, X = 100 m", 10 * MILLION,
          ("uniform", 27577, 27577, 27577), 100.0, "2", "D5: ten million"),
)
HUGE = Swarm("100 million", "uniform in a cube of 59,413 m, X = 100 m", 100 * MILLION,
             ("uniform", 59413, 59413, 59413), 100.0, "2")

# The sizes of the charts of time against size, beside the swarm's own; the largest is asked of
# beespace only.
SIZES = (1_000, 10_000, 100_000)
OWN_SIZE = 10_000_000

# Mean neighbours of the chart of cost against density, and its size.
NEIGHBOURS = (0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 100, 300, 1000)
DENSITY_POINTS = 300_000


def cube_of_density(points, neighbours, threshold_m=100.0):
    """A cube in which a point has so many neighbours on average, far from its faces."""
    ball = 4 / 3 * math.pi * threshold_m**3
    side = (points * ball / neighbours) ** (1 / 3)
    return Swarm(f"{neighbours} neighbours", "", points, ("uniform", side, side, side), threshold_m)


# Swarms that ruin a search that counts on spread-out points.
HOSTILE_SIZES = (100_000, 1_000_000)
HOSTILE = (
    Swarm("one cell", "all in a cube of 10 m, X = 100 m", MILLION, ("uniform", 10, 10, 10), 100.0),
    Swarm("X beyond the box", "all in a cube of 100 m, X = 1,000 m", MILLION,
          ("uniform", 100, 100, 100), 1000.0),
    Swarm("one place", "all at the same place, X = 100 m", MILLION, ("duplicates", 1, 100), 100.0),
    Swarm("a thousand places", "a thousandth of them at each, in a cube of 10 km, X = 100 m",
          MILLION, ("duplicates", 1000, 10000), 100.0),
    Swarm("a line", "on the diagonal of a cube of 1,000 km, X = 1 m", MILLION, ("line", 1e6), 1.0),
    Swarm("a sheet", "in a plane of 20 × 20 km, X = 10 m", MILLION, ("uniform", 20000, 20000, 0),
          10.0),
    Swarm("clump and outlier", "all but one in a cube of 100 m, one 10⁹ m away, X = 1 m", MILLION,
          ("clump_and_outlier", 100, 1e9), 1.0),
)

# The paper's four files: bees, how much wider than the course's region, and its published means:
# parse and find in ms, memory after parsing and after finding in MiB.
PAPER_FILES = (
    (1_500, 1, (2.721, 0.199, 27.7, 32.0)),
    (100_000, 1, (213.0, 9.0, 706.0, 727.0)),
    (150_000, 20, (281.0, 51.0, 454.5, 487.0)),
    (1_000_000, 1, (2106.0, 9.0, 3891.0, 4608.0)),
)
PAPER_METHODS = ("hash", "kdtree", "octree", "beespace")


def is_asked(contender, swarm, question, questions_known):
    """Whether a contender is asked: it can answer, and it ends in this life."""
    if question not in questions_known:
        return False
    if question == "nearest" and swarm.nearest_elsewhere:
        return False
    if swarm.crowded and question == "counts" and not contender.counts_crowds:
        return False
    if swarm.crowded and question == "pairs" and not contender.lists_crowds:
        return False
    limit = (contender.most_points if question == "at_risk"
             else contender.most_points_beyond_at_risk)
    return swarm.points <= limit
