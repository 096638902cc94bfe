"""Runs of faults, from the simulated drive to what came out of it, in many processes."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import islice
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from .. import Recording, lcmtypes, replay
from ..evaluate import CellFigures, Outcome, Timeline
from ..parallel import in_processes
from ..simulate import SCENARIOS, Cell, Scenario, Window, measure, suitable_config

TICK_US = 1_000_000
"""Between the node's statuses."""
CHUNK = 10
"""Runs that a process does before it reports."""


@dataclass(frozen=True)
class Said:
    """What the statuses of a run said.

    Attributes
    ----------
    at : (n,) int, µs
    ok : (n,) bool
    naming : (n,) bool
        Whether one of the inputs asked for had a problem, or the reason spoke of it.
    """

    at: NDArray[np.int64]
    ok: NDArray[np.bool_]
    naming: NDArray[np.bool_]

    @classmethod
    def of(cls, published: Recording, channel: str, inputs: Sequence[str]) -> "Said":
        """Decode the statuses."""
        kind = lcmtypes.status_t
        said = [kind.decode(data) for data in published.messages(channel)]
        naming = [
            any(
                i.problem or i.name in s.reason or i.channel in s.reason
                for i in s.inputs
                if i.name in inputs
            )
            for s in said
        ]
        return cls(
            published.arrivals(channel),
            np.array([s.state == kind.OK for s in said], dtype=bool),
            np.array(naming, dtype=bool),
        )


@dataclass(frozen=True)
class Task:
    """Some runs of a cell; `time` is the failing input's time policy, if not the configured one."""

    cell: Cell
    runs: int
    time: str | None = None


def run_tasks(
    scenario: str,
    tasks: Sequence[Task],
    window: Window,
    seed: int = 1,
    jobs: int = 1,
    progress: Callable[[float], None] | None = None,
) -> list[CellFigures]:
    """Do all runs in so many processes, and summarise each task's.

    The chance of a run follows from `seed`, the cell and the run's number alone, so the figures are
    the same for any number of processes.
    """
    chunks = [
        (task, range(first, min(first + CHUNK, task.runs)))
        for task in tasks
        for first in range(0, task.runs, CHUNK)
    ]

    def died(chunk: int) -> str:
        last = chunks[chunk][0].cell.name
        return (
            f"a process died, at or soon after '{last}': pilotage faults --jobs 1 --only "
            f"'{last}' shows whether it is that"
        )

    calls = [(scenario, task, window, seed, runs) for task, runs in chunks]
    outcomes: list[Outcome | str] = []
    for chunk in in_processes(_run_chunk, calls, jobs, died, progress):
        outcomes += chunk
    rest = iter(outcomes)
    return [CellFigures.of(list(islice(rest, t.runs)), t.cell.required) for t in tasks]


def run_once(
    scenario: Scenario, cell: Cell, window: Window, seed: Sequence[int], time: str | None = None
) -> Outcome | str:
    """Simulate a drive with a fault, localize it, and judge what was said.

    If the localizer crashes, that is the text of the exception.
    """
    rng = np.random.default_rng(np.random.SeedSequence(seed))
    measured = measure(scenario, rng)
    config = suitable_config(scenario, measured.markers, measured.drive)
    inputs = cell.inputs(measured)
    if time is not None:
        for name in inputs:
            section = f"sensors.{name}" if name in measured.sightings else name
            config[f"{section}.time"] = time
    recording = cell.strike(measured, scenario.cameras, window, rng).record()
    begin, end = (int(t) for t in measured.drive.utime[[0, -1]])
    recording.add_ticks(np.arange(begin, end, TICK_US) + int(rng.integers(TICK_US)))
    recording.sort()
    try:
        run = replay(config, recording, keep_messages=True)
    except Exception as error:
        return f"seed {list(seed)}: {type(error).__name__}: {error}"
    poses = run.poses
    said = Said.of(run.published, config["output.status"], inputs)
    timeline = Timeline.of(
        poses,
        run.published.arrivals(config["output.pose"]),
        poses["status"] == lcmtypes.status_t.OK,
        said.at,
        said.ok,
        measured.truth(),
    )
    finite = all(np.isfinite(poses[name]).all() for name in ("x", "y", "heading", "covariance"))
    return Outcome.of(timeline, finite, said.at[said.naming], window.at(begin))


def _run_chunk(
    scenario: str, task: Task, window: Window, seed: int, runs: range
) -> list[Outcome | str]:
    which = crc32(task.cell.title.encode())
    return [
        run_once(SCENARIOS[scenario], task.cell, window, (seed, which, run), task.time)
        for run in runs
    ]
