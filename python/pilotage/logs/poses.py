"""Poses that a node has sent, as a trajectory."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import Recording
from ..evaluate.trajectory import trajectory
from ..lcmtypes import pose_t


def recorded_poses(recording: Recording) -> NDArray[Any] | None:
    """Return the `pose_t` of a log as rows of `evaluate.TRAJECTORY`, None if there are none."""
    message: Any = pose_t  # generated without types
    fingerprint = message().encode()[:8]
    data = (recording[index][2] for index in range(len(recording)))
    found = [message.decode(one) for one in data if one[:8] == fingerprint]
    if not found:
        return None
    return trajectory(
        np.array([one.utime for one in found]),
        np.array([(one.x, one.y, one.heading) for one in found]),
    )
