"""What a configured sensor sees of markers, and how well."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import Config, MarkerModel
from ..evaluate import wrap_angle
from ..sensor_keys import COMPONENTS, MOUNTING, SIGMAS, in_order

ASSUMED = ("bearing", "range")
"""Of a sensor whose noise is the default throughout."""
STEP = 1e-5
"""Of a pose, m and rad: errors of rounding and of curvature are both far below any use."""

Array = NDArray[np.float64]


def guessed(config: Config, name: str) -> tuple[str, ...]:
    """Return the components whose noise is not the default: who has none leaves it alone.

    Only frames tell what a sensor measures; this is a guess, wrong of a noise that is the default.
    """
    default = Config()
    return tuple(
        component
        for component, sigma in SIGMAS.items()
        if config[f"sensors.{name}.{sigma}"] != default[f"sensors.{name}.{sigma}"]
    )


@dataclass(frozen=True)
class Sight:
    """A sensor with its mounting, its noise, and what of its surroundings it has in view."""

    name: str
    components: tuple[str, ...]
    known_by: str
    """How it is known what they are, in words."""
    mounting: tuple[float, ...]
    """x, y, z [m] and yaw [rad] in the robot frame."""
    sigmas: dict[str, float]
    """Of each component, rad or m."""
    sigma_range_per_m: float
    min_distance_m: float
    reach_m: float
    """How far it sees, slant."""
    view_rad: float
    """The whole angle, half of it to each side."""

    @classmethod
    def of(
        cls,
        config: Config,
        name: str,
        reach_m: float = np.inf,
        view_rad: float = 2.0 * np.pi,
        components: Iterable[str] = (),
    ) -> "Sight":
        """Read a sensor of a configuration, which measures these components; none are guessed."""
        guess = guessed(config, name)
        known_by = "told" if components else "guessed by its noise" if guess else "assumed"

        def value(key: str) -> float:
            return float(config[f"sensors.{name}.{key}"])

        return cls(
            name,
            in_order(components or guess or ASSUMED),
            known_by,
            tuple(value(key) for key in MOUNTING),
            {component: value(key) for component, key in SIGMAS.items()},
            value("sigma_range_per_m"),
            value("min_distance_m"),
            reach_m,
            view_rad,
        )

    def sees(self, marker: Sequence[float], poses: Array) -> NDArray[np.bool_]:
        """Tell from which robot poses (n, 3) a marker at x, y, z [m] is in view, (n,)."""
        bearing, elevation, slant = self._predict(marker, COMPONENTS, poses).T
        return np.asarray(
            (slant <= self.reach_m)
            & (slant * np.cos(elevation) >= self.min_distance_m)
            & (np.abs(wrap_angle(bearing)) <= self.view_rad / 2.0)
        )

    def information(self, marker: Sequence[float], sigma_m: float, poses: Array) -> Array:
        """Return Hᵀ R⁻¹ H of a sighting of a marker, by the robot's pose.

        H holds differences of the core's h(x), many poses at a time; R the sensor's noise and the
        survey's, as the core adds them (`fuse_sighting.hpp`).

        Parameters
        ----------
        marker : (3,), x, y in frame map, z above the ground, m
        sigma_m : float, of the survey in x and in y
        poses : (n, 3), x, y, heading

        Returns
        -------
        (n, 3, 3)
        """
        h = np.empty((len(poses), len(self.components), 3))
        for state, step in enumerate(STEP * np.eye(3)):
            ahead, behind = (
                self._predict(marker, self.components, at) for at in (poses + step, poses - step)
            )
            # So small a change wraps only where a bearing passes from π to -π.
            h[:, :, state] = wrap_angle(ahead - behind) / (2.0 * STEP)
        r = sigma_m**2 * h[:, :, :2] @ h[:, :, :2].transpose(0, 2, 1)
        values = self._predict(marker, self.components, poses)
        for row, component in enumerate(self.components):
            r[:, row, row] += self.variance(component, values[:, row])
        return np.asarray(h.transpose(0, 2, 1) @ np.linalg.solve(r, h))

    def variance(self, component: str, value: Array) -> Array:
        """Return the sensor's noise in a component that has these values (n,), squared."""
        growth = self.sigma_range_per_m * value if component == "range" else 0.0
        return np.asarray(self.sigmas[component] ** 2 + growth**2 + 0.0 * value)

    def blur(self, distance_m: float) -> float:
        """Return the standard deviation of a marker's place as seen from a distance, m."""
        sigmas = {c: float(self.variance(c, np.array(distance_m)) ** 0.5) for c in self.components}
        return max(s if c == "range" else s * distance_m for c, s in sigmas.items())

    def _predict(self, marker: Sequence[float], components: tuple[str, ...], poses: Array) -> Array:
        return MarkerModel(marker, list(components), list(self.mounting)).predict(poses)
