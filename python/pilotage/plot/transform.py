"""A Gaussian through a function: points, true moments, and what transforms make of them."""

from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .ellipse import ellipses

_SIGMA_1 = 1.0 - float(np.exp(-0.5))
"""Probability within the 1 σ ellipse."""


def transform_figure(
    points: NDArray[np.float64],
    moments: Mapping[str, tuple[NDArray[np.float64], NDArray[np.float64]]],
) -> Figure:
    """Draw points (n, 2) [m] with means (2,) and covariances (2, 2), the first being the truth."""
    figure = style.canvas(2.6)
    axes = figure.subplots()
    style.dress(axes)
    axes.set_aspect("equal")
    axes.plot(
        *points.T, linestyle="none", marker=".", markersize=1.6, color=style.FAINT,
        markeredgewidth=0, alpha=0.6, gid="points",
    )  # fmt: skip
    looks = ((style.INK, "o", "-"), (style.ELLIPSE, "x", "--"), (style.DOT, "+", "-"))
    handles = []
    for (name, (mean, covariance)), (colour, shape, line) in zip(
        moments.items(), looks, strict=True
    ):
        outline = ellipses(mean[None], covariance[None], _SIGMA_1)[0]
        width, size = (2.2, 6) if name == next(iter(moments)) else (1.1, 8)
        axes.plot(*np.vstack([outline, outline[:1]]).T, color=colour, linestyle=line, lw=width)
        handles += axes.plot(
            *mean, color=colour, marker=shape, markersize=size, linestyle=line, linewidth=width,
            markeredgewidth=1.4, markerfacecolor="none", label=name, gid=name,
        )  # fmt: skip
    style.name_axis(axes.xaxis, "x (m)")
    style.name_axis(axes.yaxis, "y (m)")
    style.headline(axes, "", "mean and 1 σ ellipse")
    style.legend(figure, handles)
    return figure
