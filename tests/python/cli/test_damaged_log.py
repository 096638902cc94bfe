"""Three bytes of a log overwritten: the rest is read, and the damage is counted and named."""

from collections import Counter
from itertools import accumulate
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pilotage import Recording, lcmtypes
from pilotage.cli.convert import convert
from pilotage.cli.replay import replay
from pilotage.replaying import SETUP_CHANNEL
from pilotage.simulate import SCENARIOS, simulate
from support.command import pilotage

HEADER = 28
Event = tuple[int, str, bytes]


def _events(recording: Recording) -> list[Event]:
    return [recording[i] for i in range(len(recording))]


@pytest.fixture(scope="module")
def drive(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a real small log and its configuration."""
    folder = tmp_path_factory.mktemp("drive")
    simulation = simulate(SCENARIOS["circle-four-poles"], np.random.default_rng(1))
    part = Recording()
    for event in _events(simulation.recording)[:150]:
        part.add(*event)
    part.save(str(folder / "run.lcmlog"))
    (folder / "run.yaml").write_text(simulation.config.to_yaml())
    return folder


def _with(drive: Path, at: int, new: bytes) -> Path:
    damaged = drive / "damaged.lcmlog"
    content = (drive / "run.lcmlog").read_bytes()
    damaged.write_bytes(content[:at] + new + content[at + len(new) :])
    return damaged


@settings(max_examples=300, deadline=None)
@given(place=st.floats(0, 1), new=st.binary(min_size=3, max_size=3))
def test_everything_but_the_damaged_event_is_read(drive: Path, place: float, new: bytes) -> None:
    events = _events(Recording.load(str(drive / "run.lcmlog")))
    begins = [0, *accumulate(HEADER + len(channel) + len(data) for _, channel, data in events)]
    at = int(place * (begins[-1] - 3))
    damaged = Recording.load(str(_with(drive, at, new)))
    outside = [
        e for e, b, end in zip(events, begins, begins[1:], strict=False) if at + 3 <= b or at >= end
    ]
    assert not Counter(outside) - Counter(_events(damaged))
    assert len(damaged) <= len(events)
    first, after = max(b for b in begins if b <= at), min(b for b in begins if b >= at + 3)
    for line in damaged.damage:
        assert first <= int(line.split()[-1]) < after


@pytest.mark.parametrize("command", ["replay", "convert"])
def test_the_damage_is_counted_and_its_place_is_named(drive: Path, command: str) -> None:
    content = (drive / "run.lcmlog").read_bytes()
    at = content.index(b"\xed\xa1\xda\x01", len(content) // 2)
    damaged = _with(drive, at, b"xyz")
    options = ["--config", drive / "run.yaml"] if command == "replay" else ["-o", drive / "again"]
    result = pilotage(command, damaged, *options)
    assert result.returncode == 0, result.stderr
    assert f"note: {damaged}: damaged in 1 places, everything else was read" in result.stderr
    assert f"bytes skipped from byte {at}\n" in result.stderr
    assert result.stderr.count("note:") == 2


def test_of_very_many_damaged_places_the_first_are_named(
    drive: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    damaged = drive / "many.lcmlog"
    damaged.write_bytes(
        (drive / "run.lcmlog").read_bytes().replace(b"\xed\xa1\xda\x01", b"\xed\xa1\xda\x02")
    )
    with damaged.open("ab") as file:
        file.write(b"".join(b"\xed\xa1\xda\x01no event" for _ in range(100)))
    convert(damaged, drive / "again")
    said = capsys.readouterr().err
    assert "damaged in 100 places" in said
    assert "... and 80 more" in said
    assert said.count("note:") == 22


@pytest.mark.parametrize("at", [8, 60, 200])
def test_a_recorded_configuration_that_is_damaged_is_named(drive: Path, at: int) -> None:
    setup = lcmtypes.setup_t()
    setup.version, setup.config = "0.1.0", (drive / "run.yaml").read_text()
    data = bytearray(setup.encode())
    data[at : at + 3] = b"\xff\xff\xff"
    recording = Recording()
    recording.add(0, SETUP_CHANNEL, bytes(data))
    for event in _events(Recording.load(str(drive / "run.lcmlog"))):
        recording.add(*event)
    recording.save(str(drive / "recorded.lcmlog"))
    if at == 8:  # its time, which nothing is made of
        replay(drive / "recorded.lcmlog", figures=False)
        return
    with pytest.raises(ValueError, match=r"the recording opens with cannot be used.*--config"):
        replay(drive / "recorded.lcmlog", figures=False)
