"""`pilotage evaluate`: errors of any two trajectories."""

import json
from pathlib import Path

import numpy as np
import pytest

from support.command import pilotage

HEADER = "utime,x,y,heading\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Truth along x at 1 m/s; an estimate 0.3 m to its left, turned by 2 degrees."""
    turn = np.radians(2.0)
    with (tmp_path / "truth.tum").open("w") as truth, (tmp_path / "pose.csv").open("w") as pose:
        pose.write(HEADER)
        for i in range(100):
            truth.write(f"{0.1 * i:.6f} {0.1 * i} 0 0 0 0 0 1\n")
            pose.write(f"{100_000 * i},{0.1 * i},0.3,{turn}\n")
    (tmp_path / "later.csv").write_text(HEADER + "900000000,0,0,0\n")
    (tmp_path / "words.csv").write_text(HEADER + "1,2,three,4\n")
    (tmp_path / "short.csv").write_text("utime,x\n1,2\n")
    (tmp_path / "log.tum").write_bytes(b"\xed\xa1\xda\x01")
    return tmp_path


def test_the_table_gives_the_errors(folder: Path):
    result = pilotage("evaluate", "pose.csv", "truth.tum", cwd=folder)
    assert result.returncode == 0, result.stderr
    lines = {line[:40].strip(): line[40:].split() for line in result.stdout.splitlines()}
    assert lines["position error, RMSE"] == ["0.300", "m"]
    assert lines["heading error, mean"] == ["+2.00", "deg"]


def test_json_has_the_keys_of_metrics_json(folder: Path):
    result = pilotage("evaluate", "--json", "pose.csv", "truth.tum", cwd=folder)
    content = json.loads(result.stdout)
    assert content["position"]["rmse_m"] == pytest.approx(0.3)
    assert content["heading"]["mean_deg"] == pytest.approx(2.0)
    assert content["position"].keys() == {"rmse_m", "mean_m", "std_m", "p95_m", "max_m"}
    assert content["heading"].keys() == {"rmse_deg", "mean_deg", "std_deg", "median_abs_deg"}


@pytest.mark.parametrize(
    ("truth", "words"),
    [
        ("nowhere.csv", ["nowhere.csv", "No such file"]),
        ("later.csv", ["pose.csv", "later.csv", "no time in common"]),
        ("words.csv", ["words.csv", "three"]),
        ("short.csv", ["short.csv", "'y'"]),
        ("log.tum", ["log.tum"]),
    ],
)
def test_what_cannot_be_compared_is_named(folder: Path, truth: str, words):
    result = pilotage("evaluate", "pose.csv", truth, cwd=folder)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr
