"""What the assignment's program shows, picture after picture: one a key 'n'.

A move command gives one picture. A sense command gives two: first the beam, from the estimate as it
still stands; then, without the beam, the revised estimate, to which the path's last point moves.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..simulate.problem_file import Problem
from .assignment_filter import Belief, Moved, Sensed
from .assignment_narrative import PROBABILITY, told_beam, told_move, told_revision, told_start

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

ROBOT_SIZE = 0.06
"""Its length as it is drawn, of the side of a square as large as the world."""


@dataclass(frozen=True)
class Frame:
    """One picture.

    Attributes
    ----------
    text : str
        The narrative since the picture before.
    path : (n, 2) float
        All final estimates so far, m.
    truth : (3,) float
    beam : (angle_rad, range_m) or None
    """

    text: str
    belief: Belief
    path: NDArray[np.float64]
    truth: NDArray[np.float64]
    beam: tuple[float, float] | None = None


def frames(problem: Problem, steps: Iterable[Moved | Sensed]) -> Iterator[Frame]:
    """Make the pictures of commands done."""
    path = problem.start[None, :2]
    yield Frame(told_start(problem), Belief(problem.start, np.zeros((3, 3))), path, problem.start)
    for step in steps:
        here = step.after.state[None, :2]
        if isinstance(step, Moved):
            path = np.concatenate([path, here])
            yield Frame(told_move(step), step.after, path, step.truth)
        else:
            beam = (step.command.angle_rad, step.range_m)
            seen = beam if np.isfinite(step.range_m) else None
            yield Frame(told_beam(step), step.before, path, step.truth, seen)
            path = np.concatenate([path[:-1], here])
            yield Frame(told_revision(step), step.after, path, step.truth)


def draw(axes: "Axes", problem: Problem, frame: Frame) -> None:
    """Draw one picture into a panel, in place of what it showed."""
    from ..plot import belief

    for artist in [*axes.lines, *axes.patches]:
        artist.remove()
    size = ROBOT_SIZE * float(np.sqrt(np.prod(np.diff(problem.world.box, axis=0))))
    belief.draw_world(axes, problem.world.boundary, problem.world.obstacles)
    belief.draw_way(axes, frame.path)
    state, covariance = frame.belief.state, frame.belief.covariance
    belief.draw_believed_pose(axes, state, covariance, size, PROBABILITY)
    belief.draw_true_pose(axes, frame.truth, size)
    if frame.beam is not None:
        belief.draw_beam(axes, state, *frame.beam)


def world_figure(problem: Problem) -> "tuple[Figure, Axes]":
    """Make a figure for the pictures, as large as the world, with a legend."""
    from ..plot import belief, style
    from ..plot.plane import plane

    low, high = problem.world.box
    room = 0.04 * float(np.max(high - low))
    figure, axes = plane(np.stack([low - room, high + room]))
    point = Belief(problem.start, np.zeros((3, 3)))
    draw(axes, problem, Frame("", point, problem.start[None, :2], problem.start, (0.0, 0.0)))
    style.legend(figure, belief.labelled(axes))
    return figure, axes
