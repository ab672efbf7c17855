"""Pictures: what is in them is what was asked for. (What they look like, people must see.)"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import beespace
from tests import oracle

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from matplotlib.collections import LineCollection, PathCollection  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Line3DCollection  # noqa: E402

data = Path(__file__).resolve().parents[2] / "examples" / "data"
cube = np.random.default_rng(4).uniform(0, 60, (80, 3))


@pytest.fixture(autouse=True)
def _no_figure_stays():
    yield
    pyplot.close("all")


def dots_of(ax):
    """The places of each set of dots, by the first word of their label that is no number."""
    dots = [each for each in ax.collections if type(each) is PathCollection]
    return {each.get_label().split(" ", 1)[1]: np.asarray(each.get_offsets()) for each in dots}


def lines_of(ax):
    [lines] = [each for each in ax.collections if type(each) is LineCollection]
    return [np.asarray(each).tolist() for each in lines.get_segments()]


def legend_of(ax):
    return [each.get_text() for each in ax.get_legend().get_texts()]


def test_points_at_risk_and_pairs_are_where_they_are():
    near = oracle.pairs(cube, 9.0)
    risky = sorted({point for pair in near for point in pair})
    calm = sorted(set(range(80)) - set(risky))
    assert near and calm
    for answer in (9.0, beespace.pairs(cube, 9.0, distances=False)):
        ax = beespace.plot(cube, answer)
        assert sorted(lines_of(ax)) == sorted([cube[i, :2].tolist(), cube[j, :2].tolist()]
                                              for i, j in near)
        dots = dots_of(ax)
        assert (dots["at risk"] == cube[risky, :2]).all()
        assert (dots["points"] == cube[calm, :2]).all()
        assert legend_of(ax) == [f"{len(near)} pairs", "80 points", f"{len(risky)} at risk"]
        assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_aspect()) == ("x [m]", "y [m]", 1.0)
    for answer in (np.array(risky), beespace.at_risk(cube, 9.0, mask=True)):
        ax = beespace.plot(cube, answer)
        assert (dots_of(ax)["at risk"] == cube[risky, :2]).all()
        assert legend_of(ax) == ["80 points", f"{len(risky)} at risk"]
    assert legend_of(beespace.plot(cube)) == ["80 points"]
    assert legend_of(beespace.plot(cube, 1e-9)) == ["80 points", "0 at risk"]


def test_in_three_dimensions_pairs_have_heights():
    near = oracle.pairs(cube, 9.0)
    ax = beespace.plot(cube, 9.0, projection="3d")
    [lines] = [each for each in ax.collections if isinstance(each, Line3DCollection)]
    assert np.array_equal(
        np.asarray(lines._segments3d), [[cube[i], cube[j]] for i, j in near]  # noqa: SLF001
    )
    assert ax.get_zlabel() == "z [m]"
    for low_high, axis in zip((ax.get_xlim(), ax.get_ylim(), ax.get_zlim()), cube.T):
        assert low_high[0] < axis.min() and axis.max() < low_high[1]
    ax.figure.canvas.draw()


def test_the_axes_that_are_given_are_drawn_on():
    figure, (left, right) = pyplot.subplots(1, 2)
    assert beespace.plot(cube, 9.0, ax=left) is left
    assert not right.collections and len(figure.axes) == 2
    solid = figure.add_subplot(projection="3d")
    assert beespace.plot(cube, ax=solid).get_zlabel() == "z [m]"
    with pytest.raises(beespace.BeespaceError) as caught:
        beespace.plot(cube, ax=left, projection="3d")
    assert caught.value.place == "ax"


def test_of_two_sets():
    near = oracle.pairs(cube[:50], 9.0, cube[50:])
    found = beespace.pairs(cube[:50], 9.0, others=cube[50:])
    for answer in (9.0, found):
        ax = beespace.plot(cube[:50], answer, others=cube[50:])
        assert lines_of(ax) == [[cube[i, :2].tolist(), cube[50 + j, :2].tolist()] for i, j in near]
        risky = sorted({i for i, _ in near})
        assert (dots_of(ax)["at risk"] == cube[risky, :2]).all()
        assert (dots_of(ax)["others"] == cube[50:, :2]).all()


def test_too_many_pairs_are_counted_and_not_drawn():
    crowd = np.zeros((500, 3))
    ax = beespace.plot(crowd, 1.0)
    assert legend_of(ax)[0] == "124,750 pairs, too many to draw"
    assert lines_of(ax) == []


@pytest.mark.skipif("not __import__('os').environ.get('BEESPACE_IO_LIBRARY')")
def test_of_a_file_in_degrees():
    bees = beespace.read(data / "bees-1000.csv")
    ax = beespace.plot(bees, 100)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("longitude [°]", "latitude [°]")
    risky = beespace.at_risk(bees, 100)
    assert (dots_of(ax)["at risk"] == bees.degrees[risky, :2]).all()
    # A degree of longitude is shorter than one of latitude.
    assert ax.get_aspect() == pytest.approx(1 / np.cos(np.radians(6.337)), abs=1e-4)
    with pytest.raises(beespace.BeespaceError, match="degrees and metres"):
        beespace.plot(bees, others=cube)


@pytest.mark.parametrize("points", [[], [[1, 2, 3]], [[1, 2]], np.zeros((3, 3), np.float32)])
@pytest.mark.parametrize("projection", [None, "3d"])
def test_few_points(points, projection):
    ax = beespace.plot(points, 1.0, projection=projection)
    ax.figure.canvas.draw()
    assert legend_of(ax)[-1].endswith(" at risk")


def test_answers_about_other_points_are_refused():
    pairs = beespace.pairs(cube, 9.0)
    between = beespace.pairs(cube, 9.0, others=cube[:7])
    for call, place in [
        (lambda: beespace.plot(cube[:40], pairs), "answer"),
        (lambda: beespace.plot(cube, between), "answer"),
        (lambda: beespace.plot(cube, pairs, others=cube), "answer"),
        (lambda: beespace.plot(cube, between, others=cube[:8]), "answer"),
        (lambda: beespace.plot(cube, np.array([80])), "answer"),
        (lambda: beespace.plot(cube, np.array([-1])), "answer"),
        (lambda: beespace.plot(cube, np.array([0.5])), "answer"),
        (lambda: beespace.plot(cube, np.ones(79, bool)), "answer"),
        (lambda: beespace.plot(cube, "near"), "threshold"),
        (lambda: beespace.plot(cube, -1.0), "threshold"),
        (lambda: beespace.plot(cube, pairs, vertical=3), None),
        (lambda: beespace.plot(cube, 5, projection="polar"), "projection"),
        (lambda: beespace.plot(cube * np.nan), "points"),
    ]:
        with pytest.raises(beespace.BeespaceError) as caught:
            call()
        assert caught.value.place == place, str(caught.value)
