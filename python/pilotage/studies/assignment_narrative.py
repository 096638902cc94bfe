"""The narrative of the assignment's program: what was commanded, sensed and computed, in words.

Six digits, as the handout's; angles in degrees here, in radians everywhere else.
"""

import numpy as np
from numpy.typing import NDArray

from ..evaluate import ellipse_axes
from ..simulate.problem_file import Problem
from .assignment_filter import Belief, Moved, Sensed

PROBABILITY = 0.954
"""Of the ellipse, 2.4816 σ, and of the cone, ±2 σ."""
FAULTS = {
    "undefined": "from the estimate, the beam meets no wall, or grazes one",
    "numeric": "the update has no finite result",
    "gated": "it is too far from the prediction",
}


def told_start(problem: Problem) -> str:
    """Say where the robot starts."""
    return f"{problem.title or problem.name}\nStart state is (x, y, th) = {_pose(problem.start)}"


def told_move(step: Moved) -> str:
    """Tell a move command."""
    distance, turn = step.command.distance_m, np.degrees(step.command.turn_rad)
    wall = "" if step.free else "\n(It drove through a wall: nothing stops this robot.)"
    return (
        f"==>The robot moved: distance={distance:g}, angle={turn:g}{wall}\n"
        f"Current state estimate is (x, y, th) = {_pose(step.before.state)}\n"
        f"New state estimate is (x, y, theta) = {_pose(step.after.state)}\n"
        f"New state covariance matrix is:\n{_matrix(step.after.covariance)}\n"
        f"True state is (x, y, th) = {_pose(step.truth)}\n{_uncertainty(step.after)}"
    )


def told_beam(step: Sensed) -> str:
    """Tell what a sense command measured, and what was expected."""
    by_x, by_y, by_heading = map(_short, step.derivatives)
    return (
        f"==>Commanding the robot to sense at an angle of {np.degrees(step.command.angle_rad):g}\n"
        f"The range is {step.range_m:g}\n"
        f"The predicted range was {step.predicted_m:g}\n"
        f"The derivatives are:\n"
        f"  dh/dx = {by_x}, dh/dy = {by_y}, dh/dth = {by_heading}"
    )


def told_revision(step: Sensed) -> str:
    """Tell what the range changed."""
    if step.fault:
        blind = "the range finder meets no wall"
        why = FAULTS[step.fault] if np.isfinite(step.range_m) else blind
        return f"The range is not used: {why}."
    return (
        f"Revised state estimate: (x, y, theta) = {_pose(step.after.state)}\n"
        f"Revised covariance matrix is:\n{_matrix(step.after.covariance)}\n"
        f"{_uncertainty(step.after)}"
    )


def uncertainty(belief: Belief) -> dict[str, float]:
    """Compute the ellipse and the cone.

    Returns
    -------
    minor_m, major_m : radii
    orientation_deg : of the major axis, 0 to 180
    cone_deg : 2 σ_θ
    """
    radii, axes = ellipse_axes(belief.covariance[:2, :2], PROBABILITY)
    along = float(np.degrees(np.arctan2(axes[1, 1], axes[0, 1])))
    return {
        "minor_m": float(radii[0]),
        "major_m": float(radii[1]),
        "orientation_deg": along % 180.0,
        "cone_deg": 2.0 * float(np.degrees(np.sqrt(belief.covariance[2, 2]))),
    }


def _uncertainty(belief: Belief) -> str:
    shown = uncertainty(belief)
    return (
        "Uncertainty ellipse is:\n"
        f"  minor radius is {shown['minor_m']:g}\n"
        f"  major radius is {shown['major_m']:g}\n"
        f"  orientation is {shown['orientation_deg']:g} degrees\n"
        f"  2*sigma_theta is {shown['cone_deg']:g} degrees"
    )


def _pose(state: NDArray[np.float64]) -> str:
    return f"({state[0]:g}, {state[1]:g}, {np.degrees(state[2]):g})"


def _matrix(rows: NDArray[np.float64]) -> str:
    return "[" + "\n".join("[" + " ".join(map(_short, row)) + "]" for row in rows) + "]"


def _short(value: float) -> str:
    """Six digits; what only rounding keeps from zero is zero."""
    return f"{value:g}" if abs(value) > 1e-12 else "0"
