"""A survey as a file."""

import json
import math
from pathlib import Path
from typing import Any

import numpy as np

from .survey import Survey
from .symmetry import Match
from .words import motion_words


def save_report(survey: Survey, findings: list[dict[str, Any]], path: Path) -> None:
    """Write everything that was found as JSON; findings as they are."""
    content = to_dict(survey) | {"findings": findings}
    path.write_text(json.dumps(content, indent=1, allow_nan=False) + "\n", encoding="utf-8")


def to_dict(survey: Survey) -> dict[str, Any]:
    """Return numbers, ids and words; a length that is infinite becomes None."""
    views, coverage = survey.views, survey.coverage
    return {
        "markers": len(survey.layout),
        "tolerance_m": survey.tolerance_m,
        "sensors": [
            {
                "name": sight.name,
                "components": list(sight.components),
                "known_by": sight.known_by,
                "reach_m": _length(sight.reach_m),
                "view_deg": math.degrees(sight.view_rad),
            }
            for sight in survey.sights
        ],
        "area": dict(zip(("x_min", "y_min", "x_max", "y_max"), coverage.ground.area, strict=True)),
        "in_line": survey.in_line,
        "symmetries": [_match(survey, match) for match in survey.symmetries],
        "views": {
            "alike": views.part(views.alike),
            "in_line": views.part(views.in_line),
            "on_circle": views.part(views.on_circle, on_circle=True),
        },
        "in_view": [{"fewer_than": than} | coverage.fewer(than)._asdict() for than in (1, 2, 3)],
        "average_radius_95_m": {
            f"{100 * part:.0f} % of the area": _length(coverage.radius_of_part(part))
            for part in (0.1, 0.5, 0.9)
        },
    }


def _match(survey: Survey, match: Match) -> dict[str, Any]:
    ids = survey.layout.ids
    return {
        "words": motion_words(survey, match),
        "turn_deg": math.degrees(match.motion.angle_rad),
        "shift_m": [match.motion.shift.real, match.motion.shift.imag],
        "mirror": match.motion.mirror,
        "error_m": match.error_m,
        "pairs": np.column_stack([ids[match.origin], ids[match.target]]).tolist(),
    }


def _length(value_m: float) -> float | None:
    return float(value_m) if math.isfinite(value_m) else None
