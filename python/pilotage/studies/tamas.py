"""L. Tamas and others: transform, infrared, ultrasonic echo, skid steering and the square.

Equation and figure numbers are the paper's. It prints no table: ours are what its figures and
claims come to in numbers. What it hears is in `tamas_ultrasonic`, how it drives in `tamas_robot`.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from .. import Ekf3, MoveAndTurn, Unscented, unscented_transform
from ..evaluate.polar import polar_moments
from .study import Findings, Request, Study, Table
from .tamas_robot import infrared, laps, measure_robot, printed_odometry, skid_steering
from .tamas_ultrasonic import ultrasonic

if TYPE_CHECKING:
    from matplotlib.figure import Figure

POLAR, POLAR_SIGMA = np.array([1.0, np.pi / 2.0]), np.array([0.02, np.radians(15.0)])
"""Range [m] and bearing [rad] of figure 2: 2 % and 15°."""
KAPPAS = (1.0, 0.0)


def run(request: Request) -> Findings:
    """Do all of it."""
    known = measure_robot(np.random.default_rng((request.seed, 0)))
    parts = [
        transform(request),
        infrared(known, np.random.default_rng((request.seed, 1))),
        ultrasonic(replace(request, progress=lambda part: request.progress(0.6 * part))),
        skid_steering(known, np.random.default_rng((request.seed, 2))),
        printed_odometry(),
        laps(replace(request, progress=lambda part: request.progress(0.6 + 0.4 * part)), known),
    ]
    results = {key: value for part in parts for key, value in part.results.items()}
    tables = [table for part in parts for table in part.tables]
    figures = {name: draw for part in parts for name, draw in part.figures.items()}
    return Findings(results, [must_show(parts[0], parts[2]), *tables], figures)


def must_show(polar: Findings, heard: Findings) -> Table:
    """Put the bars beside what came out."""
    ut, linear = polar.results["transform"]["ut_1"], polar.results["transform"]["linear"]
    rows = [
        ("UT, κ = 1: mean off", "≤ 0.1 %", f"{100 * ut['mean']:.2g} %"),
        ("UT, κ = 1: variance off, worse of the two", "≤ 6 %", f"{100 * max(ut['var']):.1f} %"),
        ("linear: range variance off", "> 80 %", f"{100 * linear['var'][1]:.1f} %"),
        ("echo at 10 dB: UKF over threshold", "≤ 0.8", f"{heard.results['ratio_at_10_db']:.2f}"),
    ]
    return Table("What it must show", ["", "bar", "measured"], rows)


def transform(request: Request) -> Findings:
    """Figure 2: eq. 18 by its Jacobian, eq. 19, and by sigma points, eqs. 14 to 17."""
    model, none = MoveAndTurn(), np.zeros(3)

    def cartesian(polar: np.ndarray) -> np.ndarray:
        """Eq. 18: to drive r from the origin along b."""
        return model.linearize([0.0, 0.0, polar[1]], [polar[0], 0.0])[0][:2]

    covariance = np.diag(np.square(POLAR_SIGMA))
    # A robot whose heading is as uncertain as the bearing, and its way as the range.
    ekf = Ekf3([0.0, 0.0, POLAR[1]], np.diag([0.0, 0.0, covariance[1, 1]]))
    ekf.predict(model, [POLAR[0], 0.0], np.diag([covariance[0, 0], 0.0]), none)
    true_mean, true = polar_moments(POLAR, POLAR_SIGMA)
    ways = {"linear": (ekf.state[:2], ekf.covariance[:2, :2])} | {
        f"ut_{kappa:g}": unscented_transform(POLAR, covariance, cartesian, Unscented(kappa=kappa))
        for kappa in KAPPAS
    }
    results = {
        name: {
            "mean": float(np.linalg.norm(mean - true_mean) / np.linalg.norm(true_mean)),
            "var": (np.abs(np.diag(p) / np.diag(true) - 1.0)).tolist(),
        }
        for name, (mean, p) in ways.items()
    }
    labels = ["linear, eq. 19", "unscented, κ = 1", "unscented, κ = 0"]
    rows: list[Sequence[str | float]] = [("exact", *_moments(true_mean, true), "", "", "")]
    for label, (name, (mean, p)) in zip(labels, ways.items(), strict=True):
        off = [results[name]["mean"], *results[name]["var"]]
        rows.append((label, *_moments(mean, p), *(f"{100 * part:.2g} %" for part in off)))
    rng = np.random.default_rng((request.seed, 0))
    points = np.array([cartesian(p) for p in rng.normal(POLAR, POLAR_SIGMA, (2000, 2))])
    table = Table(
        "Figure 2: r = 1 m ± 2 %, bearing 90° ± 15°, in the plane",
        ["", "mean y (m)", "var x (m²)", "var y (m²)", "mean off", "var x off", "var y off"],
        rows,
        "The paper has the true mean at (0, 1) and the covariance circular: neither is so.",
    )

    def draw() -> "Figure":
        from ..plot.transform import transform_figure

        named = {
            "exact": (true_mean, true),
            "linear": ways["linear"],
            "unscented, κ = 1": ways["ut_1"],
        }
        return transform_figure(points, named)

    return Findings({"transform": results}, [table], {"figure-2": draw})


def _moments(mean: np.ndarray, covariance: np.ndarray) -> tuple[str, str, str]:
    return (f"{mean[1]:.4f}", f"{covariance[0, 0]:.5f}", f"{covariance[1, 1]:.5f}")


STUDY = Study(
    "Unscented transform, ultrasonic echo, infrared, and a square by skid steering",
    "L. Tamás, Gh. Lazea, R. Robotin, C. Marcu, S. Herle, Z. Szekely, State Estimation Based on "
    "Kalman Filtering Techniques in Navigation, 2008",
    run,
)
