"""Many runs together: errors beside the smallest possible ones, NEES and NIS in their bands."""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from numpy.typing import NDArray

from ..montecarlo.measures import mean, root_mean_square
from ..montecarlo.result import MonteCarlo, Nis
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
    low, high = (np.full(len(time), end) for end in result.anees_band)
    draw_ratio(panels[2], time, result.anees, (low, high), mean(result.anees))
    style.name_axis(panels[2].yaxis, "NEES / dof")
    for axes, (name, nis) in zip(panels[3:], result.nis.items(), strict=True):
        draw_nis(axes, name, nis)
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
        smallest = root_mean_square(bound)
        right += f", bound {smallest:.3g} {unit}, ratio {root_mean_square(rmse) / smallest:.3f}"
    style.headline(axes, "", right)
    style.name_axis(axes.yaxis, f"{name} ({unit})")
    logarithmic(axes)


def draw_ratio(
    axes: Axes,
    time: NDArray[np.float64],
    ratio: NDArray[np.float64],
    band: tuple[NDArray[np.float64], NDArray[np.float64]],
    average: float,
) -> None:
    """Draw what should be 1 within its band."""
    known = np.isfinite(ratio)
    if not known.any():
        return style.note(axes, "no pose")
    axes.fill_between(time, *band, facecolor=style.BAND, linewidth=0, gid="band")
    axes.axhline(1.0, color=style.INK, linewidth=0.6, linestyle=DASHED)
    axes.plot(time, ratio, color=style.DOT, linewidth=0.9, gid="ratio")
    inside = style.share((ratio >= band[0])[known] & (ratio <= band[1])[known])
    size = f"{average:.3f}" if average < FAR else f"{average:,.0f}"
    style.headline(axes, "", f"mean {size}, {inside} of the time in the band")
    # A few moments, as those of the start, may leave the panel.
    low, high = np.percentile(ratio[known], (1.0, 99.0))
    low, high = min(low, float(np.min(band[0]))), max(high, float(np.max(band[1])))
    if high > FAR:
        axes.set_ylim(max(low, 0.1) / 1.5, high * 1.5)
        logarithmic(axes)
    else:
        margin = 0.15 * (high - low)
        axes.set_ylim(low - margin, high + margin)


def draw_nis(axes: Axes, name: str, nis: Nis) -> None:
    """Draw a sensor's NIS of each second."""
    seen = np.isfinite(nis.over_time)
    time = (np.flatnonzero(seen) + 0.5).astype(np.float64)
    draw_ratio(axes, time, nis.over_time[seen], (nis.low[seen], nis.high[seen]), nis.mean)
    style.headline(axes, name, axes.get_title(loc="right"))
    style.name_axis(axes.yaxis, "NIS / dof")


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
