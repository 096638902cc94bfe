"""The settings that the study of Kohler's report compares, and a run of them.

What the report leaves open (ring, drive, P₀, the camera's errors) is chosen here and in simulate,
and stated in docs/studies/kohler.md.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import ArcVelocity, Config, Ekf3, EulerVelocity, MidpointVelocity, Policy, Ukf3
from ..evaluate.mse import mean_squared_errors
from ..simulate import drives, worlds
from ..simulate.wheel_speeds import WheelSpeeds
from ..simulate.wheels_and_camera import WheelsAndCamera
from .kohler_filters import Filter, Ours, Start

TRACK_WIDTH_M, DURATION_S = 0.287, 60  # b, which eq. 3 calls h; ours
WHEELS_M_S = {"variance": 0.1, "sd": 0.01}  # of N(0, 0.01): sigma of a wheel's speed, m/s
PARTS = (0.1, 0.5, 1.0)  # of the true x and y, by which the start is wrong
RATES_HZ, FRAMES_HZ = (10, 30, 100, 200), 10
MOTIONS: dict[str, Any] = {"Euler": EulerVelocity, "midpoint": MidpointVelocity, "arc": ArcVelocity}
RATE_CASES = (("Euler", "a sample", 0.0), ("arc", "a sample", 0.0), ("arc", "a second", 0.5))

EKF, UKF = Filter(Ekf3, r=15.0), Filter(Ukf3, r=0.05)
RIGHT = Filter(Ekf3, printed_q=False, p0=None)
EVERY = replace(RIGHT, nearest=False, limit_m=np.inf)
RANGING = replace(RIGHT, sees=("bearing", "range"))
TUNED = {
    "EKF, R = 15, as printed": EKF,
    "UKF, R = 15": replace(UKF, r=15.0),
    "EKF, R = 0.05": replace(EKF, r=0.05),
    "UKF, R = 0.05, as printed": UKF,
    "EKF, R = 15, P₀ = I": replace(EKF, p0=np.eye(3)),
    "UKF, R = 0.05, P₀ = I": replace(UKF, p0=np.eye(3)),
    "EKF, R = 15, P₀ = error²": replace(EKF, p0=None),
    "UKF, R = 0.05, P₀ = error²": replace(UKF, p0=None),
    "EKF, right Q, R, P₀": RIGHT,
    "UKF, right Q, R, P₀": replace(RIGHT, kind=Ukf3),
    "EKF, R = 15, not wrapped": replace(EKF, wraps=False),
    "EKF, R = 0.05, not wrapped": replace(EKF, r=0.05, wraps=False),
    "EKF, right, not wrapped": replace(RIGHT, wraps=False),
}
MENDED = {
    "UKF as printed": UKF,
    "EKF, right Q, R, P₀": RIGHT,
    "bearing: sees the heading": replace(RIGHT, sees=("bearing",)),
    "bearing and range": RANGING,
    "bearing and range, UKF": replace(RANGING, kind=Ukf3),
    "the nearest marker, no limit": replace(RANGING, limit_m=np.inf),
    "all markers, no limit": replace(RANGING, nearest=False, limit_m=np.inf),
    "our defaults, 2 m limit": Ours(),
    "our defaults, no limit": Ours(np.inf),
    "our defaults, UKF, no limit": Ours(np.inf, {"filter": "ukf"}),
}
LIMITED = {
    "UKF as printed, 2 m limit": UKF,
    "UKF as printed, no limit": replace(UKF, limit_m=np.inf),
    "EKF, right Q, R, P₀, 2 m limit": RIGHT,
    "EKF, right Q, R, P₀, no limit": replace(RIGHT, limit_m=np.inf),
    "all markers, no limit": EVERY,
    "and a Student-t weight": replace(EVERY, policy=Policy.student_t()),
}


FLAW = {
    "EKF as printed": EKF,
    "UKF as printed": UKF,
    "UKF, R = 0.05, P₀ = error²": replace(UKF, p0=None),
    "EKF, right Q, R, P₀": RIGHT,
    "bearing and range": RANGING,
    "our defaults, 2 m limit": Ours(),
    "our defaults, no limit": Ours(np.inf),
}


@dataclass(frozen=True)
class Case:
    """A filter in a setting: the start's error, the wheels' noise, the rate."""

    filter: Any
    part: float = 0.1
    sigma_m_s: float = WHEELS_M_S["variance"]
    yaw_rad: float = 0.0
    rate_hz: float = 30.0
    every: int = 1
    """So many-th sample comes with a frame."""

    def drive(self, seed: int, run: int) -> WheelsAndCamera:
        """Drive once; the chance of a run is the same for every noise."""
        wheels = WheelSpeeds(TRACK_WIDTH_M, self.sigma_m_s, self.rate_hz)
        rng = np.random.default_rng((seed, run))
        way = drives.weaving(DURATION_S)
        return WheelsAndCamera.on(way, worlds.ring(), wheels, rng, self.every)

    def estimate(self, drive: WheelsAndCamera) -> NDArray[np.float64]:
        """(n + 1, 3) states from a start that is stated to be as wrong as it is."""
        error = np.append(self.part * drive.truth[0, :2], self.yaw_rad)
        sigma_heading = self.yaw_rad or float(Config()["initial.sigma_heading_rad"])
        told = Start(drive.truth[0] + error, float(np.hypot(*error[:2])), sigma_heading)
        return np.asarray(self.filter.estimate(drive, told))


def both(filters: dict[str, Any]) -> dict[Any, Case]:
    """Each with the start 10 % and 100 % off."""
    return {(name, part): Case(f, part) for name, f in filters.items() for part in (0.1, 1.0)}


RUNS = {"report": 100, "tuned": 40, "mended": 40, "limited": 40, "flaw": 40, "rates": 20}
CASES: dict[str, dict[Any, Case]] = {  # by table
    "report": {
        (name, reading, part): Case(f, part, sigma)
        for name, f in (("EKF", EKF), ("UKF", UKF), ("ours", Ours()))
        for reading, sigma in WHEELS_M_S.items()
        for part in PARTS
    },
    "tuned": both(TUNED),
    "mended": both(MENDED),
    "limited": both(LIMITED),
    "flaw": {
        (name, sigma): Case(f, 0.1, sigma, yaw_rad=0.2)
        for name, f in FLAW.items()
        for sigma in (0.0, 0.1)
    },
    # Noise as large a sample, and as large a second, as at 30 Hz.
    "rates": {
        (rate, name, noise): Case(
            replace(RIGHT, motion=MOTIONS[name]),
            sigma_m_s=0.1 * (rate / 30.0) ** power,
            rate_hz=rate,
            every=rate // FRAMES_HZ,
        )
        for rate in RATES_HZ
        for name, noise, power in RATE_CASES
    },
}


def run_once(seed: int, run: int, tables: Sequence[str]) -> dict[Any, NDArray[np.float64]]:
    """(seconds, 3) mean squared errors of the cases of some tables, by table and case."""
    driven: dict[Any, WheelsAndCamera] = {}
    found = {}
    for table in tables:
        for key, case in CASES[table].items():
            setting = (case.sigma_m_s, case.rate_hz, case.every)
            if setting not in driven:
                driven[setting] = case.drive(seed, run)
            drive = driven[setting]
            mse = mean_squared_errors(case.estimate(drive), drive.truth, DURATION_S)
            found[(table, *key)] = mse
    return found


def integration_error(rate_hz: float, name: str) -> float:
    """Find how far exact wheels lead astray at most, from the exact start [m]."""
    drive = Case(RIGHT, sigma_m_s=0.0, rate_hz=rate_hz).drive(0, 0)
    path = MOTIONS[name](drive.wheels.step_s).path(drive.truth[0], drive.rates)
    return float(np.hypot(*(path - drive.truth)[:, :2].T).max())
