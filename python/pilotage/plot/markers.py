"""Visible markers and the filter's uncertainty (Kiriy & Buehler 2002, figure 5)."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from ..evaluate import RunLike
from . import style
from .thin import envelope

BINS = 400


def markers_figure(run: RunLike) -> Figure:
    """Draw sightings per frame, trace of P, and position and heading variance apart.

    The trace adds m² and rad², as the paper's figure does; the variances beside it keep them apart.
    """
    poses = run.poses
    start = poses["utime"][0]
    time = style.seconds(poses["utime"], start)
    position = poses["covariance"][:, 0, 0] + poses["covariance"][:, 1, 1]
    heading = poses["covariance"][:, 2, 2]

    figure, (visible, trace, metres, radians) = style.stack([1.5, 1.35, 1.35, 1.35])
    draw_visible(visible, run.reports, start)
    style.name_axis(visible.yaxis, "markers")
    for axes, values, label, text in (
        (trace, position + heading, "m² + rad²", "trace of P"),
        (metres, position, "m²", "position variance, x and y together"),
        (radians, heading, "rad²", "heading variance"),
    ):
        draw_variance(axes, time, values)
        style.name_axis(axes.yaxis, label)
        style.headline(axes, text)
    trace.set_xlim(time[0], max(time[-1], time[0] + 1e-6))
    return figure


def draw_visible(axes: Axes, reports: NDArray[Any], start: int) -> None:
    """Draw sightings per frame, and how many of them were fused, as means over short intervals."""
    utime, seen, fused = count_frames(reports)
    if utime.size == 0:
        style.note(axes, "no sightings")
        return
    time = style.seconds(utime, start)
    edges = np.linspace(min(time[0], 0.0), max(time[-1], 1e-6), BINS + 1)
    frames, _ = np.histogram(time, edges)
    for counts, colour, label in (
        (seen, style.INK, "seen, not fused"),
        (fused, style.ESTIMATE, "fused"),
    ):
        total, _ = np.histogram(time, edges, weights=counts)
        mean = total / np.maximum(frames, 1)
        axes.stairs(mean, edges, fill=True, color=colour, label=label, gid=label)
    axes.set_ylim(0.0, 1.1 * float(np.max(seen)))
    axes.yaxis.set_major_locator(MaxNLocator(nbins=5, integer=True))
    style.headline(axes, f"visible markers per frame, mean over {edges[1] - edges[0]:.2g} s")
    style.corner_legend(axes)


def count_frames(
    reports: NDArray[Any],
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Count by frame, in order of time: its time (µs), its sightings, the accepted ones."""
    order = np.lexsort((reports["frame_seq"], reports["sensor"], reports["utime"]))
    rows = reports[order]
    key = np.stack([rows["utime"], rows["sensor"], rows["frame_seq"]])
    first = np.flatnonzero(np.any(np.diff(key, axis=1, prepend=-1) != 0, axis=0))
    if rows.size == 0:
        return rows["utime"], rows["utime"], rows["utime"]
    seen = np.diff(first, append=rows.size)
    fused = np.add.reduceat(rows["accepted"].astype(np.int64), first)
    return rows["utime"][first], seen, fused


def draw_variance(axes: Axes, time: NDArray[np.float64], values: NDArray[np.float64]) -> None:
    """Draw a variance on a log axis, where zero has no place and leaves a gap."""
    positive = np.where(values > 0.0, values, np.nan)
    axes.plot(*envelope(time, positive), color=style.INK, linewidth=0.7, gid="variance")
    if np.isfinite(positive).any():
        axes.set_yscale("log")
    else:
        style.note(axes, "zero throughout")
