"""`pilotage status` beside a real node."""

import json
import signal
import subprocess
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from pilotage.lcmtypes import gyro_t, status_t
from pilotage.live import URL
from support.bus import Node, frame, node
from support.command import PILOTAGE, pilotage


def _status(*options: str):
    return pilotage("status", "--lcm-url", URL, *options)


def test_the_exit_status_tells_waiting_from_well(tmp_path: Path):
    with node(tmp_path) as running:
        waiting = _status("--once")
        assert waiting.returncode == 1, waiting.stderr
        assert "WAITING since" in waiting.stdout
        assert "for encoders_t on ENCODERS" in waiting.stdout
        running.drive(20)
        for i, seen in enumerate([(1, 0.17, 2.94), (2, -0.81, 2.75), (1, 0.17, 2.92)]):
            running.send("MARKERS", frame(1_100_000 + 10_000 * i, i, seen, (9, 0.0, 1.0)))
        with _driving(running, first=20):
            running.wait(lambda: running.messages["STATUS"][-1].state == status_t.OK, "OK")
            well = _status("--once", "--json")
        assert well.returncode == 0, well.stdout + well.stderr
        said = json.loads(well.stdout)["status"]
        assert said["state"] == "OK"
        assert said["inputs"][0]["name"] == "camera"
        assert said["inputs"][0]["rejected"] == [{"reason": "unknown_marker", "count": 3}]


@contextmanager
def _driving(running: Node, first: int) -> Iterator[None]:
    """Drive on in real time meanwhile."""
    stop = threading.Event()

    def drive() -> None:
        step = first
        while not stop.wait(0.01):
            running.drive(1, first=step)
            step += 1

    thread = threading.Thread(target=drive)
    thread.start()
    try:
        yield
    finally:
        stop.set()
        thread.join()


@pytest.mark.parametrize("options", [[], ["--json"]])
def test_it_follows_a_node_until_ctrl_c(tmp_path: Path, options: list[str]):
    command = [*PILOTAGE, "status", "--lcm-url", URL, *options]
    with node(tmp_path) as running:
        follower = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        assert follower.stdout is not None
        first = follower.stdout.readline()
        running.send("STATUS", gyro_t())
        follower.send_signal(signal.SIGINT)
        rest, errors = follower.communicate(timeout=10)
        assert follower.returncode == 0
        assert errors == b""
    lines = (first + rest).decode().splitlines()
    if options:
        assert [json.loads(line)["status"]["state"] for line in lines[:1]] == ["WAITING"]
    else:
        assert lines[0] == f"pilotage-node 0.1.0 on {URL}"


def test_where_no_node_is_it_says_so():
    result = _status("--once", "--timeout", "0.5")
    assert result.returncode == 2
    assert result.stdout == ""
    assert "no status_t on STATUS for 0.5 s; is pilotage-node running" in result.stderr


@pytest.mark.outside
def test_where_lcm_cannot_work_it_says_why():
    result = pilotage("status", "--once", "--lcm-url", "udpm://nowhere:1")
    assert result.returncode == 2
    assert "LCM cannot use udpm://nowhere:1" in result.stderr
    assert "Traceback" not in result.stderr
