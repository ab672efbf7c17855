"""What takes positions asks in which frame they are: z of degrees is no height, and metres of one frame
are not those of another. A question that does not ask would answer that all is clear."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest

import beespace
from beespace.compat.scipy import KDTree
from tests.test_reading import readers


class Degrees(np.ndarray):
    frame = "wgs84"


class Metres(np.ndarray):
    frame = "metres"


# 55.6 m apart, at one height.
LON, LAT, HEIGHT = np.array([8.0, 8.0]), np.array([45.0, 45.0005]), np.array([500.0, 500.0])
PLACES = np.asarray(beespace.to_ecef(LON, LAT, HEIGHT))  # which does not say in which frame it is
degrees, metres = PLACES.view(Degrees), PLACES.view(Metres)
still = np.zeros((2, 3))
limits = {"max_speed": 5.0, "max_acceleration": 2.0}


def recording(places, **more):
    return beespace.Recording([1, 2], [0, 0], places, **more)


def out_of_core(*parts, **more):
    search = beespace.OutOfCore("100 MB", **more)
    for part in parts:
        search.add(part)
    return search


def advise(places, **more):
    return beespace.Adviser().advise(places, still, still, 100, **limits, **more)


def report_to(places, **options):
    swarm = beespace.Swarm(100, **options)
    swarm.update([1, 2], 0, places, still)
    return swarm.advance(0)


def tell(places, **options):
    beespace.Guide(3, **limits, **options).set_intruders(places, still)


def approach(places, others=PLACES, **more):
    return beespace.closest_approach(places, still, others, still, **more)


# Questions about positions of which z is the height, and the argument that says so.
UPRIGHT = [
    *[
        (lambda p, ask=ask: getattr(on, ask)(p, 100, vertical=30), "vertical")
        for on in (beespace, beespace.Engine())
        for ask in ("at_risk", "pairs", "iter_pairs", "neighbors", "count", "groups")
    ],
    (lambda p: beespace.at_risk(PLACES, 100, others=p, vertical=30), "vertical"),
    (lambda p: beespace.nearest(p, within=100, vertical=30), "vertical"),
    *[
        (lambda p, on=on: on.predict(p, still, 100, within=60, vertical=30), "vertical")
        for on in (beespace, beespace.Engine())
    ],
    (lambda p: beespace.predict_pairs(p, still, 100, within=60, vertical=30), "vertical"),
    (lambda p: approach(p, threshold=100, vertical=30), "vertical"),
    (lambda p: approach(PLACES, p, threshold=100, vertical=30), "vertical"),
    (lambda p: recording(p).conflicts(100, vertical=30), "vertical"),
    (lambda p: report_to(p, vertical=30), "vertical"),
    (lambda p: out_of_core(p).at_risk(100, vertical=30), "vertical"),
    (lambda p: out_of_core(p).count(100, vertical=30), "vertical"),
    (lambda p: list(out_of_core(p).iter_pairs(100, vertical=30)), "vertical"),
    (lambda p: out_of_core(p, [[0, 0, 0]]).at_risk(100, vertical=30), "vertical"),
    (lambda p: out_of_core([[0, 0, 0]], p).at_risk(100, vertical=30), "vertical"),
    (lambda p: advise(p, vertical=30), "vertical"),
    (lambda p: advise(p, vertical_factor=3), "vertical_factor"),
    (lambda p: advise(p, planar=True), "planar"),
    (
        lambda p: advise(
            PLACES, vertical=30, intruder_positions=p, intruder_velocities=still
        ),
        "vertical",
    ),
    (lambda p: tell(p, vertical=30), "vertical"),
    (lambda p: tell(p, vertical_factor=3), "vertical_factor"),
    (lambda p: tell(p, planar=True), "planar"),
]


@pytest.mark.parametrize(("ask", "argument"), UPRIGHT)
def test_z_of_degrees_is_no_height(ask, argument):
    with pytest.raises(beespace.BeespaceError, match="is not a height") as caught:
        ask(degrees)
    assert caught.value.place == argument
    ask(metres)


def refuses(places):
    try:
        beespace.at_risk(places, 100, vertical=30)
    except beespace.BeespaceError as error:
        assert "is not a height" in str(error)
        return True
    return False


def test_rows_of_positions_know_their_frame_and_what_is_computed_does_not():
    places = beespace.to_ecef(LON, LAT, HEIGHT)
    for rows in (
        places, places[:1], places[[1, 0]], places[places[:, 0] > 0], places.copy(), places[::-1],
        copy.deepcopy(places), pickle.loads(pickle.dumps(places)),
        beespace.to_ecef(LON, LAT, HEIGHT, velocities=still)[0],
    ):  # fmt: skip
        assert refuses(rows)
    turned = places - places[0]
    places += 0.0
    for computed in (turned, places @ np.eye(3), np.asarray(places), np.add(places, 1, out=turned)):
        assert type(computed) is np.ndarray
        assert not refuses(computed)
    assert repr(places) == repr(np.asarray(places))


def test_heights_that_are_apart_are_heights():
    flat = beespace.to_ecef(LON, LAT, 0.0).view(Degrees)
    assert len(recording(flat, heights=HEIGHT).conflicts(100, vertical=30)) == 1
    search = beespace.OutOfCore("100 MB")
    search.add(flat, heights=HEIGHT)
    assert search.at_risk(100, vertical=30).tolist() == [0, 1]
    swarm = beespace.Swarm(100, vertical=30, heights_apart=True)
    swarm.update([1, 2], 0, flat, still, heights=HEIGHT)
    assert swarm.advance(0).kind.tolist() == ["entered"]


def index_of(places):
    return beespace.Index(places)


def verifier_of(first, second):
    verifier = beespace.Verifier(10, straight=True)
    verifier.add(0, first)
    verifier.add(1, second)


def swarm_of(first, second):
    swarm = beespace.Swarm(10)
    swarm.update([1, 2], 0, first)
    swarm.update([1, 2], 1, second)


def guide_of(first, second):
    guide = beespace.Guide(3, **limits)
    guide.set_intruders(first, still)
    guide.set_intruders(second, still)


def joined(first, second):
    guide = beespace.Guide(3, **limits)
    guide.join(1, first[0])
    guide.join(2, second[1])


def with_goal(first, second):
    guide = beespace.Guide(3, **limits)
    guide.join(1, first[0])
    guide.set_goal(1, second[1])


def intruded(first, second):
    guide = beespace.Guide(3, **limits)
    guide.join(1, first[0])
    guide.set_intruders(second, still)


def restored(first, second):
    pickle.loads(pickle.dumps(KDTree(first))).query(second)


# Positions that are compared with each other.
TWO = [
    joined,
    with_goal,
    intruded,
    restored,
    lambda a, b: KDTree(a).query(b),
    lambda a, b: KDTree(a).query(b[0]),
    lambda a, b: KDTree(a).query_ball_point(b, 10),
    lambda a, b: KDTree(a).query_ball_point(b[0], 10),
    lambda a, b: KDTree(a).query_ball_tree(KDTree(b), 10),
    lambda a, b: KDTree(a).count_neighbors(KDTree(b), 10),
    lambda a, b: KDTree(a).sparse_distance_matrix(KDTree(b), 10),
    lambda a, b: beespace.at_risk(a, 10, others=b),
    lambda a, b: beespace.nearest(a, others=b),
    lambda a, b: beespace.closest_pair(a, others=b),
    lambda a, b: index_of(a).around(b, 10),
    lambda a, b: index_of(a).around(b, [10, 10]),
    lambda a, b: index_of(a).nearest(b),
    lambda a, b: index_of(a).insert(b[0]),
    lambda a, b: index_of(a).move(0, b[0]),
    approach,
    lambda a, b: out_of_core(a, b),
    lambda a, b: out_of_core(a, [[0, 0, 0]], b),
    lambda a, b: out_of_core([[0, 0, 0]], a, b),
    lambda a, b: beespace.velocity_to_goal(a, b, max_speed=5),
    lambda a, b: advise(a, intruder_positions=b, intruder_velocities=still),
    lambda a, b: advise(a, unknown_centers=b, unknown_radii=[1, 1], unknown_growths=[1, 1]),
    lambda a, b: advise(
        PLACES, intruder_positions=a, intruder_velocities=still, claim_places=b,
        claim_indptr=[0, 1, 2],
    ),
    verifier_of,
    swarm_of,
    guide_of,
]  # fmt: skip


@pytest.mark.parametrize("ask", TWO)
@pytest.mark.parametrize(("first", "second"), [(degrees, metres), (metres, degrees)])
def test_metres_of_two_frames_are_not_compared(ask, first, second):
    with pytest.raises(beespace.BeespaceError, match=r"are in .* and these in"):
        ask(first, second)
    ask(first, first)
    ask(first, np.asarray(second))


def test_a_swarm_forgets_its_frame_with_its_agents():
    swarm = beespace.Swarm(10)
    swarm.update([1, 2], 0, degrees)
    swarm.finish(0)
    swarm.update([1, 2], 0, metres)


@pytest.mark.parametrize(
    "obstacle",
    [
        beespace.Ground(0),
        beespace.Cylinder(0, 0, 1),
        beespace.Prism([(0, 0), (4, 0), (0, 3)]),
    ],
)
def test_nothing_stands_upright_beside_degrees(obstacle):
    obstacles = beespace.Obstacles([beespace.Sphere((0, 0, 0), 1), obstacle])
    stands = {"obstacles": obstacles, "clearance": 10}
    verifier = beespace.Verifier(5, straight=True, **stands)
    ids, times = [1, 2, 1, 2], [0, 0, 1, 1]
    twice = np.concatenate([PLACES, PLACES])
    for ask in (
        lambda p: verifier.add(0, p[:2]),
        lambda p: beespace.verify(ids, times, p, 5, **stands),
        lambda p: beespace.Recording(ids, times, p).verify(5, **stands),
        lambda p: advise(p[:2], **stands),
        lambda p: tell(p[:2], **stands),
    ):
        with pytest.raises(beespace.BeespaceError, match="stands upright") as caught:
            ask(twice.view(Degrees))
        assert (caught.value.place, caught.value.record) == ("obstacles", 1)
        ask(twice.view(Metres))
    sphere = beespace.Obstacles([beespace.Sphere(PLACES[0], 1)])
    verdict = beespace.verify(ids, times, twice.view(Degrees), 5, obstacles=sphere, clearance=10)
    assert verdict.clearance_loss_count


def test_parts_of_two_axes_do_not_go_with_parts_of_three():
    for parts in ([[0, 0]], [[0, 0, 50]]), ([[0, 0, 50]], [[0, 0]]):
        search = out_of_core(parts[0])
        for more in (search.add, search.refer):
            with pytest.raises(beespace.BeespaceError, match="axes") as caught:
                more(parts[1])
            assert caught.value.place == "points"
        assert len(search) == 1 and not len(search.at_risk(10))


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "two.csv"
    path.write_text("id,lon,lat,height\na,8,45,500\nb,8,45.0005,500\n")
    return path


@readers
@pytest.mark.parametrize(("ask", "argument"), UPRIGHT)
def test_points_of_a_file_in_degrees_have_no_heights(ask, argument, file):
    points = beespace.read(file)
    for given in (points, points.positions, points.positions[::-1]):
        with pytest.raises(beespace.BeespaceError, match="is not a height") as caught:
            ask(given)
        assert caught.value.place == argument


@readers
def test_a_recording_of_a_file_knows_its_frame(tmp_path):
    path = tmp_path / "flown.csv"
    rows = [f"{id},{time},{lon},45,500" for time in (0, 1) for id, lon in (("b", 8), ("a", 8.0005))]
    path.write_text("\n".join(["id,time,lon,lat,height", *rows]) + "\n")
    flown = beespace.read_recording(path, time_unit="s")
    made = beespace.Recording.from_file(flown)
    plain = beespace.Recording(flown.ids[flown.agents], flown.times, flown.positions)
    assert repr(made) == repr(plain) == "<beespace.Recording: 4 fixes of 2 agents, 0 to 1 s>"
    for asked in (made, plain):
        found = asked.conflicts(100)
        assert (found.i.tolist(), found.j.tolist()) == (["a"], ["b"])
    for asked in (made, plain):
        with pytest.raises(beespace.BeespaceError, match="is not a height"):
            asked.conflicts(100, vertical=30)
    assert refuses(flown.positions) and refuses(flown.movers().positions)
    ground = beespace.Obstacles([beespace.Ground(0)])
    with pytest.raises(beespace.BeespaceError, match="stands upright"):
        made.verify(5, obstacles=ground, clearance=10)
    lon, lat, height = flown.degrees.T
    apart = beespace.Recording(
        flown.ids[flown.agents], flown.times, beespace.to_ecef(lon, lat, 0), heights=height
    )
    assert len(apart.conflicts(100, vertical=30)) == 1


@readers
def test_a_recording_of_a_file_is_made_of_nothing_else():
    cage = beespace.read_recording("../examples/data/cage.csv")
    assert len(beespace.Recording.from_file(cage)) == len(cage)
    bees = beespace.read("../examples/data/swarm.csv")
    with pytest.raises(beespace.BeespaceError, match="read_recording") as caught:
        beespace.Recording.from_file(bees)
    assert caught.value.place == "recording"
    with pytest.raises(beespace.BeespaceError, match=r"Recording\.from_file"):
        beespace.Recording(cage.ids[cage.agents], cage.times, cage)
