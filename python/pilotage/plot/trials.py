"""Filters beside each other in one trial, and over many (Kohler's report, figures 7 to 10)."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter
from numpy.typing import NDArray

from ..evaluate import MapLike, wrap_angle
from . import style
from .plane import draw_markers, draw_truth, extent, plane

STATES = (("x", "m"), ("y", "m"), ("heading", "rad"))
LINES: tuple[Any, ...] = ((0, (5, 1.5)), (0, (1.2, 1.2)), "-")
COLOURS = tuple(style.category(i)[0] for i in (0, 4, 2))


def state_figure(
    utime: NDArray[np.int64],
    truth: NDArray[np.float64],
    estimates: Mapping[str, NDArray[np.float64]],
    column: int,
) -> Figure:
    """Draw one state over time, and below it the errors.

    Parameters
    ----------
    utime : (n,) int, µs
    truth, estimates : (n, 3) float, m, m, rad; up to three estimates by name
    column : int
    """
    time = style.seconds(utime, int(utime[0]))
    name, unit = STATES[column]
    figure, (upper, lower) = style.stack([2.1, 1.5])
    true = np.unwrap(truth[:, column]) if column == 2 else truth[:, column]
    handles = upper.plot(time, true, color=style.INK, linewidth=1.8, label="truth")
    for (label, states), colour, line in zip(estimates.items(), COLOURS, LINES, strict=False):
        error = states[:, column] - truth[:, column]
        error = wrap_angle(error) if column == 2 else error
        look: dict[str, Any] = {"color": colour, "linestyle": line, "linewidth": 1.1}
        handles += upper.plot(time, true + error, label=label, **look)
        lower.plot(time, error, **look)
    lower.axhline(0.0, color=style.INK, linewidth=0.6)
    style.name_axis(upper.yaxis, f"{name} ({unit})")
    style.name_axis(lower.yaxis, f"estimate less truth ({unit})")
    lower.set_xlim(0.0, time[-1])
    style.legend(figure, handles)
    return figure


def trial_figure(
    truth: NDArray[Any], markers: MapLike, seen: NDArray[np.bool_], label: str
) -> Figure:
    """Draw the way in the plane, where markers were seen on it, and the markers.

    Parameters
    ----------
    truth : structured array (n,) with utime, x, y, heading
    seen : (n,) bool
    label : str
        What `seen` says.
    """
    figure, axes = plane(extent(truth, None, markers))
    handles = draw_truth(axes, truth)
    x, y = (np.where(seen, truth[name], np.nan) for name in ("x", "y"))
    handles += axes.plot(x, y, color=style.ESTIMATE, linewidth=5.0, alpha=0.6, label=label)
    handles[-1].set_zorder(1.5)
    handles += draw_markers(axes, markers)
    axes.plot(truth["x"][0], truth["y"][0], "o", color=style.INK, markersize=4)
    style.tag(axes, "start", (truth["x"][0], truth["y"][0]), (5, 4))
    style.legend(figure, handles)
    return figure


def rms_figure(rms: Mapping[tuple[str, float], NDArray[np.float64]]) -> Figure:
    """Draw rms errors over time, a row a state.

    Parameters
    ----------
    rms : (seconds, 3) float, m, m, rad, by filter and by the part that the start is off
        The smallest part is drawn thin, the others thick.
    """
    figure, panels = style.stack([1.5, 1.5, 1.5])
    names = list(dict.fromkeys(name for name, _ in rms))
    parts = sorted({part for _, part in rms})
    for (name, part), values in rms.items():
        at = names.index(name)
        for column, axes in enumerate(panels):
            axes.semilogy(
                np.arange(len(values)) + 0.5, values[:, column], color=COLOURS[at],
                linestyle=LINES[at], linewidth=0.8 if part == parts[0] else 1.8,
            )  # fmt: skip
    for axes, (name, unit) in zip(panels, STATES, strict=True):
        style.name_axis(axes.yaxis, f"rms {name} ({unit})")
        axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axes.yaxis.set_major_formatter("{x:g}")
        axes.yaxis.set_minor_formatter(NullFormatter())
    handles = [
        Line2D([], [], color=colour, linestyle=line, label=name)
        for name, colour, line in zip(names, COLOURS, LINES, strict=False)
    ]
    for part, width in zip(parts, (0.8, 1.8), strict=False):
        label = f"start {100 * part:.0f} % off"
        handles.append(Line2D([], [], color=style.INK, linewidth=width, label=label))
    panels[-1].set_xlim(0.0, len(values))
    style.legend(figure, handles)
    return figure
