"""`pilotage-camera` as a user types it, without LCM."""

import os
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest

import pilotage
from pilotage.lcmtypes import marker_frame_t
from support.command import pilotage as command
from support.command import pilotage_camera
from support.drawn import drawn

LENS = """%YAML:1.0
---
image_width: 64
image_height: 48
camera_matrix: !!opencv-matrix
   {rows: 3, cols: 3, dt: d, data: [60., 0., 31.5, 0., 60., 23.5, 0., 0., 1.]}
distortion_coefficients: !!opencv-matrix
   {rows: 1, cols: 4, dt: d, data: [0., 0., 0., 0.]}
"""
ROBOT = """map: [{id: 1, x: 3, y: 0}]
sensors: {front: {z_m: 1, pitch_rad: 0.3, intrinsics: front.yaml}, rear: {z_m: 1}}
detectors: {front: {kind: discs, radius_m: 0.1}}
"""
CONFIG = ("--config", "robot.yaml")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "robot.yaml").write_text(ROBOT)
    (tmp_path / "front.yaml").write_text(LENS)
    (tmp_path / "front").mkdir()
    for i in range(4):
        cv2.imwrite(str(tmp_path / "front" / f"{1000 * i}.png"), np.zeros((48, 64, 3), np.uint8))
    return tmp_path


@pytest.fixture(scope="module")
def mower(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("mower")
    drawn(folder, "mower-cameras", 21.0)
    return folder


BOTH = ("front=front", "rear=rear")


def test_images_with_a_log_of_poses_make_a_log_that_can_be_replayed(mower: Path):
    options = ("--poses", "drive.lcmlog", "--merge", "drive.lcmlog", "-o", "found.lcmlog")
    result = pilotage_camera(*CONFIG, *BOTH, *options, "--save-video", "seen.avi", cwd=mower)
    assert result.returncode == 0, result.stderr
    assert "pilotage-camera: drive.lcmlog: 2101 true poses" in result.stderr
    assert "pilotage-camera: front: 11 frames = 11 published; " in result.stderr
    assert "seen-rear.avi written" in result.stderr
    replayed = command("replay", "found.lcmlog", *CONFIG, "-o", "out", "--no-figures", cwd=mower)
    assert replayed.returncode == 0, replayed.stderr
    log = pilotage.Recording.load(str(mower / "found.lcmlog"))
    ideal = pilotage.Recording.load(str(mower / "ideal.lcmlog"))
    truth = {}
    for data in ideal.messages("MARKERS"):
        frame = marker_frame_t.decode(data)
        for sighting in frame.sightings:
            truth[frame.sensor, frame.utime, sighting.id] = sighting
    right = 0
    for data in log.messages("MARKERS"):
        frame = marker_frame_t.decode(data)
        for sighting in frame.sightings:
            true = truth[frame.sensor, frame.utime, sighting.id]
            assert abs(sighting.bearing - true.bearing) < 5 * sighting.sigma_bearing
            assert abs(sighting.elevation - true.elevation) < 5 * sighting.sigma_elevation
            right += 1
    assert right > 10
    assert len(log) == len(pilotage.Recording.load(str(mower / "drive.lcmlog"))) + 11 + 10


def test_bad_images_are_named_and_counted_and_the_others_used(folder: Path):
    (folder / "front" / "1000.png").write_bytes(b"\x89PNG no more")
    cv2.imwrite(str(folder / "front" / "2000.png"), np.zeros((20, 30, 3), np.uint8))
    cv2.imwrite(str(folder / "front" / "last.png"), np.zeros((48, 64, 3), np.uint8))
    result = pilotage_camera(*CONFIG, "front", "-o", "found.lcmlog", cwd=folder)
    assert result.returncode == 0
    for words in (
        "front: 1000.png is no image, or a damaged one",
        "front: 2000.png: an image is 30 by 20 pixels, but the camera was calibrated at 64 by 48",
        "front: last.png has no time of capture: name images by it in microseconds",
        "front: 5 frames = 2 published + 1 no_stamp + 1 unreadable + 1 wrong_size; 0 detections",
    ):
        assert words in result.stderr
    log = pilotage.Recording.load(str(folder / "found.lcmlog"))
    assert [marker_frame_t.decode(data).seq for data in log.messages("MARKERS")] == [0, 1]


def test_if_no_image_could_be_used_the_exit_status_is_1(folder: Path):
    for image in (folder / "front").iterdir():
        image.write_bytes(b"no image")
    result = pilotage_camera(*CONFIG, "front", "-o", "found.lcmlog", cwd=folder)
    assert result.returncode == 1
    assert "front: 4 frames = 0 published + 4 unreadable" in result.stderr


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("frnt=front",), "frnt=front: no camera 'frnt' in the configuration; the nearest is"),
        (("nowhere",), "nowhere: no such file or folder; an input is a video device"),
        (("/dev/video99",), "/dev/video99 cannot be opened: is it there, and not in use?"),
        (("front", "--show"), "--show needs an OpenCV with windows and a screen"),
        (("front", "--save-video", "a.gif"), "--save-video a.gif: expected .mp4 or .avi"),
        (("front", "-o", "f.lcmlog", "--save-images", "a"), "--save-images is of what is sent"),
        (("front", "--poses", "a.lcmlog"), "--poses and --merge are of recorded images"),
        (("front", "--speed", "0"), "--speed is 0, expected 0.001 to 1e+06"),
        (("front", "-o", "f.lcmlog", "--poses", "nowhere"), "nowhere: no such file or folder"),
    ],
)
def test_what_cannot_begin_says_why_and_exits_with_2(folder: Path, arguments, words: str):
    environment = {k: v for k, v in os.environ.items() if "DISPLAY" not in k}
    result = pilotage_camera(*CONFIG, *arguments, cwd=folder, env=environment)
    assert result.returncode == 2, result.stderr
    assert "Traceback" not in result.stderr
    assert f"pilotage-camera: {words}" in result.stderr


@pytest.mark.parametrize(
    ("before", "after", "words"),
    [
        (", intrinsics: front.yaml", "", "sensors.front.intrinsics is missing: name the file"),
        ("front.yaml", "other.yaml", "other.yaml"),
        ("detectors: {front", "detectors: {rear", "detectors.front is missing: what is to be"),
        ("radius_m: 0.1", "raduis_m: 0.1", "unknown key 'raduis_m'; the nearest known key is"),
        (
            "z_m: 1, pitch",
            "z_m: 1, measures: pose, pitch",
            "which needs detectors.front",
        ),
        ("z_m: 1, pitch_rad: 0.3,", "measures: walls,", "intrinsics"),
    ],
)
def test_a_wrong_configuration_says_the_key(folder: Path, before, after, words: str):
    assert before in ROBOT
    (folder / "robot.yaml").write_text(ROBOT.replace(before, after, 1))
    result = pilotage_camera(*CONFIG, "front=front", "-o", "found.lcmlog", cwd=folder)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    assert words in result.stderr


def test_the_drives_log_is_not_written_over(folder: Path):
    (folder / "drive.lcmlog").write_bytes(b"")
    options = ("--merge", "drive.lcmlog", "-o", "drive.lcmlog")
    result = pilotage_camera(*CONFIG, "front", *options, cwd=folder)
    assert result.returncode == 2
    assert "-o drive.lcmlog is the drive's log itself" in result.stderr


def test_help_tells_what_it_does():
    result = pilotage_camera("--help", env={**os.environ, "COLUMNS": "200"})
    assert result.returncode == 0
    for words in ("NAME=INPUT", "--poses", "--merge", "--follow", "--save-video", "Ctrl-C"):
        assert words in result.stdout


def test_the_version_is_told():
    result = pilotage_camera("--version")
    assert result.stdout == f"pilotage-camera {pilotage.__version__}\n"


def test_without_opencv_the_way_out_is_told(folder: Path):
    (folder / "cv2.py").write_text("raise ImportError(\"No module named 'cv2'\")\n")
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    result = pilotage_camera(*CONFIG, "front", "-o", "f.lcmlog", cwd=folder, env=environment)
    assert result.returncode == 2
    assert "pilotage-camera needs OpenCV" in result.stderr
    assert "pip install 'pilotage[camera]'" in result.stderr


def test_pilotage_itself_does_not_need_opencv():
    program = "import sys, pilotage.cli.main, pilotage.cli.camera; sys.exit('cv2' in sys.modules)"
    import subprocess

    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0
