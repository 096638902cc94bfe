"""The screen of `pilotage status`, of messages made by hand."""

import io
import os
import time
from types import SimpleNamespace

import pytest
from rich.console import Console

from pilotage.cli.status_screen import duration, screen
from support.health import NAN, input_status, pose, status

BUSY = input_status(
    "front", "MARKERS", {"late": 3, "unknown_marker": 3300, "gate": 15},
    problem="no frame for 12.3 s", rate_hz=9.83, age_s=12.3, received=123456, fused=120138,
    pending=4, lost=17, repeated=2, clock_offset_us=1250, clock_skew_ppm=-12.3, clock_steps=1,
    noise_scale=1.7,
)  # fmt: skip
FULL = status(
    BUSY, input_status("gyro", "GYRO"), state=3, reason="no sighting for 12.3 s",
    utime=1_000_312_000_000, since=1_000_000_000_000, motion="slipping", resets=3, reset_seq=2,
    reset_answer="implausible", checkpoint_age_s=0.8, drops=12,
)  # fmt: skip
POSE = pose(x=12.402, y=-3.05, heading=1.52, v=0.51, omega=0.04)


@pytest.fixture(autouse=True)
def _utc(monkeypatch):
    monkeypatch.setitem(os.environ, "TZ", "UTC")
    time.tzset()


def _shown(status=FULL, pose=POSE, notes=(), stale: bool = False) -> list[str]:
    health = SimpleNamespace(
        url="udpm://here",
        status=SimpleNamespace(message=status),
        pose=SimpleNamespace(message=pose),
        notes=lambda: list(notes),
        stale=lambda: stale,
    )
    console = Console(width=80, record=True, file=io.StringIO())
    console.print(screen(health))
    return [line.rstrip() for line in console.export_text().splitlines()]


def test_it_shows_every_field_in_80_columns():
    assert _shown() == [
        "pilotage-node 0.1.0 on udpm://here",
        "DEAD_RECKONING since 13:46:40 (5.2 min)",
        "no sighting for 12.3 s",
        "front: no frame for 12.3 s",
        "",
        "motion      slipping; +0.51 m/s, +2.3 °/s",
        "position    x +12.402 m, y -3.050 m; 95 % radius 0.490 m",
        "heading     +87.09°; σ 1.00°",
        "resets      3; pose_reset_t 2: implausible",
        "checkpoint  800.0 ms old",
        "dropped     12 datagrams by the kernel",
        "",
        "input      rate  received    fused  rejected              clock offset",
        "channel     age      lost  pending  by reason                     skew",
        "front    9.8 Hz   123,456  120,138  3,300 unknown_marker       +1.2 ms",
        "MARKERS  12.3 s        17        4  15 gate                    -12 ppm",
        "                                    3 late                  stepped 1×",
        "                                    2 repeated",
        "                                    σ × 1.70",
        "gyro          —         0        0  —                                —",
        "GYRO          —         0        0",
    ]


def test_what_is_not_known_is_a_dash():
    lines = _shown(status(version=""), pose=None)
    assert lines[0] == "pilotage-node — on udpm://here"
    for name in ("motion", "position", "heading", "checkpoint"):
        assert f"{name:<10}  —" in lines


def test_an_unknown_covariance_is_a_dash():
    lines = _shown(pose=pose(covariance=[NAN] * 9))
    assert any(line.endswith("95 % radius —") for line in lines)
    assert any(line.endswith("σ —") for line in lines)


def test_a_node_that_waits_says_for_what():
    lines = _shown(status(reason="encoders_t on ENCODERS"))
    assert lines[1].startswith("WAITING since")
    assert lines[2] == "for encoders_t on ENCODERS"


def test_the_ok_of_a_node_that_may_be_gone_is_not_shown_as_its_state():
    shown = _shown(status(state=2, utime=1_000_000_000_000), stale=True, notes=["no status_t"])
    assert shown[1:3] == ["no status_t", "last heard at 13:46:40: OK"]


@pytest.mark.parametrize("extreme", [-(2**63), 2**63 - 1])
def test_any_time_can_be_shown(extreme: int):
    entry = input_status("gyro", "GYRO", age_s=0.0, clock_offset_us=extreme, clock_steps=extreme)
    assert _shown(status(entry, state=2, since=extreme, utime=-extreme, drops=extreme))


def test_before_a_status_there_are_notes_only():
    assert _shown(status=None, pose=None, notes=["nobody there"]) == [
        "pilotage-node on udpm://here",
        "nobody there",
    ]


def test_brackets_in_a_name_are_no_markup():
    shown = "\n".join(_shown(status(input_status("[red]", "A[1]", problem="[b]silent"))))
    for words in ("[red]", "A[1]", "[red]: [b]silent"):
        assert words in shown


@pytest.mark.parametrize(
    ("seconds", "text"),
    [
        (0.0, "0.0 ms"), (0.0123, "12.3 ms"), (59.94, "59.9 s"), (90, "1.5 min"),
        (5400, "1.5 h"), (1.7e9, "19675.9 d"), (-2.0, "-2.0 s"), (NAN, "—"),
    ],
)  # fmt: skip
def test_a_time_has_the_unit_that_suits_it(seconds: float, text: str):
    assert duration(seconds) == text
