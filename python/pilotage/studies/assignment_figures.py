"""The figures of the assignment: its pictures, side by side, and what its filter cannot show."""

from collections.abc import Sequence
from itertools import count, islice
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .. import Ekf3, Ukf3
from ..plot import belief, style
from ..plot.ellipse import ellipses
from ..simulate.problem_file import Problem
from .assignment_filter import Belief, Sensed, commanded
from .assignment_frames import Frame, draw, frames
from .assignment_handout import BEAM_DEG, POSES_DEG, RANGE_M, TRUTH_DEG, handout
from .assignment_narrative import PROBABILITY
from .assignment_problems import find_problem

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

CLOUD = 1500  # runs that are dots


def _panel(axes: "Axes", problem: Problem, frame: Frame, title: str) -> None:
    style.dress(axes)
    axes.grid(False)
    axes.set_aspect("equal")
    low, high = problem.world.box
    room = 0.03 * float(np.max(high - low))
    axes.set(xlim=(low[0] - room, high[0] + room), ylim=(low[1] - room, high[1] + room))
    draw(axes, problem, frame)
    style.headline(axes, title)


def _named(figure: "Figure", panels: "Sequence[Axes]") -> "Figure":
    """Add the legend, and what the axes are."""
    for name, label in (("x", figure.supxlabel), ("y", figure.supylabel)):
        label(f"{name} in frame map (m)", fontsize=style.TEXT, color=style.INK)
    style.legend(figure, belief.labelled(*panels))
    return figure


def narrative() -> "Figure":
    """Draw the two pictures that the handout's narrative tells: the beam, and what it revised."""
    problem = find_problem("handout")
    prior, revised, _ = handout()
    truth = np.array([*TRUTH_DEG[:2], np.radians(TRUTH_DEG[2])])
    path = np.array(POSES_DEG)[:, :2]
    beam = (float(np.radians(BEAM_DEG)), RANGE_M)
    after = np.concatenate([path[:-1], revised.state[None, :2]])
    figure = style.canvas(3.4)
    panels = figure.subplots(1, 2, sharey=True)
    _panel(
        panels[0],
        problem,
        Frame("", prior, path, truth, beam),
        "the range measured, from the estimate",
    )
    _panel(panels[1], problem, Frame("", revised, after, truth), "the estimate revised")
    for axes in panels:
        axes.set(xlim=(-0.75, 2.25), ylim=(-1.75, 1.05))
    return _named(figure, panels)


def examples(seed: int) -> "Figure":
    """Draw where the first run of each example ends."""
    figure = style.canvas(8.2)
    panels = figure.subplot_mosaic(
        [
            ["exact", "tour"],
            ["square", "spread"],
            ["corridor", "corridor"],
            ["straight", "straight"],
        ],
        height_ratios=[8, 9, 3.4, 5.2],
    )
    for name, axes in panels.items():
        problem = find_problem(name)
        *_, last = frames(problem, commanded(problem, np.random.default_rng((seed, 0))))
        _panel(axes, problem, last, name)
    return _named(figure, list(panels.values()))


def divergence(seed: int) -> "Figure":
    """Draw a run that diverges, picture by picture: the first whose first beam passes by."""
    problem = find_problem("divergence")
    for k in count():
        steps = list(commanded(problem, np.random.default_rng((seed, k))))
        beam = next(step for step in steps if isinstance(step, Sensed))
        if beam.range_m > beam.predicted_m + 1.0:
            break
    pictures = list(frames(problem, steps))
    shown = {
        3: "post expected, the beam passes by",
        4: "revised: outside, and sure of it",
        6: "a move later, the next beam",
        len(pictures) - 1: "the end",
    }
    points = np.concatenate([problem.world.box, pictures[-1].path])
    low, high = points.min(axis=0) - 0.6, points.max(axis=0) + 0.6
    figure = style.canvas(min(0.9 + style.WIDTH * (high[1] - low[1]) / (high[0] - low[0]), 8.0))
    panels = figure.subplots(2, 2, sharex=True, sharey=True).ravel()
    for axes, (k, title) in zip(panels, shown.items(), strict=True):
        _panel(axes, problem, pictures[k], title)
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    return _named(figure, panels)


def limits(seed: int) -> "Figure":
    """Draw a spread that is no ellipse, and what σ_yθ means: position and heading go together."""
    figure = style.canvas(3.6)
    left, right = figure.subplots(1, 2)
    for axes in (left, right):
        style.dress(axes)
    truth, extended = _after("spread", 2, seed, CLOUD)
    _, unscented = _after("spread", 2, seed, 1, Ukf3)
    _dots(left, truth[:, :2])
    for of, name, colour in (
        (extended, "extended", style.ELLIPSE),
        (unscented, "unscented", style.DOT),
    ):
        _outline(left, of.state[:2], of.covariance[:2, :2], name, colour)
    left.set_aspect("equal", adjustable="datalim")
    style.headline(left, "spread: after the turn and 7 m")
    style.name_axis(left.xaxis, "x in frame map (m)")
    style.name_axis(left.yaxis, "y in frame map (m)")

    truth, stated = _after("corridor", 2, seed, CLOUD)
    degrees = np.diag([1.0, np.degrees(1.0)])
    _dots(right, truth[:, 1:] @ degrees)
    joint = degrees @ stated.covariance[1:, 1:] @ degrees
    _outline(right, degrees @ stated.state[1:], joint, "with σ_yθ", style.ELLIPSE)
    _outline(right, degrees @ stated.state[1:], np.diag(np.diag(joint)), "without", style.DOT)
    style.headline(right, "corridor: after the turn and 3 m")
    style.name_axis(right.xaxis, "y in frame map (m)")
    style.name_axis(right.yaxis, "heading (°)")
    for axes in (left, right):
        axes.legend(
            frameon=False,
            fontsize=style.SMALL,
            labelcolor=style.INK,
            loc="upper left",
            markerscale=3,
        )
    return figure


def _after(
    name: str, commands: int, seed: int, runs: int, kind: type[Ekf3] | type[Ukf3] = Ekf3
) -> tuple[NDArray[np.float64], Belief]:
    """True poses (runs, 3) and the belief of the last run, after some commands of an example."""
    problem = find_problem(name)
    truth = np.empty((runs, 3))
    for k in range(runs):
        steps = commanded(problem, np.random.default_rng((seed, k)), kind=kind)
        *_, last = islice(steps, commands)
        truth[k] = last.truth
    return truth, last.after


def _dots(axes: "Axes", points: NDArray[np.float64]) -> None:
    axes.plot(
        *points.T, ".", color=style.FAINT, markersize=2.5, markeredgewidth=0, label="true poses"
    )


def _outline(
    axes: "Axes",
    centre: NDArray[np.float64],
    covariance: NDArray[np.float64],
    name: str,
    colour: str,
) -> None:
    (outline,) = ellipses(centre[None], covariance[None], PROBABILITY)
    axes.plot(*outline[[*range(len(outline)), 0]].T, color=colour, linewidth=1.1, label=name)
