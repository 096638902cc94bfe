"""The first paper's printed program, step for step, through the core.

E. Kiriy and M. Buehler, "Three-state Extended Kalman Filter for Mobile Robot Localization", 2002,
appendix A.

The listing is not the paper's filter. It drives the heading by the gyro but keeps the Jacobian
of a heading from the wheels (eq. 22); it takes every sighting stamped within 10 ms before a row,
both ends closed, so that a sighting is fused once, twice or never; and it evaluates h and H at the
pose before the row's time update, for every sighting of the row. Here each of these is said in
terms of the same models that the localizer uses, evaluated where the listing evaluates them.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .. import DifferentialDrive, Ekf3, GyroDrive, MarkerModel, Policy
from ..logs.mower import Triple

TRACK_WIDTH_M = 1.41
REFERENCE_HEIGHT_M = 0.226
STEP_S = 0.01
PROCESS_NOISE = np.array([1e-4, 1e-4, 7.62e-5])  # Q, a step: m², m², rad²
INPUT_NOISE = 1e-4 * np.eye(2)  # σγ² I, m² a step
MEASUREMENT_NOISE = np.diag([0.048**2, 0.006**2])  # R, rad²
HEADING_ROWS = slice(1, 100)  # whose mean heading is the start


@dataclass(frozen=True)
class Listing:
    """What the listing computes.

    Attributes
    ----------
    states : (n, 3) float
        x, y [m] and heading [rad] before each row's step.
    final_covariance : (3, 3) float
        After the last row.
    """

    states: NDArray[np.float64]
    final_covariance: NDArray[np.float64]

    def save(self, folder: Path) -> None:
        """Write `states.csv` and `final_covariance.csv`, 17 digits."""
        folder.mkdir(parents=True, exist_ok=True)
        np.savetxt(
            folder / "states.csv",
            self.states,
            fmt="%.17g",
            delimiter=",",
            header="x,y,heading",
            comments="",
        )
        np.savetxt(
            folder / "final_covariance.csv", self.final_covariance, fmt="%.17g", delimiter=","
        )


def run(triple: Triple) -> Listing:
    """Run the listing over the text files, from their first row."""
    drive, wheels = GyroDrive(), DifferentialDrive(TRACK_WIDTH_M)
    markers = {
        marker: MarkerModel([x, y, 0.0], ["bearing", "elevation"], [0, 0, REFERENCE_HEIGHT_M, 0])
        for marker, x, y in zip(triple.marker_id, *triple.marker_position.T, strict=True)
    }
    start = np.append(triple.truth[0, :2], triple.truth[HEADING_ROWS, 2].mean())
    ekf = Ekf3(start, np.diag(PROCESS_NOISE))
    # The association window of each row: sightings with t - 0.01 <= stamp <= t.
    by_time = np.argsort(triple.sighting_time, kind="stable")
    stamps = triple.sighting_time[by_time]
    first = np.searchsorted(stamps, triple.time - STEP_S, side="left")
    last = np.searchsorted(stamps, triple.time, side="right")

    states = np.empty((len(triple.time), 3))
    for i, (left, right, rate) in enumerate(triple.motion):
        before = states[i] = ekf.state
        turn = rate * STEP_S
        following, a, _ = drive.linearize(before, [left, right, turn])
        # Eq. 22 at the gyro's mid heading: without the wheels' own turn, which it would add.
        wheel_turn = (right - left) / TRACK_WIDTH_M
        about = before + np.array([0.0, 0.0, (turn - wheel_turn) / 2])
        _, _, b = wheels.linearize(about, [left, right])
        ekf.propagate(following, a, b, INPUT_NOISE, PROCESS_NOISE)
        for k in sorted(by_time[first[i] : last[i]]):
            model = markers[triple.sighting_id[k]]
            predicted, h, _ = model.linearize(before)
            innovation = model.minus(triple.sighting[k], predicted)
            ekf.correct(innovation, h, MEASUREMENT_NOISE, Policy())
    return Listing(states, ekf.covariance)
