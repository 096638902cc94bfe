"""Nothing that a peer sends stops the node or turns into NaN, and everything is counted."""

import math
import time
from pathlib import Path

from pilotage.lcmtypes import encoders_t, gyro_t, pose_reset_t
from support.bus import frame, node


def _counts(status) -> dict[str, dict[str, int]]:
    """Per channel the counts by reason, after checking that they add up."""
    table = {}
    for entry in status.inputs:
        by_reason = {r.reason: r.count for r in entry.rejected}
        assert entry.received == entry.fused + entry.pending + sum(by_reason.values())
        table[entry.channel] = {"fused": entry.fused, **by_reason}
    return table


def test_every_kind_of_bad_message_is_counted_and_the_node_goes_on(tmp_path: Path):
    nan, inf = math.nan, math.inf
    with node(tmp_path) as running:
        running.drive(50)
        running.wait(lambda: len(running.messages["POSE"]) == 50, "poses")
        good = encoders_t()
        good.utime, good.seq = 1_600_000, 50
        running.send("ENCODERS", good.encode()[:-3])  # truncated
        running.send("ENCODERS", good.encode() + b"xyz")  # longer than its type
        running.send("ENCODERS", b"")
        running.send("ENCODERS", b"\x00" * 7)
        running.send("ENCODERS", gyro_t())  # another type
        running.send("GYRO", good)
        for rate in (nan, inf, -inf, 1e300):
            bad = gyro_t()
            bad.utime, bad.seq, bad.rate = 1_495_000, 50, rate
            running.send("GYRO", bad)
        for marker, bearing, distance in (
            (7, 0.0, 3.0),
            (1, inf, 3.0),
            (1, nan, nan),
            (1, 0, -inf),
        ):
            running.send("MARKERS", frame(1_480_000, 1, (marker, bearing, distance)))
        running.send("MARKERS", frame(1_480_000, 2, (1, 0.0, 3.0), sensor="lidar"))
        oversized = bytearray(frame(1_480_000, 3, (1, 0.0, 3.0)).encode())
        oversized[8 + 12 + 4 + 7 : 8 + 12 + 4 + 11] = b"\x7f\xff\xff\xff"
        running.send("MARKERS", bytes(oversized))
        for field in ("x", "y", "heading"):
            reset = pose_reset_t()
            reset.utime = 1_490_000
            setattr(reset, field, nan)
            running.send("POSE_RESET", reset)
        for utime in (-(2**63), 2**63 - 1):
            extreme = encoders_t()
            extreme.utime, extreme.left = utime, 2**62
            running.send("ENCODERS", extreme)
        running.drive(50, first=50)
        running.wait(lambda: len(running.messages["POSE"]) == 100, "poses after it all")
        counts = _counts(running.status_after(time.time() + 0.2))
        assert counts["ENCODERS"]["malformed"] == 2
        assert counts["ENCODERS"]["wrong_type"] == 3
        assert counts["ENCODERS"]["clock"] == 2
        assert counts["ENCODERS"]["fused"] == 100
        assert counts["GYRO"] == {"fused": 100, "wrong_type": 1, "bad_value": 3, "implausible": 1}
        assert counts["MARKERS"] == {
            "fused": 0, "bad_value": 3, "unknown_marker": 1, "unknown_sensor": 1, "malformed": 1,
        }  # fmt: skip
        assert counts["POSE_RESET"] == {"fused": 0, "bad_value": 3}
        for pose in running.messages["POSE"]:
            assert all(map(math.isfinite, (pose.x, pose.y, pose.heading, *pose.covariance)))
        assert abs(running.messages["POSE"][-1].x - 0.99) < 1e-6
        reasons = [report.reason for report in running.messages["MARKER_REPORT"]]
        assert sorted(reasons) == ["bad_value", "bad_value", "bad_value", "unknown_marker"]
        for words in (
            "GYRO: expected gyro_t, got encoders_t",
            "broken encoders_t",
            "sensor 'lidar'",
        ):
            assert running.said.count(words) == 1


def test_a_counter_that_starts_again_moves_nothing_and_is_named(tmp_path: Path):
    with node(tmp_path) as running:
        running.drive(50, first=1000)
        running.wait(lambda: len(running.messages["POSE"]) == 50, "poses")
        before = running.messages["POSE"][-1].x
        restarted = encoders_t()
        for i in range(10):
            restarted.utime, restarted.seq = 1_000_000 + 10_000 * (1050 + i), i
            restarted.left = restarted.right = 10 * i
            running.send("ENCODERS", restarted)
        running.wait(lambda: len(running.messages["POSE"]) == 60, "poses after the restart")
        assert abs(running.messages["POSE"][50].x - before) < 1e-9
        assert abs(running.messages["POSE"][59].x - before - 0.09) < 1e-6
        counts = _counts(running.status_after(time.time() + 0.2))
        assert counts["ENCODERS"]["counter_reset"] == 1
