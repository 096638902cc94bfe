"""Normalised innovation squared of each sensor over time, with its chi-square band."""

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from ..evaluate import RunLike, mean_square_band
from . import style
from .thin import stride

PROBABILITY = 0.95
POINTS = 10_000
FEW = 1000
"""Up to so many sightings are drawn large."""


def nis_figure(run: RunLike) -> Figure:
    """Draw a panel for each sensor and number of measured components: each has its own band.

    Accepted sightings are dots, rejected ones have the colour and shape of their reason. A rejected
    sighting without a NIS, or with one above the panel, stands on the panel's upper edge.
    """
    reports = run.reports
    dof = components(reports)
    groups = np.unique(np.stack([reports["sensor"], dof]), axis=1).T.tolist()
    figure, panels = style.stack([1.9] * max(len(groups), 1))
    if not groups:
        style.note(panels[0], "no sightings")
        return figure

    time = style.seconds(reports["utime"], run.poses["utime"][0])
    for axes, (sensor, k) in zip(panels, groups, strict=True):
        chosen = (reports["sensor"] == sensor) & (dof == k)
        draw_panel(axes, time[chosen], reports[chosen], k, run.sensors[sensor])
    end = float(style.seconds(run.poses["utime"][-1], run.poses["utime"][0]))
    panels[0].set_xlim(min(0.0, time.min()), max(end, time.max(), 1e-6))
    style.legend(figure, handles(reports, run.reasons))
    return figure


def components(reports: NDArray[Any]) -> NDArray[np.int64]:
    """Count the measured components of each report; none counts as the sensor's most."""
    dof = reports["dof"].astype(np.int64)
    for sensor in np.unique(reports["sensor"]):
        own = reports["sensor"] == sensor
        dof[own & (dof == 0)] = dof[own].max()
    return dof


def draw_panel(
    axes: Axes, time: NDArray[np.float64], rows: NDArray[Any], dof: int, sensor: str
) -> None:
    """Draw one sensor's reports with one number of components."""
    accepted = rows["accepted"].astype(bool)
    nis = rows["nis"]
    low, high = mean_square_band(dof, PROBABILITY) if dof else (1.0, 1.0)
    largest = float(np.max(nis[np.isfinite(nis)], initial=0.0))
    bottom, top = low / 10.0, float(np.clip(1.5 * largest, 10.0 * high, 1000.0 * high))
    axes.set_yscale("log")
    axes.set_ylim(bottom, top)
    style.name_axis(axes.yaxis, "NIS")

    if dof:
        axes.axhspan(low, high, facecolor=style.BAND, linewidth=0, gid="band")
        axes.axhline(dof, color=style.INK, linewidth=0.6, linestyle=(0, (4, 3)), gid="expected")
    shown = np.where(np.isfinite(nis), np.clip(nis, bottom, top), top)
    few = rows.size < FEW
    fused = np.flatnonzero(accepted)
    fused = fused[stride(fused.size, POINTS)]
    axes.plot(
        time[fused], shown[fused], linestyle="none", marker=".", markersize=5 if few else 2.5,
        color=style.DOT, markeredgewidth=0, gid="accepted",
    )  # fmt: skip
    for reason in np.unique(rows["reason"][~accepted]):
        refused = np.flatnonzero(~accepted & (rows["reason"] == reason))
        refused = refused[stride(refused.size, POINTS)]
        colour, shape = style.category(int(reason))
        axes.plot(
            time[refused], shown[refused], linestyle="none", marker=shape, color=colour,
            markersize=4.5 if few else 3, markeredgewidth=0.8 if few else 0.5,
            markerfacecolor="none", clip_on=False, gid=f"rejected {reason}",
        )  # fmt: skip

    title = f"{sensor}, {dof} component{'s' if dof != 1 else ''}"
    if accepted.any():
        inside = style.share((nis[accepted] >= low) & (nis[accepted] <= high))
        style.headline(
            axes, title,
            f"{inside} of {accepted.sum()} accepted in the band, "
            f"mean {nis[accepted].mean():.2f} (expected {dof})",
        )  # fmt: skip
    else:
        style.headline(axes, title, "none accepted")


def handles(reports: NDArray[Any], reasons: Any) -> list[Artist]:
    """Make the legend: accepted, the band with its probability, and every reason with its count."""
    rejected = reports["reason"][~reports["accepted"].astype(bool)]
    entries: list[Artist] = [
        Line2D([], [], linestyle="none", marker=".", color=style.DOT, label="accepted"),
        Patch(facecolor=style.BAND, label=f"{style.percent(PROBABILITY)} band of χ²"),
        Line2D(
            [], [], color=style.INK, linewidth=0.6, linestyle=(0, (4, 3)), label="expected mean"
        ),
    ]
    for reason, count in zip(*np.unique(rejected, return_counts=True), strict=True):
        colour, shape = style.category(int(reason))
        entries.append(
            Line2D(
                [], [], linestyle="none", marker=shape, markersize=4, color=colour,
                markerfacecolor="none", label=f"rejected: {reasons[reason]} ({count})",
            )
        )  # fmt: skip
    return entries
