"""`pilotage check`: a configuration tried without a robot."""

from pathlib import Path

import pytest

from support.command import pilotage
from support.configs import sound


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "sound.yaml").write_text(sound().to_yaml())
    (tmp_path / "doubtful.yaml").write_text(sound(sensors__camera__yaw_rad=90).to_yaml())
    (tmp_path / "broken.yaml").write_text("sensors:\n  camera: {sigma_bearingg_rad: 1}\n")
    (tmp_path / "markers.yaml").write_text("[{id: 4, x: 1, y: 2}, {id: 9, x: 8, y: 2}]\n")
    (tmp_path / "twice.yaml").write_text("[{id: 4, x: 1, y: 2}, {id: 4, x: 8, y: 2}]\n")
    return tmp_path


def test_a_sound_configuration_is_said_in_words(folder: Path):
    result = pilotage("check", "sound.yaml", "--strict", cwd=folder)
    assert result.returncode == 0, result.stdout
    for words in ("heading from the gyro", "camera at x 0.2 m", "3 markers", "no warnings"):
        assert words in result.stdout


def test_a_warning_says_the_way_out_and_counts_if_strict(folder: Path):
    result = pilotage("check", "doubtful.yaml", cwd=folder)
    assert result.returncode == 0
    assert "1 warning:" in result.stdout
    assert "sensors.camera.yaw_rad: 90 rad, more than a turn" in result.stdout
    assert "→ if it was meant in degrees: 1.571" in result.stdout
    assert pilotage("check", "doubtful.yaml", "--strict", cwd=folder).returncode == 1


def test_another_map_can_be_tried(folder: Path):
    result = pilotage("check", "sound.yaml", "--map", "markers.yaml", cwd=folder)
    assert result.returncode == 0
    assert "2 markers from markers.yaml" in result.stdout
    assert "4 missing in between, the first 5" in result.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["broken.yaml"], ["broken.yaml:2", "sigma_bearingg_rad", "sigma_bearing_rad"]),
        (["nowhere.yaml"], ["nowhere.yaml", "cannot be opened"]),
        (["sound.yaml", "--map", "twice.yaml"], ["twice.yaml:1", "id 4", "twice"]),
    ],
)
def test_what_is_broken_is_named_and_exits_with_2(folder: Path, arguments, words):
    result = pilotage("check", *arguments, cwd=folder)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr
