"""A short drive with a configuration that suits it, as files."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pilotage.simulate import SCENARIOS, simulate

SENSOR = "scanner"


def write_drive(
    folder: Path, *, exact: bool = False, duration_s: float = 20.0, **settings: Any
) -> NDArray[np.void]:
    """Write drive.lcmlog and robot.yaml; its truth.

    Frames arrive 80 ms late. An exact drive has no noise but the ticks' quantisation. `settings` are
    configuration keys, with two underscores for a dot.
    """
    scenario = replace(SCENARIOS["figure-eight"], duration_s=duration_s, latency_s=0.08)
    if exact:
        tick = scenario.encoders.m_per_tick
        scenario = scenario.with_noise(0.0)
        scenario = replace(scenario, encoders=replace(scenario.encoders, m_per_tick=tick))
    simulation = simulate(scenario, np.random.default_rng(3))
    for key, value in settings.items():
        simulation.config[key.replace("__", ".")] = value
    (folder / "robot.yaml").write_text(simulation.config.to_yaml())
    simulation.recording.save(str(folder / "drive.lcmlog"))
    return simulation.truth
