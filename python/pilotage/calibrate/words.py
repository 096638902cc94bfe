"""A mounting in words: for the screen and for the configuration."""

import math

import numpy as np

from .extrinsics import Extrinsics
from .reprojection import NAMES


def left_words(found: Extrinsics) -> str:
    """Say how many sightings there are and what is left of them before and after."""
    before, after = (
        np.sqrt(np.nanmean((left[found.used] ** 2).sum(axis=1)))
        for left in (found.before, found.after)
    )
    pictures = len(np.unique(found.seen.utime[found.used]))
    aside = {**found.dropped, "outliers": int((~found.used).sum())}
    others = ", ".join(f"{count} {reason}" for reason, count in aside.items() if count)
    return (
        f"{np.count_nonzero(found.used)} sightings in {pictures} pictures, {before:.2f} px rms "
        f"before and {after:.3f} px after" + (f"; left aside: {others}" if others else "")
    )


def parameter_rows(found: Extrinsics) -> list[tuple[str, ...]]:
    """Return a table of the parameters, in mm, degrees and ms."""
    rows: list[tuple[str, ...]] = [("", "start", "found", "sigma", "unit")]
    for index, name in enumerate(NAMES):
        factor, unit = _units(name)
        start, value, sigma = (factor * a[index] for a in (found.start, found.values, found.sigmas))
        told = (f"{value:.2f}", f"{sigma:.2f}") if found.free[index] else ("held", "")
        rows.append((name.rpartition("_")[0], f"{start:.2f}", *told, unit))
    return rows


def configuration_lines(sensor: str, found: Extrinsics) -> str:
    """Return the lines for the configuration, of what was looked for."""
    lines = [
        f"    {name}: {value:.6g}"
        for name, value, free in zip(NAMES, found.values, found.free, strict=True)
        if free
    ]
    return "\n".join(["sensors:", f"  {sensor}:", *lines])


def _units(name: str) -> tuple[float, str]:
    if name.endswith("_rad"):
        return math.degrees(1.0), "°"
    return 1e3, "ms" if name.endswith("_s") else "mm"
