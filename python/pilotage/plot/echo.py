"""Ultrasonic echoes: the record with its envelope, and errors against noise and distance."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.artist import Artist
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter, ScalarFormatter
from numpy.typing import NDArray

from . import style

Line = tuple[Sequence[float] | NDArray[np.float64], Sequence[float] | NDArray[np.float64]]


def echo_figure(
    times: NDArray[np.float64],
    samples: NDArray[np.float64],
    envelope: NDArray[np.float64],
    fitted: NDArray[np.float64],
    moments: Mapping[str, float],
) -> Figure:
    """Draw a record over time [s], all (n,), with moments [s] marked by their names."""
    figure = style.canvas(3.0)
    axes = figure.subplots()
    style.dress(axes)
    ms = times * 1e3
    handles: list[Artist] = []
    handles += axes.plot(
        ms, samples, color=style.ESTIMATE, linewidth=0.5, alpha=0.8, label="samples", gid="samples"
    )
    handles += axes.plot(
        ms, envelope, color=style.ELLIPSE, linewidth=1.1, label="Hilbert envelope", gid="envelope"
    )
    handles += axes.plot(
        ms, fitted, color=style.INK, linewidth=1.5, label="fitted by the UKF", gid="fitted"
    )
    looks = (("-", style.category(2)[0]), ("--", style.INK), (":", style.category(4)[0]))
    for (name, at), (line, colour) in zip(moments.items(), looks, strict=False):
        drawn = axes.axvline(at * 1e3, color=colour, linestyle=line, linewidth=1.3, label=name)
        handles.append(drawn)
    axes.set_xlim(ms[0], ms[-1])
    style.name_axis(axes.xaxis, "time since the ping (ms)")
    style.name_axis(axes.yaxis, "amplitude (first echo: 1)")
    style.legend(figure, handles)
    return figure


def against_noise_figure(errors: Mapping[str, Line], bounds: Mapping[str, Line]) -> Figure:
    """Draw errors [µs] over the peak signal-to-noise ratio [dB], and the bounds as broken lines."""
    figure = style.canvas(3.3)
    axes = figure.subplots()
    style.dress(axes)
    handles = []
    for i, (name, (x, y)) in enumerate(errors.items()):
        colour, shape = style.category((4, 0, 2)[i])
        handles += axes.plot(
            x, y, color=colour, marker=shape, markersize=5, linewidth=1.1, label=name, gid=name
        )
    for (name, (x, y)), line in zip(bounds.items(), ("--", ":", "-."), strict=False):
        handles += axes.plot(
            x, y, color=style.INK, linestyle=line, linewidth=1.0, label=name, gid=name
        )
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.yaxis.set_major_formatter(ScalarFormatter())
    axes.yaxis.set_minor_formatter(NullFormatter())
    style.name_axis(axes.xaxis, "peak signal-to-noise ratio of the samples (dB)")
    style.name_axis(axes.yaxis, "time of flight, RMSE (µs)")
    style.legend(figure, handles)
    return figure


def against_distance_figure(errors: Mapping[str, Line], bound: Line) -> Figure:
    """Draw range errors [mm] over the distance [m], and their bound as a line."""
    figure = style.canvas(3.0)
    axes = figure.subplots()
    style.dress(axes)
    handles = []
    for i, (name, (x, y)) in enumerate(errors.items()):
        colour, shape = style.category((4, 0)[i])
        handles += axes.plot(
            x, y, color=colour, marker=shape, markersize=5, linestyle="none", markeredgewidth=1.4,
            label=name, gid=name,
        )  # fmt: skip
    handles += axes.plot(
        *bound,
        color=style.INK,
        linestyle="--",
        linewidth=1.0,
        label="Cramér-Rao bound",
        gid="bound",
    )
    axes.set_xlim(left=0.0)
    axes.set_ylim(bottom=0.0)
    style.name_axis(axes.xaxis, "distance (m)")
    style.name_axis(axes.yaxis, "range, RMSE (mm)")
    style.legend(figure, handles)
    return figure
