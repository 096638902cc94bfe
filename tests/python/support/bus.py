"""A real node on a real LCM bus: tests with it run in a network of their own."""

import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import lcm

from pilotage import lcmtypes
from pilotage.live import URL

NODE = [sys.executable, "-c", "from pilotage._node import main; main()"]

CONFIG = """
map: [{id: 1, x: 3.0, y: 0.5, z: 0.5}, {id: 2, x: 2.0, y: -2.0, z: 0.5}]
encoders: {left_m_per_tick: 0.001, right_m_per_tick: 0.001, track_width_m: 0.5}
sensors: {camera: {z_m: 0.5}}
initial: {x_m: 0, y_m: 0, heading_rad: 0}
"""


class Node:
    """A running node, and what it has published."""

    def __init__(self, process: "subprocess.Popen[str]", says: Path):
        self.process = process
        self._says = says
        self.bus = lcm.LCM(URL)
        self.messages: dict[str, list[Any]] = {"POSE": [], "MARKER_REPORT": [], "STATUS": []}
        types = {
            "POSE": lcmtypes.pose_t,
            "MARKER_REPORT": lcmtypes.marker_report_t,
            "STATUS": lcmtypes.status_t,
        }
        for channel, kind in types.items():
            self.bus.subscribe(
                channel, lambda name, data, kind=kind: self.messages[name].append(kind.decode(data))
            ).set_queue_capacity(0)

    @property
    def said(self) -> str:
        return self._says.read_text()

    def send(self, channel: str, message: Any) -> None:
        self.bus.publish(channel, message if isinstance(message, bytes) else message.encode())

    def wait(self, condition, what: str, seconds: float = 10.0) -> None:
        end = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < end, f"waited {seconds} s for {what}; the node: {self.said}"
            self.bus.handle_timeout(20)

    def status_after(self, moment: float) -> Any:
        """The first status that the node made after a moment of the wall clock."""
        self.wait(lambda: any(s.utime > moment * 1e6 for s in self.messages["STATUS"]), "a status")
        return next(s for s in self.messages["STATUS"] if s.utime > moment * 1e6)

    def drive(self, steps: int, first: int = 0) -> None:
        """Encoders and gyro of a straight drive at 1 m/s, 100 Hz."""
        for i in range(first, first + steps):
            utime = 1_000_000 + 10_000 * i
            gyro = lcmtypes.gyro_t()
            gyro.utime, gyro.seq, gyro.rate = utime, i, 0.0
            self.send("GYRO", gyro)
            encoders = lcmtypes.encoders_t()
            encoders.utime, encoders.seq, encoders.left, encoders.right = utime, i, 10 * i, 10 * i
            self.send("ENCODERS", encoders)


@contextmanager
def node(folder: Path, config: str = CONFIG, *options: str) -> Iterator[Node]:
    file = folder / "robot.yaml"
    file.write_text(config)
    says = folder / "said.txt"
    with says.open("w") as stderr:
        process = subprocess.Popen(
            [*NODE, "--config", str(file), "--lcm-url", URL, *options], stderr=stderr, text=True
        )
        try:
            running = Node(process, says)
            running.wait(lambda: "markers" in running.said or process.poll() is not None, "it")
            yield running
        finally:
            process.kill()
            process.wait()


def frame(utime: int, seq: int, *sightings: tuple[int, float, float], sensor: str = "camera"):
    """A marker_frame_t of (id, bearing, range)."""
    message = lcmtypes.marker_frame_t()
    message.utime, message.seq, message.sensor, message.n = utime, seq, sensor, len(sightings)
    for marker, bearing, distance in sightings:
        sighting = lcmtypes.marker_sighting_t()
        sighting.id, sighting.label = marker, -1
        sighting.bearing, sighting.elevation, sighting.range = bearing, float("nan"), distance
        sighting.sigma_bearing = sighting.sigma_elevation = sighting.sigma_range = float("nan")
        message.sightings.append(sighting)
    return message
