"""What the assignment's program shows and tells, command by command."""

import matplotlib
import numpy as np
import pytest

from pilotage import Policy
from pilotage.simulate.problem_file import parse_problem
from pilotage.studies.assignment_filter import Moved, Sensed, commanded
from pilotage.studies.assignment_frames import draw, frames, world_figure
from pilotage.studies.assignment_problems import find_problem
from support.artists import artist, has

ROOM = """
boundary 0,0 8,0 8,6 0,6
start 2 2 0
commandDstSigmaRatio 0.05
commandAngSigmaRatio 0.05
rangeSigmaRatio 0.01
"""


def steps_of(problem, seed=1, **how):
    return list(commanded(problem, np.random.default_rng((seed, 0)), **how))


@pytest.fixture
def handout():
    problem = find_problem("handout")
    steps = steps_of(problem)
    return problem, steps, list(frames(problem, steps))


def test_a_move_is_one_picture_and_a_sense_two(handout):
    _, steps, pictures = handout
    assert [type(step) for step in steps] == [Moved, Moved, Sensed]
    assert [picture.beam is not None for picture in pictures] == [False, False, False, True, False]


def test_uncertainty_starts_at_zero(handout):
    problem, _, pictures = handout
    assert (pictures[0].belief.covariance == 0).all()
    np.testing.assert_array_equal(pictures[0].truth, problem.start)


def test_the_beam_shows_the_measured_range_from_the_estimate_as_it_stood(handout):
    _, steps, pictures = handout
    seen = pictures[3]
    assert seen.beam == (np.pi / 2, steps[2].range_m)
    np.testing.assert_array_equal(seen.belief.state, steps[1].after.state)


def test_the_revised_estimate_moves_the_paths_last_point(handout):
    _, steps, pictures = handout
    assert [len(picture.path) for picture in pictures] == [1, 2, 3, 3, 3]
    np.testing.assert_array_equal(pictures[3].path[-1], steps[1].after.state[:2])
    np.testing.assert_array_equal(pictures[4].path[-1], steps[2].after.state[:2])
    np.testing.assert_array_equal(pictures[4].path[:-1], pictures[3].path[:-1])
    assert (pictures[4].path[-1] != pictures[3].path[-1]).any()


def test_the_picture_has_all_that_the_assignment_asks_for(handout):
    problem, _, pictures = handout
    _, axes = world_figure(problem)
    draw(axes, problem, pictures[3])
    for gid in ("robot", "reference", "ellipse", "cone", "path", "truth", "beam"):
        assert has(axes, gid), gid
    state, (angle, reach) = pictures[3].belief.state, pictures[3].beam
    beam = np.column_stack(artist(axes, "beam").get_data())
    np.testing.assert_allclose(beam[0], state[:2])
    assert np.hypot(*(beam[1] - beam[0])) == pytest.approx(reach)
    assert np.arctan2(*(beam[1] - beam[0])[::-1]) % (2 * np.pi) == pytest.approx(
        (state[2] + angle) % (2 * np.pi)
    )
    cone = artist(axes, "cone")
    sigma = np.degrees(np.sqrt(pictures[3].belief.covariance[2, 2]))
    assert cone.theta2 - cone.theta1 == pytest.approx(4 * sigma)
    (x, *_), (y, *_) = artist(axes, "truth").get_data()
    np.testing.assert_allclose([x, y], pictures[3].truth[:2])
    draw(axes, problem, pictures[4])
    assert not has(axes, "beam")


def test_the_narrative_has_the_handouts_lines(handout):
    _, steps, pictures = handout
    told = [picture.text for picture in pictures]
    assert "==>The robot moved: distance=1.75, angle=90" in told[1]
    for words in (
        "Current state estimate is (x, y, th) = (-0.6, -1.25, 0)",
        "New state estimate is (x, y, theta) = (1.15, -1.25, 90)",
        "New state covariance matrix is:\n[[0.00275625 0 0]\n[0 0 0]\n[0 0 0.0061685]]",
        "True state is (x, y, th) = (",
        "Uncertainty ellipse is:\n  minor radius is 0\n  major radius is 0.130283\n"
        "  orientation is 0 degrees\n  2*sigma_theta is 9 degrees",
    ):
        assert words in told[1]
    for words in (
        "==>Commanding the robot to sense at an angle of 90",
        f"The range is {steps[2].range_m:g}",
        "The predicted range was 2\n",
        "dh/dx = 0, dh/dy = 1, dh/dth = 0",
    ):
        assert words in told[3]
    assert "Revised state estimate: (x, y, theta) = (" in told[4]
    assert "Revised covariance matrix is:" in told[4]


@pytest.mark.parametrize(
    ("start", "commands", "words"),
    [
        ("start 2 2 0", "move 9 0\nsense 0", "the range finder meets no wall"),
        ("start 1 0.1 0", "sense -2", "from the estimate, the beam meets no wall, or grazes one"),
    ],
)
def test_a_range_that_is_not_used_is_told_with_its_reason(start, commands, words):
    problem = parse_problem(ROOM.replace("start 2 2 0", start) + commands, "x")
    pictures = list(frames(problem, steps_of(problem)))
    assert f"The range is not used: {words}." in pictures[-1].text
    assert (pictures[-1].belief.state == pictures[-2].belief.state).all()


def test_a_gated_range_is_told():
    problem = find_problem("divergence")
    told = "".join(
        picture.text
        for seed in range(5)
        for picture in frames(problem, steps_of(problem, seed, policy=Policy.gate(0.001)))
    )
    assert "The range is not used: it is too far from the prediction." in told


def test_a_robot_in_the_wall_is_told():
    problem = parse_problem(ROOM + "move 9 0", "x")
    *_, last = frames(problem, steps_of(problem))
    assert "drove through a wall" in last.text


def test_drawing_does_not_touch_matplotlibs_state(handout):
    before = dict(matplotlib.rcParams)
    problem, _, pictures = handout
    _, axes = world_figure(problem)
    draw(axes, problem, pictures[-1])
    assert dict(matplotlib.rcParams) == before
