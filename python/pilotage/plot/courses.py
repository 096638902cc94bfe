"""How the position errors of many runs go over time, a filter a colour."""

from collections.abc import Mapping

import numpy as np
from matplotlib.artist import Artist
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from ..evaluate.courses import Courses
from . import style
from .montecarlo import DASHED, logarithmic

COLOURS = (style.ELLIPSE, style.DOT, "#009e73")
BAND = (5.0, 95.0)
LEAST_M = 0.02


def courses_figure(
    courses: Mapping[str, Courses], limit_m: float, within_s: float, xlabel: str
) -> Figure:
    """Draw median and 5 to 95 % of the runs, with the limit that they should be below in time."""
    figure, (axes,) = style.stack([2.6], xlabel)
    handles: list[Artist] = []
    for (name, course), colour in zip(courses.items(), COLOURS, strict=False):
        low, middle, high = np.percentile(course.distance, (BAND[0], 50.0, BAND[1]), axis=0)
        axes.fill_between(
            course.time_s, np.maximum(low, LEAST_M / 2), high, facecolor=colour, alpha=0.2,
            linewidth=0,
        )  # fmt: skip
        axes.plot(course.time_s, middle, color=colour, linewidth=1.2)
        back = 100.0 * course.settled_within(limit_m, within_s)
        label = f"{name}: {back:.0f} % below {limit_m:g} m for good within {within_s:g} s"
        handles.append(Line2D([], [], color=colour, linewidth=1.2, label=label))
    axes.axhline(limit_m, color=style.INK, linewidth=0.7, linestyle=DASHED)
    axes.axvline(within_s, color=style.INK, linewidth=0.7, linestyle=DASHED)
    handles.append(Patch(facecolor=style.FAINT, alpha=0.4, label="5 to 95 % of the runs"))
    style.name_axis(axes.yaxis, "position error (m)")
    axes.set_xlim(0.0, course.time_s[-1])
    axes.set_ylim(LEAST_M, None)
    logarithmic(axes)
    style.legend(figure, handles)
    return figure
