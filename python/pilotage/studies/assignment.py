"""The assignment's program over example problems, each of which is to prove something.

"Localization and the extended Kalman filter", a course assignment: a robot among polygons is
commanded to move and to sense, and a filter keeps track of where it may be. The program itself is
`pilotage assignment`; here its examples run many times.
"""

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from ..evaluate import Ensemble
from ..parallel import in_processes
from .assignment_ends import WAYS, ends
from .assignment_handout import handout_table
from .assignment_narrative import PROBABILITY
from .assignment_problems import NAMES
from .assignment_tables import examples, must_show, proofs_of, ways
from .study import Findings, Request, Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

RUNS = 1000


def run(request: Request) -> Findings:
    """Run the examples, hold them against what they are to prove, and draw them."""
    from . import assignment_figures as figures

    n = request.runs(RUNS)
    calls = [(name, way, request.seed, n) for way in WAYS for name in NAMES]
    done = in_processes(
        ends, calls, request.jobs, lambda k: f"a process died at {calls[k]}", request.progress
    )
    found = {(name, way): one for (name, way, *_), one in zip(calls, done, strict=True)}
    printed, apart = handout_table()
    proofs = proofs_of(found, apart)
    results = {
        "runs": n,
        "handout": {row[0]: {"printed": row[1], "ours": row[2]} for row in printed.rows},
        "ends": {way: {name: _numbers(found[name, way]) for name in NAMES} for way in WAYS},
        "must_show": {what: numbers for what, *numbers in proofs},
    }
    tables = [printed, examples(found, n), ways(found), must_show(proofs)]
    drawn: dict[str, Callable[[], Figure]] = {
        "narrative": figures.narrative,
        "examples": partial(figures.examples, request.seed),
        "divergence": partial(figures.divergence, request.seed),
        "limits": partial(figures.limits, request.seed),
    }
    return Findings(results, tables, drawn)


def _numbers(of: Ensemble) -> dict[str, float | None]:
    """What is told of an example; None where it has no meaning."""
    values = {
        "position_rms_m": of.position_m,
        "position_stated_m": of.stated_m,
        "heading_rms_deg": of.heading_deg,
        "heading_stated_deg": of.stated_deg,
        "in_ellipse": of.in_ellipse(PROBABILITY),
        "in_cone": of.in_cone(),
        "lost": of.lost,
    }
    return {name: value if np.isfinite(value) else None for name, value in values.items()}


STUDY = Study(
    "A robot among polygons: commanded to move and to sense, by an extended Kalman filter",
    '"Localization and the extended Kalman filter", course assignment',
    run,
)
