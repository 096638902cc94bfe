"""The one style of all figures: made for print, safe for colour-blind readers, legible in grey.

Everything is set on the artists themselves, without pyplot and without a change to matplotlib's
global state, so figures can be made in any thread.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

WIDTH = 6.5  # inches: the text width of an A4 or letter page
DPI = 150
TEXT = 8.5
SMALL = 7.5

INK = "#1a1a1a"
"""Text, axes and truth."""
ESTIMATE = "#4f97c9"
"""Lighter than the truth, also in grey."""
BAND = "#cfe0ee"
"""Region that a stated probability falls into."""
DOT = "#2f6f9f"
MARKER = "#e69f00"
ELLIPSE = "#d55e00"
FAINT = "#9a9a9a"

# Okabe and Ito's colours and darker ones; the shapes tell them apart in grey.
CATEGORIES = (
    ("#d55e00", "x"),
    ("#cc79a7", "v"),
    ("#009e73", "s"),
    ("#000000", "+"),
    ("#0072b2", "D"),
    ("#a89400", "^"),
    ("#7a3b00", "p"),
    ("#666666", "h"),
)


def category(index: int) -> tuple[str, str]:
    """Return colour and shape of the index-th category."""
    return CATEGORIES[index % len(CATEGORIES)]


def stack(
    heights: Sequence[float], xlabel: str = "time since start (s)"
) -> tuple[Figure, list[Axes]]:
    """Make panels above each other with one time axis; heights in inches."""
    figure = canvas(sum(heights) + 0.5)
    axes = figure.subplots(
        len(heights), 1, sharex=True, squeeze=False, height_ratios=list(heights)
    )[:, 0]
    for panel in axes:
        dress(panel)
    axes[-1].set_xlabel(xlabel, fontsize=TEXT, color=INK)
    figure.align_ylabels(list(axes))
    return figure, list(axes)


def canvas(height: float) -> Figure:
    """Make an empty figure of the common width; height in inches."""
    layout = ConstrainedLayoutEngine(w_pad=0.06, h_pad=0.06, hspace=0.04)
    return Figure(figsize=(WIDTH, height), dpi=DPI, facecolor="white", layout=layout)


def dress(axes: Axes) -> None:
    """Give a panel thin axes at the left and below, quiet grid."""
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set(linewidth=0.6, color=INK)
    axes.tick_params(labelsize=SMALL, width=0.6, length=3, color=INK, labelcolor=INK)
    axes.tick_params(which="minor", labelsize=SMALL, width=0.4, length=1.5, color=INK)
    axes.grid(True, linewidth=0.4, color="#e4e4e4")
    axes.set_axisbelow(True)


def name_axis(axis: Axis, text: str) -> None:
    """Label an axis; the text ends in its unit."""
    axis.set_label_text(text, fontsize=TEXT, color=INK)


def headline(axes: Axes, left: str, right: str = "") -> None:
    """Say above a panel what it shows, and a figure of merit at its right end."""
    axes.set_title(left, loc="left", fontsize=TEXT, color=INK, pad=4)
    axes.set_title(right, loc="right", fontsize=SMALL, color=INK, pad=4)


def note(axes: Axes, text: str) -> None:
    """Say in the middle of an empty panel why it is empty."""
    axes.set_yticks([])
    axes.text(
        0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center",
        fontsize=TEXT, color=FAINT,
    )  # fmt: skip


def legend(figure: Figure, handles: Sequence[Artist]) -> None:
    """Put a legend in lines above the panels, where it hides nothing."""
    figure.legend(
        handles=list(handles), loc="outside upper left", ncols=columns_for(handles),
        frameon=False, fontsize=SMALL, labelcolor=INK, borderpad=0.2, handlelength=1.8,
        columnspacing=1.6,
    )  # fmt: skip


def columns_for(handles: Sequence[Artist]) -> int:
    """Find the most columns that fit, from inches a letter and a handle."""
    lengths = [0.055 * len(str(handle.get_label())) + 0.45 for handle in handles]
    for columns in range(len(lengths), 1, -1):
        rows = -(-len(lengths) // columns)
        if sum(max(lengths[i : i + rows]) for i in range(0, len(lengths), rows)) <= WIDTH:
            return columns
    return 1


def corner_legend(axes: Axes) -> None:
    """Put a legend of the panel's labelled artists in the line above its right end."""
    axes.legend(
        loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=4, frameon=False, fontsize=SMALL,
        labelcolor=INK, borderpad=0.0, borderaxespad=0.3, handlelength=1.2, columnspacing=1.2,
    )  # fmt: skip


def tag(
    axes: Axes,
    text: str,
    at: tuple[float, float],
    offset: tuple[float, float],
    **how: Any,
) -> None:
    """Write a small text beside a point of the data, offset in points, readable on top of lines.

    Tags of points outside the panel do not show, and none takes part in the layout.
    """
    look: dict[str, Any] = {"fontsize": SMALL, "color": INK, "zorder": 6} | how
    label = axes.annotate(
        text, at, xytext=offset, textcoords="offset points", annotation_clip=True, **look
    )
    label.set_path_effects([withStroke(linewidth=1.8, foreground="white")])
    label.set_in_layout(False)


def percent(probability: float) -> str:
    """Write a probability: 0.95 is "95 %", 0.9545 is "95.4 %"."""
    return f"{100.0 * probability:.3g} %"


def share(part: NDArray[np.bool_]) -> str:
    """Write how many of the rows are true: "81.0 %"."""
    return f"{100.0 * float(np.mean(part)):.1f} %"


def save(figure: Figure, path: Path) -> None:
    """Write the figure as a PNG; `Figure.savefig` would draw it twice."""
    FigureCanvasAgg(figure).print_png(path)  # type: ignore[no-untyped-call]


def seconds(utime: NDArray[np.int64], start: int) -> NDArray[np.float64]:
    """Return the time since the start, s."""
    return np.asarray((utime - start) * 1e-6)
