"""Many runs together: errors beside the smallest possible ones, NEES and NIS in their bands."""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from numpy.typing import NDArray

from ..evaluate import root_mean_square
from ..montecarlo.measures import ratio
from ..montecarlo.per_dof import PerDof
from ..montecarlo.result import MonteCarlo
from . import style

NAMED = 6
"""Lost runs that the figure draws by themselves, and names, at most."""
FAR = 5.0
"""What should be 1 and comes to more is drawn on a logarithmic axis."""
DASHED = (0, (4, 3))


def montecarlo_figure(result: MonteCarlo) -> Figure:
    """Draw RMSE of position and heading over the bound, NEES per dof, and NIS of each sensor."""
    figure, panels = style.stack([1.7, 1.4, 1.4, *[1.2] * len(result.nis)])
    time, bound = result.time_s, result.bound
    lost = result.trials.distance[result.lost[:NAMED]].T
    position = None if bound is None else bound.position_m
    heading = None if bound is None else np.degrees(bound.heading_rad)
    draw_error(panels[0], time, result.position_m, position, "position RMSE", "m", lost)
    draw_error(panels[1], time, np.degrees(result.heading_rad), heading, "heading RMSE", "deg")
    draw_ratio(panels[2], result.nees, "", "NEES / dof")
    for axes, (name, nis) in zip(panels[3:], result.nis.items(), strict=True):
        draw_ratio(axes, nis, name, "NIS / dof")
    panels[0].set_xlim(0.0, time[-1])
    style.legend(figure, handles(result))
    return figure


def draw_error(
    axes: Axes,
    time: NDArray[np.float64],
    rmse: NDArray[np.float64],
    bound: NDArray[np.float64] | None,
    name: str,
    unit: str,
    lost: NDArray[np.float64] | None = None,
) -> None:
    """Draw errors on a logarithmic axis, some lost runs by themselves behind them."""
    if not np.isfinite(rmse).any():
        return style.note(axes, "no pose")
    if lost is not None:
        axes.plot(time, lost, color=style.ELLIPSE, linewidth=0.4, gid="lost")
    axes.plot(time, rmse, color=style.DOT, linewidth=1.1, gid="rmse")
    right = f"{root_mean_square(rmse):.3g} {unit}"
    if bound is not None:
        axes.plot(time, bound, color=style.INK, linewidth=0.8, linestyle=DASHED, gid="bound")
        right += f", bound {root_mean_square(bound):.3g} {unit}, ratio {ratio(rmse, bound):.3f}"
    style.headline(axes, "", right)
    style.name_axis(axes.yaxis, f"{name} ({unit})")
    logarithmic(axes)


def draw_ratio(axes: Axes, of: PerDof, name: str, axis: str) -> None:
    """Draw what should be 1 within its band."""
    known = np.isfinite(of.over_time)
    if not known.any():
        return style.note(axes, "no pose")
    time, over_time = of.time_s[known], of.over_time[known]
    lower, upper = of.low[known], of.high[known]
    axes.fill_between(time, lower, upper, facecolor=style.BAND, linewidth=0, gid="band")
    axes.axhline(1.0, color=style.INK, linewidth=0.6, linestyle=DASHED)
    axes.plot(time, over_time, color=style.DOT, linewidth=0.9, gid="ratio")
    size = f"{of.mean:.3f}" if of.mean < FAR else f"{of.mean:,.0f}"
    inside = f"{100.0 * of.inside:.1f} % of the time in the band"
    style.headline(axes, name, f"mean {size}, {inside}")
    style.name_axis(axes.yaxis, axis)
    # A few moments, as those of the start, may leave the panel.
    low, high = np.percentile(over_time, (1.0, 99.0))
    low, high = min(low, float(lower.min())), max(high, float(upper.max()))
    if high > FAR:
        axes.set_ylim(max(low, 0.1) / 1.5, high * 1.5)
        logarithmic(axes)
    else:
        margin = 0.15 * (high - low)
        axes.set_ylim(low - margin, high + margin)


def logarithmic(axes: Axes) -> None:
    """Give a panel a logarithmic axis with plain numbers."""
    axes.set_yscale("log")
    low, high = axes.get_ylim()
    steps = (1.0,) if high > 50.0 * low else (1.0, 2.0, 5.0)
    axes.yaxis.set_major_locator(LogLocator(subs=steps))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())


def handles(result: MonteCarlo) -> list[Artist]:
    """Make the legend, with the lost runs by their numbers."""
    entries: list[Artist] = [
        Line2D([], [], color=style.DOT, linewidth=1.1, label=f"{result.runs} runs")
    ]
    if result.bound is not None:
        entries.append(
            Line2D(
                [], [], color=style.INK, linewidth=0.8, linestyle=DASHED,
                label="posterior Cramér-Rao bound",
            )
        )  # fmt: skip
    entries.append(Patch(facecolor=style.BAND, label="95 % band"))
    if len(result.lost):
        more = ", ..." if len(result.lost) > NAMED else ""
        numbers = ", ".join(map(str, result.lost[:NAMED])) + more
        words = f"{len(result.lost)} lost: {numbers}"
        entries.append(Line2D([], [], color=style.ELLIPSE, linewidth=0.6, label=words))
    return entries
