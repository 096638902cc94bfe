"""Readings of infrared pairs against the distance (Tamas et al. 2008, figure 4)."""

from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import ScalarFormatter
from numpy.typing import NDArray

from . import style


def infrared_figure(
    distance: NDArray[np.float64],
    readings: Mapping[str, NDArray[np.float64]],
    curves: Mapping[str, NDArray[np.float64]],
) -> Figure:
    """Draw readings (n,) [V] over distances (n,) [m] and the curve fitted to each, by name."""
    figure = style.canvas(3.3)
    axes = figure.subplots()
    style.dress(axes)
    handles = []
    for i, (name, reading) in enumerate(readings.items()):
        colour, shape = style.category((4, 0, 7)[i])
        handles += axes.plot(
            distance, reading, color=colour, marker=shape, markersize=3.5, linestyle="none",
            label=name, gid=name,
        )  # fmt: skip
        axes.plot(distance, curves[name], color=style.INK, linewidth=0.9, zorder=3)
    (line,) = axes.plot([], [], color=style.INK, linewidth=0.9, label="a + b ln d, fitted")
    axes.set_xscale("log")
    axes.set_xticks([0.1, 0.2, 0.3, 0.4, 0.6, 0.8])
    axes.xaxis.set_major_formatter(ScalarFormatter())
    axes.xaxis.set_minor_formatter(lambda *_: "")
    style.name_axis(axes.xaxis, "distance (m)")
    style.name_axis(axes.yaxis, "reading (V)")
    style.legend(figure, [*handles, line])
    return figure
