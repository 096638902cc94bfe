"""An hour of faults that come and go: each is named at once, and the journal stays readable."""

import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import pytest

from support.bench import Bench
from support.driving import CONFIG, Robot

SECOND = 1_000_000
NAMED_WITHIN_S = 2
LINES_AN_HOUR = 4 * (6 + 60) + 2 * (1 + 60)
"""One a minute of encoders, gyro, camera, the state, wrong types and foreign sensors, and a few
more at the beginning. The faults below are three times as many, and their messages thousands."""

Sent = list[tuple[str, Any]]


def _silent(channel: str) -> Callable[[Sent], Sent]:
    return lambda sent: [(name, message) for name, message in sent if name != channel]


def _changed(channel: str, change: Callable[[Any], None]) -> Callable[[Sent], Sent]:
    def strike(sent: Sent) -> Sent:
        for name, message in sent:
            if name == channel:
                change(message)
        return sent

    return strike


def _ahead(message: Any) -> None:
    message.utime += 3 * SECOND


def _not_a_number(message: Any) -> None:
    message.rate = float("nan")


def _nowhere(message: Any) -> None:
    message.sightings[0].id = 99


def _renamed(message: Any) -> None:
    message.sensor = "lidar"


def _mistyped(sent: Sent) -> Sent:
    """The gyro's driver sends what the encoders should."""
    gyro = next(message for name, message in sent if name == "GYRO")
    return [(name, gyro if name == "ENCODERS" else message) for name, message in sent]


@dataclass(frozen=True)
class Fault:
    """What is done to the messages, and what the status says of which input."""

    strike: Callable[[Sent], Sent]
    input: str
    words: str


FAULTS = (
    Fault(_silent("ENCODERS"), "encoders", "silent for"),
    Fault(_silent("GYRO"), "gyro", "silent for"),
    Fault(_silent("MARKERS"), "camera", "silent for"),
    Fault(_changed("GYRO", _not_a_number), "gyro", "rejected: bad_value"),
    Fault(_changed("GYRO", _ahead), "gyro", "by 3.000 s"),
    Fault(_changed("ENCODERS", _ahead), "encoders", "by 3.000 s"),
    Fault(_changed("MARKERS", _ahead), "camera", "by 3.000 s"),
    Fault(_changed("MARKERS", _nowhere), "camera", "rejected: unknown_marker"),
    Fault(_changed("MARKERS", _renamed), "camera", "rejected: unknown_sensor"),
    Fault(_mistyped, "encoders", "rejected: wrong_type"),
)


class Hour:
    """Drives, with faults between quiet times."""

    def __init__(self) -> None:
        self.bench = Bench(CONFIG)
        self.robot = Robot(period_us=50_000)

    def drive(self, seconds: float, strike: Callable[[Sent], Sent] = lambda sent: sent) -> None:
        end = self.robot.utime + round(seconds * SECOND)
        while (now := self.robot.utime) < end:
            self.bench.pass_time(now)
            for channel, message in strike(list(self.robot.messages(self.robot.step % 4 == 0))):
                self.bench.send(channel, message, now)

    def problems(self, name: str, since: int) -> list[str]:
        """What was wrong with an input by each status since then."""
        told = [status for status in self.bench.messages["STATUS"] if status.utime > since]
        return [i.problem for status in told for i in status.inputs if i.name == name]

    def meets(self, fault: Fault, seconds: float) -> None:
        """A fault, named in time."""
        begun = self.robot.utime
        self.drive(NAMED_WITHIN_S, fault.strike)
        assert any(fault.words in problem for problem in self.problems(fault.input, begun))
        assert fault.input + ": " in self.bench.status.reason
        self.drive(seconds - NAMED_WITHIN_S, fault.strike)


@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: f"{fault.input} {fault.words}")
def test_a_fault_is_named_within_two_seconds_in_the_status_and_in_the_journal(fault: Fault):
    hour = Hour()
    hour.drive(20)
    assert [line for _, line in hour.bench.said] == ["state OK"]
    begun = hour.robot.utime
    hour.meets(fault, 3)
    hour.drive(30)
    named = [at for at, line in hour.bench.said if line.startswith(fault.input + " (")]
    assert named
    assert 0 < named[0] - begun <= NAMED_WITHIN_S * SECOND
    assert set(hour.problems(fault.input, hour.robot.utime - 3 * SECOND)) == {""}
    again = [line for _, line in hour.bench.said if "well again; it was: " in line]
    assert any(fault.words in line for line in again)


@pytest.mark.parametrize(("channel", "name"), [("GYRO", "gyro"), ("MARKERS", "camera")])
def test_an_input_whose_clock_was_set_and_no_other_stays_named(channel: str, name: str):
    """Its stamps are believed again, but the motion does not reach them."""
    hour = Hour()
    hour.drive(20)
    hour.drive(30, _changed(channel, _ahead))
    assert set(hour.problems(name, hour.robot.utime - 20 * SECOND)) == {
        "its samples are dated 3.0 s ahead of the motion's: are the clocks in step?"
    }
    assert sum(line.startswith(name + " (") for _, line in hour.bench.said) == 1


def test_an_hour_of_faults_leaves_a_short_journal():
    rng, hour = random.Random(1), Hour()
    hour.drive(20)
    begun = hour.robot.utime
    faults = 0
    while hour.robot.utime - begun < 3600 * SECOND:
        hour.meets(rng.choice(FAULTS), rng.uniform(2.0, 10.0))
        hour.drive(rng.uniform(4.0, 15.0))
        faults += 1
    assert faults > 200
    assert len(hour.bench.said) <= LINES_AN_HOUR
    # Where there was no room for a fault's line, that of its end tells what it was.
    assert not any(line.endswith("well again") for _, line in hour.bench.said)
