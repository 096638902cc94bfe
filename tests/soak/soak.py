"""Two hours of a robot's traffic in a few minutes, through a real node with others on the bus.

1.5 million messages: encoders and gyro at 100 Hz, frames at 10 Hz, 30 times as fast, beside
lcm-logger and a subscriber to everything. Passes if the node counts every message that was sent, as
received or as lost, and if its memory stays as it is after the first tenth.

Example: make soak, or PYTHONPATH=tests/python python tests/soak/soak.py --hours 0.1
"""

import argparse
import multiprocessing
import sys
from collections import Counter
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path
from resource import getpagesize
from tempfile import TemporaryDirectory
from time import monotonic, sleep

import lcm
import numpy as np

from pilotage import multicast
from pilotage.lcmtypes import encoders_t, gyro_t, marker_frame_t, status_t
from pilotage.live import URL, running_node
from pilotage.simulate import SCENARIOS, Simulation, simulate
from support.logger import lcm_logger

SPEED = 30
WARM_UP = 0.1
"""Of the traffic: by then every buffer has been as full as it gets."""
MAY_GROW_BYTES = 1_000_000
SENT = {"ENCODERS": encoders_t, "GYRO": gyro_t, "MARKERS": marker_frame_t}


def simulated(hours: float) -> Simulation:
    scenario = replace(SCENARIOS["figure-eight"], duration_s=3600 * hours)
    simulation = simulate(scenario, np.random.default_rng(1))
    simulation.config["encoders.max_speed_m_s"] *= SPEED
    simulation.config["history.window_s"] /= SPEED
    return simulation


def hurried(message, start: int):
    """The message of a robot that lives faster: its clock has to go as ours does."""
    message.utime = start + (message.utime - start) // SPEED
    if isinstance(message, gyro_t):
        message.rate *= SPEED
    return message


def send(simulation: Simulation, at_warm_up) -> Counter[str]:
    """Samples sent, by channel; a sighting is a sample."""
    bus, sent = lcm.LCM(URL), Counter()
    recording = simulation.recording
    start, began, warm_up = recording[0][0], monotonic(), int(WARM_UP * len(recording))
    for i in range(len(recording)):
        _, channel, data = recording[i]
        if channel not in SENT:
            continue
        message = hurried(SENT[channel].decode(data), start)
        ahead_s = (message.utime - start) * 1e-6 - (monotonic() - began)
        if ahead_s > 0.001:
            sleep(ahead_s)
        bus.publish(channel, message.encode())
        sent[channel] += message.n if channel == "MARKERS" else 1
        if i == warm_up:
            at_warm_up()
        if i % (len(recording) // 10) == 0:
            print(f"  {i / len(recording):4.0%} sent", flush=True)
    return sent


def spy(end: Connection) -> None:
    """Listen to everything, as lcm-spy does; give counts and the newest status when asked."""
    bus, counts, status = lcm.LCM(URL), Counter(), [b""]

    def take(channel: str, data: bytes) -> None:
        counts[channel] += 1
        if channel == "STATUS":
            status[0] = data

    bus.subscribe(".*", take).set_queue_capacity(0)
    while not end.poll():
        bus.handle_timeout(100)
    end.send((counts, status[0]))


def memory_bytes(pid: int) -> int:
    return int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * getpagesize()


def soak(hours: float, folder: Path) -> list[str]:
    """What is wrong; empty if all is well."""
    simulation = simulated(hours)
    here, there = multiprocessing.Pipe()
    multiprocessing.Process(target=spy, args=(there,), daemon=True).start()
    memory = []
    with lcm_logger(folder / "logger.lcmlog"), running_node(simulation.config, folder) as node:
        sent = send(simulation, lambda: memory.append(memory_bytes(node.pid)))
        sleep(3)  # a status that knows the last message
        memory.append(memory_bytes(node.pid))
    here.send("end")
    heard, newest = here.recv()
    return report(sent, heard, status_t.decode(newest), memory)


def report(sent: Counter[str], heard: Counter[str], status, memory: list[int]) -> list[str]:
    """Print what was counted; what is wrong with it."""
    faults = []
    print(f"{'':12}{'sent':>10}{'received':>10}{'fused':>10}{'lost':>8}")
    for entry in status.inputs:
        n = sent[entry.channel]
        print(f"{entry.channel:12}{n:10}{entry.received:10}{entry.fused:10}{entry.lost:8}")
        # Of a frame that was lost the node cannot know how many sightings it had.
        lost_frames = entry.channel == "MARKERS" and entry.lost > 0
        if entry.received + entry.lost != n and not (lost_frames and entry.received < n):
            faults.append(
                f"{entry.channel}: {n - entry.received - entry.lost} are not accounted for"
            )
    grown = memory[1] - memory[0]
    print(f"dropped by the kernel: {status.drops}; heard beside: {sum(heard.values())} messages")
    print(f"memory: {memory[0] / 1e6:.2f} MB after the warm-up, {grown / 1e6:+.2f} MB at the end")
    if grown > MAY_GROW_BYTES:
        faults.append(f"the node's memory grew by {grown} bytes")
    return faults


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--hours", type=float, default=2.0, help="of traffic (2)")
    hours = parser.parse_args().hours
    inside = multicast.rerun_in_private_network()
    if inside is not None:
        return inside
    with TemporaryDirectory() as folder:
        faults = soak(hours, Path(folder))
    for fault in faults:
        print(f"FAULT: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
