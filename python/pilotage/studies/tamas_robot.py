"""The robot of Tamas et al. 2008: infrared, skid steering, odometry, and two laps of the square."""

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .. import Ekf3, Ukf3
from ..evaluate import wrap_angle
from ..parallel import in_processes
from ..simulate.infrared import COLOURS, LogCurve
from ..simulate.skid_steer import WALLS, Lap, SkidSteered, square_lap
from . import tamas_square as square
from .study import Findings, Request, Table
from .tamas_square import Known

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LAPS = 60
ROBOT = SkidSteered()
CALIBRATION_STEPS = 3000
AXLE_M = 0.6
PERFECT = replace(
    ROBOT,
    coefficients=((0.5, 0.5), (0.0, 0.0), (1.0 / AXLE_M, -1.0 / AXLE_M)),
    slip=(0.0, 0.0, 0.0),
    slip_turning=(0.0, 0.0, 0.0),
    wheel_m_s=0.0,
)
"""A robot that moves as eqs. 31 to 35 have it."""
EVERY = {"0.1 s": 1, "0.5 s": 5, "1 s": 10}
NEAR = np.geomspace(0.1, 0.8, 60)
"""Distances at which the infrared pairs are measured, m."""


def measure_robot(rng: np.random.Generator) -> Known:
    """Fit eq. 30 to a drive under a camera, and figure 4 to a white wall, by least squares."""
    wheels, body = ROBOT.calibration_drive(CALIBRATION_STEPS, rng)
    coefficients = np.asarray(np.linalg.lstsq(wheels, body, rcond=None)[0].T, np.float64)
    ahead = np.zeros_like(NEAR)
    curves = [
        LogCurve.fit(NEAR, pair.reading(NEAR, ahead, COLOURS["white"], rng))
        for pair in ROBOT.infrared
    ]
    return Known(coefficients, tuple(curves))


def infrared(known: Known, rng: np.random.Generator) -> Findings:
    """Section IV A and figure 4: colours seen by the first pair; what alignment leaves."""
    ahead, pair, white = np.zeros_like(NEAR), ROBOT.infrared[0], known.infrared[0]
    readings = {name: pair.reading(NEAR, ahead, part, rng) for name, part in COLOURS.items()}
    curves = {name: LogCurve.fit(NEAR, reading) for name, reading in readings.items()}

    def off(curve: LogCurve, reading: NDArray[np.float64]) -> float:
        return float(np.sqrt(np.mean(np.square(curve.distance(reading) / NEAR - 1.0))))

    names = ("front", "left", "rear", "right")
    pairs = Table(
        "Figure 4: reading = a + b ln d of the four pairs, white wall",
        ["pair", "a (V)", "b (V)", "residual (V)", "σ of the distance"],
        [
            (n, c.at_1_m, c.slope, c.sigma_v, f"{100 * c.sigma_v / abs(c.slope):.1f} % of it")
            for n, c in zip(names, known.infrared, strict=True)
        ],
        "A pair sees a wall only if it looks at it within 10° of its normal.",
    )
    errors = {n: (off(white, r), off(curves[n], r)) for n, r in readings.items()}
    colours = Table(
        "Distance by infrared over colours, relative RMSE",
        ["colour", "by the white curve", "by its own curve"],
        [(n, f"{100 * a:.0f} %", f"{100 * b:.1f} %") for n, (a, b) in errors.items()],
    )

    def draw() -> "Figure":
        from ..plot.infrared import infrared_figure

        fitted = {n: c.at_1_m + c.slope * np.log(NEAR) for n, c in curves.items()}
        return infrared_figure(NEAR, readings, fitted)

    return Findings({"infrared": errors}, [pairs, colours], {"figure-4": draw})


def skid_steering(known: Known, rng: np.random.Generator) -> Findings:
    """Eq. 30's coefficients, and what they are worth on a drive that they were not fitted to."""
    true, fitted = np.array(ROBOT.coefficients), known.coefficients
    table = Table(
        "Eq. 30: coefficients by least squares",
        ["", *(f"a{i}{j}" for i in (1, 2, 3) for j in (1, 2))],
        [
            ("true", *(f"{a:.3f}" for a in true.ravel())),
            (f"fitted, {CALIBRATION_STEPS} steps", *(f"{a:.3f}" for a in fitted.ravel())),
        ],
    )
    return Findings({"coefficients": {"true": true, "fitted": fitted}}, [table])


def printed_odometry() -> Findings:
    """Eqs. 31 to 33 as printed and as they should be, on a robot that they describe exactly."""
    lap = square_lap(PERFECT, np.random.default_rng(0))
    corners = np.count_nonzero(np.diff(lap.turning.astype(int)) == 1)
    rows, results = [], {}
    for name, every in EVERY.items():
        ends = [
            square.printed_odometry(lap, AXLE_M, every, arctan)[-1] - lap.pose[-1]
            for arctan in (True, False)
        ]
        midpoint = square.odometry(lap, AXLE_M, every)[-1] - lap.pose[-1]
        lost = -float(np.degrees(wrap_angle(ends[0][2]))) / corners
        far = [100.0 * float(np.hypot(*end[:2])) for end in (*ends, midpoint)]
        results[name] = [lost, *far]
        rows.append((name, f"{lost:.2f}°", *(f"{d:.1f} cm" for d in far)))
    # A whole corner in one reading.
    once = np.degrees(np.arctan(np.pi / 2.0))
    table = Table(
        "Eqs. 31 to 33 on a perfect robot: what the printed form loses in two laps",
        ["wheels read every", "a corner loses", "end off, printed", "no arctan", "mid heading"],
        rows,
        f"Read once a corner, the arctan makes {once:.1f}° of 90°.",
    )  # fmt: skip
    return Findings({"printed_odometry": results}, [table])


def paths(lap: Lap, known: Known) -> dict[str, tuple[NDArray[np.float64], float]]:
    """Return each way's poses (n + 1, 3) and its mean NEES over 3, NaN where it has none."""
    inertial = square.gyro_and_compass(lap, known, ROBOT)
    found = {
        "odometry, 31–35": square.odometry(lap, known.track_width_m),
        "skid steering, 29–30": square.skid_steer(lap, known),
        "gyro and compass, 36–37": inertial,
        "  + ranges, LKF of x, y": square.linear_position(lap, known, ROBOT, inertial),
    }
    ways = {name: (pose, np.nan) for name, pose in found.items()}
    for name, kind in (("EKF", Ekf3), ("UKF", Ukf3)):
        for what, sigma, corners, infrared in (
            ("R as at 1 m", lambda d: ROBOT.sonar_sigma(np.ones_like(d)), False, False),
            ("R by distance", ROBOT.sonar_sigma, False, False),
            ("+ Q at corners", ROBOT.sonar_sigma, True, False),
            ("+ infrared", ROBOT.sonar_sigma, True, True),
        ):
            pose, nees = square.fuse(kind, lap, known, ROBOT, sigma, corners, infrared)
            ways[f"{name}: {what}"] = pose, float(np.mean(nees)) / 3.0
    return ways


def one_run(seed: int, run: int, known: Known) -> NDArray[np.float64]:
    """(ways, 4) RMS of position [m] and heading [rad], position error at the end, NEES over 3."""
    lap = square_lap(ROBOT, np.random.default_rng((seed, run)))
    rows = []
    for pose, nees in paths(lap, known).values():
        distance = np.hypot(*(pose - lap.pose)[:, :2].T)
        heading = wrap_angle(pose[:, 2] - lap.pose[:, 2])
        rms = (float(np.sqrt(np.mean(np.square(e)))) for e in (distance, heading))
        rows.append((*rms, distance[-1], nees))
    return np.array(rows)


def laps(request: Request, known: Known) -> Findings:
    """Section IV C and figure 7: two laps of the square, by itself and with ranges."""
    calls = [(request.seed, k, known) for k in range(request.runs(LAPS))]
    done = in_processes(
        one_run, calls, request.jobs, lambda k: f"the process of lap {k} died", request.progress
    )
    each = np.array(list(done))
    lap = square_lap(ROBOT, np.random.default_rng((request.seed, 0)))
    shown = paths(lap, known)
    mean = np.sqrt(np.mean(np.square(each), axis=0)) * [100.0, np.degrees(1.0), 100.0, 1.0]
    mean[:, 3] = each[:, :, 3].mean(axis=0)
    worst = 100.0 * each[:, :, 0].max(axis=0)
    names = list(shown)
    table = Table(
        f"Figure 7: two laps of the 2 m square, RMS over {len(each)} runs",
        ["", "position (cm)", "worst (cm)", "heading (°)", "at end (cm)", "NEES / 3"],
        [
            (n, f"{m[0]:.2f}", f"{w:.1f}", f"{m[1]:.2f}", f"{m[2]:.2f}",
             "–" if np.isnan(m[3]) else f"{m[3]:.2f}")
            for n, m, w in zip(names, mean, worst, strict=True)
        ],
        "NEES / 3 is 1 where the covariance is as large as the error.",
    )  # fmt: skip

    def draw() -> "Figure":
        from ..plot.square import square_figure

        named = {
            "odometry": names[0],
            "gyro and compass": names[2],
            "UKF with ranges and infrared": names[-1],
        }
        return square_figure(WALLS, lap.pose, {label: shown[n][0] for label, n in named.items()})

    results = {
        n: dict(zip(("position_cm", "heading_deg", "end_cm", "nees_over_3"), m, strict=True))
        for n, m in zip(names, mean.tolist(), strict=True)
    }
    return Findings({"square": results}, [table], {"figure-7": draw})
