"""Images to a pose with real processes: pilotage-camera, LCM, pilotage-node and the drive."""

import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import cv2
import lcm
import numpy as np
import pytest

import pilotage
from pilotage import lcmtypes
from pilotage.lcmtypes import status_t
from pilotage.live import URL, play
from support.bus import Node, node
from support.command import CAMERA, pilotage_camera
from support.drawn import drawn

REST_US = 1_000_000
"""Of the drive after the last image: all poses in it know all images."""


@contextmanager
def camera(folder: Path, *arguments: object) -> Iterator["subprocess.Popen[str]"]:
    command = [*CAMERA, "--config", "robot.yaml", "--lcm-url", URL, *map(str, arguments)]
    with (folder / "camera.txt").open("w") as says:
        process = subprocess.Popen(command, cwd=folder, stderr=says)
        try:
            yield process
        finally:
            process.kill()
            process.wait()


def said(folder: Path) -> str:
    return (folder / "camera.txt").read_text()


def without_the_last(folder: Path, names: list[str], end: int) -> int:
    """Leave out images from a time on; how many are left."""
    left = 0
    for name in names:
        for image in (folder / name).iterdir():
            if int(image.stem) >= end:
                image.unlink()
            else:
                left += 1
    return left


def play_beside(
    running: Node, folder: Path, drive: pilotage.Recording, speed: float, *inputs: str
) -> None:
    """Play the drive with images beside it, until all its poses are there."""
    with camera(folder, *inputs, "--follow") as process:
        running.wait(lambda: "sending" in said(folder), "the camera")
        play(drive, speed, url=URL)
        assert process.wait(timeout=30) == 0, said(folder)
    count = len(drive.arrivals("ENCODERS"))
    running.wait(lambda: len(running.messages["POSE"]) == count, "poses")


@pytest.mark.parametrize(
    ("scenario", "duration_s", "speed"), [("aruco-ring", 3.0, 0.5), ("mower-cameras", 13.0, 1.0)]
)
def test_live_poses_are_those_of_the_images_offline(
    tmp_path: Path, scenario: str, duration_s: float, speed: float
):
    config = drawn(tmp_path, scenario, duration_s)
    drive = pilotage.Recording.load(str(tmp_path / "drive.lcmlog"))
    end = int(drive.arrivals("ENCODERS")[-1]) - REST_US
    images = without_the_last(tmp_path, config.sensors, end)
    inputs = [f"{name}={name}" for name in config.sensors]

    merge = ("--merge", "drive.lcmlog", "-o", "found.lcmlog")
    offline = pilotage_camera("--config", "robot.yaml", *inputs, *merge, cwd=tmp_path)
    assert offline.returncode == 0, offline.stderr
    expected = pilotage.replay(config, str(tmp_path / "found.lcmlog"))
    assert expected.reports["accepted"].sum() > 3

    robot = (tmp_path / "robot.yaml").read_text()
    record = ("--record", str(tmp_path / "node.lcmlog"))
    with node(tmp_path, robot, *record) as running:
        play_beside(running, tmp_path, drive, speed, *inputs)
        running.process.terminate()
        running.process.wait(timeout=10)
    recorded = pilotage.Recording.load(str(tmp_path / "node.lcmlog"))
    channels = [recorded[i][1] for i in range(len(recorded))]
    assert channels.count("MARKERS") == images
    last = len(channels) - channels[::-1].index("MARKERS")
    # Poses before an image has arrived cannot know it; those after the last one know all.
    after = [
        lcmtypes.pose_t.decode(recorded[i][2])
        for i in range(last, len(channels))
        if channels[i] == "POSE"
    ]
    rest = expected.poses[-len(after) :]
    assert len(after) > 20
    assert [pose.utime for pose in after] == rest["utime"].tolist()
    for pose, row in zip(after, rest, strict=True):
        np.testing.assert_allclose((pose.x, pose.y), (row["x"], row["y"]), rtol=0, atol=1e-9)
        assert abs(pose.heading - row["heading"]) < 1e-9
    replayed = pilotage.replay(config, recorded)
    assert np.array_equal(replayed.reports["id"], expected.reports["id"])
    np.testing.assert_allclose(
        replayed.reports["innovation"], expected.reports["innovation"], rtol=0, atol=1e-9
    )


def test_images_that_cannot_be_used_leave_the_node_in_dead_reckoning(tmp_path: Path):
    """Damaged, of another size, and of a clock a hundred seconds behind: counted, in words."""
    drawn(tmp_path, "aruco-ring", 2.0)
    images = sorted((tmp_path / "camera").iterdir(), key=lambda path: int(path.stem))
    good = images[:30]
    for image in images[30:]:
        image.unlink()
    good[0].write_bytes(b"no image")
    good[1].write_bytes(small_picture())
    # Ten of them are as they should be, so that there is a pose to be carried on.
    stamps = [int(image.stem) - (100_000_000 if i >= 10 else 0) for i, image in enumerate(good)]
    rows = [f"{image.name},{stamp}\n" for image, stamp in zip(good, stamps, strict=True)]
    (tmp_path / "camera" / "stamps.csv").write_text("file,utime\n" + "".join(rows))
    drive = pilotage.Recording.load(str(tmp_path / "drive.lcmlog"))
    with node(tmp_path, soon_in_dead_reckoning(tmp_path)) as running:
        play_beside(running, tmp_path, drive, 1.0, "camera")
        assert running.messages["POSE"][-1].utime == drive.arrivals("ENCODERS")[-1]
        assert_dead_reckoning_at_the_end(running)
        known = len(running.messages["STATUS"])
        running.wait(lambda: len(running.messages["STATUS"]) > known, "the status")
        [entry] = [e for e in running.messages["STATUS"][-1].inputs if e.name == "camera"]
    [rejected] = entry.rejected
    assert rejected.reason == "late"
    assert rejected.count > 20
    assert entry.received == entry.fused + rejected.count
    words = said(tmp_path)
    assert "is no image, or a damaged one" in words
    assert "an image is 64 by 48 pixels, but the camera was calibrated at 640 by 480" in words
    assert "s behind the poses, more than history.window_s (2 s)" in words
    assert "camera: 30 frames = 28 published + 1 unreadable + 1 wrong_size" in words


def soon_in_dead_reckoning(folder: Path) -> str:
    """The configuration, with less patience."""
    text = (folder / "robot.yaml").read_text()
    assert "dead_reckoning_after_s: 5\n" in text
    return text.replace("dead_reckoning_after_s: 5\n", "dead_reckoning_after_s: 0.4\n")


def assert_dead_reckoning_at_the_end(running: Node) -> None:
    """While the drive went on the pose was sure first, and then carried on by motion alone."""
    states = [pose.status for pose in running.messages["POSE"]]
    assert status_t.OK in states
    assert states[-1] == status_t.DEAD_RECKONING


def picture(file: Path) -> np.ndarray:
    image = cv2.imread(str(file))
    assert image is not None, file
    return image


def small_picture() -> bytes:
    return cv2.imencode(".png", np.zeros((48, 64, 3), np.uint8))[1].tobytes()


def test_a_camera_that_is_gone_is_said_by_the_node_which_goes_on(tmp_path: Path):
    drawn(tmp_path, "aruco-ring", 3.0)
    drive = pilotage.Recording.load(str(tmp_path / "drive.lcmlog"))
    end = int(drive.arrivals("ENCODERS")[-1]) - REST_US
    without_the_last(tmp_path, ["camera"], end - REST_US)
    with node(tmp_path, soon_in_dead_reckoning(tmp_path)) as running:
        play_beside(running, tmp_path, drive, 1.0, "camera")
        assert_dead_reckoning_at_the_end(running)
        running.wait(lambda: "camera: silent" in running.said, "words")


def test_the_camera_ends_on_a_signal_and_says_where_all_frames_went(tmp_path: Path):
    drawn(tmp_path, "aruco-ring", 1.0)
    options = ("--speed", "0.01", "--save-images", "kept")
    with camera(tmp_path, "camera", *options) as process:
        bus = Listening()
        bus.wait(2)
        process.terminate()
        assert process.wait(timeout=30) == 0
    words = said(tmp_path).splitlines()[-1]
    assert "published + 1 ended; " in words
    assert len(bus.frames) >= 2
    assert [frame.seq for frame in bus.frames] == list(range(len(bus.frames)))
    for frame in bus.frames:
        kept = tmp_path / "kept" / "camera" / f"{frame.utime}.png"
        assert np.array_equal(picture(kept), picture(tmp_path / "camera" / f"{kept.stem}.jpg"))


class Listening:
    def __init__(self):
        self.bus = lcm.LCM(URL)
        self.frames = []
        self.bus.subscribe(
            "MARKERS", lambda _, data: self.frames.append(lcmtypes.marker_frame_t.decode(data))
        )

    def wait(self, count: int) -> None:
        end = time.monotonic() + 30
        while len(self.frames) < count:
            assert time.monotonic() < end, "no frames"
            self.bus.handle_timeout(100)
