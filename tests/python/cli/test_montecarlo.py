"""`pilotage montecarlo`, with few runs."""

import json
from pathlib import Path

import pytest

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
    assert result.returncode == 0, result.stderr
    head, *lines = result.stdout.splitlines()
    assert head.split() == ["row", "measure", "measured", "bar"]
    assert lines[0].startswith("nominal")
    assert (tmp_path / "out" / "bars.json").is_file()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["square"], ["no scenario 'square'", "yard", "nominal"]),
        ([], ["no scenario ''", "yard", "nominal"]),
        (["square", "--bars"], ["no row has 'square'", "nominal"]),
        (["yard", "--jobs", "0"], ["--jobs is 0"]),
        (["gate"], ["no scenario 'gate'"]),
    ],
)
def test_what_cannot_be_run_is_named(tmp_path: Path, arguments, words):
    result = pilotage("montecarlo", *arguments, cwd=tmp_path)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr
