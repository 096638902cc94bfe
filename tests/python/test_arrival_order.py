"""In whatever order samples arrive within the window, the result is that of their own order."""

from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from pilotage import Config, Recording, Run
from pilotage import replay as run_through
from pilotage.evaluate import wrap_angle
from pilotage.logs import read
from pilotage.replaying import prepared_config
from pilotage.simulate import SCENARIOS, simulate
from support.datasets import dataset

RECORDINGS = {
    "Lost in the Woods": ("lost-in-the-woods/dataset2.mat", None),
    "Plaza": ("plaza/Plaza1_.mat", None),
    "MRCLAM": ("mrclam/MRCLAM_Dataset6", 1),
    "mower": ("mower-listing", None),
}
CASES = {**dict.fromkeys(RECORDINGS, 170), "figure-eight": 160, "yard": 160}  # 1,000 together
SLACK_S = 0.3
"""Of the window no delay uses this much: a log has latencies of its own."""
MOTION = ("ENCODERS", "VELOCITY")

Event = tuple[int, str, bytes]


@dataclass(frozen=True)
class Material:
    """A long log to cut stretches from."""

    config: Config
    truth: NDArray[Any]
    events: list[Event]

    @cached_property
    def received(self) -> NDArray[np.int64]:
        return np.array([event[0] for event in self.events])

    def stretch(self, start: float, duration_s: float) -> tuple[Config, list[Event]]:
        """Cut at a part of the way; the configuration begins there with the true pose."""
        received = self.received
        room = received[-1] - received[0] - duration_s * 1e6
        begin = int(received[0] + start * room)
        first, last = np.searchsorted(received, [begin, begin + duration_s * 1e6])
        true = self.truth[np.searchsorted(self.truth["utime"], begin).clip(max=len(self.truth) - 1)]
        config = Config(self.config)
        for key, column in (("x_m", "x"), ("y_m", "y"), ("heading_rad", "heading")):
            config[f"initial.{key}"] = float(true[column])
        return config, self.events[first:last]


@cache
def _material(name: str) -> Material:
    if name in RECORDINGS:
        path, robot = RECORDINGS[name]
        folder, _, file = path.partition("/")
        log = read(dataset(folder) / file, robot=robot)
        config, recording, truth = prepared_config(log), log.recording, log.truth
        assert truth is not None
    else:
        scenario = replace(SCENARIOS[name], duration_s=60.0)
        simulation = simulate(scenario, np.random.default_rng(1))
        config, recording, truth = simulation.config, simulation.recording, simulation.truth
    events = [recording[i] for i in range(len(recording))]
    return Material(config, truth, [event for event in events if event[1] != "REFERENCE"])


def _delayed(events: list[Event], delay_s: NDArray[np.float64]) -> list[Event]:
    """The same events later; each input's first in time, so that its clock is known from then on.

    The newest motion comes last: only the arrival of newer motion publishes a pose.
    """
    received = np.array([event[0] for event in events])
    channels = [event[1] for event in events]
    arrival = received + np.rint(delay_s * 1e6).astype(np.int64)
    for channel in set(channels):
        first = channels.index(channel)
        arrival[first] = received[first]
    newest = max(i for i, channel in enumerate(channels) if channel in MOTION)
    arrival[newest] = arrival.max() + 1
    order = np.argsort(arrival, kind="stable")
    return [(int(arrival[i]), *events[i][1:]) for i in order]


def _in_order(config: Config, events: list[Event]) -> list[Event]:
    """The same events in the order of the moments that they speak of."""
    motion = config["motion.source"]
    names = ["gyro", motion, *(f"sensors.{sensor}" for sensor in config.sensors)]
    channels = [config[f"{name}.channel"] for name in names]
    latency_us = {
        channel: round(config[f"{name}.latency_s"] * 1e6)
        for name, channel in zip(names, channels, strict=True)
    }
    most_us = max(latency_us.values())
    arrived = [
        (int.from_bytes(data[8:16], "big", signed=True) + most_us - latency_us[name], name, data)
        for _, name, data in events
    ]
    return sorted(arrived, key=lambda event: (event[0], channels.index(event[1])))


def _run(config: Config, events: list[Event]) -> Run:
    recording = Recording()
    for event in events:
        recording.add(*event)
    return run_through(config, recording)


def _same(one: NDArray[Any], other: NDArray[Any], but: tuple[str, ...] = ()) -> None:
    """Rows are equal, numbers to 1e-9."""
    assert one.size == other.size
    for name in one.dtype.names or ():
        if name in but:
            continue
        if one.dtype[name].base.kind != "f":
            np.testing.assert_array_equal(one[name], other[name], name)
            continue
        difference = one[name] - other[name]
        if name == "heading":
            difference = wrap_angle(difference)
        assert np.array_equal(np.isnan(one[name]), np.isnan(other[name])), name
        assert np.nanmax(np.abs(difference), initial=0.0) <= 1e-9, name


def _in_their_order(reports: NDArray[Any]) -> NDArray[Any]:
    return np.sort(reports, order=["utime", "sensor", "frame_seq", "index"])


@pytest.mark.parametrize(("name", "cases"), CASES.items())
def test_any_order_of_arrival_gives_what_the_samples_own_order_gives(name: str, cases: int):
    material = _material(name)
    longest_s = material.config["history.window_s"] - SLACK_S
    seen = {"reports": 0, "disorder": 0}

    @settings(
        max_examples=cases, deadline=None, suppress_health_check=list(HealthCheck), database=None
    )
    @given(
        start=st.floats(0.0, 1.0),
        duration_s=st.floats(3.0, 10.0),
        longest_delay_s=st.sampled_from([0.05, 0.5, longest_s]),
        share=st.sampled_from([0.05, 0.3, 1.0]),
        late=st.sampled_from(["any", *sorted({channel for _, channel, _ in material.events})]),
        seed=st.integers(0, 2**32 - 1),
    )
    def holds(
        start: float, duration_s: float, longest_delay_s: float, share: float, late: str, seed: int
    ) -> None:
        config, events = material.stretch(start, duration_s)
        rng = np.random.default_rng(seed)
        delay_s = rng.uniform(0.0, longest_delay_s, len(events))
        delay_s *= rng.random(len(events)) < share
        if late != "any":
            delay_s *= [channel == late for _, channel, _ in events]
        shuffled = _delayed(events, delay_s)
        expected, got = _run(config, _in_order(config, events)), _run(config, shuffled)
        assert all(row["counts"].get("late", 0) == 0 for row in got.inputs)
        assert all(row["counts"].get("clock", 0) == 0 for row in got.inputs)
        _same(got.poses[-1:], expected.poses[-1:], but=("resets",))
        _same(_in_their_order(got.reports), _in_their_order(expected.reports), but=("revision",))
        seen["reports"] += got.reports.size
        seen["disorder"] += [e[2] for e in shuffled] != [e[2] for e in events]

    holds()
    assert seen["reports"] > cases / 2
    assert seen["disorder"] > cases / 3
