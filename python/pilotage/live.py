"""A recording sent to a real node over LCM, and what it answers."""

import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from time import monotonic, sleep
from typing import Any

from . import Config, Recording
from .bus import connect

URL = "udpm://239.255.76.67:7668?ttl=0&recv_buf_size=4194304"
"""Another port than LCM's own: what is only tried out must not reach a robot that runs here."""
OUTSTANDING = 50
"""Motion samples sent ahead of the poses that answer them."""
PATIENCE_S = 10.0


@contextmanager
def running_node(config: Config, folder: Path, url: str = URL) -> Iterator["subprocess.Popen[str]"]:
    """Start `pilotage-node`, which records into ``folder/node.lcmlog``; end it on the way out.

    Raises
    ------
    RuntimeError
        If it does not start, with what it says.
    """
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "robot.yaml").write_text(config.to_yaml(), encoding="utf-8")
    command = [sys.executable, "-c", "from pilotage._node import main; main()"]
    command += ["--config", str(folder / "robot.yaml"), "--lcm-url", url]
    command += ["--record", str(folder / "node.lcmlog")]
    with (folder / "node.txt").open("w+") as says:
        node = subprocess.Popen(command, stderr=says, text=True)
        try:
            start = monotonic()
            while "waiting for" not in (said := (folder / "node.txt").read_text()):
                if node.poll() is not None or monotonic() - start > PATIENCE_S:
                    raise RuntimeError(f"pilotage-node did not start: {said.strip()}")
                sleep(0.02)
            yield node
        finally:
            node.terminate()
            node.wait(timeout=PATIENCE_S)


def send(
    recording: Recording,
    config: Config,
    progress: Callable[[float], None] = lambda _: None,
    url: str = URL,
) -> list[bytes]:
    """Send every input as fast as the node answers; the encoded pose_t in their order.

    Raises
    ------
    RuntimeError
        If the node stops answering.
    """
    bus = connect(url)
    poses: list[bytes] = []
    subscription = bus.subscribe(config["output.pose"], lambda _, data: poses.append(data))
    subscription.set_queue_capacity(0)
    motion = config[f"{config['motion.source']}.channel"]
    sent = 0
    for i in range(len(recording)):
        _, channel, data = recording[i]
        bus.publish(channel, data)
        sent += channel == motion
        _await(bus, poses, sent - OUTSTANDING)
        if i % 1000 == 0:
            progress(i / len(recording))
    _await(bus, poses, sent)
    return poses


def _await(bus: Any, poses: list[bytes], count: int) -> None:
    while len(poses) < count:
        if bus.handle_timeout(round(PATIENCE_S * 1000)) == 0:
            raise RuntimeError(
                f"pilotage-node answered {len(poses)} of {count} motion samples and then no more"
            )


def play(
    recording: Recording,
    speed: float,
    progress: Callable[[float], None] = lambda _: None,
    url: str | None = None,
) -> None:
    """Send a recording with the pauses that it was recorded with, `speed` times as fast."""
    bus = connect(url)
    start, first = monotonic(), recording[0][0]
    for i in range(len(recording)):
        received, channel, data = recording[i]
        ahead_s = (received - first) * 1e-6 / speed - (monotonic() - start)
        if ahead_s > 0:
            sleep(ahead_s)
        bus.publish(channel, data)
        progress(i / len(recording))
