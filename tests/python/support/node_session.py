"""A real pilotage-node from its start to its end: what it published, said and recorded."""

import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
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
    """Exit code, standard error, and the messages on the bus by channel, in order."""

    exit_code: int
    said: str
    messages: dict[str, list[bytes]]

    @property
    def last_status(self) -> Any:
        """The newest status_t, decoded."""
        return lcmtypes.status_t.decode(self.messages["STATUS"][-1])

    def counts(self, name: str) -> dict[str, int]:
        """What the newest status counts of an input's channel."""
        (status,) = (i for i in self.last_status.inputs if i.channel == name)
        rejected = {reason.reason: reason.count for reason in status.rejected}
        return {"received": status.received, "fused": status.fused} | rejected


def node_session(
    folder: Path,
    log: Path | None = None,
    *,
    options: Sequence[str] = (),
    speed: float | None = None,
    logger: bool = False,
    end: signal.Signals = signal.SIGTERM,
) -> Session:
    """Start a node on ``folder/robot.yaml``, send it a log, let it tick twice, and end it.

    Parameters
    ----------
    folder : path
        Gets node.txt, and logger.lcmlog if there is a logger.
    log : path, optional
        To send.
    options : sequence of str
        Of the node, besides its configuration.
    speed : float, optional
        Times as fast as recorded; without it as fast as the node answers, which is for logs whose
        every motion sample is answered.
    logger : bool
        Whether lcm-logger listens as well.
    end : signal
        That ends the node.
    """
    messages: dict[str, list[bytes]] = {}
    bus = lcm.LCM()
    everything = bus.subscribe(
        ".*", lambda channel, data: messages.setdefault(channel, []).append(data)
    )
    everything.set_queue_capacity(0)

    def ticks() -> int:
        bus.handle_timeout(20)
        return len(messages.get("STATUS", []))

    with ExitStack() as processes:
        if logger:
            write = [str(LOGGER), "-q", "-f", str(folder / "logger.lcmlog")]
            process = processes.enter_context(_running(write, folder / "logger.txt"))
            _wait(lambda: _listeners() == 2, process)
        command = [*NODE, "--config", str(folder / "robot.yaml"), *options]
        node = processes.enter_context(_running(command, folder / "node.txt"))
        _wait(lambda: ticks() > 0, node)
        if log is not None and speed is None:
            send(Recording.load(str(log)), load_config(str(folder / "robot.yaml")))
        elif log is not None:
            play(Recording.load(str(log)), speed)
        seen = ticks()
        _wait(lambda: ticks() > seen + 1, node)
        node.send_signal(end)
        exit_code = node.wait(PATIENCE_S)
    return Session(exit_code, (folder / "node.txt").read_text(), messages)


@contextmanager
def _running(command: Sequence[str], says: Path) -> Iterator["subprocess.Popen[bytes]"]:
    with says.open("wb") as out:
        process = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT)
        try:
            yield process
        finally:
            process.terminate()
            process.wait(PATIENCE_S)


def _wait(for_this: Callable[[], bool], process: "subprocess.Popen[bytes]") -> None:
    start = monotonic()
    while not for_this():
        assert process.poll() is None, f"{process.args} ended with {process.returncode}"
        assert monotonic() - start < PATIENCE_S, f"{process.args}: nothing came of it"
        sleep(0.01)


def _listeners() -> int:
    """How many sockets of this network are bound to LCM's port."""
    rows = Path("/proc/net/udp").read_text().splitlines()[1:]
    return sum(row.split()[1].endswith(f":{PORT:04X}") for row in rows)
