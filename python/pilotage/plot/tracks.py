"""True and estimated positions, step by step (Sousa and others, figures 2, 3, 5 and 9)."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from ..simulate.pole_runs import World
from . import style
from .ellipse import ellipse_label, ellipses
from .plane import draw_markers

ELLIPSE_STEPS = 50
"""From one ellipse to the next: two seconds."""
SQUARE_STEPS = 5
"""From one square to the next."""
MARGIN_M = 0.6
POLES = (style.ESTIMATE, style.MARKER, "#009e73", "#cc79a7")
"""Colours of the estimates while each of them is in view."""


def tracks_figure(world: World, tracks: Mapping[str, NDArray[Any]]) -> Figure:
    """Draw where the robot was and what filters made of it, every 40 ms, a panel a filter.

    Parameters
    ----------
    tracks : name to structured array with x, y, heading, covariance
    """
    truth = world.drive.truth()
    points = np.concatenate(
        [world.poles.positions[:, :2], *(_xy(rows) for rows in (truth, *tracks.values()))]
    )
    low, high = points.min(axis=0) - MARGIN_M, points.max(axis=0) + MARGIN_M
    figure, panels = _panels(low, high, len(tracks))
    pole = _pole_of(world)
    for axes, (name, poses) in zip(panels, tracks.items(), strict=True):
        _draw_truth(axes, truth, world.struck)
        _draw_estimates(axes, poses, pole[np.searchsorted(truth["utime"], poses["utime"])])
        draw_markers(axes, world.poles)
        error = np.hypot(*(_xy(poses[-1:]) - _xy(truth[-1:]))[0])
        style.headline(axes, name, f"{error:.2f} m off")
    style.legend(figure, _handles(world, pole))
    return figure


def _panels(
    low: NDArray[np.float64], high: NDArray[np.float64], count: int
) -> tuple[Figure, list[Axes]]:
    """Make panels of equal scales, side by side or, where they are wide, above each other."""
    ratio = float((high - low)[1] / (high - low)[0])
    columns = count if ratio > 0.7 else 1
    width = (style.WIDTH - 0.6) / columns - 0.3
    figure = style.canvas((ratio * width + 0.45) * count / columns + 0.7)
    panels = figure.subplots(count // columns, columns, sharex=True, sharey=True, squeeze=False)
    for axes in panels.flat:
        style.dress(axes)
        axes.set_aspect("equal")
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
    for axes in panels[-1]:
        style.name_axis(axes.xaxis, "x in frame map (m)")
    for axes in panels[:, 0]:
        style.name_axis(axes.yaxis, "y in frame map (m)")
    return figure, list(panels.flat)


def _pole_of(world: World) -> NDArray[np.intp]:
    """(n + 1,) which pole was in view at each stamp; -1: none, or several."""
    count = np.bincount(world.seen.step, minlength=len(world.drive.utime))
    pole = np.full(len(count), -1)
    pole[world.seen.step] = world.seen.pole
    pole[count != 1] = -1
    return pole


def _draw_truth(axes: Axes, truth: NDArray[Any], struck: int) -> None:
    for part in (truth[:struck], truth[struck:]):
        axes.plot(
            part["x"], part["y"], linewidth=0.5, color=style.INK, gid="truth", marker="s",
            markersize=3.0, markevery=SQUARE_STEPS, markerfacecolor="none", markeredgewidth=0.5,
        )  # fmt: skip
    if struck:
        before, after = _xy(truth[struck - 1 : struck + 1])
        axes.annotate(
            "", after, before, arrowprops={"arrowstyle": "->", "color": style.INK, "lw": 1.0}
        )
        style.tag(axes, "bump", tuple(after), (4, -9))


def _draw_estimates(axes: Axes, poses: NDArray[Any], pole: NDArray[np.intp]) -> None:
    rows = poses[::ELLIPSE_STEPS]
    outlines = ellipses(_xy(rows), rows["covariance"][:, :2, :2])
    axes.add_collection(
        PolyCollection(
            list(outlines), facecolor="none", edgecolor=style.ELLIPSE, linewidth=0.8, zorder=3,
            gid="ellipses",
        ),
        autolim=False,
    )  # fmt: skip
    for which in np.unique(pole):
        seen = poses[pole == which]
        axes.plot(
            seen["x"], seen["y"], linestyle="none", marker="o", markersize=2.2, gid="estimate",
            markerfacecolor=_colour(which), markeredgecolor="none", zorder=4,
        )  # fmt: skip


def _colour(pole: int) -> str:
    return style.FAINT if pole < 0 else POLES[pole]


def _xy(rows: NDArray[Any]) -> NDArray[np.float64]:
    return np.column_stack([rows["x"], rows["y"]])


def _handles(world: World, pole: NDArray[np.intp]) -> list[Artist]:
    def dots(shape: str, face: str, edge: str, size: float, label: str) -> Line2D:
        return Line2D(
            [], [], linestyle="none", marker=shape, markersize=size, markerfacecolor=face,
            markeredgecolor=edge, label=label,
        )  # fmt: skip

    handles: list[Artist] = [dots("s", "none", style.INK, 3, "robot")]
    for which in np.unique(pole[1:]):
        what = f"pole {which} in view" if which >= 0 else _unclear(world)
        handles.append(dots("o", _colour(which), "none", 4, f"estimate, {what}"))
    handles.append(Line2D([], [], color=style.ELLIPSE, linewidth=0.8, label=ellipse_label()))
    return handles


def _unclear(world: World) -> str:
    """What is in view where it is not one pole."""
    most = np.bincount(world.seen.step).max()
    return "no pole in view" if most == 1 else f"{most} poles in view"
