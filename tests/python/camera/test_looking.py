"""From a source to detections: what is left out is counted, always."""

import cv2
import numpy as np
import pytest

from pilotage import CameraModel
from pilotage.camera.detection import Detection
from pilotage.camera.eye import Eye
from pilotage.camera.frame import Frame
from pilotage.camera.looking import look
from pilotage.camera.mounting import MountingNoise
from pilotage.camera.shutter import Shutter
from pilotage.camera.tally import Tally

IMAGE = np.zeros((48, 64, 3), np.uint8)


class Given:
    rate_hz, begin = 10.0, 0

    def __init__(self, *frames: Frame):
        self._frames = frames

    def frames(self, tally):
        yield from self._frames

    def close(self):
        pass


class Fixed:
    """Finds the same in every image; fails at images that begin with a 99."""

    def detect(self, image):
        if image[0, 0, 0] == 99:
            raise cv2.error("assertion failed")
        return [Detection(np.array([10.0, 20.0 * k]), np.eye(2)) for k in (0, 1)]


def eye(shutter: Shutter = Shutter()) -> Eye:  # noqa: B008 - frozen
    camera = CameraModel((64, 48), (60, 60, 31.5, 23.5))
    mounting = (0.0, 0.0, 1.0, 0.0)
    return Eye("front", camera, Fixed(), MountingNoise(), shutter, "markers", "MARKERS", mounting)


def frame(utime: int, image=IMAGE) -> Frame:
    return Frame(utime, f"{utime}.png", image)


def result(*frames: Frame, **options):
    said: list[str] = []
    tally = Tally("front", said.append)
    seen = list(look(eye(**options), Given(*frames), tally))
    for _ in seen:
        tally.publish(2)
    assert tally.read == tally.published + sum(tally.dropped.values())
    return seen, tally, said


def test_every_image_is_looked_at():
    seen, tally, said = result(frame(100), frame(200))
    assert [(one.utime, len(one.detections)) for one in seen] == [(100, 2), (200, 2)]
    assert tally.summary() == "2 frames = 2 published; 4 detections"
    assert said == []


@pytest.mark.parametrize(
    ("bad", "reason", "words"),
    [
        (Frame(150, "x.png", None, "unreadable", "x.png is no image"), "unreadable", "no image"),
        (frame(100), "repeated_stamp", "100.png has the time of the image before it, 100"),
        (frame(40), "clock_back", "40.png is 6e-05 s before the image before it"),
        (frame(150, np.zeros((24, 32, 3), np.uint8)), "wrong_size", "calibrated at 64 by 48"),
        (frame(150, IMAGE[:, :, 0]), "wrong_size", "150.png: an image is (48, 64)"),
        (frame(150, IMAGE + np.uint8(99)), "not_detected", "150.png: the detector failed: "),
    ],
)
def test_what_cannot_be_used_is_counted_and_said_and_the_rest_goes_on(bad, reason, words):
    seen, tally, said = result(frame(100), bad, frame(200))
    assert [one.utime for one in seen] == [100, 200]
    assert tally.dropped == {reason: 1}
    assert len(said) == 1
    assert words in said[0]
    assert f"3 frames = 2 published + 1 {reason}" in tally.summary()


def test_after_a_clock_that_was_set_back_one_image_is_lost():
    seen, tally, _ = result(*(frame(t) for t in (500, 600, 20, 30, 40)))
    assert [one.utime for one in seen] == [500, 600, 30, 40]
    assert tally.dropped == {"clock_back": 1}


def test_many_of_one_kind_are_said_once_and_counted_all():
    bad = [Frame(i, f"{i}.png", None, "unreadable", f"{i}.png is no image") for i in range(50)]
    _, tally, said = result(*bad, frame(100, IMAGE + np.uint8(99)))
    assert tally.dropped == {"unreadable": 50, "not_detected": 1}
    assert [words.split(": ")[1] for words in said] == ["0.png is no image", "100.png"]


def test_when_it_is_no_longer_time_the_image_is_counted():
    tally = Tally("front", lambda _: None)
    frames = Given(frame(100), frame(200), frame(300))
    seen = list(look(eye(), frames, tally, lambda utime: utime < 200))
    assert [one.utime for one in seen] == [100]
    assert (tally.read, tally.dropped) == (2, {"ended": 1})


def test_the_time_is_that_of_the_capture():
    [seen], *_ = result(frame(1_000_000), shutter=Shutter(exposure_offset_s=0.01))
    assert seen.utime == 990_000
    # Rows 0 and 20 of 48, so their mean is 13.5 rows above the middle one.
    [seen], *_ = result(frame(1_000_000), shutter=Shutter(readout_s=0.047))
    assert seen.utime == 1_000_000 - 13_500
