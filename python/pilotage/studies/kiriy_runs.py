"""The first paper's experiment: drives through every filter, as it was and as it was wished for."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import Run, replay
from ..evaluate import PoseErrors, pose_errors, wrap_angle
from ..logs import mower
from ..logs.log import Log
from ..logs.mower import Triple
from ..replaying import prepared_config
from ..simulate.mower import BLIND_S, SIGMA, mower_log
from ..simulate.poselog import at_rows, in_step
from . import kiriy_listing, kiriy_velocities
from .kiriy_listing import IDEAL_NOISE, MEASUREMENT_NOISE, MENDED, Mends

IDEAL_SIGMA = 1e-6  # eq. 31
MEASURES = ("position mean", "position sd", "heading mean", "heading sd", "285-300 s")
"""Of a run: m, m, deg, deg, and the mean position error with one marker in view or none, m."""
Measures = NDArray[np.float64]
"""(5,) in the order of `MEASURES`."""


@dataclass(frozen=True)
class Wish:
    """What is otherwise than in the paper's experiment."""

    noise: float = 1.0
    """Marker noise over the paper's."""
    stated: float = 1.0
    """What the configuration says of it, over the truth."""
    motion_stated: float = 1.0
    """The same of wheels, gyro and process."""
    adaptive: bool = False
    """Whether the innovations scale Q and R."""
    rate: float = 1.0
    """Frames over the paper's."""
    dated: Callable[[Triple], Triple] | None = None


DEFAULTS = Wish()
IDEAL = ", ideal"
WISHES = {
    "on-line Q and R": Wish(adaptive=True),
    "marker noise stated 1/3": Wish(stated=1 / 3),
    "marker noise 1/3, on-line": Wish(stated=1 / 3, adaptive=True),
    "marker noise stated x 3": Wish(stated=3.0),
    "marker noise x 3, on-line": Wish(stated=3.0, adaptive=True),
    "motion noise stated 1/5": Wish(motion_stated=1 / 5),
    "motion noise 1/5, on-line": Wish(motion_stated=1 / 5, adaptive=True),
    "motion noise stated x 5": Wish(motion_stated=5.0),
    "motion noise x 5, on-line": Wish(motion_stated=5.0, adaptive=True),
    "uniform clock, 5 s behind": Wish(dated=in_step),
    "dated by the next row": Wish(dated=at_rows),
    "markers 4 times as often": Wish(rate=4.0),
    "markers 10 times as often": Wish(rate=10.0),
    "half the marker noise": Wish(noise=0.5),
    "a tenth of it": Wish(noise=0.1),
}
ABLATION = {
    "each sighting fused once": Mends(fuse_once=True),
    "B for the gyro": Mends(gyro_noise=True),
    "h and H refreshed": Mends(refreshed=True),
    "time by the stamps": Mends(stamped=True),
}
UNIFORM = "10 ms a row, 5 s behind"
EKFS = {"EKF, pose alone": False, "EKF, velocities as states": True}


def drive_log(seed: int, run: int, wish: Wish = DEFAULTS) -> Triple:
    """Return the log of a run's drive; markers, wheels and gyro are the same for every wish."""
    triple = mower_log(np.random.default_rng((seed, run)), wish.noise, wish.rate)
    return triple if wish.dated is None else wish.dated(triple)


def localize(triple: Triple, wish: Wish = DEFAULTS) -> tuple[Run, Log]:
    """Replay with the mower's ready configuration, as `pilotage replay` does."""
    log = mower.as_log(triple)
    config = prepared_config(log)
    for name, sigma in zip(("bearing", "elevation"), SIGMA[:2], strict=True):
        told = max(wish.stated * wish.noise * sigma, IDEAL_SIGMA)
        config[f"sensors.camera.sigma_{name}_rad"] = told
    for key, _, _ in config.describe():
        if key.startswith("noise.") and "_per_sqrt_" in key:
            config[key] *= wish.motion_stated
    config["noise.adaptation"] = "on" if wish.adaptive else "off"
    return replay(config, log.recording), log


def errors_of(estimates: NDArray[np.float64], triple: Triple) -> PoseErrors:
    """Compare a filter's rows (n, 3 or more) with the log's truth."""
    less = estimates[:, :3] - triple.truth
    utime = np.rint(triple.time * 1e6).astype(np.int64)
    return PoseErrors(utime, less[:, :2], wrap_angle(less[:, 2]))


def one_run(seed: int, run: int, rest: bool) -> dict[str, Measures]:
    """Put a run's drive through every filter; without `rest` through those of Table 1 alone."""
    found: dict[str, PoseErrors] = {}
    for name, wish, noise in (
        ("", DEFAULTS, MEASUREMENT_NOISE),
        (IDEAL, Wish(noise=0.0), IDEAL_NOISE),
    ):
        triple = drive_log(seed, run, wish)
        for filter_name, mends in (("the listing", Mends()), ("the paper's filter", MENDED)):
            estimates = kiriy_listing.run(triple, mends, noise).estimates
            found[filter_name + name] = errors_of(estimates, triple)
        found["our defaults" + name] = errors_of_run(*localize(triple, wish))
    if rest:
        triple = drive_log(seed, run)
        for name, mends in ABLATION.items():
            found[name] = errors_of(kiriy_listing.run(triple, mends).estimates, triple)
        found[UNIFORM] = errors_of(kiriy_listing.run(in_step(triple)).estimates, triple)
        config = prepared_config(mower.as_log(triple))
        for name, velocities in EKFS.items():
            found[name] = errors_of(kiriy_velocities.run(triple, config, velocities), triple)
        for name, wish in WISHES.items():
            found[name] = errors_of_run(*localize(drive_log(seed, run, wish), wish))
    return {name: measures(errors) for name, errors in found.items()}


def errors_of_run(run: Run, log: Log) -> PoseErrors:
    """Compare a replay with the log's truth."""
    return pose_errors(run.poses, log.truth)


def measures(errors: PoseErrors) -> Measures:
    """Return the `MEASURES` of a run's errors."""
    distance, heading = errors.distance, np.degrees(errors.heading)
    since = (errors.utime - errors.utime[0]) * 1e-6
    blind = distance[(since >= BLIND_S[0]) & (since < BLIND_S[1])].mean()
    return np.array([distance.mean(), distance.std(), heading.mean(), heading.std(), blind])
