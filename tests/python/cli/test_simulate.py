"""`pilotage simulate` into a log."""

import json
from math import isnan
from pathlib import Path

import pytest

from pilotage import Recording
from pilotage.lcmtypes import gyro_t
from support.command import pilotage


def test_a_simulated_log_replays_with_the_configuration_beside_it(tmp_path: Path):
    log, config = tmp_path / "eight.lcmlog", tmp_path / "eight.yaml"
    simulated = pilotage(
        "simulate", "figure-eight", "-o", log, "--duration", 20, "--gyro-bias", 0.002,
        "--slip", 0.02, "--latency", 0.1, "--seed", 4,
    )  # fmt: skip
    assert simulated.returncode == 0, simulated.stderr
    assert f"pilotage replay {log} --config {config}" in simulated.stdout
    replayed = pilotage("replay", log, "--config", config, "--no-figures", "-o", tmp_path / "out")
    assert replayed.returncode == 0, replayed.stderr
    metrics = json.loads((tmp_path / "out" / "metrics.json").read_text())
    assert metrics["position"]["rmse_m"] < 0.05
    assert metrics["counts"]["rejected"] == {}


def test_a_seed_gives_the_same_file(tmp_path: Path):
    for name, seed in (("a", 7), ("b", 7), ("c", 8)):
        options = ("--duration", 5, "--seed", seed)
        result = pilotage(
            "simulate", "circle-four-poles", "-o", tmp_path / f"{name}.lcmlog", *options
        )
        assert result.returncode == 0, result.stderr
    a, b, c = ((tmp_path / f"{name}.lcmlog").read_bytes() for name in "abc")
    assert a == b
    assert a != c


@pytest.mark.parametrize(
    ("name", "arguments"),
    [("lab.yaml", ["-o", "lab.lcmlog"]), ("lab.yaml", ["--live", "--no-wait"]),
     ("lab.yml", ["-o", "lab.yml"])],
)  # fmt: skip
def test_the_scenario_itself_is_not_written_over(tmp_path: Path, name: str, arguments: list[str]):
    scenario = "site: yard\ndrive: rounds\nduration_s: 2\nsensors: {eye: {}}\n"
    (tmp_path / name).write_text(scenario)
    result = pilotage("simulate", f"../{tmp_path.name}/{name}", *arguments, cwd=tmp_path)
    assert result.returncode == 2
    assert f"{name} would be written, and is the scenario itself: " in result.stderr
    assert [file.name for file in tmp_path.iterdir()] == [name]
    assert (tmp_path / name).read_text() == scenario


def test_a_fault_is_in_the_log(tmp_path: Path):
    log = tmp_path / "yard.lcmlog"
    simulated = pilotage("simulate", "yard", "-o", log, "--fault", "gyro NaN")
    assert simulated.returncode == 0, simulated.stderr
    rates = [gyro_t.decode(data).rate for data in Recording.load(str(log)).messages("GYRO")]
    assert sum(map(isnan, rates)) == 1500


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["square", "-o", "x.lcmlog"], ["square", "mower-spiral", "figure-eight"]),
        (["figure-eight"], ["-o", "--live"]),
        (["figure-eight", "-o", "x.lcmlog", "--live"], ["-o", "--live"]),
        (["figure-eight", "-o", "x.yaml"], ["x.yaml", "another name"]),
        (["figure-eight", "-o", "missing/x.lcmlog"], ["missing/x.lcmlog", "No such file"]),
        (["figure-eight", "-o", "x.lcmlog", "--duration", "0"], ["duration_s is 0", "1 to"]),
        (["figure-eight", "-o", "x.lcmlog", "--noise", "-1"], ["--noise", "-1", "0 to"]),
        (["yard", "-o", "x.lcmlog", "--fault", "gyro dead"], ["gyro dead", "markers", "stuck"]),
        (["figure-eight", "-o", "x.lcmlog", "--slip", "1"], ["slip is 1", "0.9"]),
        (["figure-eight", "-o", "x.lcmlog", "--latency", "nan"], ["latency_s is nan"]),
        (["figure-eight", "-o", "x.lcmlog", "--gyro-bias", "inf"], ["bias_rad_s is inf"]),
    ],
)
def test_what_cannot_be_simulated_is_named(tmp_path: Path, arguments, words):
    result = pilotage("simulate", *arguments, cwd=tmp_path)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr
    assert list(tmp_path.iterdir()) == []


def test_what_cameras_see_is_drawn_into_a_folder(tmp_path: Path):
    folder = tmp_path / "mower"
    options = ("--cameras", "--duration", 3, "-o", folder)
    drawn = pilotage("simulate", "mower-cameras", *options)
    assert drawn.returncode == 0, drawn.stderr
    assert f"{folder / 'front'}: 2 pictures, " in drawn.stdout
    assert len([*folder.glob("*/*.png")]) == 3
    replayed = pilotage("replay", folder / "ideal.lcmlog", "--config", folder / "robot.yaml")
    assert replayed.returncode == 0, replayed.stderr
    again = pilotage("simulate", "mower-cameras", *options)
    assert again.returncode == 2
    assert "front is not empty: name another folder" in again.stderr


@pytest.mark.parametrize("options", [[], ["-o", "x", "--live"], ["-o", "x", "--run", "1"]])
def test_pictures_are_drawn_into_a_folder_and_nowhere_else(options: list[str]):
    result = pilotage("simulate", "poles", "--cameras", *options)
    assert result.returncode == 2
    assert "--cameras draws into the folder of -o, without --live" in result.stderr
