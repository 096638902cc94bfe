"""One rendered drive by all ways from pictures to a pose."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import Config, Recording, Run, load_config
from .. import replay as replayed
from ..evaluate import compute_metrics
from ..evaluate.truth import interpolate
from ..simulate import Scenario
from ..simulate.detection_faults import Unreliable
from ..simulate.view import sight

NEAR_PX = 5.0
"""A detection is of the marker that truly shows within this."""
SPOILED = 0.2
HORIZON = 0.3
"""Part of the picture's height above which no false marker is made up: there is no ground."""
RADIUS_PX = 64
VARIANTS = (
    "ideal angles",
    "ideal angles, as sure as images",
    "images",
    "images, measures: pixels",
    f"images, pixels within {RADIUS_PX} px",
    "images, spoiled",
    "images, measures: pixels, spoiled",
    f"images, pixels within {RADIUS_PX} px, spoiled",
)


@dataclass(frozen=True)
class Outcome:
    """How a run came out; `nis` is by sensor, over its degrees of freedom, `nees` over three."""

    mean_m: float
    rmse_m: float
    nees: float
    nis: dict[str, float]
    fused: int
    wrong: int

    @property
    def false_share(self) -> float:
        """Of what was fused, what was of another marker or of none."""
        return self.wrong / max(self.fused, 1)


@dataclass(frozen=True)
class Sight:
    """One picture: what was found in it, which markers (n,) these truly are, -1 none, and where."""

    utime: int
    detections: Sequence[Any]
    ids: NDArray[np.int64]
    exact: NDArray[np.float64]


Sights = dict[str, list[Sight]]
"""By camera."""


def drive(scenario: Scenario, seed: int, folder: Path) -> dict[str, Outcome]:
    """Return the outcomes of `VARIANTS`."""
    from ..simulate.pictures import DRIVE, IDEAL, take_pictures
    from ..simulate.robot_files import ROBOT

    take_pictures(scenario, np.random.default_rng(seed), folder)
    file = str(folder / ROBOT)
    own = Recording.load(str(folder / DRIVE))
    truth = own.reference()
    found = sights(load_config(file), folder, truth)
    spoiled = spoil(found, load_config(file), truth, seed)

    def outcome(seen: Sights, **keys: Any) -> Outcome:
        config = load_config(file)
        for key, value in keys.items():
            for name in seen:
                config[f"sensors.{name}.{key}"] = value
        return judge(replayed(config, with_frames(config, folder / DRIVE, seen)), truth, seen)

    exact = replayed(load_config(file), Recording.load(str(folder / IDEAL)))
    pixels: dict[str, Any] = {"measures": "pixels", "channel": "PIXELS"}
    near = pixels | {"association_radius_pixel": RADIUS_PX}
    outcomes = [judge(exact, truth, None), outcome(certain(found))]
    outcomes += [outcome(seen, **keys) for seen in (found, spoiled) for keys in ({}, pixels, near)]
    return dict(zip(VARIANTS, outcomes, strict=True))


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


def with_frames(config: Config, log: Path, seen: Sights) -> Recording:
    """Return a drive with what its cameras saw, as the camera program merges it."""
    from ..camera.eye import make_eye
    from ..camera.messages import message
    from ..camera.offline import Found, merged

    frames = []
    for name, some in seen.items():
        eye = make_eye(config, name)
        for seq, s in enumerate(some):
            frame = message(eye, s.utime, seq, s.detections, config.map)
            assert frame is not None  # only poses may be left out
            frames.append(Found(s.utime, eye.channel, frame.encode()))
    return merged(config, log, frames, list(seen))[0]


def judge(run: Run, truth: NDArray[Any], seen: Sights | None) -> Outcome:
    """Hold a run against the truth, and what was fused against what it is of."""
    metrics = compute_metrics(run, truth)
    assert metrics.position is not None
    assert metrics.nees is not None
    fused = run.reports[run.reports["accepted"].astype(bool)]
    wrong = 0
    if seen is not None:
        wrong = sum(
            int(seen[run.sensors[row["sensor"]]][row["frame_seq"]].ids[row["index"]] != row["id"])
            for row in fused
        )
    return Outcome(
        metrics.position.mean_m,
        metrics.position.rmse_m,
        metrics.nees.mean / metrics.nees.dof,
        {
            name: nis.mean / nis.dof
            for name, nis in metrics.nis.items()
            if nis.mean is not None and nis.dof is not None
        },
        len(fused),
        wrong,
    )
