"""Errors over time within their ±2σ bands (Kiriy & Buehler 2002, figure 6)."""

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from ..evaluate import RunLike, pose_errors, sigma_probability
from . import style
from .thin import envelope

SIGMAS = 2.0
PROBABILITY = style.percent(sigma_probability(SIGMAS))
NAMES = (("x error", "m"), ("y error", "m"), ("heading error", "deg"))


def errors_figure(run: RunLike, truth: NDArray[Any] | None = None) -> Figure:
    """Draw the errors in x, y and heading; without truth the bands alone.

    Parameters
    ----------
    run : RunLike
    truth : structured array with utime, x, y, heading, or None
        Where it is not known the lines have gaps.
    """
    poses = run.poses
    time = style.seconds(poses["utime"], poses["utime"][0])
    error = pose_errors(poses, truth).pose
    variance = np.diagonal(poses["covariance"], axis1=1, axis2=2)
    sigma = np.sqrt(np.maximum(variance, 0.0))
    scale = np.array([1.0, 1.0, np.degrees(1.0)])

    figure, panels = style.stack([1.7, 1.7, 1.7])
    for column, (axes, (name, unit)) in enumerate(zip(panels, NAMES, strict=True)):
        draw_error(axes, time, error[:, column] * scale[column], sigma[:, column] * scale[column])
        style.name_axis(axes.yaxis, f"{name} ({unit})")
    panels[-1].set_xlim(time[0], max(time[-1], time[0] + 1e-6))
    style.legend(figure, handles(bool(np.isfinite(error).any())))
    return figure


def handles(has_truth: bool) -> list[Artist]:
    """Make the legend: the band with its probability, and the error if there is one."""
    label = f"±{SIGMAS:g}σ of the filter, {PROBABILITY} of a Gaussian"
    band = Patch(facecolor=style.BAND, edgecolor=style.ESTIMATE, linewidth=0.5, label=label)
    error = Line2D([], [], color=style.INK, linewidth=0.7, label="estimate less truth")
    return [error, band] if has_truth else [band]


def draw_error(
    axes: Axes, time: NDArray[np.float64], error: NDArray[np.float64], sigma: NDArray[np.float64]
) -> None:
    """Draw one component: the band, the error, and how many of the errors lie within."""
    band_time, band = envelope(time, SIGMAS * sigma)
    axes.fill_between(
        band_time, -band, band, facecolor=style.BAND, edgecolor=style.ESTIMATE, linewidth=0.5,
        gid="band",
    )  # fmt: skip
    axes.axhline(0.0, color=style.FAINT, linewidth=0.5)
    axes.plot(*envelope(time, error), color=style.INK, linewidth=0.7, gid="error")

    known = ~np.isnan(error)
    size = np.abs(error[known])
    if known.any():
        within = style.share(size <= SIGMAS * sigma[known])
        style.headline(axes, "", f"{within} within ±{SIGMAS:g}σ, {PROBABILITY} expected")
    else:
        style.headline(axes, "", "no truth to compare with")
    # A wide band at the start or in a gap may leave the panel, an error may not.
    limit = 1.1 * max(size.max(initial=0.0), np.percentile(SIGMAS * sigma, 98.0), 1e-9)
    axes.set_ylim(-limit, limit)
