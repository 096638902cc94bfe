"""One run: a robot drawn from its priors drives, the real core localizes it, truth judges it."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap, replay
from ..evaluate import beyond, mahalanobis_squared, pose_errors
from ..lcmtypes import status_t
from ..simulate import Measured, Scenario, Simulation, measure, simulate, suitable_config
from ..simulate.drives import STEP_US
from ..simulate.worlds import Surveyed

GRID_STEPS = 10
"""Motion samples from one time of the results to the next."""
NIS_STEPS = 100
"""Motion samples over which NIS is summed,"""
NIS_S = NIS_STEPS * STEP_US * 1e-6
"""that is, s."""
STATUS_STEPS = 10
"""Times of the results from one status to the next."""
NO_POSE = -1
"""The status before the first pose, where none is asked for."""
PARTS = 4
"""Of NIS: the whole of a sighting, and its bearing, elevation and range by themselves."""


@dataclass(frozen=True)
class Trial:
    """What came out of a run, at g times.

    Attributes
    ----------
    distance, heading : (g,) float, m and rad
        Of the error; NaN without a pose.
    nees : (g,) float
    status : (g,) int
    wrong : (g,) bool
        Whether the error is outside what the covariance states.
    in_view : (g,) int
        Markers that the sensors have in view.
    pairs, triples : (g,) int
        Frames of two, and of three, markers or more up to then.
    kidnap_index : int, or (n,) of many runs
        Of the first time after it; g where the robot was not carried away.
    nis, dof : (sensors, PARTS, periods) float
        Sums over the sightings of each `NIS_S`.
    """

    distance: NDArray[np.float64]
    heading: NDArray[np.float64]
    nees: NDArray[np.float64]
    status: NDArray[np.int8]
    wrong: NDArray[np.bool_]
    in_view: NDArray[np.int64]
    pairs: NDArray[np.int64]
    triples: NDArray[np.int64]
    kidnap_index: Any
    nis: NDArray[np.float64]
    dof: NDArray[np.float64]


def on_one_site(scenario: Scenario, seed: int) -> tuple[Scenario, MarkerMap]:
    """Survey the site once: all runs have the same map."""
    markers = scenario.site(np.random.default_rng(seed))
    return replace(scenario, site=Surveyed.of(markers)), markers


def chance(seed: int, run: int) -> np.random.Generator:
    """Return all chance of a run: the run-th child of the seed, whoever computes it."""
    return np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(run,)))


def simulate_run(
    scenario: Scenario,
    seed: int,
    run: int,
    spoil: Callable[[Measured], Measured] | None = None,
) -> Simulation:
    """Return one of the runs as a recording, to look at it; `spoil` may change what is sent."""
    rng = chance(seed, run)
    return simulate(on_one_site(scenario, seed)[0].drawn(rng), rng, spoil)


def run_trial(scenario: Scenario, rng: np.random.Generator) -> Trial:
    """Draw, measure, localize and compare."""
    robot = scenario.drawn(rng)
    measured = measure(robot, rng)
    drive, cameras = measured.drive, robot.cameras
    config = suitable_config(robot, measured.markers, drive)
    recording = measured.record()
    at = drive.utime[::GRID_STEPS]
    if not robot.start.known:  # without a pose only the status speaks
        recording.add_ticks(at[::STATUS_STEPS])
        recording.sort()
    run = replay(config, recording, keep_messages=not robot.start.known)
    newest = np.searchsorted(run.poses["utime"], at, side="right") - 1
    known = newest >= 0
    poses = run.poses[newest[known]]
    poses["utime"] = at[known]  # the pose in force, judged by the truth of now
    errors = pose_errors(poses, measured.truth()[::GRID_STEPS])

    def column(values: NDArray[Any], missing: Any) -> NDArray[Any]:
        full = np.full(len(at), missing, values.dtype)
        full[known] = values
        return full

    status = column(poses["status"], NO_POSE)
    if run.published is not None:
        told = [status_t.decode(m) for m in run.published.messages(config["output.status"])]
        latest = np.searchsorted([s.utime for s in told], at[~known], side="right") - 1
        status[~known] = np.array([s.state for s in told], np.int8)[np.maximum(latest, 0)]

    markers = measured.true_markers
    views = [camera.in_view(camera.look_at_all(drive, markers, at)) for camera in cameras]
    nis, dof = _nis_sums(run.reports, len(cameras), drive.utime)
    carried = measured.kidnapped_at
    return Trial(
        distance=column(errors.distance, np.nan),
        heading=column(errors.heading, np.nan),
        nees=column(mahalanobis_squared(errors.pose, poses["covariance"]), np.nan),
        status=status,
        wrong=column(beyond(errors, poses["covariance"]), False),
        in_view=np.any(views, axis=0).sum(axis=1),
        pairs=_frames(measured, 2, at),
        triples=_frames(measured, 3, at),
        kidnap_index=len(at) if carried is None else int(np.searchsorted(at, carried)),
        nis=nis,
        dof=dof,
    )


def _frames(measured: Measured, markers: int, at: NDArray[np.int64]) -> NDArray[np.int64]:
    """(g,) how many frames of so many markers or more were fused before each time.

    That is when they arrive, and the motion sample after them has. What was captured before the
    robot was carried away tells nothing of it, though it may arrive later: it counts as captured.
    """
    fused = []
    for seen in measured.sightings.values():
        _, first, count = np.unique(seen.seq, return_index=True, return_counts=True)
        frames = seen.rows(first[count >= markers])
        told = frames.utime >= (measured.kidnapped_at or 0)
        arrived = np.where(told, frames.received, frames.utime)
        fused.append(np.maximum(arrived, frames.utime + STEP_US))
    return np.asarray(np.searchsorted(np.sort(np.concatenate(fused)), at))


def _nis_sums(
    reports: NDArray[Any], sensors: int, utime: NDArray[np.int64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """(sensors, PARTS, periods) sums of NIS and of its degrees of freedom."""
    edges = utime[::NIS_STEPS]
    reports = reports[np.isfinite(reports["nis"])]
    period = np.searchsorted(edges, reports["utime"], side="right") - 1
    single = np.square(reports["innovation"] / reports["sigma"])
    nis = np.column_stack([reports["nis"], np.nan_to_num(single)])
    dof = np.column_stack([reports["dof"], np.isfinite(single)]).astype(np.float64)
    cell = reports["sensor"] * len(edges) + period

    def sums(columns: NDArray[np.float64]) -> NDArray[np.float64]:
        totals = [np.bincount(cell, c, minlength=sensors * len(edges)) for c in columns.T]
        return np.array(totals, np.float64).reshape(PARTS, sensors, -1).swapaxes(0, 1)

    return sums(nis), sums(dof)
