"""A recording held as arrays through the localizer in one call: samples a second, three states."""

import json
import statistics
import time

import numpy as np

from pilotage import Localizer
from pilotage.simulate import SCENARIOS, simulate

ROUNDS = 9


def main() -> None:
    scenario = SCENARIOS["mower-spiral"]
    config = simulate(scenario, np.random.default_rng(1)).config
    for state in ("gyro_bias", "distance_scale", "rotation_scale"):
        config[f"calibration.{state}.sigma"] = 0.0
        config[f"calibration.{state}.walk"] = 0.0
    rng = np.random.default_rng(1)
    markers = scenario.site(rng)
    drive = scenario.drive(scenario.duration_s)
    rates = scenario.gyro.rates(drive, rng)
    ticks = scenario.encoders.ticks(drive, rng).astype(float)
    seen_at, marker, seen = scenario.cameras[0].sightings(drive, markers, rng)
    samples = 2 * len(drive.utime) + len(seen_at)
    seconds = []
    for _ in range(ROUNDS):
        localizer = Localizer(config)
        start = time.perf_counter()
        poses = localizer.run(drive.utime, ticks, drive.utime, rates, seen_at, marker, seen)
        seconds.append(time.perf_counter() - start)
    assert len(poses) > 0.99 * len(drive.utime)
    print(json.dumps({"samples_per_s": samples / statistics.median(seconds)}))


if __name__ == "__main__":
    main()
