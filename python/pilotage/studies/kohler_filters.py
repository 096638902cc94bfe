"""The filters of Kohler's report and what mends them, over one simulated drive; all in the core."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import Config, Ekf3, EulerVelocity, Localizer, MarkerModel, Policy, Ukf3, WorldBearing
from ..simulate.wheels_and_camera import WheelsAndCamera

PRINTED_Q = np.array([0.001, 0.001, 2.178e-5])  # a step; of the heading 2 σ² Ts², without 1 / b²
LIMIT_M = 2.0  # "a euclidean distance from the camera lens of 2 meters or less"
M_PER_TICK = 1e-6


@dataclass(frozen=True)
class Start:
    """What a filter is told of the start: x, y, heading, and how well they are known."""

    state: NDArray[np.float64]
    sigma_position_m: float
    sigma_heading_rad: float

    @property
    def covariance(self) -> NDArray[np.float64]:
        """(3, 3) of x, y, heading."""
        sigma = [self.sigma_position_m, self.sigma_position_m, self.sigma_heading_rad]
        return np.diag(np.square(sigma))


@dataclass(frozen=True)
class Filter:
    """A filter of three states; as the report has it unless said otherwise.

    Attributes
    ----------
    kind : Ekf3 or Ukf3
        The latter with 2n points and Cholesky's root.
    r : float or None, rad²
        Of the direction; None: R is the camera's noise, of all that is measured.
    printed_q : bool
        Else Q follows from the noise of the wheels: B Γ Bᵀ.
    p0 : (3, 3) float or None
        The report does not say it, so Q; None: what is said of the start.
    sees : words
        ``direction`` from the marker to the robot (eq. 4), or ``bearing``, ``range``.
    wraps : bool
        The innovation; not to wrap it is for Ekf3 only.
    nearest : bool
        One marker of a frame; else all.
    """

    kind: type[Ekf3] | type[Ukf3]
    r: float | None = None
    printed_q: bool = True
    p0: NDArray[np.float64] | None = field(default_factory=lambda: np.diag(PRINTED_Q))
    sees: tuple[str, ...] = ("direction",)
    wraps: bool = True
    nearest: bool = True
    limit_m: float = LIMIT_M
    policy: Policy = field(default_factory=Policy)
    motion: Any = EulerVelocity  # eqs. 5 and 6

    def estimate(self, drive: WheelsAndCamera, start: Start) -> NDArray[np.float64]:
        """(n + 1, 3) states at the drive's stamps."""
        kf: Any = self.kind(start.state, start.covariance if self.p0 is None else self.p0)
        motion = self.motion(drive.wheels.step_s)
        gamma, q = drive.wheels.rate_covariance(), np.zeros(3)
        if self.printed_q:
            gamma, q = np.zeros((2, 2)), PRINTED_Q
        updates = self._updates(drive)
        states = [start.state]
        for k, u in enumerate(drive.rates, start=1):  # eqs. 1 to 3
            kf.predict(motion, u, gamma, q)
            for model, z, r in updates.get(k, ()):
                if self.wraps:
                    kf.update(model, z, r, self.policy)
                else:
                    predicted, h, _ = model.linearize(kf.state)
                    kf.correct(z - predicted, h, r, self.policy)
            states.append(kf.state)
        return np.array(states)

    def _updates(self, drive: WheelsAndCamera) -> dict[int, list[tuple[Any, Any, Any]]]:
        """Model, measurement and R of the detections that are fused, by the stamp's index."""
        seen, camera = drive.seen.within(self.limit_m), drive.camera
        seen = seen.nearest() if self.nearest else seen
        values = np.column_stack([getattr(seen, name) for name in self.sees])
        sigma = np.column_stack([camera.sigma(name, seen.range) for name in self.sees])
        models: list[Any] = [
            WorldBearing(position[:2])
            if self.sees == ("direction",)
            else MarkerModel(position, list(self.sees), camera.camera.mounting)
            for position in drive.markers.positions
        ]
        updates: dict[int, list[tuple[Any, Any, Any]]] = {}
        for i, frame in enumerate(seen.frame.tolist()):
            r = np.diag(sigma[i] ** 2) if self.r is None else np.array([[self.r]])
            updates.setdefault(frame, []).append((models[seen.marker[i]], values[i], r))
        return updates


@dataclass(frozen=True)
class Ours:
    """The localizer with its defaults, told its wheels, its camera and its start."""

    limit_m: float = LIMIT_M
    config: dict[str, Any] = field(default_factory=dict)

    def estimate(self, drive: WheelsAndCamera, start: Start) -> NDArray[np.float64]:
        """(n + 1, 3) poses at the drive's stamps."""
        seen, camera = drive.seen.within(self.limit_m), drive.camera
        x, y, z, _ = camera.camera.mounting
        values = {
            "motion.heading": "wheels",
            "encoders.left_m_per_tick": M_PER_TICK,
            "encoders.right_m_per_tick": M_PER_TICK,
            "encoders.track_width_m": drive.wheels.track_width_m,
            "sensors.camera.x_m": x,
            "sensors.camera.y_m": y,
            "sensors.camera.z_m": z,
            "sensors.camera.sigma_bearing_rad": camera.sigma_bearing_rad,
            "sensors.camera.sigma_range_m": 0.001,  # nearly all of it grows with the range
            "sensors.camera.sigma_range_per_m": camera.sigma_range_per_m,
            "initial.sigma_position_m": start.sigma_position_m,
            "initial.sigma_heading_rad": start.sigma_heading_rad,
        }
        for name, value in zip(("x_m", "y_m", "heading_rad"), start.state, strict=True):
            values[f"initial.{name}"] = float(value)
        config = Config()
        config.map = drive.markers
        for key, setting in (values | self.config).items():
            config[key] = setting
        poses = Localizer(config).run(
            drive.utime,
            drive.ticks(M_PER_TICK),
            sighting_utime=drive.utime[seen.frame],
            sighting_id=drive.markers.ids[seen.marker],
            sighting=np.column_stack([seen.bearing, np.full(len(seen.frame), np.nan), seen.range]),
        )
        return np.column_stack([poses["x"], poses["y"], poses["heading"]])
