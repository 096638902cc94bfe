"""`pilotage convert`: replaying what it wrote gives what replaying the original gives."""

from pathlib import Path

import pytest

from support.command import pilotage
from support.datasets import dataset


def _poses(folder: Path, *arguments: object) -> bytes:
    result = pilotage("replay", *arguments, "--no-figures", "-o", folder)
    assert result.returncode == 0, result.stderr
    return (folder / "pose.csv").read_bytes()


@pytest.mark.parametrize(
    ("name", "options"),
    [("plaza", ()), ("lost-in-the-woods", ()), ("mrclam/MRCLAM_Dataset6", ("--robot", 2))],
)
def test_a_converted_recording_replays_as_the_original(tmp_path: Path, name: str, options):
    original, log = dataset(name), tmp_path / "run.lcmlog"
    result = pilotage("convert", original, "-o", log, *options)
    assert result.returncode == 0, result.stderr
    again = _poses(tmp_path / "again", log, "--config", tmp_path / "run.yaml")
    assert again == _poses(tmp_path / "first", original, *options)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nowhere", "-o", "x.lcmlog"], ["nowhere", "no such file"]),
        (["empty", "-o", "x.lcmlog"], ["empty", "not a recording", "poselog"]),
        (["empty", "-o", "x.yaml"], ["x.yaml", "another name"]),
    ],
)
def test_what_cannot_be_converted_is_named(tmp_path: Path, arguments, words):
    (tmp_path / "empty").mkdir()
    result = pilotage("convert", *arguments, cwd=tmp_path)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr
