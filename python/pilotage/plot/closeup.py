"""A stretch of the path with times along it (Kiriy & Buehler 2002, figure 7)."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from ..evaluate import HasPoses, MapLike, interpolate, pose_errors
from . import style
from .plane import draw_ellipses, draw_estimate, draw_markers, draw_truth, extent, plane

TIMES = 9
"""About so many times stand along the path."""


def closeup_figure(
    run: HasPoses,
    truth: NDArray[Any] | None = None,
    markers: MapLike | None = None,
    window_s: tuple[float, float] | None = None,
) -> Figure:
    """Draw the path within a time window, with 95 % ellipses and the times since the start.

    Parameters
    ----------
    run : HasPoses
    truth : structured array with utime, x, y, heading, or None
    markers : MapLike or None
    window_s : (from, to), s since the first pose
        Default: around the largest position error, without truth the largest position variance.

    Raises
    ------
    ValueError
        If no pose lies in the window.
    """
    poses = run.poses
    time = style.seconds(poses["utime"], poses["utime"][0])
    title = f"{window_s[0]:g} s to {window_s[1]:g} s" if window_s else ""
    if window_s is None:
        worst, title = worst_pose(poses, truth)
        window_s = window_around(time[worst], time[-1])
    chosen = (time >= window_s[0]) & (time <= window_s[1])
    if not chosen.any():
        raise ValueError(
            f"no pose between {window_s[0]:g} s and {window_s[1]:g} s: the run lasts {time[-1]:g} s"
        )
    part, part_time = poses[chosen], time[chosen]
    if truth is not None:
        inside = (truth["utime"] >= part["utime"][0]) & (truth["utime"] <= part["utime"][-1])
        truth = truth[inside]

    box = extent(part, truth, margin=0.15)
    ticks = apart(part, tick_poses(part_time), 0.04 * float(np.max(box[1] - box[0])))
    figure, axes = plane(box)
    handles = draw_truth(axes, truth)
    handles += draw_estimate(axes, part)
    handles += draw_ellipses(axes, part[ticks])
    handles += draw_errors(axes, part[ticks], truth)
    handles += draw_markers(axes, markers)
    draw_times(axes, part, ticks, part_time, truth)
    style.headline(axes, title, "numbers: time since start (s)")
    style.legend(figure, handles)
    return figure


def worst_pose(poses: NDArray[Any], truth: NDArray[Any] | None) -> tuple[int, str]:
    """Find the pose to look at: its index, and the reason in words."""
    error = pose_errors(poses, truth).distance
    if np.isfinite(error).any():
        worst = int(np.nanargmax(error))
        what = f"around the largest position error, {error[worst]:.2f} m"
    else:
        worst = int(np.argmax(poses["covariance"][:, 0, 0] + poses["covariance"][:, 1, 1]))
        what = "around the largest position variance"
    time = style.seconds(poses["utime"], poses["utime"][0])[worst]
    return worst, f"{what} at {time:.0f} s"


def window_around(time: float, end: float) -> tuple[float, float]:
    """Take a twentieth of the run, 10 s to 60 s, with the time in its middle where it can be."""
    length = float(np.clip(end / 20.0, 10.0, 60.0))
    first = float(np.clip(time - length / 2.0, 0.0, max(end - length, 0.0)))
    return first, first + length


def tick_poses(time: NDArray[np.float64]) -> NDArray[np.intp]:
    """Find the poses at round times, about `TIMES` of them, or else the first."""
    steps = np.array([0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1800, 3600])
    length = time[-1] - time[0]
    step = steps[min(np.searchsorted(steps, length / TIMES), steps.size - 1)]
    ticks = np.arange(np.ceil(time[0] / step), np.floor(time[-1] / step) + 1) * step
    rows = np.minimum(np.searchsorted(time, ticks - 1e-9), time.size - 1)
    return np.unique(rows) if rows.size else np.array([0])


def apart(poses: NDArray[Any], ticks: NDArray[np.intp], distance: float) -> NDArray[np.intp]:
    """Keep the ticks that lie a distance (m) from the one before: a robot may stand."""
    kept: list[int] = []
    for tick in ticks.tolist():
        here, last = poses[tick], poses[kept[-1]] if kept else None
        if last is None or np.hypot(here["x"] - last["x"], here["y"] - last["y"]) >= distance:
            kept.append(tick)
    return np.array(kept, dtype=np.intp)


def draw_errors(axes: Axes, poses: NDArray[Any], truth: NDArray[Any] | None) -> list[Line2D]:
    """Join each of the poses to where the robot truly was at that time."""
    if truth is None or truth.size == 0:
        return []
    true = interpolate(truth, poses["utime"])
    lift = np.full(len(poses), np.nan)
    x = np.column_stack([poses["x"], true[:, 0], lift]).ravel()
    y = np.column_stack([poses["y"], true[:, 1], lift]).ravel()
    return axes.plot(
        x, y, color=style.INK, linewidth=0.7, marker=".", markersize=4, label="same moment",
        gid="same moment", zorder=4,
    )  # fmt: skip


def draw_times(
    axes: Axes,
    poses: NDArray[Any],
    ticks: NDArray[np.intp],
    time: NDArray[np.float64],
    truth: NDArray[Any] | None,
) -> None:
    """Write the time at each tick, beside the path and away from the truth."""
    before = np.maximum(ticks - 5, 0)
    after = np.minimum(ticks + 5, poses.size - 1)
    across = np.column_stack(
        [poses["y"][before] - poses["y"][after], poses["x"][after] - poses["x"][before]]
    )
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)
    error = pose_errors(poses[ticks], truth).position
    towards_truth = np.sum(across * np.nan_to_num(error), axis=1) < 0.0
    across[towards_truth] *= -1.0
    for index, (dx, dy) in zip(ticks, 13.0 * across, strict=True):
        at = (poses["x"][index], poses["y"][index])
        text = f"{time[index]:.1f}".removesuffix(".0")
        style.tag(axes, text, at, (dx, dy), ha="center", va="center", weight="bold")
