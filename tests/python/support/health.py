"""Messages of a node's health, made by hand."""

from typing import Any

from pilotage.lcmtypes import input_status_t, pose_t, reason_count_t, status_t

NAN = float("nan")


def _with(message: Any, values: dict[str, Any]) -> Any:
    for name, value in values.items():
        assert name in message.__slots__
        setattr(message, name, value)
    return message


def input_status(name: str, channel: str, rejected: dict[str, int] | None = None, **values: Any):
    """An input from which nothing came yet, but for the values."""
    silent = {"rate_hz": NAN, "age_s": NAN, "clock_skew_ppm": NAN, "noise_scale": 1.0}
    counts = [
        _with(reason_count_t(), {"reason": r, "count": n}) for r, n in (rejected or {}).items()
    ]
    return _with(
        input_status_t(),
        {
            "name": name, "channel": channel, **silent, **values,
            "n_rejected": len(counts), "rejected": counts,
        },
    )  # fmt: skip


def status(*inputs: Any, **values: Any) -> Any:
    """A status_t of a node that has just started, but for the values."""
    fresh = {"reset_seq": -1, "checkpoint_age_s": NAN, "version": "0.1.0"}
    return _with(status_t(), {**fresh, **values, "n_inputs": len(inputs), "inputs": list(inputs)})


def pose(**values: Any) -> Any:
    """A pose_t in the origin, with sigmas of 0.1 m, 0.2 m and 1 degree."""
    variances = [0.01, 0, 0, 0, 0.04, 0, 0, 0, 0.017453292519943295**2]
    return _with(pose_t(), {"covariance": variances, **values})
