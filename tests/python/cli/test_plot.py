"""`pilotage plot`: figures of a replay's folder, or of a recording."""

from pathlib import Path

import pytest

from support.command import pilotage

FIGURES = {"path.png", "closeup.png", "markers.png", "errors.png", "nis.png"}


@pytest.fixture(scope="module")
def replayed(tmp_path_factory) -> Path:
    """The folder of a short replay with figures, beside the log and its configuration."""
    place = tmp_path_factory.mktemp("plot")
    log, config = place / "run.lcmlog", place / "run.yaml"
    for command in (
        ("simulate", "figure-eight", "-o", log, "--duration", 20),
        ("replay", log, "--config", config, "-o", place / "out"),
    ):
        result = pilotage(*command)
        assert result.returncode == 0, result.stderr
    return place / "out"


def _pictures(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.glob("*.png")}


def test_a_folder_is_drawn_as_the_replay_drew_it(replayed: Path, tmp_path: Path):
    result = pilotage("plot", replayed, "-o", tmp_path)
    assert result.returncode == 0, result.stderr
    assert set(result.stdout.split()) == {str(tmp_path / name) for name in FIGURES}
    assert _pictures(tmp_path) == _pictures(replayed)


def test_a_recording_is_replayed_first(replayed: Path, tmp_path: Path):
    log, config = replayed.parent / "run.lcmlog", replayed.parent / "run.yaml"
    result = pilotage("plot", log, "--config", config, "-o", tmp_path)
    assert result.returncode == 0, result.stderr
    assert _pictures(tmp_path) == _pictures(replayed)


def test_a_window_changes_the_close_up_alone(replayed: Path, tmp_path: Path):
    result = pilotage("plot", replayed, "-o", tmp_path, "--window", 5, 10)
    assert result.returncode == 0, result.stderr
    before, after = _pictures(replayed), _pictures(tmp_path)
    assert {name for name in FIGURES if before[name] != after[name]} == {"closeup.png"}


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nowhere"], ["nowhere", "no such file"]),
        (["run.lcmlog"], ["run.lcmlog", "-o"]),
        (["out", "-o", "figures", "--window", "50", "60"], ["50 s", "60 s", "lasts 20 s"]),
    ],
)
def test_what_cannot_be_drawn_is_named(replayed: Path, arguments, words):
    result = pilotage("plot", *arguments, cwd=replayed.parent)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr
