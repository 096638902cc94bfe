"""What a simulated robot measures and records, and a configuration that suits it."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import Config, MarkerMap, Recording
from ..sensor_keys import MOUNTING, SIGMAS
from .drives import Drive
from .labels import add_labelled
from .scenario import Scenario
from .streams import Stream
from .worlds import as_they_stand

UNKNOWN_ID = -1


@dataclass(frozen=True)
class Simulation:
    """What a simulated robot recorded, what was true, and a configuration that suits it.

    `truth` has rows of `evaluate.TRAJECTORY`.
    """

    recording: Recording
    truth: NDArray[np.void]
    config: Config


@dataclass(frozen=True)
class Measured:
    """What the robot's sensors sent on a drive, before it is encoded.

    Attributes
    ----------
    markers : MarkerMap
        As surveyed: the localizer's map.
    true_markers : MarkerMap
        Where they are.
    sightings : Stream by the sensor's name
        With the marker that each is of, also where the sensor does not say.
    ids : bool
        Whether sightings say which marker they are of.
    kidnapped_at : int or None, µs
        When the robot was carried elsewhere.
    tilt : (n + 1, 2) float or None, rad
        Pitch and roll of the body at the drive's stamps, if it does not stand level.
    """

    drive: Drive
    markers: MarkerMap
    true_markers: MarkerMap
    encoders: Stream
    gyro: Stream
    sightings: dict[str, Stream]
    ids: bool = True
    kidnapped_at: int | None = None
    tilt: NDArray[np.float64] | None = None

    def record(self) -> Recording:
        """Encode everything, in order of arrival."""
        recording = Recording()
        gyro, encoders = self.gyro, self.encoders
        recording.add_gyro("GYRO", gyro.utime, gyro.value[:, 0], gyro.received, gyro.seq)
        left, right = _ticks(encoders.value).T
        recording.add_encoders(
            "ENCODERS", encoders.utime, left, right, encoders.received, encoders.seq
        )
        labelled = (self.markers.labels >= 0).any()
        for sensor, seen in self.sightings.items():
            ids = seen.id if self.ids else np.full_like(seen.id, UNKNOWN_ID)
            if labelled:
                labels = self.markers.labels[np.searchsorted(self.markers.ids, seen.id)]
                add_labelled(recording, "MARKERS", sensor, replace(seen, id=ids), labels)
                continue
            bearing, elevation, slant = seen.value.T
            recording.add_sightings(
                "MARKERS",
                sensor,
                seen.utime,
                ids,
                bearing,
                elevation,
                slant,
                seen.received,
                seen.seq,
            )
        recording.add_reference("REFERENCE", self.drive.utime, *self.drive.pose.T)
        recording.sort()
        return recording

    def truth(self) -> NDArray[np.void]:
        """Return the true trajectory, rows of `evaluate.TRAJECTORY`."""
        return self.drive.truth()


def measure(scenario: Scenario, rng: np.random.Generator) -> Measured:
    """Drive and measure; all chance comes from `rng`."""
    markers = scenario.site(rng)
    drive = scenario.start.placed(scenario.drive(scenario.duration_s), rng)
    kidnapped_at = None
    if scenario.kidnap is not None:
        drive, kidnapped_at = scenario.kidnap.strike(drive, markers, rng)
    true_markers = as_they_stand(markers, rng)
    tilt = None if scenario.tilt is None else scenario.tilt.angles(drive, rng)
    rates = Stream.sent(drive.utime, scenario.gyro.rates(drive, rng)[:, None])
    ticks = Stream.sent(drive.utime, scenario.encoders.ticks(drive, rng).astype(np.float64))
    sightings = {}
    for camera in scenario.cameras:
        utime, marker, value = camera.sightings(drive, true_markers, rng, tilt)
        seen = Stream.sent(utime, value, marker)
        if scenario.outliers is not None:
            seen = scenario.outliers.strike(seen, camera, markers, rng)
        sightings[camera.name] = seen.late(scenario.latency_s, scenario.jitter_s, rng)
    return Measured(
        drive,
        markers,
        true_markers,
        encoders=ticks.late(0.0, scenario.jitter_s, rng),
        gyro=rates.late(0.0, scenario.jitter_s, rng),
        sightings=sightings,
        ids=scenario.ids,
        kidnapped_at=kidnapped_at,
        tilt=tilt,
    )


def simulate(
    scenario: Scenario,
    rng: np.random.Generator,
    spoil: Callable[[Measured], Measured] | None = None,
) -> Simulation:
    """Drive, measure and record; all chance comes from `rng`. `spoil` may change what is sent."""
    measured = measure(scenario, rng)
    if spoil is not None:
        measured = spoil(measured)
    config = suitable_config(scenario, measured.markers, measured.drive)
    return Simulation(measured.record(), measured.truth(), config)


def suitable_config(scenario: Scenario, markers: MarkerMap, drive: Drive) -> Config:
    """Return the configuration of a robot whose engineer knows its sensors."""
    config = Config()
    config.map = markers
    encoders, gyro = scenario.encoders, scenario.gyro
    position, heading = scenario.prior()
    values: dict[str, Any] = {
        "encoders.left_m_per_tick": encoders.m_per_tick,
        "encoders.right_m_per_tick": encoders.m_per_tick,
        "encoders.track_width_m": encoders.track_width_m,
        "noise.wheel_m_per_sqrt_m": encoders.noise_m_per_sqrt_m,
        "noise.gyro_rad_per_sqrt_s": gyro.noise_rad_per_sqrt_s,
        "noise.position_m_per_sqrt_m": 0.0,  # all that is uncertain of this motion is its sensors
        "calibration.gyro_bias.sigma": gyro.bias_sigma_rad_s,
        "calibration.gyro_bias.walk": gyro.walk_rad_s_per_sqrt_s,
        "calibration.distance_scale.sigma": encoders.scale_sigma,
        "initial.sigma_position_m": position,
        "initial.sigma_heading_rad": heading,
    }
    if scenario.start.known:
        told = drive.pose[0] + scenario.start.error
        for name, value in zip(("x_m", "y_m", "heading_rad"), told, strict=True):
            values[f"initial.{name}"] = float(value)
    for camera in scenario.cameras:
        prefix = f"sensors.{camera.name}."
        for name, value in zip(MOUNTING, camera.mounting, strict=True):
            values[prefix + name] = value
        for (component, key), sigma in zip(SIGMAS.items(), camera.sigma, strict=True):
            if component in camera.components and sigma > 0:
                values[prefix + key] = sigma
    for key, number in (values | scenario.config).items():
        config[key] = number
    return config


def _ticks(value: NDArray[np.float64]) -> NDArray[np.int64]:
    """Whole ticks; not a number becomes what a cast in C makes of it on most machines."""
    missing = np.isnan(value)
    ticks = np.rint(np.where(missing, 0.0, value)).astype(np.int64)
    return np.where(missing, np.iinfo(np.int64).min, ticks)
