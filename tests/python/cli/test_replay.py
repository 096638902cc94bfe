"""`pilotage replay`, as a user types it."""

import json
from pathlib import Path

import numpy as np
import pytest

from pilotage import Recording
from support.command import pilotage
from support.datasets import dataset


def test_the_output_folder_holds_what_the_documentation_says(tmp_path: Path):
    result = pilotage("replay", dataset("plaza") / "Plaza1_.mat", "-o", tmp_path)
    assert result.returncode == 0, result.stderr
    assert {path.name for path in tmp_path.iterdir()} >= {
        "pose.csv", "pose.tum", "reports.csv", "metrics.json", "config.yaml", "path.png",
        "closeup.png", "markers.png", "errors.png", "nis.png",
    }  # fmt: skip
    metrics = json.loads((tmp_path / "metrics.json").read_text())
    assert metrics["position"].keys() == {"rmse_m", "mean_m", "std_m", "p95_m", "max_m"}
    assert metrics["heading"].keys() == {"rmse_deg", "mean_deg", "std_deg", "median_abs_deg"}
    assert metrics["nees"].keys() == {"mean", "dof"}
    assert metrics["nis"]["radio"].keys() == {"mean", "dof", "count"}
    assert metrics["counts"] == {"samples": 3529, "accepted": 3529, "rejected": {}}
    assert f"{metrics['position']['rmse_m']:.3f}" in result.stdout

    poses = np.genfromtxt(tmp_path / "pose.csv", delimiter=",", names=True)
    tum = np.loadtxt(tmp_path / "pose.tum")
    assert len(poses) == len(tum)
    assert np.abs(tum[:, 0] - poses["utime"] * 1e-6).max() < 1e-9 * poses["utime"].max()
    assert np.abs(2 * np.arctan2(tum[:, 6], tum[:, 7]) - poses["heading"]).max() < 1e-12
    reports = (tmp_path / "reports.csv").read_text().splitlines()
    assert len(reports) == 1 + metrics["counts"]["samples"]


def test_the_configuration_as_used_repeats_the_run(tmp_path: Path):
    log = dataset("plaza") / "Plaza1_.mat"
    for folder, options in (("a", []), ("b", ["--config", tmp_path / "a" / "config.yaml"])):
        result = pilotage("replay", log, "--no-figures", "-o", tmp_path / folder, *options)
        assert result.returncode == 0, result.stderr
    poses = [(tmp_path / folder / "pose.csv").read_bytes() for folder in "ab"]
    assert poses[0] == poses[1]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["replay", "nowhere"], ["nowhere"]),
        (["replay", "{log}", "--config", "missing.yaml"], ["missing.yaml", "cannot be opened"]),
        (["replay", "{log}", "--config", "{bad}"], ["bad.yaml:2", "gyrro", "gyro"]),
        (["replay", "{empty}"], ["--config"]),
    ],
)
def test_what_a_user_can_mend_is_one_line_and_exit_2(tmp_path: Path, arguments, words):
    recording = Recording()
    recording.add_gyro("GYRO", [1, 2], [0.0, 0.0])
    recording.save(str(tmp_path / "empty.lcmlog"))
    (tmp_path / "bad.yaml").write_text("motion: {source: encoders}\ngyrro: {channel: G}\n")
    places = {"log": tmp_path / "empty.lcmlog", "bad": tmp_path / "bad.yaml"}
    places["empty"] = places["log"]
    result = pilotage(*(str(a).format(**places) for a in arguments))
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr


COMMANDS = (
    "demo", "replay", "convert", "simulate", "evaluate", "plot", "config", "check", "status",
)  # fmt: skip


def test_every_command_explains_itself_with_an_example():
    top = pilotage("--help")
    assert top.returncode == 0
    for command in COMMANDS:
        assert command in top.stdout
        assert "Example: pilotage " + command in pilotage(command, "--help").stdout
