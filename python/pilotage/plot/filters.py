"""Several filters on one drive, side by side (Kiriy & Buehler 2002, figures 4 to 6)."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from ..evaluate import MapLike, pose_errors
from . import style
from .plane import draw_estimate, draw_markers, draw_truth, extent
from .thin import envelope

LOOKS = ((style.ELLIPSE, 0.8), (style.INK, 0.8), (style.ESTIMATE, 0.8))
"""Colour and width of each filter's lines, in their order."""
Filters = Mapping[str, NDArray[Any]]
"""Poses by the filter's name, rows as of `evaluate.HasPoses`."""


def paths_figure(filters: Filters, truth: NDArray[Any], markers: MapLike) -> Figure:
    """Draw each filter's path over the truth, in panels of one scale."""
    low, high = extent(truth, markers, margin=0.12)
    panel = style.WIDTH / len(filters) - 0.25
    figure = style.canvas(panel * (high[1] - low[1]) / (high[0] - low[0]) + 0.9)
    panels = figure.subplots(1, len(filters), sharex=True, sharey=True, squeeze=False)[0]
    for axes, (name, poses) in zip(panels, filters.items(), strict=True):
        style.dress(axes)
        axes.set_aspect("equal")
        handles = draw_truth(axes, truth) + draw_estimate(axes, poses)
        handles += draw_markers(axes, markers, [""] * len(markers.ids))
        distance = pose_errors(poses, truth).distance
        style.headline(axes, name, f"{np.nanmean(distance):.2f} m")
        style.name_axis(axes.xaxis, "x (m)")
    panels[0].set_xlim(low[0], high[0])
    panels[0].set_ylim(low[1], high[1])
    style.name_axis(panels[0].yaxis, "y (m)")
    style.legend(figure, handles)
    return figure


def convergence_figure(
    filters: Filters, seen: NDArray[np.int64], window_s: tuple[float, float]
) -> Figure:
    """Draw how many markers each sighting's moment has, and the variances of position and heading.

    Parameters
    ----------
    seen : (k,) int, µs
        When each sighting was captured.
    window_s : (from, to), s since the first pose
        Shaded.
    """
    start = int(next(iter(filters.values()))["utime"][0])
    figure, panels = style.stack([0.9, 1.7, 1.7])
    moments, count = np.unique(seen, return_counts=True)
    panels[0].vlines(style.seconds(moments, start), 0, count, color=style.INK, linewidth=0.6)
    panels[0].set_yticks(range(count.max() + 1))
    panels[0].set_ylim(0, count.max() + 0.3)
    style.name_axis(panels[0].yaxis, "markers seen")
    for (name, poses), (color, width) in zip(filters.items(), LOOKS, strict=False):
        time = style.seconds(poses["utime"], start)
        variance = np.diagonal(poses["covariance"], axis1=1, axis2=2)
        for axes, part in zip(
            panels[1:], (variance[:, :2].sum(axis=1), variance[:, 2]), strict=True
        ):
            axes.semilogy(*envelope(time, part), color=color, linewidth=width, label=name)
    style.name_axis(panels[1].yaxis, "position part of\ntrace P (m²)")
    style.name_axis(panels[2].yaxis, "heading part of\ntrace P (rad²)")
    return _finished(figure, panels, window_s, filters)


def filter_errors_figure(
    filters: Filters, truth: NDArray[Any], window_s: tuple[float, float]
) -> Figure:
    """Draw each filter's position and heading error over time; `window_s` is shaded."""
    figure, panels = style.stack([2.1, 2.1])
    for (name, poses), (color, width) in zip(filters.items(), LOOKS, strict=False):
        errors = pose_errors(poses, truth)
        time = style.seconds(poses["utime"], int(poses["utime"][0]))
        for axes, part in zip(panels, (errors.distance, np.degrees(errors.heading)), strict=True):
            axes.plot(*envelope(time, part), color=color, linewidth=width, label=name)
    style.name_axis(panels[0].yaxis, "position error (m)")
    style.name_axis(panels[1].yaxis, "heading error (deg)")
    limits = [_limit(axes, unit) for axes, unit in zip(panels, ("m", "deg"), strict=True)]
    panels[0].set_ylim(0.0, limits[0])
    panels[1].set_ylim(-limits[1], limits[1])
    return _finished(figure, panels, window_s, filters)


def _limit(axes: Axes, unit: str) -> float:
    """Return twice the middle of the filters' largest errors, and say who leaves the panel."""
    sizes = {line.get_label(): np.nanmax(np.abs(line.get_ydata())) for line in axes.lines}
    limit = 2.0 * float(np.median(list(sizes.values())))
    beyond = [f"{name}: up to {size:.0f} {unit}" for name, size in sizes.items() if size > limit]
    style.headline(axes, "", "; ".join(beyond))
    return limit


def _finished(
    figure: Figure, panels: list[Axes], window_s: tuple[float, float], filters: Filters
) -> Figure:
    for axes in panels:
        axes.axvspan(*window_s, color=style.BAND, linewidth=0, zorder=0)
    ends = [style.seconds(p["utime"][[-1]], int(p["utime"][0]))[0] for p in filters.values()]
    panels[0].set_xlim(0.0, max(ends))
    handles: list[Any] = [
        Line2D([], [], color=color, linewidth=1.4, label=name)
        for name, (color, _) in zip(filters, LOOKS, strict=False)
    ]
    handles.append(
        Line2D(
            [], [], color=style.BAND, linewidth=6,
            label=f"{window_s[0]:g} s to {window_s[1]:g} s: one marker in view, or none",
        )
    )  # fmt: skip
    style.legend(figure, handles)
    return figure
