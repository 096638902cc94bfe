"""A robot that does what it is told, but not exactly: section 2 of the assignment."""

import numpy as np
from numpy.typing import NDArray

from .. import MoveAndTurn
from .problem_file import Move, Problem, Sense


class CommandedRobot:
    """The truth: its pose, changed by noisy motion, and what its range finder reads there.

    Parameters
    ----------
    problem : Problem
    rng : numpy.random.Generator
        Distance, turn and range errors are independent and Gaussian, their standard deviations
        proportional to what is driven, turned and measured.
    """

    def __init__(self, problem: Problem, rng: np.random.Generator) -> None:
        self.pose: NDArray[np.float64] = problem.start  # x, y [m], heading [rad]
        self._problem = problem
        self._rng = rng
        self._motion = MoveAndTurn()
        self._walls = problem.world.walls()

    def move(self, command: Move) -> bool:
        """Drive and turn; return whether there was room: nothing stops it at a wall."""
        wanted = np.array([command.distance_m, command.turn_rad])
        ratios = np.array([self._problem.distance_ratio, self._problem.turn_ratio])
        done = wanted + ratios * np.abs(wanted) * self._rng.standard_normal(2)
        before = self.pose
        self.pose = self._motion.step_each(before[None], done[None])[0]
        return self._problem.world.is_free(before[:2], self.pose[:2])

    def sense(self, command: Sense) -> float:
        """Return what the range finder reads, m; inf where there is no wall."""
        distance = float(self._walls.cast(self.pose[None], [command.angle_rad])[0, 0])
        error = self._problem.range_ratio * float(self._rng.standard_normal())
        return max(distance * (1.0 + error), 0.0) if np.isfinite(distance) else distance
