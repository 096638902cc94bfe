"""One rendered drive by all ways from pictures to a pose."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import Config, Recording, Run, load_config
from .. import replay as replayed
from ..evaluate import compute_metrics
from ..simulate import Scenario
from .kiriy_camera_sights import Sights, certain, sights, spoil

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
