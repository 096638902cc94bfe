"""The robot that does what it is told, but not exactly."""

import numpy as np
import pytest

from pilotage.simulate.commanded_robot import CommandedRobot
from pilotage.simulate.problem_file import Move, Sense, parse_problem

TEXT = """
boundary -10,-10 10,-10 10,10 -10,10
start 0 0 90
commandDstSigmaRatio {}
commandAngSigmaRatio {}
rangeSigmaRatio {}
"""


def robot(distance=0.0, turn=0.0, range_=0.0, seed=1):
    problem = parse_problem(TEXT.format(distance, turn, range_), "x")
    return CommandedRobot(problem, np.random.default_rng(seed))


def test_without_noise_it_drives_and_then_turns():
    one = robot()
    assert one.move(Move(2.0, np.pi / 2))
    np.testing.assert_allclose(one.pose, [0, 2, np.pi], atol=1e-15)
    assert one.sense(Sense(0.0)) == pytest.approx(10.0)


def test_noise_is_in_proportion_to_what_is_commanded_and_independent():
    many = [robot(0.02, 0.05, seed=seed) for seed in range(3000)]
    for one in many:
        one.move(Move(-4.0, -1.0))
    error = np.array([one.pose - [0, -4, np.pi / 2 - 1.0] for one in many])[:, 1:]
    np.testing.assert_allclose(error.mean(axis=0), 0, atol=5e-3)
    np.testing.assert_allclose(error.std(axis=0), [0.08, 0.05], rtol=0.05)
    assert abs(np.corrcoef(error.T)[0, 1]) < 0.06


def test_range_noise_is_in_proportion_to_the_range():
    one = robot(range_=0.01)
    ranges = [one.sense(Sense(0.0)) for _ in range(3000)]
    assert np.mean(ranges) == pytest.approx(10.0, abs=0.01)
    assert np.std(ranges) == pytest.approx(0.1, rel=0.05)


def test_a_wall_does_not_stop_it_but_is_told():
    one = robot()
    assert not one.move(Move(12.0, 0.0))
    assert one.pose[1] == pytest.approx(12.0)
    assert one.sense(Sense(0.0)) == np.inf


def test_no_range_is_negative():
    assert min(robot(range_=1.0, seed=seed).sense(Sense(0.0)) for seed in range(50)) == 0.0
