"""A live run, and the replay of what was recorded of it, give the same bytes."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pilotage
from pilotage.evaluate import wrap_angle
from pilotage.lcmtypes import pose_t
from pilotage.live import URL, play, send
from pilotage.simulate import SCENARIOS, Simulation, simulate
from support.bus import Node, node

LOGGER = Path(sys.executable).parent / "lcm-logger"
INPUTS = ("encoders", "gyro", "sensors.scanner")
SPEED = 10.0
EVENT_BYTES = 28  # of a log, besides channel and data
AHEAD_BYTES = 2000  # fewer than 30 messages


def _simulated(duration_s: float = 20.0, noise: float = 1.0, policy: str = "utime") -> Simulation:
    """A drive with frames that arrive late; without noise the ticks' quantisation remains."""
    scenario = replace(SCENARIOS["figure-eight"], duration_s=duration_s, latency_s=0.08)
    tick = scenario.encoders.m_per_tick
    scenario = scenario.with_noise(noise)
    scenario = replace(scenario, encoders=replace(scenario.encoders, m_per_tick=tick))
    simulation = simulate(scenario, np.random.default_rng(3))
    simulation.config["encoders.max_speed_m_s"] = 10 * SPEED
    for name in INPUTS:
        simulation.config[f"{name}.time"] = policy
    return simulation


@contextmanager
def _lcm_logger(log: Path) -> Iterator[None]:
    """lcm-logger, which is a script around the program: both are ended, as one group."""
    command = [str(LOGGER), "--quiet", "--flush-interval=1", f"--lcm-url={URL}", str(log)]
    process = subprocess.Popen(command, start_new_session=True)
    try:
        yield
    finally:
        os.killpg(process.pid, signal.SIGINT)
        process.wait(timeout=10)


def _raw(running: Node, *channels: str) -> dict[str, list[bytes]]:
    """Lists that fill with the messages of channels, as they stand on the bus."""
    messages: dict[str, list[bytes]] = {channel: [] for channel in channels}
    for channel in channels:
        running.bus.subscribe(
            channel, lambda name, data: messages[name].append(data)
        ).set_queue_capacity(0)
    return messages


def _send_as_logged(recording: pilotage.Recording, running: Node, log: Path) -> None:
    """Send no more at once than lcm-logger's queue holds, which is 30 messages."""
    on_the_bus = 0

    def count(channel: str, data: bytes) -> None:
        nonlocal on_the_bus
        on_the_bus += EVENT_BYTES + len(channel) + len(data)

    running.bus.subscribe(".*", count).set_queue_capacity(0)
    for i in range(len(recording)):
        _, channel, data = recording[i]
        running.send(channel, data)
        running.wait(lambda: log.stat().st_size >= on_the_bus - AHEAD_BYTES, "lcm-logger")


def _end(running: Node) -> None:
    running.process.terminate()
    assert running.process.wait(timeout=10) == 0
    while running.bus.handle_timeout(50):
        pass


def _replayed(simulation: Simulation, log: Path) -> pilotage.Recording:
    run = pilotage.replay(simulation.config, str(log), keep_messages=True)
    assert run.damage == []
    return run.published


def test_what_lcm_logger_recorded_beside_the_node_gives_its_poses(tmp_path: Path):
    simulation = _simulated(duration_s=5.0)
    log = tmp_path / "logger.lcmlog"
    with _lcm_logger(log), node(tmp_path, simulation.config.to_yaml()) as running:
        live = _raw(running, "POSE")
        running.wait(lambda: log.exists() and log.stat().st_size > 0, "lcm-logger")
        _send_as_logged(simulation.recording, running, log)
        running.wait(lambda: len(live["POSE"]) == 501, "poses")
    assert _replayed(simulation, log).messages("POSE") == live["POSE"]


@pytest.mark.parametrize("policy", ["utime", "receive", "mapped"])
def test_the_nodes_own_record_gives_all_that_it_published(tmp_path: Path, policy: str):
    simulation = _simulated(policy=policy)
    log = tmp_path / "node.lcmlog"
    with node(tmp_path, simulation.config.to_yaml(), "--record", str(log)) as running:
        live = _raw(running, "POSE", "MARKER_REPORT", "STATUS")
        running.wait(lambda: live["STATUS"], "a status")
        play(simulation.recording, SPEED, url=URL)
        running.wait(lambda: len(live["POSE"]) > 1900, "poses")
        _end(running)
    assert len(live["MARKER_REPORT"]) > 1000
    replayed = _replayed(simulation, log)
    recorded = pilotage.Recording.load(str(log))
    for channel, messages in live.items():
        again = replayed.messages(channel)
        # The node may tick before we listen, and only a replay knows that no more motion will come.
        first, end = again.index(messages[0]), len(recorded.messages(channel))
        assert again[:end] == recorded.messages(channel)
        assert again[first:end] == messages
        assert channel == "MARKER_REPORT" or end == len(again)


def test_an_exact_drive_is_followed_over_lcm_to_two_ticks(tmp_path: Path):
    simulation = _simulated(noise=0.0)
    with node(tmp_path, simulation.config.to_yaml()):
        poses = [pose_t.decode(data) for data in send(simulation.recording, simulation.config)]
    truth = simulation.truth
    assert [p.utime for p in poses] == truth["utime"].tolist()
    two_ticks = 2 * simulation.config["encoders.left_m_per_tick"]
    distance = np.hypot([p.x for p in poses] - truth["x"], [p.y for p in poses] - truth["y"])
    turn = np.abs(wrap_angle([p.heading for p in poses] - truth["heading"]))
    assert distance.max() <= two_ticks
    assert turn.max() <= two_ticks / simulation.config["encoders.track_width_m"]
