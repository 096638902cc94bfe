"""What is left of a camera's calibration, over its picture."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from numpy.typing import NDArray

from . import style

Array = NDArray[np.float64]
LONGEST = 0.06
"""Of the picture's width: how long the typical residual is drawn."""


def residuals_figure(
    size: tuple[int, int],
    pixels: Array,
    residuals: Array,
    covered: NDArray[np.bool_] | None = None,
    before: Array | None = None,
    used: NDArray[np.bool_] | None = None,
) -> Figure:
    """Draw residuals where they are in the picture, and about their mean.

    Parameters
    ----------
    size : (w, h) px
    pixels, residuals : (n, 2) px
        Where something was seen, and that less where it is projected.
    covered : (rows, columns) bool
        Cells of the picture; those without anything are hatched.
    before : (n, 2) px
        Residuals before the calibration.
    used : (n,) bool
        False for outliers.
    """
    used = np.ones(len(pixels), dtype=bool) if used is None else used
    figure = style.canvas(style.WIDTH * 0.58 * size[1] / size[0] + 0.6)
    image, cloud = figure.subplots(1, 2, width_ratios=(1.5, 1.0))
    for axes in (image, cloud):
        style.dress(axes)
    _in_picture(image, size, pixels[used], residuals[used], covered)
    if not used.all():
        image.plot(*pixels[~used].T, "x", color=style.ELLIPSE, markersize=3, markeredgewidth=0.7)
    _cloud(cloud, residuals[used], None if before is None else before[used])
    return figure


def _in_picture(
    axes: Axes,
    size: tuple[int, int],
    pixels: Array,
    residuals: Array,
    covered: NDArray[np.bool_] | None,
) -> None:
    width, height = size
    if covered is not None:
        rows, columns = covered.shape
        for row, column in zip(*np.nonzero(~covered), strict=True):
            corner = (column * width / columns, row * height / rows)
            axes.add_patch(
                Rectangle(
                    corner, width / columns, height / rows, facecolor="none", edgecolor="#cccccc",
                    hatch="///", linewidth=0,
                )
            )  # fmt: skip
    typical = float(np.percentile(np.hypot(*residuals.T), 90.0))
    factor = LONGEST * width / max(typical, 1e-9)
    axes.quiver(
        *pixels.T, *residuals.T, angles="xy", scale_units="xy", scale=1 / factor,
        color=style.ESTIMATE, width=0.0025, zorder=3,
    )  # fmt: skip
    axes.plot(*pixels.T, ".", color=style.INK, markersize=1.2, zorder=4)
    axes.set(xlim=(-0.5, width - 0.5), ylim=(height - 0.5, -0.5), aspect="equal")
    style.name_axis(axes.xaxis, "u (px)")
    style.name_axis(axes.yaxis, "v (px)")
    style.headline(axes, f"residuals, {factor:.0f} times as long")


def _cloud(axes: Axes, residuals: Array, before: Array | None) -> None:
    axes.plot(*residuals.T, ".", color=style.DOT, markersize=2)
    limit = 1.1 * float(np.nanmax(np.abs(residuals)))
    axes.set(xlim=(-limit, limit), ylim=(limit, -limit), aspect="equal")
    style.name_axis(axes.xaxis, "residual in u (px)")
    style.name_axis(axes.yaxis, "in v (px)")
    was = "" if before is None else f", before {_rms(before)}"
    style.headline(axes, _rms(residuals) + was)


def _rms(residuals: Array) -> str:
    return f"{np.sqrt(np.nanmean((residuals**2).sum(axis=1))):.3g} px rms"
