"""Poses that a node has sent, as a trajectory."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import Recording
from ..evaluate.trajectory import trajectory
from ..lcmtypes import pose_t


def recorded_poses(recording: Recording) -> NDArray[Any]:
    """Return the `pose_t` of a log as rows of `evaluate.TRAJECTORY`; a ValueError without any."""
    message: Any = pose_t  # generated without types
    fingerprint = message().encode()[:8]
    data = (recording[index][2] for index in range(len(recording)))
    found = [message.decode(one) for one in data if one[:8] == fingerprint]
    if not found:
        raise ValueError(
            "the log has neither reference_t nor pose_t: name the robot's poses with --poses, such "
            "as the pose.csv of pilotage replay -o"
        )
    return trajectory(
        np.array([one.utime for one in found]),
        np.array([(one.x, one.y, one.heading) for one in found]),
    )
