"""`pilotage faults`, with few runs."""

import json
from pathlib import Path

import pytest

from support.command import pilotage


def test_a_campaign_leaves_a_table_a_file_and_a_page(tmp_path: Path):
    result = pilotage("faults", "--runs", 1, "--jobs", 2, "-o", tmp_path)
    assert result.returncode == 0, result.stderr
    assert "wrong but plausible" in result.stdout
    assert "not covered" not in result.stdout
    content = json.loads((tmp_path / "faults.json").read_text())
    assert len(content["cells"]) == content["runs"] == 50
    assert content["crashes"] == content["not_finite"] == 0
    assert content["silent_failures"] == sum(cell["silent"] for cell in content["cells"])
    assert [cell["cell"] for cell in content["cells"] if cell["missed"]] == []
    assert content["no_fault"]["ok"] > 0.99
    assert {ladder["cell"] for ladder in content["smallest"]} >= {"markers moved"}
    assert content["policies"].keys() == {"receive", "mapped"}
    page = (tmp_path / "faults.md").read_text()
    assert page.startswith("# ")
    assert page.count("\n| markers ") >= 20
    for word in ("silent failure", "What nobody sees", "swapped pair", "`time: utime`"):
        assert word in page


def test_cells_that_were_not_run_are_shown_as_such(tmp_path: Path):
    result = pilotage("faults", "--runs", 2, "--jobs", 1, "--only", "gyro d", "-o", tmp_path)
    assert result.returncode == 0, result.stderr
    assert result.stdout.count("\ngyro ") == 3
    cells = json.loads((tmp_path / "faults.json").read_text())["cells"]
    covered = [cell["cell"] for cell in cells if cell["covered"]]
    assert covered == ["gyro delayed", "gyro duplicate", "gyro drifting clock"]
    assert (tmp_path / "faults.md").read_text().count("not covered") == 47


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["square"], ["square", "yard"]),
        (["--only", "nothing"], ["nothing", "encoders", "swapped pair"]),
        (["--jobs", "0"], ["--jobs", "0", "-1"]),
        (["--runs", "0"], ["--runs"]),
        (["-o", "a-file"], ["-o a-file", "another folder"]),
    ],
)
def test_what_cannot_be_run_is_named(tmp_path: Path, arguments, words):
    (tmp_path / "a-file").touch()
    result = pilotage("faults", *arguments, cwd=tmp_path)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr
