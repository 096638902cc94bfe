"""The first paper's printed program, step for step, through the core, and its mends.

E. Kiriy and M. Buehler, "Three-state Extended Kalman Filter for Mobile Robot Localization", 2002,
appendix A.

The listing is not the paper's filter. It drives the heading by the gyro but keeps the Jacobian
of a heading from the wheels (eq. 22); it takes every sighting stamped within 10 ms before a row,
both ends closed, so that a sighting is fused once, twice or never; it evaluates h and H at the
pose before the row's time update, for every sighting of the row; and a row is 10 ms to it, whatever
the stamps say. Here each of these is said in terms of the same models that the localizer uses,
evaluated where the listing evaluates them, and each can be mended. With all mends it is the filter
of the paper's text, with its tuning.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .. import DifferentialDrive, Ekf3, GyroDrive, MarkerModel, Policy
from ..logs.mower import Triple

TRACK_WIDTH_M = 1.41
REFERENCE_HEIGHT_M = 0.226
STEP_S = 0.01
PROCESS_NOISE = np.array([1e-4, 1e-4, 7.62e-5])  # Q of eq. 29, a step: m², m², rad²
INPUT_NOISE = 1e-4 * np.eye(2)  # σγ² I of eq. 26, m² a step
GYRO_INPUT_NOISE = np.diag([1e-4, 1e-4, 0.0])  # the paper states none for the gyro
MEASUREMENT_NOISE = np.diag([0.048**2, 0.006**2])  # R of eq. 30, rad²
IDEAL_NOISE = 1e-12 * np.eye(2)  # eq. 31
HEADING_ROWS = slice(1, 100)  # whose mean heading is the start


@dataclass(frozen=True)
class Mends:
    """What is put right of the listing."""

    fuse_once: bool = False
    """Each sighting at the first row at or after it, as section 3.2 says."""
    gyro_noise: bool = False
    """B of a heading from the gyro instead of eq. 22."""
    refreshed: bool = False
    """h and H at the state as it stands."""
    stamped: bool = False
    """The gyro's rate over the time between the stamps."""


MENDED = Mends(True, True, True, True)


@dataclass(frozen=True)
class Listing:
    """What the listing computes.

    Attributes
    ----------
    states : (n, 3) float
        x, y [m] and heading [rad] before each row's step.
    estimates : (n, 3) float
        After it.
    covariances : (n, 3, 3) float
        After it.
    """

    states: NDArray[np.float64]
    estimates: NDArray[np.float64]
    covariances: NDArray[np.float64]

    def save(self, folder: Path) -> None:
        """Write `states.csv` and `final_covariance.csv`, 17 digits."""
        folder.mkdir(parents=True, exist_ok=True)
        how = {"fmt": "%.17g", "delimiter": ","}
        np.savetxt(folder / "states.csv", self.states, header="x,y,heading", comments="", **how)
        np.savetxt(folder / "final_covariance.csv", self.covariances[-1], **how)


def run(
    triple: Triple,
    mends: Mends = Mends(),
    measurement_noise: NDArray[np.float64] = MEASUREMENT_NOISE,
) -> Listing:
    """Run the listing over the text files, from their first row."""
    drive, wheels = GyroDrive(), DifferentialDrive(TRACK_WIDTH_M)
    markers = marker_models(triple)
    start = np.append(triple.truth[0, :2], triple.truth[HEADING_ROWS, 2].mean())
    ekf = Ekf3(start, np.diag(PROCESS_NOISE))
    due = sightings_by_row(triple, mends.fuse_once)
    left, right, rate = triple.motion.T
    step_s = np.diff(triple.time, prepend=triple.time[0]) if mends.stamped else STEP_S
    turn = rate * step_s
    inputs = np.column_stack([left, right, turn])
    # Eq. 22 at the gyro's mid heading: without the wheels' own turn, which it would add.
    mid = np.zeros_like(inputs)
    mid[:, 2] = (turn - (right - left) / TRACK_WIDTH_M) / 2

    states = np.empty((len(inputs) + 1, 3))
    covariances = np.empty((len(inputs), 3, 3))
    states[0] = before = start
    for i, u in enumerate(inputs):
        if mends.gyro_noise:
            ekf.predict(drive, u, GYRO_INPUT_NOISE, PROCESS_NOISE)
        else:
            following, a, _ = drive.linearize(before, u)
            _, _, b = wheels.linearize(before + mid[i], u[:2])
            ekf.propagate(following, a, b, INPUT_NOISE, PROCESS_NOISE)
        for k in due.get(i, ()):
            model = markers[triple.sighting_id[k]]
            predicted, h, _ = model.linearize(ekf.state if mends.refreshed else before)
            innovation = model.minus(triple.sighting[k], predicted)
            ekf.correct(innovation, h, measurement_noise, Policy())
        states[i + 1] = before = ekf.state
        covariances[i] = ekf.covariance
    return Listing(states[:-1], states[1:], covariances)


def marker_models(triple: Triple) -> dict[int, MarkerModel]:
    """Return eqs. 23 to 25 of every marker by its id, seen from the mid-axis."""
    return {
        marker: MarkerModel([x, y, 0.0], ["bearing", "elevation"], [0, 0, REFERENCE_HEIGHT_M, 0])
        for marker, x, y in zip(triple.marker_id.tolist(), *triple.marker_position.T, strict=True)
    }


def sightings_by_row(triple: Triple, once: bool = True) -> dict[int, Sequence[int]]:
    """Return for each row that fuses any the sightings that it fuses, in their order in the file.

    `once`: at the first row at or after it (section 3.2); else at every row of the listing's
    window, ``t - 0.01 <= stamp <= t``.
    """
    time, stamp = triple.time, triple.sighting_time
    first = np.searchsorted(time, stamp, side="left")
    # t - 0.01 as the listing rounds it, not stamp + 0.01.
    last = first + 1 if once else np.searchsorted(time - STEP_S, stamp, side="right")
    due: dict[int, list[int]] = {}
    for k in range(len(stamp)):
        for row in range(first[k], last[k]):
            due.setdefault(row, []).append(k)
    return dict(due)
