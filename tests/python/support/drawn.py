"""A rendered drive in a folder, as `pilotage simulate --cameras` leaves it."""

from dataclasses import replace
from pathlib import Path

import numpy as np

import pilotage
from pilotage.montecarlo import find_scenario
from pilotage.simulate.pictures import take_pictures


def drawn(folder: Path, scenario: str, duration_s: float) -> pilotage.Config:
    """Draw it; its configuration."""
    chosen = replace(find_scenario(scenario), duration_s=duration_s)
    take_pictures(chosen, np.random.default_rng(1), folder)
    return pilotage.load_config(str(folder / "robot.yaml"))


def part(recording: pilotage.Recording, begin: int, end: int) -> pilotage.Recording:
    """What arrived from a time on and before another, µs."""
    some = pilotage.Recording()
    for i in range(len(recording)):
        received, channel, data = recording[i]
        if begin <= received < end:
            some.add(received, channel, data)
    return some
