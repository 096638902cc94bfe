"""A survey in words, by sections."""

import math

import numpy as np

from .survey import Survey
from .symmetry import Match

LISTED = 4
"""Motions that are listed; `map.json` has all."""


def describe(survey: Survey) -> dict[str, list[str]]:
    """Return lines by section: seen, area, alike, in view, position."""
    return {
        "seen": [_seen(survey)],
        "area": [_area(survey)],
        "alike": _alike(survey),
        "in view": _in_view(survey),
        "position": _position(survey),
    }


def match_words(survey: Survey, match: Match) -> str:
    """Say what a motion does to the map: "turned by 180° about (1.0, 2.0) m, 8 of 10 …"."""
    count, n = len(match.origin), len(survey.layout)
    many = f"all {n}" if count == n else f"{count} of {n}"
    return f"{motion_words(survey, match)}, {many} markers fall on markers" + (
        f" within {match.error_m:.2f} m" if match.error_m >= 0.005 else ""
    )


def motion_words(survey: Survey, match: Match) -> str:
    """Say what a motion does, as of the middle of the map."""
    return match.motion.words(complex(survey.layout.z.mean()))


def percent(part: float) -> str:
    """Write a part, with a digit more where it is small but not nothing."""
    return f"{100.0 * part:.1f} %" if 0.0 < part < 0.095 else f"{100.0 * part:.0f} %"


def _up_to(radius_m: float) -> str:
    return f"up to {radius_m:.3g} m" if math.isfinite(radius_m) else "not fixed"


def _seen(survey: Survey) -> str:
    parts = [
        f"{s.name} measures {' and '.join(s.components)} ({s.known_by})" for s in survey.sights
    ]
    first = survey.sights[0]
    reach = f"to {first.reach_m:g} m" if math.isfinite(first.reach_m) else "however far"
    view = math.degrees(first.view_rad)
    return f"{'; '.join(parts)}; {reach}, {'all round' if view >= 360 else f'within {view:g}°'}"


def _area(survey: Survey) -> str:
    low_x, low_y, high_x, high_y = survey.coverage.ground.area
    cells = survey.coverage.ground.shape
    return (
        f"x {low_x:.1f} to {high_x:.1f} m, y {low_y:.1f} to {high_y:.1f} m, "
        f"in {cells[1]} × {cells[0]} places and {cells[2]} headings"
    )


def _alike(survey: Survey) -> list[str]:
    within = f"{survey.tolerance_m:.2g} m"
    lines = [match_words(survey, match) for match in survey.symmetries[:LISTED]]
    if more := len(survey.symmetries) - LISTED:
        lines += [f"and {more} other motions"] if more > 0 else []
    if not lines:
        lines = [f"no motion brings many of the markers onto others, within {within}"]
    part = survey.views.part(survey.views.alike)
    return [
        *lines,
        f"views of three markers or more that fit elsewhere too: {percent(part)} of all poses",
    ]


def _in_view(survey: Survey) -> list[str]:
    lines = ["markers       all poses  worst heading  best heading"]
    for than in (1, 2, 3):
        parts = map(percent, survey.coverage.fewer(than))
        name = "none" if than == 1 else f"fewer than {than}"
        lines.append("{:<12}  {:>9}  {:>13}  {:>12}".format(name, *parts))
    return lines


def _position(survey: Survey) -> list[str]:
    coverage, alert = survey.coverage, survey.alert_limit_m
    half, most = (_up_to(coverage.radius_of_part(part)) for part in (0.5, 0.9))
    heading = f"{math.degrees(survey.sigma_heading_rad):.2g}° (initial.sigma_heading_rad)"
    enough = percent(float(np.mean(coverage.radius_m <= alert)))
    return [
        f"95 % radius of an average frame, with the heading known to {heading}:",
        f"{half} in the better half of the area, {most} in nine tenths",
        f"one frame fixes it to {alert:g} m (status.alert_limit_m) from {enough} of all poses",
    ]
