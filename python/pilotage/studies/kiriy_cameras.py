"""Section 2 of the first paper: pictures of two cameras to a pose, held against ideal angles."""

from collections.abc import Callable, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import numpy as np

from ..parallel import in_processes
from ..simulate import find_scenario
from .kiriy_camera_runs import VARIANTS, Outcome, drive
from .study import Findings, Request, Study, Table

RUNS = 3
SCENARIO, DURATION_S = "mower-cameras", 549.0
IDEAL, SURE, IMAGES, *_ = VARIANTS
SPOILED = f"{IMAGES}, spoiled"


class Bar(NamedTuple):
    """Something that has to be shown, by the seeds' worst."""

    what: str
    limit: float
    value: Callable[[Mapping[str, Outcome]], float]
    unit: str = "×"


BARS = (
    Bar(
        "images: mean position error by that of ideal angles",
        1.3,
        lambda by: by[IMAGES].mean_m / by[IDEAL].mean_m,
    ),
    Bar(
        "the same, by that of ideal angles as sure as images",
        1.3,
        lambda by: by[IMAGES].mean_m / by[SURE].mean_m,
    ),
    Bar("images: false associations", 0.5, lambda by: 100 * by[IMAGES].false_share, "%"),
    Bar(
        "20 % false, 20 % missed: RMSE by that without",
        1.5,
        lambda by: by[SPOILED].rmse_m / by[IMAGES].rmse_m,
    ),
    Bar("the same: false associations", 0.5, lambda by: 100 * by[SPOILED].false_share, "%"),
)


def run(request: Request) -> Findings:
    """Draw, detect, associate, fuse."""
    seeds = [request.seed + k for k in range(request.runs(RUNS))]
    calls = [(seed, DURATION_S) for seed in seeds]
    runs = list(in_processes(one_drive, calls, request.jobs, _died, request.progress))
    by_seed = dict(zip(seeds, runs, strict=True))
    results = {
        str(seed): {name: vars(outcome) for name, outcome in by.items()}
        for seed, by in by_seed.items()
    }
    return Findings(results, [_outcomes(by_seed), _bars(by_seed)])


def one_drive(seed: int, duration_s: float) -> dict[str, Outcome]:
    """Return what all ways to a pose make of one drive, by name."""
    from dataclasses import replace

    scenario = replace(find_scenario(SCENARIO), duration_s=duration_s)
    with TemporaryDirectory(prefix="pilotage-") as folder:
        return drive(scenario, seed, Path(folder))


def _outcomes(by_seed: Mapping[int, Mapping[str, Outcome]]) -> Table:
    def mean(name: str, what: Callable[[Outcome], float]) -> float:
        return float(np.mean([what(by[name]) for by in by_seed.values()]))

    def row(name: str) -> list[Any]:
        nis = " ".join(
            f"{mean(name, lambda o, s=sensor: o.nis[s]):.2f}"  # type: ignore[misc]
            for sensor in next(iter(by_seed.values()))[name].nis
        )
        return [
            name,
            f"{1e3 * mean(name, lambda o: o.mean_m):.1f}",
            f"{1e3 * mean(name, lambda o: o.rmse_m):.1f}",
            f"{mean(name, lambda o: o.nees):.2f}",
            nis,
            f"{mean(name, lambda o: o.fused):.0f}",
            f"{sum(by[name].wrong for by in by_seed.values())}",
        ]

    return Table(
        f"28 red markers, two cameras at 0.5 Hz, {DURATION_S:g} s; means of {_seeds(by_seed)}",
        (
            "from",
            "mean error (mm)",
            "RMSE (mm)",
            "NEES by 3",
            "NIS by dof, front rear",
            "fused",
            "wrong, all seeds",
        ),
        [row(name) for name in VARIANTS],
        "Ideal angles have no error and are weighed by the configured 0.5 px; those 'as sure as "
        "images' by what the detector states of each. Spoiled: 20 % of the detections missed, for "
        "20 % a false one beside. Wrong: fused with another marker than it is of, or of none.",
    )


def _bars(by_seed: Mapping[int, Mapping[str, Outcome]]) -> Table:
    rows = []
    for bar in BARS:
        values = [bar.value(by) for by in by_seed.values()]
        rows.append(
            (
                bar.what,
                f"{bar.limit:g} {bar.unit}",
                " ".join(f"{value:.2f}" for value in values),
                "yes" if max(values) <= bar.limit else "NO",
            )
        )
    return Table("What it must show", ("what", "at most", _seeds(by_seed), "met"), rows)


def _seeds(by_seed: Mapping[int, Any]) -> str:
    return f"seeds {' '.join(map(str, by_seed))}"


def _died(index: int) -> str:
    return f"a process died at run {index}, perhaps for want of memory: name fewer --jobs"


STUDY = Study(
    "Angles from images of two cameras, on rendered pictures of the paper's drive",
    "Kiriy and Buehler, Three-state extended Kalman filter for mobile robot localization, 2002",
    run,
)
