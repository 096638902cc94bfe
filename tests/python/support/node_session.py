"""A real pilotage-node from its start to its end, with what it heard, said and published."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from time import monotonic, sleep
from typing import Any

import lcm

from pilotage import Recording, lcmtypes, load_config
from pilotage.live import play, send

NODE = [sys.executable, "-c", "from pilotage._node import main; main()"]
LOGGER = Path(sys.executable).parent / "lcm-logger"
PORT = 7667
PATIENCE_S = 20.0


@dataclass
class Session:
    """What came of it: exit code, standard error, and messages by channel in their order."""

    exit_code: int
    said: str
    published: dict[str, list[bytes]] = field(default_factory=dict)

    @property
    def last_status(self) -> Any:
        """The newest status_t, decoded."""
        return lcmtypes.status_t.decode(self.published["STATUS"][-1])


def node_session(
    folder: Path,
    log: Path | None = None,
    *,
    options: Sequence[str] = (),
    speed: float | None = None,
    answered: bool = True,
    logger: bool = False,
    end: signal.Signals = signal.SIGTERM,
) -> Session:
    """Start a node on ``folder/robot.yaml``, send it a log, let it tick twice, and end it.

    Parameters
    ----------
    folder, log : path
    options : of the node, besides its configuration
    speed : times as fast as recorded; None: as fast as the node answers
    answered : whether every motion sample gets a pose, which `speed=None` relies on
    logger : whether lcm-logger writes ``folder/logger.lcmlog`` beside it
    end : the signal that ends it
    """
    command = [*NODE, "--config", str(folder / "robot.yaml"), *options]
    with _running(command, folder / "node.txt") as node:
        listening = 1
        published: dict[str, list[bytes]] = {}
        bus = lcm.LCM()
        everything = bus.subscribe(".*", lambda channel, data: _keep(published, channel, data))
        everything.set_queue_capacity(0)
        listening += 1
        if logger:
            beside = _running([LOGGER, "-q", "-f", str(folder / "logger.lcmlog")], folder / "logger.txt")
            listening += 1
            with beside as process:
                _await_listeners(listening, node)
                _converse(bus, published, folder, log, speed, answered)
                process.send_signal(signal.SIGINT)
                process.wait(PATIENCE_S)
        else:
            _await_listeners(listening, node)
            _converse(bus, published, folder, log, speed, answered)
        node.send_signal(end)
        exit_code = node.wait(PATIENCE_S)
    return Session(exit_code, (folder / "node.txt").read_text(), published)


def _converse(
    bus: Any,
    published: dict[str, list[bytes]],
    folder: Path,
    log: Path | None,
    speed: float | None,
    answered: bool,
) -> None:
    if log is not None:
        recording = Recording.load(str(log))
        if speed is not None or not answered:
            play(recording, speed or 100.0)
        else:
            send(recording, load_config(str(folder / "robot.yaml")))
    before = len(published.get("STATUS", []))
    start = monotonic()
    while len(published.get("STATUS", [])) < before + 2:
        assert monotonic() - start < PATIENCE_S, "the node ticks no more"
        bus.handle_timeout(100)


def _keep(published: dict[str, list[bytes]], channel: str, data: bytes) -> None:
    published.setdefault(channel, []).append(data)


@contextmanager
def _running(command: Sequence[Any], says: Path) -> Iterator["subprocess.Popen[bytes]"]:
    with says.open("wb") as out:
        process = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT)
        try:
            yield process
        finally:
            process.kill()
            process.wait()


def _await_listeners(count: int, node: "subprocess.Popen[bytes]") -> None:
    """Wait until so many sockets of this network are bound to LCM's port."""
    start = monotonic()
    while monotonic() - start < PATIENCE_S and node.poll() is None:
        bound = [line.split()[1] for line in Path("/proc/net/udp").read_text().splitlines()[1:]]
        if sum(place.endswith(f":{PORT:04X}") for place in bound) >= count:
            return
        sleep(0.02)
    raise AssertionError(f"{count} listeners did not come; node ended: {node.poll()}")
