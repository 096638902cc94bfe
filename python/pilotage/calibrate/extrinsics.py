"""How a camera is mounted, from a drive past surveyed markers."""

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import CameraModel, MarkerMap, associate_pixels
from ..camera.detection import Array
from ..evaluate.truth import interpolate
from .reprojection import NAMES, Problem, mounted
from .sightings import Sightings

OUTSIDE = 4.0
"""Robust standard deviations beyond which a sighting is left out of the last fit."""
ROUNDS = 4
FEWEST = 8


@dataclass(frozen=True, eq=False)
class Extrinsics:
    """What a calibration found.

    Attributes
    ----------
    start, values, sigmas : (7,)
        In the order of `NAMES`: m, rad, s. A parameter that was held has sigma 0.
    covariance : (7, 7)
    free : (7,) bool
        Which parameters were looked for.
    seen : Sightings
        Those that have a marker and a pose.
    marker : (n,) int
        Index into the map of each.
    before, after : (n, 2) px
        Seen less projected, from the start and from the values found.
    used : (n,) bool
        False for outliers.
    dropped : dict of str to int
        How many sightings were left aside before, by reason.
    """

    start: Array
    values: Array
    covariance: Array
    free: NDArray[np.bool_]
    seen: Sightings
    marker: NDArray[np.intp]
    before: Array
    after: Array
    used: NDArray[np.bool_]
    dropped: dict[str, int]

    @property
    def sigmas(self) -> Array:
        """Standard deviations."""
        return np.sqrt(self.covariance.diagonal())


def calibrate(
    camera: CameraModel,
    seen: Sightings,
    poses: NDArray[Any],
    markers: MarkerMap,
    start: Array,
    hold: Collection[str] = ("latency_s",),
    radius_px: float = 64.0,
) -> Extrinsics:
    """Fit the mounting by least squares on the reprojection.

    Sightings without ids are of the marker that is projected nearest within a radius, as Kiriy and
    Buehler (2002) had it, which shrinks as the mounting is found.

    Parameters
    ----------
    poses : structured (m,) of utime, x, y, heading
        Of the robot: the truth, or those of a run that did not use this camera.
    start : (7,) in the order of `NAMES`
        As measured with a ruler.
    hold : names of parameters that are left as they are

    Raises
    ------
    ValueError
        If what is left of the sightings is too little; says why the others were left aside.
    """
    free = np.array([name not in hold for name in NAMES])
    if not free.any():
        raise ValueError("all parameters are held: nothing is left to look for")
    dropped: dict[str, int] = {}
    # Where a pose is known however the latency comes out.
    margin = round(3e6 * (0.05 if free[6] else 0.0))
    sides = [
        interpolate(poses, seen.utime - round(1e6 * start[6]) + aside)[:, 0]
        for aside in (-margin, margin)
    ]
    known = np.isfinite(sides[0]) & np.isfinite(sides[1])
    dropped["no pose at their time"] = int((~known).sum())
    seen = seen.rows(known)
    values, radius = start, radius_px
    for turn in range(ROUNDS):
        marker = associate(camera, seen, poses, markers, values, radius)
        there = marker >= 0
        if turn == 0:
            dropped["of no marker"] = int((~there).sum())
        _enough(there, dropped, radius)
        part = seen.rows(there)
        problem = Problem(camera, poses, part, markers.positions[marker[there]])
        values = problem.fit(values, free, robust=True)
        left = problem.residuals(values)
        radius = min(radius, max(4.0, 10 * _scatter(left / part.sigma) * part.sigma.max()))
    dropped["of no marker"] = int((~there).sum())
    points = markers.positions[marker[there]]
    used = np.hypot(*(left / part.sigma).T) < OUTSIDE * _scatter(left / part.sigma)
    _enough(used, dropped, radius_px)
    final = Problem(camera, poses, part.rows(used), points[used])
    values = final.fit(values, free, robust=False)
    which = np.flatnonzero(free)
    covariance = np.zeros((7, 7))
    covariance[np.ix_(which, which)] = final.covariance(values, start, which)
    return Extrinsics(
        start,
        values,
        covariance,
        free,
        part,
        marker[there],
        problem.residuals(start),
        problem.residuals(values),
        used,
        {reason: count for reason, count in dropped.items() if count},
    )


def associate(
    camera: CameraModel,
    seen: Sightings,
    poses: NDArray[Any],
    markers: MarkerMap,
    values: Array,
    radius_px: float,
) -> NDArray[np.intp]:
    """(n,) index into the map of the marker that a sighting is of, -1 none."""
    index = {int(number): i for i, number in enumerate(markers.ids)}
    marker = np.array([index.get(int(number), -1) for number in seen.id], dtype=np.intp)
    unknown = seen.id < 0
    body = mounted(camera, values)
    mounting = (*values[:3], values[5])
    for time in np.unique(seen.utime[unknown]):
        rows = np.flatnonzero(unknown & (seen.utime == time))
        (pose,) = interpolate(poses, [time - round(1e6 * values[6])])
        if np.isfinite(pose).all():
            numbers = associate_pixels(
                body, mounting, tuple(pose), markers, seen.pixel[rows], radius_px, seen.label[rows]
            )
            marker[rows] = [index.get(int(number), -1) for number in numbers]
    return marker


def _scatter(normal: Array) -> float:
    """Robust standard deviation of normalised residuals (n, 2), at least a little."""
    return max(1.4826 * float(np.nanmedian(np.abs(normal))), 1e-6)


def _enough(kept: NDArray[np.bool_], dropped: dict[str, int], radius_px: float) -> None:
    if np.count_nonzero(kept) >= FEWEST:
        return
    why = ", ".join(f"{count} {reason}" for reason, count in dropped.items() if count)
    raise ValueError(
        f"{np.count_nonzero(kept)} sightings of surveyed markers are left, at least {FEWEST} are "
        f"needed{f' ({why})' if why else ''}. Do poses and pictures have one clock, and is the "
        f"start right to {radius_px:g} px? 10° of the image are some 100 px: name a larger --radius"
    )
