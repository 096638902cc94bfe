"""What poles tell of the position, one by one and together (Sousa and others, figure 4)."""

from collections.abc import Sequence

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from .. import MarkerMap
from . import style
from .ellipse import ellipse_label, ellipses
from .plane import draw_markers

MARGIN_M = 0.4


def overlap_figure(
    poles: MarkerMap,
    places: Sequence[tuple[str, NDArray[np.float64], NDArray[np.float64]]],
) -> Figure:
    """Draw ellipses of the position about where the robot is, a panel a place.

    Parameters
    ----------
    places : sequence of (name, position (2,), covariances (k, 2, 2))
        The last covariance is that of all poles together, the others of one each [m²].
    """
    drawn = [ellipses(np.repeat(at[None], len(each), axis=0), each) for _, at, each in places]
    points = np.concatenate(
        [poles.positions[:, :2], *(outlines.reshape(-1, 2) for outlines in drawn)]
    )
    low, high = points.min(axis=0) - MARGIN_M, points.max(axis=0) + MARGIN_M
    width = (style.WIDTH - 0.6) / len(places) - 0.3
    figure = style.canvas(float((high - low)[1] / (high - low)[0]) * width + 1.1)
    panels = figure.subplots(1, len(places), sharey=True, squeeze=False)[0]
    for axes, (name, at, covariances), outlines in zip(panels, places, drawn, strict=True):
        style.dress(axes)
        axes.set_aspect("equal")
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
        for part, face, edge in (
            (outlines[:-1], style.BAND + "80", style.DOT),
            (outlines[-1:], style.ELLIPSE + "55", style.ELLIPSE),
        ):
            filled = PolyCollection(
                list(part), facecolor=face, edgecolor=edge, linewidth=0.9, zorder=3
            )
            axes.add_collection(filled, autolim=False)
        axes.plot(*at, marker="s", markersize=3.5, color=style.INK, zorder=4)
        draw_markers(axes, poles)
        sigma = np.sqrt(np.linalg.eigvalsh(covariances[-1])[-1])
        style.headline(axes, name, f"together: σ up to {sigma:.2f} m")
        style.name_axis(axes.xaxis, "x in frame map (m)")
    style.name_axis(panels[0].yaxis, "y in frame map (m)")
    style.legend(
        figure,
        [
            Line2D([], [], color=style.DOT, label=f"one pole: {ellipse_label()}"),
            Line2D([], [], color=style.ELLIPSE, label="both"),
        ],
    )
    return figure
