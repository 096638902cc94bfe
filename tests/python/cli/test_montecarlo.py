"""`pilotage montecarlo`, with few runs."""

import json
from pathlib import Path

import numpy as np
import pytest

from pilotage import Recording, load_config, replay
from pilotage.evaluate import pose_errors
from pilotage.montecarlo import find_scenario, run_montecarlo
from support.command import pilotage

SITE = """\
site: yard
drive: {name: circle, radius_m: 2, speed_m_s: 0.8}
duration_s: 8
sensors: {scanner: {components: [bearing, range], reach_m: 8, rate_hz: 10}}
"""


def test_a_file_gives_a_table_a_file_and_a_figure(tmp_path: Path):
    (tmp_path / "site.yaml").write_text(SITE)
    result = pilotage(
        "montecarlo", "site.yaml", "--runs", 4, "--jobs", 1, "-o", "out", cwd=tmp_path
    )
    assert result.returncode == 0, result.stderr
    for words in ("site.yaml, 4 runs", "position RMSE", "smallest possible", "NIS/dof, scanner"):
        assert words in result.stdout
    content = json.loads((tmp_path / "out" / "montecarlo.json").read_text())
    assert content["runs"] == 4
    assert len(content["over_time"]["position_bound_m"]) == 81
    assert (tmp_path / "out" / "montecarlo.png").read_bytes().startswith(b"\x89PNG")


def test_a_run_that_is_recorded_is_that_of_the_many(tmp_path: Path):
    changed = SITE + "encoders: {slip: 0.05}\ngyro: {bias_rad_s: 0.02}\nlatency_s: 0.1\n"
    (tmp_path / "site.yaml").write_text(changed)
    log, config = tmp_path / "run.lcmlog", tmp_path / "run.yaml"
    result = pilotage("simulate", "site.yaml", "--run", 2, "-o", log, cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    recording = Recording.load(str(log))
    poses = replay(load_config(str(config)), recording).poses
    distance = pose_errors(poses, recording.reference()).distance
    many = run_montecarlo(find_scenario(str(tmp_path / "site.yaml")), 3)
    np.testing.assert_allclose(distance[::10], many.trials.distance[2], atol=1e-12)


def test_a_run_of_a_file_is_recorded_to_be_looked_at(tmp_path: Path):
    (tmp_path / "site.yaml").write_text(SITE)
    logs = []
    for name, run in (("a", 3), ("b", 3), ("c", 4)):
        log = tmp_path / f"{name}.lcmlog"
        result = pilotage("simulate", "site.yaml", "--run", run, "-o", log, cwd=tmp_path)
        assert result.returncode == 0, result.stderr
        logs.append(log.read_bytes())
    assert logs[0] == logs[1] != logs[2]


def test_bars_are_a_table(tmp_path: Path):
    result = pilotage("montecarlo", "nominal", "--bars", "--runs", 2, "-o", tmp_path / "out")
    head, *lines, where = result.stdout.splitlines()
    assert head.split() == ["row", "measure", "measured", "bar"]
    assert lines[0].startswith("nominal")
    assert (tmp_path / "out" / "bars.json").is_file()
    assert "bars.json" in where
    missed = [line for line in lines if line.endswith("missed")]
    assert result.returncode == (1 if missed else 0), result.stderr


def test_a_missed_bar_is_the_exit_status():
    status = {}
    for row in ("nominal", "global-ids"):  # two runs are hardly within 6 %, and start right
        result = pilotage("montecarlo", row, "--bars", "--runs", 2, "--jobs", 1)
        status[result.returncode] = result.stdout
    assert "missed" in status[1]
    assert "missed" not in status[0]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["square"], ["no scenario 'square'", "yard", "nominal"]),
        ([], ["no scenario ''", "yard", "nominal"]),
        (["square", "--bars"], ["no row has 'square'", "nominal"]),
        (["yard", "--jobs", "0"], ["--jobs is 0"]),
        (["gate"], ["no scenario 'gate'"]),
        (["yard", "--runs", "100000", "-o", "a-file"], ["-o a-file", "another folder"]),
        (["--bars", "--runs", "100000", "-o", "a-file"], ["-o a-file", "another folder"]),
    ],
)
def test_what_cannot_be_run_is_named(tmp_path: Path, arguments, words):
    (tmp_path / "a-file").touch()
    result = pilotage("montecarlo", *arguments, cwd=tmp_path)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr
