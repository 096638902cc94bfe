"""What a node says of its health, heard from a bus that is not there."""

import json
import re

import pytest

from pilotage import Config, health
from pilotage.lcmtypes import gyro_t
from support.health import NAN, input_status, pose, status


class Bus:
    """Delivers at once what is said; takes patterns, as LCM does."""

    def __init__(self):
        self.listeners = []

    def subscribe(self, pattern, listener):
        self.listeners.append((re.compile(pattern), listener))

    def say(self, channel, data):
        for pattern, listener in self.listeners:
            if pattern.fullmatch(channel):
                listener(channel, data)


@pytest.fixture
def bus(monkeypatch) -> Bus:
    bus = Bus()
    monkeypatch.setattr(health, "connect", lambda _: bus)
    return bus


@pytest.fixture
def clock(monkeypatch):
    now = [100.0]
    monkeypatch.setattr(health, "monotonic", lambda: now[0])
    return now


def test_before_a_word_it_says_what_it_waits_for_and_then_what_is_missing(bus, clock):
    heard = health.Health("memq://", Config())
    assert heard.notes() == ["waiting for status_t on STATUS"]
    clock[0] += 4
    assert heard.notes() == [
        "no status_t on STATUS for 4.0 s; is pilotage-node running on this URL?"
    ]
    assert heard.as_dict() == {"url": "memq://", "status": None, "pose": None}


def test_a_node_that_falls_silent_is_named_and_its_last_words_stay(bus, clock):
    heard = health.Health("memq://", Config())
    bus.say("STATUS", status(state=2).encode())
    bus.say("POSE", pose(x=1.5).encode())
    assert heard.notes() == []
    clock[0] += 3
    assert "no status_t on STATUS for 3.0 s" in heard.notes()[0]
    assert heard.pose.message.x == 1.5


def test_a_pose_that_stays_away_is_named_unless_the_node_waits(bus, clock):
    heard = health.Health("memq://", Config())
    for state, notes in (
        (0, []),
        (2, ["no pose_t on POSE for 5.0 s; it answers every motion sample"]),
    ):
        clock[0] += 5 if state == 0 else 0
        bus.say("STATUS", status(state=state).encode())
        assert heard.notes() == notes


@pytest.mark.parametrize(
    "data", [b"", b"hello", gyro_t().encode(), status(version="a").encode()[:-5]]
)
def test_what_is_no_status_is_counted_and_named(bus, data):
    heard = health.Health("memq://", Config())
    bus.say("STATUS", data)
    assert not heard.status.heard()
    assert "messages on STATUS that are no status_t: 1;" in heard.notes()[-1]
    bus.say("STATUS", status().encode())
    bus.say("STATUS", data)
    assert heard.status.heard()
    assert "messages on STATUS that are no status_t: 2;" in heard.notes()[-1]


def test_channels_are_as_configured_and_no_patterns(bus):
    config = Config()
    config["output.status"] = "R.2"
    heard = health.Health(None, config)
    bus.say("RX2", status().encode())
    assert not heard.status.heard()
    bus.say("R.2", status().encode())
    assert heard.status.heard()


def test_as_json_every_field_has_its_name_and_nan_is_null(bus):
    heard = health.Health("memq://", Config())
    sent = status(input_status("gyro", "GYRO", {"late": 3}, received=3), state=5, drops=7)
    bus.say("STATUS", sent.encode())
    bus.say("POSE", pose(heading=0.5).encode())
    read = json.loads(json.dumps(heard.as_dict(), allow_nan=False))
    assert set(read["status"]) == set(sent.__slots__)
    assert set(read["status"]["inputs"][0]) == set(sent.inputs[0].__slots__)
    assert read["status"]["state"] == "LOST"
    assert read["status"]["drops"] == 7
    assert read["status"]["checkpoint_age_s"] is None
    assert read["status"]["inputs"][0]["rejected"] == [{"reason": "late", "count": 3}]
    assert read["pose"]["heading"] == 0.5
    assert read["radius_95_m"] == pytest.approx(2.4477 * 0.2, rel=1e-4)
    assert read["sigma_heading_rad"] == pytest.approx(0.0174533, rel=1e-5)


def test_an_unknown_covariance_has_no_radius(bus):
    unknown = pose(covariance=[NAN] * 9)
    assert health.plain(health.radius_95_m(unknown)) is None
    assert health.plain(health.sigma_heading_rad(unknown)) is None


def test_a_state_of_a_newer_node_has_its_number():
    assert health.state_name(2) == "OK"
    assert health.state_name(9) == "state 9"
