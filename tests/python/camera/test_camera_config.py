"""Cameras in the configuration: calibration files, the section that the node passes over."""

import numpy as np
import pytest

import pilotage

OPENCV = """%YAML:1.0
---
calibration_time: "Tue 12 Nov 2025"
image_width: 640
image_height: 480
flags: 0
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 6.1e+02, 0., 3.225e+02, 0., 6.05e+02, 2.38e+02, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -2.8e-01, 9.0e-02, 1.2e-03, -7.0e-04, 1.0e-02 ]
"""
ROS = """image_width: 640
image_height: 480
camera_name: front
camera_matrix:
  rows: 3
  cols: 3
  data: [610, 0, 322.5, 0, 605, 238, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.28, 0.09, 0.0012, -0.0007, 0.01]
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
"""
ROBOT = """map: [{id: 1, x: 1, y: 2}]
sensors:
  front: {x_m: 0.2, z_m: 0.9, roll_rad: 0.02, pitch_rad: 0.3, intrinsics: front.yaml,
          sigma_pixel: 0.5, measures: MEASURES}
"""


def load(folder, calibration=OPENCV, robot=ROBOT, measures="pixels"):
    (folder / "front.yaml").write_text(calibration)
    (folder / "robot.yaml").write_text(robot.replace("MEASURES", measures))
    return pilotage.load_config(str(folder / "robot.yaml"))


@pytest.mark.parametrize("calibration", [OPENCV, ROS])
@pytest.mark.parametrize("measures", ["markers", "pixels", "pose"])
def test_the_camera_is_that_of_the_file(tmp_path, calibration, measures):
    camera = load(tmp_path, calibration, measures=measures).camera("front")
    assert camera.size == (640, 480)
    assert camera.matrix == (610, 605, 322.5, 238)
    assert camera.distortion == [-0.28, 0.09, 0.0012, -0.0007, 0.01, 0, 0, 0]
    assert (camera.roll_rad, camera.pitch_rad) == (0.02, 0.3)


def test_what_opencv_writes_is_read(tmp_path):
    cv2 = pytest.importorskip("cv2")
    storage = cv2.FileStorage(str(tmp_path / "front.yaml"), cv2.FILE_STORAGE_WRITE)
    storage.write("image_width", 640)
    storage.write("image_height", 480)
    storage.write("camera_matrix", np.array([[610, 0, 322.5], [0, 605, 238], [0, 0, 1.0]]))
    storage.write("distortion_coefficients", np.array([[-0.28, 0.09, 0.0012, -0.0007]]))
    storage.release()
    camera = load(tmp_path, (tmp_path / "front.yaml").read_text()).camera("front")
    assert camera.matrix == (610, 605, 322.5, 238)
    assert camera.distortion[:4] == [-0.28, 0.09, 0.0012, -0.0007]


def test_a_written_configuration_needs_no_file_any_more(tmp_path):
    config = load(tmp_path)
    config.detectors = {"front": {"kind": "discs", "hue": [1, 2]}}
    text = config.to_yaml()
    again = pilotage.Config.parse(text)
    assert again.to_yaml() == text
    assert again.camera("front").distortion == config.camera("front").distortion
    assert again.camera("front").pitch_rad == 0.3
    assert again.detectors == {"front": {"kind": "discs", "hue": [1, 2]}}


def test_a_camera_can_be_set_and_turned_in_memory():
    config = pilotage.Config()
    config["sensors.front.measures"] = "pixels"
    assert config.camera("front") is None
    assert config.pixel_sensors == ["front"]
    config.set_camera("front", pilotage.CameraModel((64, 48), (50, 50, 32, 24), pitch_rad=0.4))
    assert config["sensors.front.pitch_rad"] == 0.4
    config["sensors.front.pitch_rad"] = 0.1
    assert config.camera("front").pitch_rad == 0.1
    assert config.camera("front").size == (64, 48)
    with pytest.raises(ValueError, match="set_camera"):
        config["sensors.front.intrinsics"] = "front.yaml"
    with pytest.raises(KeyError, match="rear"):
        config.camera("rear")


def test_the_section_of_detectors_is_passed_over_as_it_stands(tmp_path):
    robot = ROBOT + "detectors: {front: {kind: tags, size_m: 0.2, deep: [{a: yes, b: '007'}, ~]}}\n"
    config = load(tmp_path, robot=robot)
    assert config.detectors == {
        "front": {"kind": "tags", "size_m": 0.2, "deep": [{"a": True, "b": "007"}, None]}
    }
    assert pilotage.Config.parse(config.to_yaml()).detectors == config.detectors
    assert pilotage.Config().detectors == {}


@pytest.mark.parametrize(
    ("section", "word"),
    [
        ("detectors: {a: {b: 1, b: 2}}", "'b' comes twice"),
        ("detectors: 3", "'detectors' is a section"),
        ("detectors: &a {a: *a}", "nested too deep"),
    ],
)
def test_a_section_of_detectors_that_cannot_be_kept_is_refused(section, word):
    with pytest.raises(pilotage.ConfigError, match=word):
        pilotage.Config.parse(section)


@pytest.mark.parametrize(
    ("old", "new", "word"),
    [
        ("image_width: 640\n", "", "front.yaml:.*'image_width' is missing"),
        ("image_height: 480", "image_height: 0", "image size is 640 x 0"),
        ("image_height: 480", "image_height: 4.5", "image_height is '4.5'"),
        ("camera_matrix:", "matrix:", "'camera_matrix' is missing"),
        ("6.1e+02, 0.,", "6.1e+02, 0., 0.,", "camera_matrix has 10 numbers"),
        ("6.1e+02, 0.,", "6.1e+02, 2.,", "camera_matrix is not of the form"),
        ("6.1e+02", "-1", "fx is -1"),
        ("6.1e+02", ".Nan", "front.yaml:11: camera_matrix is '.Nan', expected a finite number"),
        ("-2.8e-01, 9.0e-02, ", "", "there are 3 distortion coefficients, expected 4"),
        ("-2.8e-01", "much", "distortion_coefficients is 'much'"),
        (
            "distortion_coefficients:",
            "distortion_model: fisheye\ndistortion_coefficients:",
            "distortion_model is 'fisheye', expected plumb_bob",
        ),
        ("flags: 0", "image_width: 640", "'image_width' comes twice"),
        (OPENCV, "- 1\n", "a camera's calibration has the keys"),
        (OPENCV, "{", "not YAML"),
    ],
)
def test_a_calibration_that_cannot_be_used_is_named_with_its_file(tmp_path, old, new, word):
    with pytest.raises(pilotage.ConfigError, match=word) as error:
        load(tmp_path, OPENCV.replace(old, new))
    assert "front.yaml" in str(error.value)


def test_a_file_that_is_not_there_is_named(tmp_path):
    (tmp_path / "robot.yaml").write_text(ROBOT.replace("MEASURES", "markers"))
    with pytest.raises(pilotage.ConfigError, match=r"front\.yaml: cannot be opened"):
        pilotage.load_config(str(tmp_path / "robot.yaml"))


def test_a_scanner_of_walls_has_no_camera():
    with pytest.raises(pilotage.ConfigError, match=r"unknown key 'sensors\.laser\.pitch_rad'"):
        pilotage.Config.parse("sensors: {laser: {measures: walls, pitch_rad: 0.1}}")
