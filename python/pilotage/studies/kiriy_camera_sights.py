"""What is found in a drive's pictures, which markers that truly is, and what chance makes of it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import Config
from ..evaluate.truth import interpolate
from ..simulate.detection_faults import Unreliable
from ..simulate.view import sight

NEAR_PX = 5.0
"""A detection is of the marker that truly shows within this."""
SPOILED = 0.2
HORIZON = 0.3
"""Part of the picture's height above which no false marker is made up: there is no ground."""


@dataclass(frozen=True)
class Sight:
    """One picture: what was found in it, which markers (n,) these truly are, -1 none, and where."""

    utime: int
    detections: Sequence[Any]
    ids: NDArray[np.int64]
    exact: NDArray[np.float64]


Sights = dict[str, list[Sight]]
"""By camera."""


def sights(config: Config, folder: Path, truth: NDArray[Any]) -> Sights:
    """Detect in all pictures."""
    from ..camera import images
    from ..camera.eye import make_eye
    from ..camera.looking import look
    from ..camera.tally import Tally

    found: Sights = {}
    for name in config.detectors:
        tally = Tally(name, print)
        seen = look(make_eye(config, name), images.folder(folder / name), tally)
        found[name] = [identified(config, name, s.utime, s.detections, truth) for s in seen]
        if tally.dropped:
            raise RuntimeError(f"{name}: {tally.summary()}")
    return found


def identified(
    config: Config, name: str, utime: int, detections: Sequence[Any], truth: NDArray[Any]
) -> Sight:
    """Say which markers detections truly are."""
    camera = config.camera(name)
    assert camera is not None
    x, y, z, yaw = (config[f"sensors.{name}.{key}"] for key in ("x_m", "y_m", "z_m", "yaw_rad"))
    eye, turn = sight((x, y, z, yaw), interpolate(truth, [utime])[0])
    shown = camera.project((config.map.positions - eye) @ turn)
    ids, exact = [], []
    for one in detections:
        off = np.nan_to_num(np.hypot(*(shown - one.pixel).T), nan=np.inf)
        nearest = int(np.argmin(off))
        ids.append(int(config.map.ids[nearest]) if off[nearest] < NEAR_PX else -1)
        exact.append(shown[nearest])
    return Sight(utime, detections, np.array(ids, int), np.array(exact).reshape(-1, 2))


def certain(found: Sights) -> Sights:
    """Return the same without the detector's errors."""
    return {
        name: [
            replace(
                s,
                detections=[
                    replace(d, pixel=at) for d, at in zip(s.detections, s.exact, strict=True)
                ],
            )
            for s in some
        ]
        for name, some in found.items()
    }


def spoil(found: Sights, config: Config, truth: NDArray[Any], seed: int) -> Sights:
    """Miss some detections and make some up."""
    spoiled: Sights = {}
    for index, (name, some) in enumerate(found.items()):
        camera = config.camera(name)
        assert camera is not None
        blank = np.zeros((camera.size[1], camera.size[0], 3), np.uint8)
        rng = np.random.default_rng((seed, index))
        again = Unreliable(_Remembered(some), rng, SPOILED, SPOILED, top=HORIZON)
        spoiled[name] = [
            identified(config, name, s.utime, again.detect(blank), truth) for s in some
        ]
    return spoiled


class _Remembered:
    """Gives detections once more, picture by picture."""

    def __init__(self, some: Sequence[Sight]) -> None:
        self._rest = iter(some)

    def detect(self, _: NDArray[np.uint8]) -> Sequence[Any]:
        return next(self._rest).detections
