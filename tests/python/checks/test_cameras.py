"""`pilotage check` on cameras: what pilotage-camera would refuse."""

import sys

import pytest

import pilotage
from pilotage.checks import check_config, summarize
from pilotage.checks.cameras import detector_wrong

LENS = """{image_width: 640, image_height: 480,
  camera_matrix: {rows: 3, cols: 3, data: [320, 0, 319.5, 0, 320, 239.5, 0, 0, 1]},
  distortion_coefficients: {rows: 1, cols: 4, data: [0, 0, 0, 0]}}"""


def config(detectors: str, sensor: str = "") -> pilotage.Config:
    front = f"front: {{x_m: 0.2, z_m: 1, pitch_rad: 0.35, intrinsics: {LENS}, {sensor}}}"
    return pilotage.Config.parse(
        f"map: [{{id: 1, x: 1, y: 2}}]\nsensors: {{{front}}}\ndetectors: {detectors}"
    )


def test_a_sound_detector_is_no_finding():
    sound = config("{front: {kind: discs, radius_m: 0.1, sigma_pitch_rad: 0.01}}")
    assert not list(detector_wrong(sound))
    assert not list(detector_wrong(config("{}")))


@pytest.mark.parametrize(
    ("detectors", "sensor", "key", "words"),
    [
        ("{front: {kind: discs}}", "", "detectors.front", "'radius_m' is missing"),
        ("{front: {kind: disks, radius_m: 1}}", "", "detectors.front", "expected one of discs"),
        ("{front: {kind: tags, dictionary: 5x4}}", "", "detectors.front", "the nearest known one"),
        ("{rear: {kind: discs, radius_m: 1}}", "", "detectors.rear", "there is no sensor of this"),
        (
            "{front: {kind: tags, dictionary: 4x4_50, size_m: 0.1}}",
            "measures: pose",
            "detectors.front",
            "which needs detectors.front to be of kind tags with size_m and yaw_rad",
        ),
    ],
)
def test_what_the_program_would_refuse_is_a_finding(detectors, sensor, key, words):
    [finding] = [f for f in check_config(config(detectors, sensor)) if f.key.startswith("detect")]
    assert finding.key == key
    assert words in finding.problem
    assert not finding.note


def test_without_opencv_it_is_said_that_nothing_was_checked(monkeypatch):
    for name in [name for name in sys.modules if name.startswith("pilotage.camera")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "cv2", None)
    [finding] = detector_wrong(config("{front: {kind: discs}}"))
    assert finding.note
    assert "pilotage[camera]" in finding.remedy


@pytest.mark.parametrize(
    ("measures", "words"), [("markers", "bearing"), ("pixels", "u and v 1 px"), ("pose", "fixes")]
)
def test_a_camera_is_said_in_words(measures: str, words: str):
    chosen = config("{front: {kind: discs, radius_m: 0.1}}", f"measures: {measures}")
    lines = summarize(chosen)["sensors"]
    assert any(words in line for line in lines)
    assert (
        "camera of 640 by 480 px, 90° across, pitched 20.1° down, rolled 0°; finds discs"
        in (lines[-1])
    )
