"""`pilotage demo`, on a machine without a route for multicast."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from pilotage import multicast
from support.command import pilotage

LEFT = {
    "path.png", "closeup.png", "markers.png", "errors.png", "nis.png", "pose.csv", "pose.tum",
    "reports.csv", "metrics.json", "config.yaml",
}  # fmt: skip
ALONE = ["unshare", "-rn"]


@pytest.fixture(autouse=True)
def _namespaces():
    if shutil.which("unshare") is None or subprocess.run([*ALONE, "true"], check=False).returncode:
        pytest.skip("needs unshare (util-linux) and a kernel that lets users make namespaces")


def test_it_says_what_is_missing_and_runs_live_in_a_private_network(tmp_path: Path):
    if multicast.private_network(["true"]) is None:
        pytest.skip("needs ip (iproute2)")
    result = pilotage("demo", "-o", tmp_path, within=ALONE)
    assert result.returncode == 0, result.stderr
    assert "sudo ip route add 224.0.0.0/4 dev lo" in result.stderr
    assert "pilotage-node answered with 54901 poses" in result.stdout
    assert "the same, byte for byte" in result.stdout
    assert "position error, RMSE" in result.stdout
    assert json.loads((tmp_path / "metrics.json").read_text())["counts"]["rejected"] == {}
    assert {path.name for path in tmp_path.iterdir()} >= LEFT | {"node.lcmlog", "robot.yaml"}
    again = pilotage("replay", tmp_path / "node.lcmlog", "--no-figures", "-o", tmp_path / "again")
    assert again.returncode == 0, again.stderr
    poses = [(folder / "pose.csv").read_bytes() for folder in (tmp_path, tmp_path / "again")]
    assert poses[0] == poses[1]


def test_without_a_private_network_it_runs_the_engine_itself(tmp_path: Path):
    tools = tmp_path / "bin"
    tools.mkdir()  # no ip there, nor unshare
    unshare = [str(shutil.which("unshare")), "-rn"]
    environment = {**os.environ, "PATH": str(tools)}
    result = pilotage("demo", "-o", tmp_path / "out", within=unshare, env=environment)
    assert result.returncode == 0, result.stderr
    assert "the engine runs in this process" in result.stderr
    assert {path.name for path in (tmp_path / "out").iterdir()} >= LEFT
