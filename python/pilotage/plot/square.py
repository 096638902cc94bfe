"""Paths round a square within its walls (Tamas et al. 2008, figure 7)."""

from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .plane import plane


def square_figure(
    walls: NDArray[np.float64],
    truth: NDArray[np.float64],
    paths: Mapping[str, NDArray[np.float64]],
) -> Figure:
    """Draw walls (k, 4) [x, y, x, y], the true poses (n, 3) and others by their names."""
    ends = walls.reshape(-1, 2)
    everything = np.vstack([ends, *(path[:, :2] for path in paths.values())])
    room = 0.05 * np.ptp(ends[:, 0])
    figure, axes = plane(np.stack([everything.min(axis=0) - room, everything.max(axis=0) + room]))
    for x0, y0, x1, y1 in walls:
        axes.plot([x0, x1], [y0, y1], color=style.FAINT, linewidth=2.5, gid="wall")
    looks = ((style.MARKER, ":"), (style.CATEGORIES[2][0], "--"), (style.ESTIMATE, "-"))
    handles = axes.plot(*truth[:, :2].T, color=style.INK, linewidth=2.0, label="truth", gid="truth")
    for (name, path), (colour, line) in zip(paths.items(), looks, strict=True):
        handles += axes.plot(
            *path[:, :2].T, color=colour, linestyle=line, linewidth=1.2, label=name, gid=name
        )
    style.legend(figure, handles)
    return figure
