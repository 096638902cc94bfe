"""The path: estimate, truth, markers and position ellipses (Kiriy & Buehler 2002, figure 4)."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..evaluate import MapLike, RunLike
from . import style
from .plane import draw_ellipses, draw_estimate, draw_markers, draw_truth, extent, plane

ELLIPSES = 30


def path_figure(
    run: RunLike, truth: NDArray[Any] | None = None, markers: MapLike | None = None
) -> Figure:
    """Draw the whole path in the plane, with 95 % ellipses of the position along it.

    Parameters
    ----------
    run : RunLike
    truth : structured array with utime, x, y, heading, or None
    markers : MapLike or None
    """
    poses = run.poses
    figure, axes = plane(extent(poses, truth, markers))
    handles = draw_truth(axes, truth)
    handles += draw_estimate(axes, poses)
    handles += draw_ellipses(axes, poses[spread_along(poses, ELLIPSES)])
    handles += draw_markers(axes, markers)
    draw_ends(axes, poses)
    style.legend(figure, handles)
    return figure


def spread_along(poses: NDArray[Any], count: int) -> NDArray[np.intp]:
    """Find up to `count` poses at equal distances along the path, the start left out."""
    steps = np.hypot(np.diff(poses["x"]), np.diff(poses["y"]))
    travelled = np.concatenate([[0.0], np.cumsum(steps)])
    wanted = np.linspace(0.0, travelled[-1], count + 1)[1:]  # ends exactly where the path ends
    return np.unique(np.searchsorted(travelled, wanted))


def draw_ends(axes: Axes, poses: NDArray[Any]) -> None:
    """Mark where the estimate starts and ends."""
    for pose, name, shape, offset, side in (
        (poses[0], "start", "o", (-5, 5), "right"),
        (poses[-1], "end", "s", (5, -11), "left"),
    ):
        axes.plot(
            pose["x"], pose["y"], marker=shape, markersize=5, markerfacecolor="white",
            markeredgecolor=style.INK, markeredgewidth=0.9, zorder=5, gid=name,
        )  # fmt: skip
        style.tag(axes, name, (pose["x"], pose["y"]), offset, ha=side)
