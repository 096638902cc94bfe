"""Video files and video devices; the device is a stand-in."""

from pathlib import Path
from threading import Event

import cv2
import numpy as np
import pytest

from pilotage.camera import videos
from pilotage.camera.tally import Tally
from pilotage.camera.videos import Device, VideoFile


def write(path: Path, count: int, rate: float = 10.0) -> None:
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"MJPG"), rate, (64, 48))
    for i in range(count):
        writer.write(np.full((48, 64, 3), 20 * i % 256, np.uint8))
    writer.release()


def quiet() -> Tally:
    return Tally("front", lambda _: None)


def test_a_frame_is_dated_by_the_beginning_and_its_time_in_the_file(tmp_path: Path):
    write(tmp_path / "drive.avi", 5)
    video = VideoFile(tmp_path / "drive.avi", 7_000_000)
    frames = list(video.frames(quiet()))
    assert [f.utime for f in frames] == [7_000_000 + 100_000 * i for i in range(5)]
    np.testing.assert_allclose([f.image.mean() for f in frames], [0, 20, 40, 60, 80], atol=3)
    assert video.rate_hz == 10
    assert video.begin == 7_000_000


def test_a_video_that_ends_early_is_said(tmp_path: Path):
    write(tmp_path / "drive.avi", 30)
    content = (tmp_path / "drive.avi").read_bytes()
    (tmp_path / "drive.avi").write_bytes(content[: len(content) // 2])
    said: list[str] = []
    frames = list(VideoFile(tmp_path / "drive.avi", 0).frames(Tally("front", said.append)))
    assert 0 < len(frames) < 30
    assert said == [
        f"front: {tmp_path / 'drive.avi'} ends after {len(frames)} of 30 frames: it is damaged, "
        "or was not closed"
    ]


def test_what_is_no_video_is_an_error(tmp_path: Path):
    (tmp_path / "drive.mp4").write_bytes(b"no video")
    with pytest.raises(ValueError, match="no video that this OpenCV can read"):
        VideoFile(tmp_path / "drive.mp4", 0)


class Camera:
    """Stands for cv2.VideoCapture: gives what a list has, None being a failure."""

    def __init__(self, script: list[int | None], opens: bool = True):
        self.script, self.opens, self.asked = script, opens, {}
        self.used_up = Event()

    def isOpened(self) -> bool:
        return self.opens

    def set(self, key: int, value: float) -> None:
        self.asked[key] = value

    def get(self, key: int) -> float:
        return 30.0

    def grab(self) -> bool:
        if not self.script:
            self.used_up.set()
            return False
        return self.script[0] is not None

    def retrieve(self):
        return True, np.full((4, 6, 3), self.script.pop(0), np.uint8)

    def release(self) -> None:
        pass


class Failing(Camera):
    def grab(self) -> bool:
        if self.script and self.script[0] is None:
            self.script.pop(0)
            return False
        return super().grab()


def given(monkeypatch, *cameras: Camera) -> None:
    left = list(cameras)
    monkeypatch.setattr(videos.cv2, "VideoCapture", lambda _: left.pop(0))
    monkeypatch.setattr(videos, "AGAIN_S", 0.01)


def test_the_newest_image_counts_and_those_it_replaced_are_counted(monkeypatch):
    camera = Camera([10, 20, 30])
    given(monkeypatch, camera, *(Camera([], opens=False) for _ in range(10_000)))
    device, tally = Device(0, (6, 4)), quiet()
    frames = device.frames(tally)
    first = next(frames)  # while it is worked on the others come
    camera.used_up.wait(10)
    last = first if first.image[0, 0, 0] == 30 else next(frames)
    assert last.image[0, 0, 0] == 30
    yielded = 1 if last is first else 2
    assert tally.dropped["busy"] == tally.read == 3 - yielded
    assert last.utime >= first.utime > 1_600_000_000_000_000
    device.close()
    assert list(frames) == []


def test_a_device_that_is_gone_is_said_and_found_again(monkeypatch):
    before, after = Failing([None, 10, None, None, None]), Camera([50])
    given(monkeypatch, before, Camera([], opens=False), after, *(Camera([], False),) * 10_000)
    said: list[str] = []
    device = Device("/dev/video7", (6, 4))
    frames = device.frames(Tally("front", said.append))
    assert next(frames).image[0, 0, 0] == 10
    assert next(frames).image[0, 0, 0] == 50
    device.close()
    assert list(frames) == []
    assert said[:2] == [
        "front: /dev/video7 is gone; looked for every 0.01 s",
        "front: /dev/video7 is back",
    ]
    assert after.asked == {cv2.CAP_PROP_FRAME_WIDTH: 6, cv2.CAP_PROP_FRAME_HEIGHT: 4}


def test_a_device_that_is_not_there_is_an_error(monkeypatch):
    given(monkeypatch, Camera([], opens=False))
    with pytest.raises(ValueError, match="/dev/video3 cannot be opened: is it there"):
        Device(3, (6, 4))
