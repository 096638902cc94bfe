"""Whether the gate rejects as many good sightings as its setting says."""

import numpy as np

from .. import Config, Policy

BATCH = 1_000_000


def false_rejects(dof: int, draws: int, rng: np.random.Generator) -> float:
    """Return the share of good innovations of so many components above the gate, over its setting.

    An innovation that its covariance whitens is standard normal, so nothing else is drawn.
    """
    setting = Config()["sensors.any.gate_false_reject"]
    limit, rejected = Policy.gate(setting).gate_nis(dof), 0
    for first in range(0, draws, BATCH):
        innovation = rng.standard_normal((min(BATCH, draws - first), dof))
        rejected += int((np.square(innovation).sum(axis=1) > limit).sum())
    return float(rejected / draws / setting)
