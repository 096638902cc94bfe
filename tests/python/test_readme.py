"""What the README shows is what the program says."""

import re
from pathlib import Path

import pytest

from support.command import pilotage

README = (Path(__file__).parents[2] / "README.md").read_text()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the map and the configuration that the README starts from."""
    markers, robot = re.findall(r"^   ```yaml\n(.*?)^   ```", README, re.M | re.S)
    (tmp_path / "markers.yaml").write_text(markers)
    (tmp_path / "robot.yaml").write_text(robot)
    return tmp_path


def test_its_configuration_has_no_warning(folder: Path):
    result = pilotage("check", "robot.yaml", "--strict", cwd=folder)
    assert result.returncode == 0, result.stdout + result.stderr


def test_check_says_what_it_shows(folder: Path):
    robot = folder / "robot.yaml"
    robot.write_text(robot.read_text().replace("latency_s: 0.04", "latency_s: 40"))
    shown = re.search(r"^\$ pilotage check robot.yaml\n(.*?)^```", README, re.M | re.S)
    assert shown
    assert pilotage("check", "robot.yaml", cwd=folder).stdout == shown[1]
