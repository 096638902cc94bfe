"""What is doubtful about a calibration."""

import math

import numpy as np
from numpy.typing import NDArray

from .. import CameraModel
from ..checks.finding import Finding
from .intrinsics import Intrinsics, rms

FEW_VIEWS = 10
TILTED_RAD = math.radians(15)
"""A view that is tilted less tells hardly the focal length from the distance."""
CELLS = (8, 6)
"""Columns and rows of the picture that should all have corners in them."""
CORNER = 0.2
"""Of width and height: so near to a corner of the picture some corner of a board should be."""
COARSE_PX = 1.0
WORSE = 3.0
"""Times the median of views' residuals: such a view is named."""


def coverage(found: Intrinsics) -> NDArray[np.bool_]:
    """(rows, columns) whether a cell of the picture has any corner of a board."""
    u, v = np.concatenate([view.pixels for view in found.views]).T
    columns, rows = CELLS
    width, height = found.size
    count = np.histogram2d(v, u, (rows, columns), ((0, height), (0, width)))[0]
    return np.asarray(count > 0)


def doubts(found: Intrinsics) -> list[Finding]:
    """Return warnings: too few views, none tilted, corners of the picture never covered, ..."""
    return [
        *_views(found),
        *_corners(found),
        *_residuals(found),
        *_lens(found),
    ]


def _views(found: Intrinsics) -> list[Finding]:
    some = []
    if len(found.views) < FEW_VIEWS:
        some.append(
            Finding(
                "views",
                f"the board was found in {len(found.views)} pictures",
                f"take {FEW_VIEWS} to 20 of it",
            )
        )
    tilted = found.tilts_rad >= TILTED_RAD
    if np.count_nonzero(tilted) < 3:
        widest = math.degrees(found.tilts_rad.max())
        some.append(
            Finding(
                "tilt",
                f"the board faces the camera in nearly all pictures, {widest:.0f}° at most: focal "
                "length and distance are hardly told apart",
                "tilt it by 20 to 45° about either axis in most pictures",
            )
        )
    return some


def _corners(found: Intrinsics) -> list[Finding]:
    pixels = np.concatenate([view.pixels for view in found.views]) / np.array(found.size)
    missing = [
        f"{vertical} {side}"
        for vertical, v in (("top", 0.0), ("bottom", 1.0))
        for side, u in (("left", 0.0), ("right", 1.0))
        if not (np.abs(pixels - (u, v)).max(axis=1) < CORNER).any()
    ]
    if not missing:
        return []
    return [
        Finding(
            "coverage",
            f"no corner of a board was near the picture's {', '.join(missing)}: the lens is "
            "guessed there",
            "hold the board there, close enough to fill a good part of the picture",
        )
    ]


def _residuals(found: Intrinsics) -> list[Finding]:
    some = []
    if found.rms_px > COARSE_PX:
        some.append(
            Finding(
                "residuals",
                f"{found.rms_px:.2f} px are left",
                "is the board flat, its size right, and no picture smeared? Or another lens: "
                "--coefficients 8",
            )
        )
    each = np.array([rms(left) for left in found.residuals])
    for index in np.flatnonzero(each > WORSE * np.median(each)).tolist():
        some.append(
            Finding(
                found.views[index].name,
                f"{each[index]:.2f} px are left, of the others {np.median(each):.2f} px",
                "look at it, and leave it out if it is smeared",
            )
        )
    return some


def _lens(found: Intrinsics) -> list[Finding]:
    model = CameraModel(found.size, found.matrix, list(found.distortion))
    width, height = found.size
    ends = np.array([[0, 0], [width - 1, 0], [0, height - 1], [width - 1, height - 1]])
    blind = ~np.isfinite(model.rays(ends.astype(np.float64))).all(axis=1)
    if not blind.any():
        return []
    return [
        Finding(
            "lens",
            f"in {np.count_nonzero(blind)} of the picture's corners the distortion found is not "
            "one-to-one: what is seen there is refused",
            "cover the corners with the board, or take fewer coefficients: --coefficients 4",
        )
    ]
