"""`kill -9` at any moment: the checkpoint can always be read, and confirms nothing by itself."""

import random
import subprocess
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import lcm

import pilotage
from pilotage._node import BINARY
from pilotage.health import radius_95_m
from pilotage.lcmtypes import pose_t, status_t
from pilotage.live import URL
from support.driving import CONFIG, Robot

KILLS, ROBOTS = 200, 4
UNSEEN = 5
"""Steps after a start in which the robot drives and sees nothing: nothing can confirm its pose."""
LIVES_S = 0.5
"""A node is killed before that, counted from its start."""
BUSY = CONFIG + "checkpoint: {interval_s: 0.004}\n"


@dataclass
class Victim:
    """A robot whose node is killed again and again."""

    folder: Path
    number: int
    robot: Robot = field(default_factory=Robot)
    kills: int = 0
    kept: int = 0
    confirmed: int = 0

    def __post_init__(self) -> None:
        self.folder.mkdir()
        self.config, self.path = self.folder / "robot.yaml", self.folder / "pose"
        self.config.write_text(BUSY)
        self.rng = random.Random(self.number)
        self.url = URL.replace(":7668", f":{7700 + self.number}")
        self.bus = lcm.LCM(self.url)
        self.poses: list[Any] = []
        self.first = 0
        self.bus.subscribe("POSE", self._take).set_queue_capacity(0)

    def _take(self, _: str, data: bytes) -> None:
        pose = pose_t.decode(data)
        if pose.utime >= self.first:  # else the last word of a former life
            self.poses.append(pose)

    def live_and_die(self) -> None:
        """Start, drive until some moment, die; then look at what is left."""
        newest = self._kept_utime()
        said = self.folder / "said.txt"
        with said.open("w") as stderr:
            command = [BINARY, "--config", self.config, "--checkpoint", self.path]
            node = subprocess.Popen([*command, "--lcm-url", self.url], stderr=stderr)
            end = time.monotonic() + self.rng.uniform(0.0, LIVES_S)
            try:
                self._drive(end)
            finally:
                node.kill()
                node.wait()
        self.kills += 1
        words = said.read_text()
        assert "begins without" not in words, words
        assert newest <= self._kept_utime(), "an older checkpoint has come back"
        self.kept += self._kept_utime() > newest

    def _kept_utime(self) -> int:
        if not self.path.exists():
            assert self.kept == 0, "the checkpoint is gone"
            return 0
        return pilotage.read_checkpoint(str(self.path))["utime"]

    def _drive(self, end: float) -> None:
        if self.rng.random() < 0.3:  # the robot was carried while nobody looked, or switched off
            self.robot.aside = (self.rng.uniform(-0.5, 0.5), self.rng.uniform(-0.5, 0.5))
            self.robot.ticks_from = self.robot.step
        self.poses.clear()
        self.first, steps, ok = self.robot.utime, 0, False
        while time.monotonic() < end:
            # Until the node hears, the robot stands: it sends the same again.
            before, step = len(self.poses), self.robot.step
            for channel, message in self.robot.messages(sightings=steps >= UNSEEN):
                self.bus.publish(channel, message.encode())
            while time.monotonic() < end and len(self.poses) == before:
                if self.bus.handle_timeout(3) == 0 and steps == 0:
                    self.robot.step = step
                    break
            steps += len(self.poses) > before
            for pose in self.poses[before:]:
                if pose.status != status_t.OK:
                    continue
                assert steps > UNSEEN + 2, "OK before three sightings"
                off_m = self.robot.distance(pose)
                assert off_m < max(0.25, 2.5 * radius_95_m(pose)), "OK where it is not"
                ok = True
        self.confirmed += ok


def test_two_hundred_kills_leave_a_file_that_can_be_read_and_a_pose_to_be_confirmed(
    tmp_path: Path,
):
    victims = [Victim(tmp_path / str(i), i) for i in range(ROBOTS)]
    failed = threading.Event()

    def lives(victim: Victim) -> None:
        try:
            while victim.kills < KILLS / ROBOTS and not failed.is_set():
                victim.live_and_die()
        except BaseException:
            failed.set()
            raise

    with ThreadPoolExecutor(ROBOTS) as pool:
        for done in [pool.submit(lives, victim) for victim in victims]:
            done.result()
    assert sum(victim.kills for victim in victims) == KILLS
    assert sum(victim.kept for victim in victims) > KILLS / 5, "hardly anything was written"
    assert sum(victim.confirmed for victim in victims) > KILLS / 5, "hardly anything was confirmed"
