"""Figures of the plane: a panel of equal scales, and what is drawn into it."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from ..evaluate import MAX_GAP_S, MapLike
from . import style
from .ellipse import PROBABILITY, ellipse_label, ellipses, magnification
from .thin import stride

POINTS = 20_000


def plane(box: NDArray[np.float64], beside: float = 0.0) -> tuple[Figure, Axes]:
    """Make a figure with equal scales, as high as the box [[x, y] low, [x, y] high] needs, in m.

    `beside` is room at the panel's right, in inches.
    """
    low, high = box
    size = high - low
    width = style.WIDTH - 0.7 - beside
    height = float(np.clip(width * size[1] / size[0], 2.5, 6.0))
    # Widen the side that falls short, so that equal scales fill the panel.
    spare = np.maximum([size[1] * width / height, size[0] * height / width] - size, 0.0) / 2.0
    figure = style.canvas(height + 0.8)
    axes = figure.subplots()
    style.dress(axes)
    axes.set_aspect("equal")
    axes.set_xlim(low[0] - spare[0], high[0] + spare[0])
    axes.set_ylim(low[1] - spare[1], high[1] + spare[1])
    style.name_axis(axes.xaxis, "x in frame map (m)")
    style.name_axis(axes.yaxis, "y in frame map (m)")
    return figure, axes


def extent(*sets: Any, margin: float = 0.06) -> NDArray[np.float64]:
    """Find the box [[x, y] low, [x, y] high] around poses, truth and map (or None)."""
    points = np.concatenate([_points(source) for source in sets if source is not None])
    low, high = np.nanmin(points, axis=0), np.nanmax(points, axis=0)
    room = max(margin * float(np.max(high - low)), 0.05)
    return np.stack([low - room, high + room])


def _points(source: Any) -> NDArray[np.float64]:
    if hasattr(source, "positions"):
        return np.asarray(source.positions[:, :2])
    return np.column_stack([source["x"], source["y"]])


def draw_truth(axes: Axes, truth: NDArray[Any] | None) -> list[Line2D]:
    """Draw truth as a dark line, broken where it is not known."""
    if truth is None or truth.size == 0:
        return []
    gaps = np.flatnonzero(np.diff(truth["utime"]) > MAX_GAP_S * 1e6) + 1
    kept = np.arange(truth.size)[stride(truth.size, POINTS)]
    rows = np.unique(np.concatenate([kept, gaps - 1, gaps]))
    x, y = (
        np.insert(truth[name][rows], np.searchsorted(rows, gaps), np.nan) for name in ("x", "y")
    )
    return axes.plot(x, y, color=style.INK, linewidth=1.8, label="truth", gid="truth")


def draw_estimate(axes: Axes, poses: NDArray[Any]) -> list[Line2D]:
    """Draw the estimate as a lighter, thinner line on top: both show where they agree."""
    rows = poses[stride(poses.size, POINTS)]
    return axes.plot(
        rows["x"], rows["y"], color=style.ESTIMATE, linewidth=1.0, label="estimate", gid="estimate"
    )


def draw_ellipses(axes: Axes, poses: NDArray[Any]) -> list[Line2D]:
    """Draw the position's 95 % ellipse at each pose, as much larger as it takes to see them."""
    centre = np.column_stack([poses["x"], poses["y"]])
    arms = ellipses(centre, poses["covariance"][:, :2, :2]) - centre[:, None, :]
    radius = np.hypot(arms[..., 0], arms[..., 1]).max(axis=1)
    times = magnification(float(np.median(radius)), 0.01 * float(np.ptp(axes.get_xlim())))
    outlines = centre[:, None, :] + times * arms
    face, edge = style.ELLIPSE + "33", style.ELLIPSE
    axes.add_collection(
        PolyCollection(
            list(outlines), facecolor=face, edgecolor=edge, linewidth=0.8, zorder=3, gid="ellipses"
        ),
        autolim=False,
    )
    label_outermost(axes, outlines, style.percent(PROBABILITY))
    return [
        Line2D(
            [], [], linestyle="none", marker="o", markersize=7, markeredgewidth=0.7,
            markerfacecolor=face, markeredgecolor=edge, label=ellipse_label(times),
        )
    ]  # fmt: skip


def label_outermost(axes: Axes, outlines: NDArray[np.float64], text: str) -> None:
    """Write beside the outline furthest from the middle, on its outer side: there is room."""
    centre = outlines.mean(axis=1)
    away = centre - centre.mean(axis=0)
    outermost = int(np.argmax(np.hypot(away[:, 0], away[:, 1])))
    side, align = (1.0, "left") if away[outermost, 0] >= 0.0 else (-1.0, "right")
    edge = outlines[outermost][np.argmax(side * outlines[outermost][:, 0])]
    style.tag(
        axes, text, tuple(edge), (3.0 * side, 0.0), color=style.ELLIPSE, ha=align, va="center"
    )


def draw_markers(
    axes: Axes, markers: MapLike | None, names: Sequence[str] | None = None
) -> list[Line2D]:
    """Draw markers as stars with their ids, or other names."""
    if markers is None or len(markers.ids) == 0:
        return []
    x, y = markers.positions[:, 0], markers.positions[:, 1]
    tags = map(str, markers.ids) if names is None else names
    for tag, at in zip(tags, zip(x, y, strict=True), strict=True):
        style.tag(axes, tag, at, (4, 3), fontsize=style.SMALL - 1)
    return axes.plot(
        x, y, linestyle="none", marker="*", markersize=8, markerfacecolor=style.MARKER,
        markeredgecolor=style.INK, markeredgewidth=0.5, label="marker", gid="markers", zorder=4,
    )  # fmt: skip
