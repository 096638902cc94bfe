"""What a drive does not tell of a mounting."""

import math

import numpy as np

from ..checks.finding import Finding
from .extrinsics import Extrinsics
from .reprojection import NAMES

LIMITS = (0.05, 0.05, 0.05, math.radians(1), math.radians(1), math.radians(1), 0.05)
"""Standard deviations, m, rad, s, above which the drive did not tell a parameter."""
ALIKE = 0.9
"""Correlation above which two parameters are told only together."""
FEWER = 0.5
MANY_OUTLIERS = 0.1
REMEDIES = {
    "x_m": "pass markers close by, ahead and to the side, at several headings",
    "y_m": "pass markers close by, ahead and to the side, at several headings",
    "z_m": "pass markers close by: a far one shows the camera's pitch, not its height",
    "roll_rad": "have markers near the left and right borders of the picture",
    "pitch_rad": "have markers far off as well as near",
    "yaw_rad": "have markers far off as well as near",
    "latency_s": "drive fast and slow, and turn both ways",
}


def weaknesses(found: Extrinsics) -> list[Finding]:
    """Return what is not observable, and what else is doubtful."""
    some = []
    sigmas = found.sigmas
    with np.errstate(invalid="ignore", divide="ignore"):
        alike = found.covariance / np.outer(sigmas, sigmas)
    for index in np.flatnonzero(sigmas > LIMITS):
        others = [
            f"{NAMES[k]} ({alike[index, k]:+.2f})"
            for k in np.flatnonzero(found.free)
            if k != index and abs(alike[index, k]) > ALIKE
        ]
        only = f" apart from {', '.join(others)}" if others else ""
        some.append(
            Finding(
                NAMES[index],
                f"this drive does not tell it{only}",
                f"{REMEDIES[NAMES[index]]}, or hold it at what a ruler says: --hold {NAMES[index]}",
            )
        )
    outliers = 1 - found.used.mean()
    if outliers > MANY_OUTLIERS:
        some.append(
            Finding(
                "outliers",
                f"{outliers:.0%} of the sightings do not fit",
                "wrong markers (a smaller --radius, ids), a survey or poses that are off",
            )
        )
    return some
