"""The comparison with other packages finds wrong answers: what it says of right ones can be believed."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).parents[1] / "compare"))

from questions import Answer, difference, of_pairs, of_rows  # noqa: E402
from scenes import Scene  # noqa: E402

# At 0, 60 and 120 m on a line: two pairs within 100 m.
points = np.array([[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [120.0, 0.0, 0.0]])
i, j, apart = np.array([0, 1]), np.array([1, 2]), np.array([60.0, 60.0])


def test_right_answers_are_right_in_any_order() -> None:
    right = of_pairs(i, j, 3, apart)
    assert difference("pairs", of_pairs(j[::-1], i[::-1], 3, apart), right, points, 1e-9) == ""
    rows = of_rows([0, 1, 3, 4], [1, 0, 2, 1], 3)
    assert difference("neighbors", of_rows([0, 1, 3, 4], [1, 2, 0, 1], 3), rows, points, 1e-9) == ""


@pytest.mark.parametrize(
    "wrong",
    [
        of_pairs(i[:1], j[:1], 3),
        of_pairs(np.array([0, 0, 1]), np.array([1, 2, 2]), 3),
        of_pairs(np.array([0, 0, 1]), np.array([1, 1, 2]), 3),
        of_pairs(i, j, 3, apart + 0.001),
    ],
)
def test_missing_and_spurious_pairs_and_wrong_distances_are_found(wrong: Answer) -> None:
    assert difference("pairs", wrong, of_pairs(i, j, 3, apart), points, 1e-6)


def test_a_pair_at_the_threshold_may_be_decided_either_way_by_those_who_round() -> None:
    near = points.copy()
    near[2] = [160.0 + 1e-5, 0.0, 0.0]
    one, two = of_pairs(i[:1], j[:1], 3), of_pairs(i, j, 3)
    assert difference("pairs", two, one, near, 1e-4) == ""
    assert difference("pairs", two, one, near, 1e-9)


def test_wrong_flags_counts_and_nearest_are_found() -> None:
    flags = np.array([True, True, False])
    assert difference("at_risk", Answer(~flags), Answer(flags), points, 1e-9)
    assert difference("counts", Answer(np.array([1, 2])), Answer(np.array([1, 2, 1])), points, 1e-9)
    right = Answer(np.array([[1], [0], [1]]), np.full((3, 1), 60.0))
    equally_far = Answer(np.array([[1], [2], [1]]), np.full((3, 1), 60.0))
    too_far = Answer(np.array([[2], [0], [1]]), np.full((3, 1), 60.0))
    assert difference("nearest", equally_far, right, points, 1e-9) == ""
    assert difference("nearest", too_far, right, points, 1e-9)
    assert difference("nearest", Answer(right.ids, np.full((3, 1), 61.0)), right, points, 1e-9)


def test_a_scene_has_the_neighbours_that_it_says() -> None:
    scene = Scene(1_000, 2.0)
    assert scene.points * 4 / 3 * np.pi * 100.0**3 / scene.side_m**3 == pytest.approx(2.0)
    made = scene.make()
    assert made.shape == (1_000, 3) and made.min() >= 0.0 and made.max() <= scene.side_m
    assert np.array_equal(made, scene.make())
