"""Damaged files of every format give a log or an error that names the file, nothing else."""

import warnings
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pilotage.logs import read, write_lcmlog
from support import made_logs

Damage = Callable[[bytes], bytes]

PLACE = st.floats(0, 1, exclude_max=True)
WORDS = [
    b"nan",
    b"inf",
    b"-inf",
    b"1e999",
    b"1e300",
    b"-1e15",
    b"-1",
    b"0",
    b"0.5",
    b"x",
    b"",
    b"#",
]
NUMBERS = [b"2147483647", b"2147483648", b"-2147483649", b"9223372036854775807", b"1e-320"]


def _lcmlog(path: Path) -> Path:
    with TemporaryDirectory() as folder:
        write_lcmlog(read(made_logs.woods(Path(folder) / "a.mat")), path)
    return path


MAKE = {
    "mower": made_logs.mower,
    "mrclam": made_logs.mrclam,
    "woods": lambda folder: made_logs.woods(folder / "a.mat"),
    "plaza": lambda folder: made_logs.plaza(folder / "a.mat"),
    "lcm": lambda folder: _lcmlog(folder / "a.lcmlog"),
}


@st.composite
def overwritten(draw: st.DrawFn) -> Damage:
    place, new = draw(PLACE), draw(st.binary(min_size=1, max_size=8))

    def damage(content: bytes) -> bytes:
        at = int(place * len(content))
        return content[:at] + new[: len(content) - at] + content[at + len(new) :]

    return damage


@st.composite
def cut(draw: st.DrawFn) -> Damage:
    place = draw(PLACE)
    return lambda content: content[: int(place * len(content))]


@st.composite
def line_lost_or_doubled(draw: st.DrawFn) -> Damage:
    place, times = draw(PLACE), draw(st.sampled_from([0, 2]))

    def damage(content: bytes) -> bytes:
        lines = content.splitlines(keepends=True)
        at = int(place * len(lines))
        return b"".join(lines[:at] + lines[at : at + 1] * times + lines[at + 1 :])

    return damage


@st.composite
def field_garbled(draw: st.DrawFn) -> Damage:
    place, word = draw(PLACE), draw(st.sampled_from(WORDS + NUMBERS))

    def damage(content: bytes) -> bytes:
        lines = [line.split(b" ") for line in content.split(b"\n")]
        places = [(i, j) for i, line in enumerate(lines) for j in range(len(line))]
        i, j = places[int(place * len(places))]
        lines[i][j] = word
        return b"\n".join(b" ".join(line) for line in lines)

    return damage


DAMAGES = st.lists(
    overwritten() | cut() | line_lost_or_doubled() | field_garbled(), min_size=1, max_size=3
)


@pytest.mark.parametrize("kind", MAKE)
@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(which=PLACE, damages=DAMAGES)
def test_a_damaged_file_gives_a_log_or_names_itself(
    kind: str, which: float, damages: list[Damage]
) -> None:
    with TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("error")  # of numpy's, that a number made no sense
        path = MAKE[kind](Path(folder))
        files = [path] if path.is_file() else sorted(path.iterdir())
        file = files[int(which * len(files))]
        content = file.read_bytes()
        for damage in damages:
            content = damage(content)
        file.write_bytes(content)
        _require_sound(path)


def _require_sound(path: Path) -> None:
    try:
        log = read(path)
    except ValueError as error:
        if str(path) not in str(error):
            raise
        return
    stamps = [log.recording[i][0] for i in range(len(log.recording))]
    if log.kind != "lcm":  # whose order is that of its file
        assert stamps == sorted(stamps)
    if log.truth is not None:
        assert all(np.isfinite(log.truth[name]).all() for name in ("x", "y"))
        assert np.all(np.abs(log.truth["heading"]) <= np.pi)
    if log.map is not None:
        assert np.isfinite(log.map.positions).all()
        assert len(set(log.map.ids.tolist())) == len(log.map) > 0
