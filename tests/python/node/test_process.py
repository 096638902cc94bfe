"""The node as a process: how it starts, ends, and what it says."""

import signal
import subprocess
from pathlib import Path

import pytest

from pilotage.lcmtypes import pose_reset_t
from support.bus import CONFIG, NODE, frame, node


@pytest.mark.parametrize("end", [signal.SIGTERM, signal.SIGINT])
def test_a_signal_ends_it_cleanly(end: signal.Signals, tmp_path: Path):
    with node(tmp_path) as running:
        running.process.send_signal(end)
        assert running.process.wait(timeout=5) == 0


@pytest.mark.outside
@pytest.mark.parametrize(
    ("config", "words"),
    [
        ("sensors: {camera: {sigma_bearingg_rad: 1}}", ["robot.yaml:1", "sigma_bearing_rad"]),
        ("encoders: {track_width_m: -1}\nmap: []", ["track_width_m", "-1", "above 0"]),
        ("map: []", ["map", "no marker"]),
        ("map: missing.yaml", ["missing.yaml", "cannot be opened"]),
        ("map: [{id: 1, x: 0, y: 0}, {id: 1, x: 1, y: 0}]", ["id 1", "twice"]),
        ("gyro: {channel: A}\ngyro: {channel: B}", ["robot.yaml:2", "twice"]),
        (
            "initial: {x_m: .nan, y_m: 0, heading_rad: 0}",
            ["initial.x_m", ".nan", "expected a number"],
        ),
        ("encoders: {channel: ENCODERS", ["robot.yaml", "not YAML"]),
        ("sensors: {camera: {z_m: 1}}", ["'map' is missing"]),
    ],
)
def test_a_bad_configuration_is_named_and_exits_with_2(tmp_path: Path, config, words):
    (tmp_path / "robot.yaml").write_text(config + "\n")
    result = subprocess.run(
        [*NODE, "--config", str(tmp_path / "robot.yaml")], capture_output=True, text=True
    )
    assert result.returncode == 2
    for word in words:
        assert word in result.stderr


@pytest.mark.outside
def test_without_a_route_for_multicast_it_says_how_to_make_one(tmp_path: Path):
    (tmp_path / "robot.yaml").write_text(CONFIG)
    command = [*NODE, "--config", str(tmp_path / "robot.yaml")]
    alone = subprocess.run(["unshare", "-rn", *command], capture_output=True, text=True)
    if "unshare" in alone.stderr:
        pytest.skip("no user namespaces here")
    assert alone.returncode == 1
    assert "ip route add 224.0.0.0/4 dev lo" in alone.stderr


def test_it_says_what_it_waits_for_until_it_has_all(tmp_path: Path):
    without_start = "\n".join(line for line in CONFIG.splitlines() if "initial" not in line)
    with node(tmp_path, without_start) as running:
        waiting = "waiting for markers enough to find the pose"
        running.wait(lambda: waiting in running.said, "its first words")
        assert "encoders_t on ENCODERS" in running.said
        assert "marker_frame_t on MARKERS" in running.said
        running.wait(lambda: running.messages["STATUS"], "a status")
        assert running.messages["STATUS"][0].state == 0
        assert "pose_reset_t on POSE_RESET" in running.messages["STATUS"][0].reason
        start = pose_reset_t()
        start.utime, start.x, start.heading = 900_000, 1.0, 0.5
        start.covariance = [0.01, 0, 0, 0, 0.01, 0, 0, 0, 0.001]
        running.send("POSE_RESET", start)
        running.drive(20)
        running.send("MARKERS", frame(1_100_000, 0, (1, 0.1, 2.0)))
        running.drive(20, first=20)
        running.wait(lambda: "all inputs are there" in running.said, "its last words")
        running.wait(lambda: len(running.messages["POSE"]) == 40, "a pose for each sample")
        assert running.messages["POSE"][0].x == 1.0


def test_a_full_disk_ends_the_recording_and_not_the_run(tmp_path: Path):
    with node(tmp_path, CONFIG, "--record", "/dev/full") as running:
        running.drive(300)
        running.wait(lambda: len(running.messages["POSE"]) == 300, "poses")
        running.wait(lambda: "the recording ends here" in running.said, "a word about the disk")
        running.drive(10, first=300)
        running.wait(lambda: len(running.messages["POSE"]) == 310, "poses without a recording")
