"""The messages of a recording, decoded."""

from typing import Any

from pilotage import Recording, lcmtypes

TYPES = {
    "ENCODERS": lcmtypes.encoders_t,
    "GYRO": lcmtypes.gyro_t,
    "VELOCITY": lcmtypes.velocity_t,
    "MARKERS": lcmtypes.marker_frame_t,
    "REFERENCE": lcmtypes.reference_t,
}


def messages(recording: Recording) -> dict[str, list[Any]]:
    """Messages by channel, in the order of their arrival; checks that they arrived when stamped."""
    by_channel: dict[str, list[Any]] = {}
    for i in range(len(recording)):
        received, channel, data = recording[i]
        message = TYPES[channel].decode(data)
        assert received == message.utime
        by_channel.setdefault(channel, []).append(message)
    return by_channel


def channels(recording: Recording) -> list[tuple[int, str]]:
    """(received, channel) of each message in order."""
    return [recording[i][:2] for i in range(len(recording))]
