"""`pilotage map check`: a map looked at without a robot."""

import json
import re
from pathlib import Path

import pytest

from support.command import pilotage
from support.sites import BEARINGS, LINE, RANGES, SQUARE, markers, site

PAGE = (Path(__file__).parents[3] / "docs" / "map-check.md").read_text()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    markers(SQUARE).save(str(tmp_path / "square.yaml"))
    markers(LINE).save(str(tmp_path / "line.yaml"))
    (tmp_path / "robot.yaml").write_text(site(SQUARE).to_yaml())
    for name, sensor in (("ranges", RANGES), ("bearings", BEARINGS)):
        eye = ", ".join(f"{key}: {value}" for key, value in sensor.items())
        (tmp_path / f"{name}.yaml").write_text(f"sensors: {{eye: {{{eye}}}}}\n")
    (tmp_path / "no-sensor.yaml").write_text("map: square.yaml\n")
    return tmp_path


def test_a_configuration_is_looked_at_with_its_own_sensors(folder: Path):
    result = pilotage("map", "check", "robot.yaml", "--strict", cwd=folder)
    assert result.returncode == 0, result.stderr
    for words in (
        "4 markers",
        "eye measures bearing and range (guessed by its noise); however far, all round",
        "turned by 180° about (2.0, 2.0) m, all 4 markers fall on markers",
        "fit elsewhere too: 100 % of all poses",
        "fewer than 3        0 %            0 %           0 %",
        "with the heading known to 3°",
        "no warnings",
        "1 note:",
        "It matters only where ids are not known",
    ):
        assert words in result.stdout


def test_a_map_is_looked_at_with_another_files_sensors(folder: Path):
    result = pilotage("map", "check", "line.yaml", "-c", "ranges.yaml", "--strict", cwd=folder)
    assert result.returncode == 1
    assert "4 markers from line.yaml" in result.stdout
    assert "eye measures range" in result.stdout
    assert "1 warning:" in result.stdout
    assert "in a line, and no bearing is measured" in result.stdout


def test_a_map_alone_is_looked_at_with_an_assumed_sensor(folder: Path):
    result = pilotage("map", "check", "square.yaml", cwd=folder)
    assert result.returncode == 0, result.stderr
    assert "assumed measures bearing and range (assumed)" in result.stdout


def test_what_is_measured_can_be_told(folder: Path):
    result = pilotage("map", "check", "robot.yaml", "--components", "range", cwd=folder)
    assert result.returncode == 0, result.stderr
    assert "eye measures range (told)" in result.stdout


def test_a_folder_gets_the_numbers_and_the_picture(folder: Path):
    options = ("--reach", 3, "--view", 90, "--area", -4, -4, 8, 8, "-o", "out")
    result = pilotage("map", "check", "robot.yaml", *options, cwd=folder)
    assert result.returncode == 0, result.stderr
    assert "to 3 m, within 90°" in result.stdout
    assert "x -4.0 to 8.0 m" in result.stdout
    assert (folder / "out" / "map.png").read_bytes().startswith(b"\x89PNG")
    assert "not fixed in nine tenths" in result.stdout
    assert "up to not" not in result.stdout
    content = json.loads((folder / "out" / "map.json").read_text())
    assert content["area"] == {"x_min": -4, "y_min": -4, "x_max": 8, "y_max": 8}
    assert [s["turn_deg"] for s in content["symmetries"]] == pytest.approx([90, -90, 180])
    assert content["symmetries"][0]["pairs"] == [[0, 1], [1, 2], [2, 3], [3, 0]]
    few = [row["poses"] for row in content["in_view"]]
    assert few == sorted(few)
    assert content["average_radius_95_m"]["90 % of the area"] is None
    assert {finding["key"] for finding in content["findings"]} == {"map"}


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nowhere.yaml"], ["nowhere.yaml", "cannot be opened"]),
        (["ranges.yaml"], ["ranges.yaml has no map", "-c ranges.yaml"]),
        (["no-sensor.yaml"], ["no-sensor.yaml has no sensor", "sensors:"]),
        (["robot.yaml", "-c", "ranges.yaml"], ["robot.yaml is a configuration", "ranges.yaml"]),
        (["robot.yaml", "--reach", "0"], ["--reach is 0", "more than 0 m"]),
        (["robot.yaml", "--view", "400"], ["--view is 400", "360°"]),
        (["robot.yaml", "--area", "1", "2", "1", "4"], ["--area is 1 2 1 4", "highest"]),
        (["robot.yaml", "--area", "0", "0", "inf", "3"], ["--area is 0 0 inf 3", "numbers"]),
        (["robot.yaml", "--components", "colour"], ["components are colour", "elevation"]),
        (["robot.yaml", "-o", "robot.yaml"], ["-o robot.yaml", "another folder"]),
    ],
)
def test_what_cannot_be_looked_at_is_named(folder: Path, arguments, words):
    result = pilotage("map", "check", *arguments, cwd=folder)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr


def test_help_has_an_example():
    result = pilotage("map", "check", "--help")
    assert "Example: pilotage map check robot.yaml" in result.stdout


def test_the_page_shows_what_is_said(folder: Path):
    simulated = pilotage(
        "simulate", "circle-four-poles", "-o", "poles.lcmlog", "--duration", 1, cwd=folder
    )
    assert simulated.returncode == 0, simulated.stderr
    shown = re.search(r"^\$ pilotage (map check .*?)\n(.*?)^```", PAGE, re.M | re.S)
    assert shown
    assert pilotage(*shown[1].split(), cwd=folder).stdout == shown[2]
