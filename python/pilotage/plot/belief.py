"""A pose that is believed, one that is true, and a beam, in a world of polygons.

The picture of the assignment "Localization and the extended Kalman filter", section 1.
"""

from collections.abc import Sequence

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Polygon, Wedge
from numpy.typing import NDArray

from . import style
from .ellipse import ellipses

BEAM = "#009e73"
OUTLINE = np.array([[1.0, 0.0], [0.35, 0.65], [-0.8, 0.65], [-0.8, -0.65], [0.35, -0.65]])
"""Of the robot, pointed at its front; its reference point is the origin."""


def draw_world(
    axes: Axes, boundary: NDArray[np.float64], obstacles: Sequence[NDArray[np.float64]]
) -> None:
    """Draw the boundary, corners (n, 2) in m, as a wall, and obstacles as blocks."""
    axes.add_patch(Polygon(boundary, fill=False, edgecolor=style.INK, linewidth=1.2, gid="wall"))
    for obstacle in obstacles:
        axes.add_patch(
            Polygon(obstacle, facecolor="#dcdcdc", edgecolor=style.INK, linewidth=0.8, gid="wall")
        )


def draw_believed_pose(
    axes: Axes,
    state: NDArray[np.float64],
    covariance: NDArray[np.float64],
    size: float,
    probability: float,
) -> list[Artist]:
    """Draw the robot (its length is `size`, m) with reference point, position ellipse and cone.

    The ellipse holds the position with `probability`; the cone is heading ±2σ.
    """
    x, y, heading = state
    turn = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
    spread = np.degrees([heading, 2.0 * np.sqrt(max(covariance[2, 2], 0.0))])
    cone = Wedge(
        (x, y), 1.6 * size, spread[0] - min(spread[1], 180.0), spread[0] + min(spread[1], 180.0),
        facecolor=style.MARKER + "55", edgecolor=style.MARKER, linewidth=0.7, zorder=2.5,
        label="heading ±2σ", gid="cone",
    )  # fmt: skip
    (outline,) = ellipses(state[None, :2], covariance[None, :2, :2], probability)
    ellipse = Polygon(
        outline, facecolor=style.ELLIPSE + "33", edgecolor=style.ELLIPSE, linewidth=0.9, zorder=3,
        label=f"{style.percent(probability)} ellipse", gid="ellipse",
    )  # fmt: skip
    body = Polygon(
        state[:2] + 0.55 * size * OUTLINE @ turn.T, facecolor=style.ESTIMATE + "66",
        edgecolor=style.DOT, linewidth=1.0, zorder=3.5, label="estimate", gid="robot",
    )  # fmt: skip
    for patch in (body, ellipse, cone):
        axes.add_patch(patch)
    point = axes.plot(x, y, "o", color=style.DOT, markersize=2.5, zorder=5, gid="reference")
    return [body, ellipse, cone, *point]


def draw_true_pose(axes: Axes, pose: NDArray[np.float64], size: float) -> list[Line2D]:
    """Draw the true position as a dot, and the true heading as a segment from it."""
    x, y, heading = pose
    ends = [x, x + size * np.cos(heading)], [y, y + size * np.sin(heading)]
    return axes.plot(
        *ends, color=style.INK, linewidth=1.2, marker="o", markersize=4, markevery=[0], zorder=6,
        label="truth", gid="truth",
    )  # fmt: skip


def draw_beam(
    axes: Axes, state: NDArray[np.float64], angle_rad: float, range_m: float
) -> list[Line2D]:
    """Draw a beam of the measured length from the estimate: its end shows that it is not there."""
    direction = state[2] + angle_rad
    end = state[:2] + range_m * np.array([np.cos(direction), np.sin(direction)])
    return axes.plot(
        [state[0], end[0]], [state[1], end[1]], color=BEAM, linewidth=1.1, marker="x",
        markersize=5, markevery=[1], zorder=5.5, label="measured range", gid="beam",
    )  # fmt: skip


def draw_way(axes: Axes, points: NDArray[np.float64]) -> list[Line2D]:
    """Draw the path through points (n, 2), m."""
    return axes.plot(
        *points.T, color=style.ESTIMATE, linewidth=1.0, marker=".", markersize=3.5, zorder=2.8,
        label="estimated path", gid="path",
    )  # fmt: skip


def labelled(*panels: Axes) -> list[Artist]:
    """Find one artist of each label in the panels, for a legend."""
    found: dict[str, Artist] = {}
    for axes in panels:
        for artist in axes.get_children():  # as they were drawn
            label = str(artist.get_label())
            if isinstance(artist, Line2D | Patch) and label and label[0] != "_":
                found.setdefault(label, artist)
    return list(found.values())
