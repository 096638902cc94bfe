"""The filter of the assignment, command by command, beside the simulated robot.

"Localization and the extended Kalman filter", sections 2 and 3. The robot's noise is in its
input u, so eq. 7 has J_u P_u J_u' and no further process noise, and P starts at zero.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import Ekf3, MoveAndTurn, Policy, Ukf3, WallRange
from ..simulate.commanded_robot import CommandedRobot
from ..simulate.problem_file import Move, Problem, Sense


@dataclass(frozen=True)
class Belief:
    """What the filter holds for true: state (3,) in m, m and rad, and its covariance (3, 3)."""

    state: NDArray[np.float64]
    covariance: NDArray[np.float64]

    @classmethod
    def of(cls, ekf: Ekf3 | Ukf3) -> "Belief":
        """Take a filter's."""
        return cls(ekf.state, ekf.covariance)


@dataclass(frozen=True)
class Moved:
    """A move command done; `free` is whether the robot met no wall on its way."""

    command: Move
    before: Belief
    after: Belief
    truth: NDArray[np.float64]
    free: bool


@dataclass(frozen=True)
class Sensed:
    """A sense command done.

    Attributes
    ----------
    range_m, predicted_m : float
        z and H[x] of eq. 9; inf where there is no wall.
    derivatives : (3,) float
        J_H: of the range by x, y and heading.
    fault : str
        Why the range was not used, '' if it was.
    """

    command: Sense
    before: Belief
    after: Belief
    truth: NDArray[np.float64]
    range_m: float
    predicted_m: float
    derivatives: NDArray[np.float64]
    nis: float
    fault: str


def commanded(
    problem: Problem,
    rng: np.random.Generator,
    policy: Policy | None = None,
    kind: type[Ekf3] | type[Ukf3] = Ekf3,
    joint: bool = True,
) -> Iterator[Moved | Sensed]:
    """Command the robot, and estimate where it is.

    Parameters
    ----------
    policy : Policy
        How an innovation decides about its own update; the assignment fuses every one in full.
    kind : type
        Of the filter; the assignment's is the extended one.
    joint : bool
        False forgets after every command how position and heading go together (σ_xθ, σ_yθ).
    """
    robot = CommandedRobot(problem, rng)
    walls = problem.world.walls()
    motion = MoveAndTurn()
    ekf = kind(problem.start, np.zeros((3, 3)))
    for command in problem.commands:
        before = Belief.of(ekf)
        if isinstance(command, Move):
            free = robot.move(command)
            u = np.array([command.distance_m, command.turn_rad])
            p_u = np.diag(np.square([problem.distance_ratio, problem.turn_ratio] * u))  # eq. 1
            ekf.predict(motion, u, p_u, np.zeros(3))  # eqs. 4 and 7
            yield Moved(command, before, Belief.of(ekf), robot.pose, free)
        else:
            z = robot.sense(command)
            model = WallRange(walls, command.angle_rad)
            predicted, j_h, _ = model.linearize(ekf.state)
            c_v = (problem.range_ratio * z) ** 2
            report = ekf.update(model, [z], [[c_v]], policy or Policy())  # eqs. 9 to 12
            yield Sensed(
                command, before, Belief.of(ekf), robot.pose,
                z, float(predicted[0]), j_h[0], report.nis, report.fault,
            )  # fmt: skip
        if not joint:
            kept = ekf.covariance
            kept[:2, 2] = kept[2, :2] = 0.0
            ekf = kind(ekf.state, kept)
