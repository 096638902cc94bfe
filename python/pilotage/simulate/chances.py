"""What a robot meets by chance: a wrong start, outliers, being carried away."""

from dataclasses import dataclass, replace

import numpy as np

from .. import MarkerMap
from ..fields import ascending, within
from .drives import Drive
from .marker_faults import other_ids
from .sensors import Camera
from .streams import Stream

Span = tuple[float, float]
"""From, to; drawn uniformly."""
TRIES = 1000


@dataclass(frozen=True)
class Start:
    """Where the drive begins, and what the localizer is told of it."""

    known: bool = True
    """Else no initial pose is configured, and the localizer has to find it."""
    sigma_position_m: float | None = None
    """Stated, in x and in y; None: as the configuration has it."""
    sigma_heading_rad: float | None = None
    error_factor: float = 1.0
    """What the localizer is told is wrong by the stated sigma times this."""
    error: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Told less true x, y [m] and heading [rad]."""
    x_m: Span | None = None
    """With `y_m`: the drive begins anywhere in this box, with any heading."""
    y_m: Span | None = None

    def __post_init__(self) -> None:
        if (self.x_m is None) != (self.y_m is None):
            raise ValueError("x_m and y_m, the box in which the drive begins, go together")
        within("sigma_position_m", self.sigma_position_m or 0.0, 0.0)
        within("sigma_heading_rad", self.sigma_heading_rad or 0.0, 0.0)
        within("error_factor", self.error_factor, 0.0)
        for name, span in (("x_m", self.x_m), ("y_m", self.y_m)):
            ascending(name, span or (0.0, 0.0))

    def placed(self, drive: Drive, rng: np.random.Generator) -> Drive:
        """Return the drive from where it begins in this run."""
        if self.x_m is None or self.y_m is None:
            return drive
        low, high = np.array([self.x_m, self.y_m, (-np.pi, np.pi)]).T
        return drive.displaced(0, rng.uniform(low, high))


@dataclass(frozen=True)
class Kidnap:
    """The robot is lifted while it drives and goes on elsewhere; wheels and gyro notice nothing."""

    at_s: Span
    distance_m: Span = (0.0, 0.0)
    turn_rad: Span = (0.0, 0.0)
    """To either side."""

    def __post_init__(self) -> None:
        ascending("at_s", self.at_s, 0.0)
        ascending("distance_m", self.distance_m, 0.0)
        ascending("turn_rad", self.turn_rad, 0.0)

    def strike(
        self, drive: Drive, markers: MarkerMap, rng: np.random.Generator
    ) -> tuple[Drive, int]:
        """Return the drive and when it broke off [µs]; it goes on within the markers' rectangle."""
        k = int(np.searchsorted(drive.utime, drive.utime[0] + rng.uniform(*self.at_s) * 1e6))
        low, high = markers.positions[:, :2].min(axis=0), markers.positions[:, :2].max(axis=0)
        for _ in range(TRIES):
            way, direction = rng.uniform(*self.distance_m), rng.uniform(-np.pi, np.pi)
            turn = rng.uniform(*self.turn_rad) * rng.choice((-1.0, 1.0))
            step = [way * np.cos(direction), way * np.sin(direction), turn]
            pose = drive.pose[k] + step
            if way == 0.0 or ((low <= pose[:2]) & (pose[:2] <= high)).all():
                return drive.displaced(k, pose), int(drive.utime[k])
        raise ValueError(f"kidnap: nothing within the markers is {self.distance_m} m away")


@dataclass(frozen=True)
class Outliers:
    """Sightings that are grossly wrong, each with a probability."""

    share: float
    kind: str = "both"
    """``bearing``: anywhere in view; ``id``: another marker's; ``both``: half and half."""

    def __post_init__(self) -> None:
        within("share", self.share, 0.0, 1.0)
        if self.kind not in ("bearing", "id", "both"):
            raise ValueError(f"kind is '{self.kind}', expected bearing, id or both")

    @property
    def of_bearings(self) -> bool:
        """Whether some are of bearings."""
        return self.kind != "id"

    @property
    def of_ids(self) -> bool:
        """Whether some are of ids."""
        return self.kind != "bearing"

    def strike(
        self, seen: Stream, camera: Camera, markers: MarkerMap, rng: np.random.Generator
    ) -> Stream:
        """Return the stream with its outliers."""
        n = len(seen)
        wrong = rng.random(n) < self.share
        astray = rng.random(n) < {"bearing": 1.0, "id": 0.0, "both": 0.5}[self.kind]
        anywhere = rng.uniform(-camera.half_view_rad, camera.half_view_rad, n)
        other = other_ids(seen.id, markers, rng)
        value = seen.value.copy()
        value[:, 0] = np.where(wrong & astray, anywhere, value[:, 0])
        return replace(seen, value=value, id=np.where(wrong & ~astray, other, seen.id))
