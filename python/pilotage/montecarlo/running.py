"""All runs of a scenario, in many processes."""

from collections.abc import Callable, Sequence
from dataclasses import fields
from typing import Any

import numpy as np

from ..parallel import in_processes
from ..simulate import Scenario
from .bound import Bound
from .result import MonteCarlo
from .trial import GRID_STEPS, Trial, chance, on_one_site, run_trial

CHUNK = 20
"""Runs that a process does before it reports."""


def run_montecarlo(
    scenario: Scenario,
    runs: int,
    seed: int = 1,
    jobs: int = 1,
    progress: Callable[[float], None] | None = None,
) -> MonteCarlo:
    """Do all runs and summarise them.

    The chance of a run follows from `seed` and the run's number alone, so the figures are the same
    for any number of processes.
    """
    scenario, markers = on_one_site(scenario, seed)
    drive = scenario.drive(scenario.duration_s)
    same = scenario.start.known and scenario.start.x_m is None and scenario.kidnap is None
    bound = Bound.of(scenario, markers, drive).every(GRID_STEPS) if same else None
    chunks = [range(first, min(first + CHUNK, runs)) for first in range(0, runs, CHUNK)]

    def died(chunk: int) -> str:
        return (
            f"a process died, at or soon after run {chunks[chunk][0]} of '{scenario.name}': "
            "--jobs 1 shows whether it is that"
        )

    calls = [(scenario, seed, chunk) for chunk in chunks]
    parts = list(in_processes(_run_chunk, calls, jobs, died, progress))
    trials = _joined(parts, np.concatenate)
    sensors = [(camera.name, camera.components) for camera in scenario.cameras]
    time_s = (drive.utime[::GRID_STEPS] - drive.utime[0]) * 1e-6
    return MonteCarlo(scenario.name, seed, time_s, trials, sensors, bound)


def _run_chunk(scenario: Scenario, seed: int, runs: range) -> Trial:
    return _joined([run_trial(scenario, chance(seed, run)) for run in runs], np.stack)


def _joined(trials: Sequence[Trial], join: Callable[[list[Any]], Any]) -> Trial:
    """Return one whose arrays have the runs in front."""
    return Trial(*(join([getattr(t, f.name) for t in trials]) for f in fields(Trial)))
