"""A map as its sensors see it: how sure one frame makes the position, place by place."""

import math

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap, LogNorm
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from ..site import Survey
from ..site.words import motion_words
from . import style
from .plane import draw_markers, plane

BAR = 0.7
"""Inches for the colour bar."""
PARTNERS = 60
"""More lines than this hide what they are drawn on."""
COLOURS = LinearSegmentedColormap.from_list("sure", ["#08306b", "#2f6f9f", "#8fbcdb", "#eef4f9"])
"""From sure to unsure, monotonic in grey."""


def site_figure(survey: Survey) -> Figure:
    """Draw the 95 % radius of an average frame, blind zones, and markers with their partners.

    Where the radius is above `status.alert_limit_m`, and where no marker is in view whichever way
    the robot heads, the ground is hatched.
    """
    low_x, low_y, high_x, high_y = survey.coverage.ground.area
    figure, axes = plane(np.array([[low_x, low_y], [high_x, high_y]]), beside=BAR)
    axes.set(xlim=(low_x, high_x), ylim=(low_y, high_y))
    axes.grid(False)
    draw_radius(figure, axes, survey)
    handles = draw_zones(axes, survey)
    handles += draw_partners(axes, survey)
    handles += draw_circle(axes, survey)
    handles += draw_markers(axes, survey.config.map, survey.layout.names)
    style.legend(figure, handles)
    return figure


def draw_radius(figure: Figure, axes: Axes, survey: Survey) -> None:
    """Colour each place by the radius of an average frame."""
    coverage = survey.coverage
    sure = np.ma.masked_invalid(coverage.average_m)
    if sure.count() == 0:
        return
    low, high = np.percentile(sure.compressed(), [2.0, 98.0])
    norm = LogNorm(low, max(high, 2.0 * low))
    low_x, low_y, high_x, high_y = coverage.ground.area
    image = axes.imshow(
        sure, cmap=COLOURS, norm=norm, extent=(low_x, high_x, low_y, high_y), origin="lower",
        interpolation="nearest", aspect="equal", gid="radius", zorder=1,
    )  # fmt: skip
    bar = figure.colorbar(image, cax=axes.inset_axes((1.02, 0.0, 0.03, 1.0)))
    bar.ax.yaxis.set_major_locator(LogLocator(subs=(1.0, 1.5, 2.0, 3.0, 5.0, 7.0)))
    bar.ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    bar.ax.yaxis.set_minor_formatter(NullFormatter())
    bar.ax.tick_params(labelsize=style.SMALL, width=0.6, length=3)
    bar.outline.set_linewidth(0.6)
    known = f"{math.degrees(survey.sigma_heading_rad):.2g}°"
    text = f"95 % radius of an average frame, heading known to {known} (m)"
    style.name_axis(bar.ax.yaxis, text)


def draw_zones(axes: Axes, survey: Survey) -> list[Artist]:
    """Hatch where an average frame is not enough, and more densely where none shows a marker."""
    coverage = survey.coverage
    unsure = coverage.average_m > survey.alert_limit_m
    blind = np.all(coverage.count == 0, axis=-1)
    handles: list[Artist] = []
    for zone, hatch, name in (
        (unsure & ~blind, "////", f"above {survey.alert_limit_m:g} m, or not fixed"),
        (blind, "xxxxxx", "no marker in view"),
    ):
        if not zone.any():
            continue
        low_x, low_y, high_x, high_y = coverage.ground.area
        fine = np.where(zone, 1.0, 0.0)
        filled = axes.contourf(
            np.concatenate([[low_x], coverage.ground.x, [high_x]]),
            np.concatenate([[low_y], coverage.ground.y, [high_y]]),
            np.pad(fine, 1, mode="edge"),
            levels=[0.5, 1.5], colors="none", hatches=[hatch], zorder=2,
        )  # fmt: skip
        filled.set_edgecolor(style.FAINT)
        filled.set_linewidth(0.0)
        filled.set_gid(name)
        handles.append(
            Patch(facecolor="white", edgecolor=style.FAINT, hatch=hatch, linewidth=0.5, label=name)
        )
    return handles


def draw_partners(axes: Axes, survey: Survey) -> list[Line2D]:
    """Join each marker to the one that it falls on, by the motion that brings most onto others."""
    told = [match for match in survey.symmetries if match.ids_help]
    if not told or len(told[0].origin) > PARTNERS:
        return []
    match, z = told[0], survey.layout.z
    pairs = np.unique(np.sort(np.column_stack([match.origin, match.target]), axis=1), axis=0)
    ends = np.column_stack([z[pairs], np.full(len(pairs), np.nan)])
    return axes.plot(
        ends.real.ravel(), ends.imag.ravel(), color=style.ELLIPSE, linewidth=0.9,
        linestyle=(0, (5, 3)), zorder=3, gid="partners",
        label=f"alike without ids: {motion_words(survey, match)}",
    )  # fmt: skip


def draw_circle(axes: Axes, survey: Survey) -> list[Line2D]:
    """Draw the danger circle that most poses are near, where only bearings are measured."""
    circles = [view.circle for view in survey.views.on_circle if view.circle]
    if not survey.bearings_only or not circles:
        return []
    around = circles[0].centre + circles[0].radius * np.exp(1j * np.linspace(0.0, 2.0 * np.pi, 181))
    return axes.plot(
        around.real, around.imag, color=style.ELLIPSE, linewidth=1.1, linestyle=(0, (1, 1.5)),
        zorder=3, gid="circle", label="here bearings do not fix the position",
    )  # fmt: skip
