"""Odometry and coloured poles in one EKF, and a bump that odometry does not notice.

Section 4 of Sousa, Costa, Moreira and Carvalho rerun over many seeds, a circle like that of
section 5, and both poles at once, which the authors wished for.
"""

from collections import defaultdict
from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from ..evaluate.courses import Courses
from ..lcmtypes import status_t
from ..parallel import in_processes
from ..simulate.pole_runs import RUNS, static_errors
from ..simulate.poles import corner_poles, first_poles
from .sousa_filters import FILTERS, told_by
from .sousa_tables import BACK_M, BACK_S, BAR, OURS, PAPERS, PRINTED_IN, UNTOLD, Found, tables_of
from .study import Findings, Request, Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STRUCK, REST, CHUNK, STATIC_SETS = 200, 50, 10, 200
DRAWN = {
    "figure-2": ("stopped, in turn", (PAPERS, OURS, UNTOLD)),
    "figure-3": ("moving, in turn", (PAPERS, OURS, UNTOLD)),
    "figure-5": ("bump, in turn", (PAPERS, OURS)),
    "figure-5-both": (BAR, (PAPERS, OURS)),
    "figure-9": ("circle, by colour", (PAPERS, OURS)),
}
PLACES = {"poles 90° apart": (2.5, 0.0), "poles 39° apart": (-2.0, 0.0)}


def run(request: Request) -> Findings:
    """Do all runs, and the static measurements."""
    found = all_courses(request)
    sets = range(request.runs(STATIC_SETS))
    errors = [static_errors(np.random.default_rng((request.seed, k))) for k in sets]
    sigmas = np.array([np.sqrt(np.mean(e**2, axis=0)) for e in errors])
    results = {
        run: {name: course.summary(BACK_M, BACK_S) for name, course in by_filter.items()}
        for run, by_filter in found.items()
    }
    return Findings(
        {"runs": results, "sigmas": sigmas[0]}, tables_of(found, sigmas), figures(request, found)
    )


def courses(run: str, filters: Sequence[str], seed: int, numbers: range) -> list[Courses]:
    """Return how each of the filters does in the runs of these numbers."""
    worlds = [RUNS[run].world(np.random.default_rng((seed, k))) for k in numbers]
    return [
        Courses.of([(FILTERS[f](w), w.drive.truth(), w.struck) for w in worlds], status_t.OK)
        for f in filters
    ]


def all_courses(request: Request) -> dict[str, dict[str, Courses]]:
    """Return all runs, by run and filter."""
    calls: list[tuple[str, list[str], int, range]] = []
    for run in RUNS:
        filters = list(FILTERS) if run in PRINTED_IN else [PAPERS, OURS, UNTOLD]
        total = request.runs(STRUCK if run.startswith("bump") else REST)
        chunks = (range(k, min(k + CHUNK, total)) for k in range(0, total, CHUNK))
        calls += [(run, filters, request.seed, chunk) for chunk in chunks]

    def died(call: int) -> str:
        return f"a process died at or soon after '{calls[call][0]}'"

    found: dict[str, dict[str, list[Courses]]] = {run: defaultdict(list) for run in RUNS}
    done = in_processes(courses, calls, request.jobs, died, request.progress)
    for (run, filters, *_), parts in zip(calls, done, strict=True):
        for name, part in zip(filters, parts, strict=True):
            found[run][name].append(part)
    return {
        run: {name: Courses.joined(parts) for name, parts in by_filter.items()}
        for run, by_filter in found.items()
    }


def figures(request: Request, found: Found) -> dict[str, "Callable[[], Figure]"]:
    """Figures by the paper's numbers; of the first run of each."""
    from ..plot.courses import courses_figure
    from ..plot.overlap import overlap_figure
    from ..plot.tracks import tracks_figure

    def tracks(run: str, names: Sequence[str]) -> "Figure":
        world = RUNS[run].world(np.random.default_rng((request.seed, 0)))
        return tracks_figure(world, {name: FILTERS[name](world) for name in names})

    def overlap() -> "Figure":
        poles = first_poles(corner_poles(), 2)
        places = [(name, np.array(at), told_by(poles, at)) for name, at in PLACES.items()]
        return overlap_figure(poles, places)

    drawn: dict[str, Callable[[], Figure]] = {k: partial(tracks, *v) for k, v in DRAWN.items()}
    of_bump = {name: found[BAR][name] for name in (PAPERS, OURS)}
    drawn["figure-4"] = overlap
    drawn["bump"] = lambda: courses_figure(of_bump, BACK_M, BACK_S, "time since the bump (s)")
    return drawn


STUDY = Study(
    "odometry and coloured poles in one EKF, and a bump",
    "A. J. Sousa, P. J. Costa, A. P. Moreira and A. S. Carvalho, FEUP, after 2004",
    run,
)
