"""Which input is of which camera, and what kind of thing it is."""

from pathlib import Path

import cv2
import numpy as np
import pytest

import pilotage
from pilotage.camera.images import ImageFiles
from pilotage.camera.inputs import by_camera, is_device, open_source
from pilotage.camera.videos import VideoFile

LENS = """{image_width: 64, image_height: 48,
  camera_matrix: {rows: 3, cols: 3, data: [60, 0, 31.5, 0, 60, 23.5, 0, 0, 1]},
  distortion_coefficients: {rows: 1, cols: 4, data: [0, 0, 0, 0]}}"""


def config(*names: str) -> pilotage.Config:
    sensors = "".join(f"{name}: {{z_m: 1, intrinsics: {LENS}}}, " for name in names)
    return pilotage.Config.parse(f"sensors: {{{sensors}laser: {{z_m: 0.4}}}}")


def test_of_one_camera_the_name_may_be_left_out():
    assert by_camera(config("front"), ["0"]) == {"front": "0"}
    assert by_camera(config("front"), ["front=a=b.mp4"]) == {"front": "a=b.mp4"}


def test_an_input_with_a_sign_of_its_own_is_a_file_if_it_is_there(tmp_path: Path):
    (tmp_path / "a=b").mkdir()
    assert by_camera(config("front"), [f"{tmp_path}/a=b"]) == {"front": f"{tmp_path}/a=b"}


def test_of_several_cameras_each_input_has_its_name():
    both = by_camera(config("front", "rear"), ["rear=1", "front=/dev/video0"])
    assert both == {"rear": "1", "front": "/dev/video0"}


@pytest.mark.parametrize(
    ("cameras", "inputs", "words"),
    [
        (["front"], ["frnt=0"], "no camera 'frnt' in the configuration; the nearest is 'front'"),
        (["front"], ["laser=0"], "no camera 'laser'"),
        (["front", "rear"], ["0"], "0: say of which camera, as in front=0"),
        (["front"], ["0", "1"], "0: say of which camera"),
        (["front"], ["front=0", "front=1"], "camera 'front' has 0 already"),
        ([], ["0"], "the configuration has no camera"),
    ],
)
def test_a_wrong_name_says_the_right_ones(cameras: list[str], inputs: list[str], words: str):
    with pytest.raises(ValueError, match="camera") as error:
        by_camera(config(*cameras), inputs)
    assert words in str(error.value)


@pytest.mark.parametrize(
    ("text", "device"), [("0", True), ("12", True), ("/dev/video2", True), ("front", False)]
)
def test_a_device_is_a_number_or_its_file(text: str, device: bool):
    assert is_device(text) == device


def test_the_kind_of_a_source_is_seen(tmp_path: Path):
    (tmp_path / "front").mkdir()
    picture = np.zeros((48, 64, 3), np.uint8)
    for stamp in (100, 200):
        cv2.imwrite(str(tmp_path / "front" / f"{stamp}.png"), picture)
    film = tmp_path / "1000417.avi"
    writer = cv2.VideoWriter(str(film), cv2.VideoWriter.fourcc(*"MJPG"), 10, (64, 48))
    writer.write(picture)
    writer.release()
    size = (64, 48)
    assert isinstance(open_source(str(tmp_path / "front"), size, None), ImageFiles)
    assert open_source(f"{tmp_path}/front/2*.png", size, None).begin == 200
    assert isinstance(open_source(str(film), size, None), VideoFile)
    assert open_source(str(film), size, None, 5).begin == 1_000_417
    assert open_source(str(film), size, 7, 5).begin == 7
    named = film.rename(tmp_path / "drive.avi")
    assert open_source(str(named), size, None, 5).begin == 5
    with pytest.raises(ValueError, match=r"does not say when it begins: give --begin"):
        open_source(str(named), size, None)
    with pytest.raises(ValueError, match=r"no such file or folder; an input is a video device"):
        open_source("nowhere", size, None)
    with pytest.raises(ValueError, match=r"no images there"):
        open_source(f"{tmp_path}/rear/*.png", size, None)
