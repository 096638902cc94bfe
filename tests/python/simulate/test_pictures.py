"""A folder of pictures: what is in it, and that it is the same for the same seed."""

from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from pilotage import Recording, load_config, replay
from pilotage.simulate import Scenario, find_scenario, measure, parse_scenario
from pilotage.simulate.pictures import take_pictures
from pilotage.simulate.render import Renderer
from pilotage.simulate.view import in_view
from support.messages import messages

CAMERA = {
    "z_m": 0.3,
    "pitch_rad": 0.1,
    "size": [64, 48],
    "focal_px": [50, 52],
    "distortion": [-0.1, 0.02, 0.001, 0],
    "rate_hz": 4,
    "noise": 3,
}
SMALL: dict[str, Any] = {
    "site": [{"id": 4, "x": 3, "y": 1}, {"id": 6, "x": 3, "y": -0.5}],
    "drive": {"waypoints": [[0, 0], [1, 0]], "speed_m_s": 0.5},
    "duration_s": 2,
    "cameras": {"front": CAMERA, "rear": {**CAMERA, "yaw_rad": 3.1, "pictures": "jpg"}},
    "world": {"markers": {"kind": "discs"}},
}


def small(camera: dict[str, Any] | None = None, **changes: Any) -> Scenario:
    """Two cameras of a few pixels; `camera` changes the first."""
    cameras = {**SMALL["cameras"], "front": CAMERA | (camera or {})}
    return parse_scenario({**SMALL, "cameras": cameras, **changes}, "small")


def take(folder: Path, scenario: Scenario | None = None, seed: int = 1, jobs: int = 1):
    return take_pictures(scenario or small(), np.random.default_rng(seed), folder, jobs)


def files(folder: Path) -> dict[str, bytes]:
    return {
        str(file.relative_to(folder)): file.read_bytes()
        for file in folder.rglob("*")
        if file.is_file()
    }


def test_a_folder_has_pictures_by_time_and_the_robots_files(tmp_path):
    front, rear = take(tmp_path)
    there = set(files(tmp_path))
    pictures = {f"front/{t}.png" for t in front.utime} | {f"rear/{t}.jpg" for t in rear.utime}
    rest = {"front.yaml", "rear.yaml", "robot.yaml", "markers.yaml"}
    assert there == pictures | rest | {"drive.lcmlog", "ideal.lcmlog"}
    assert len(front.utime) == 8
    assert set(np.diff(front.utime)) == {250_000}
    assert cv2.imread(str(tmp_path / "rear" / f"{rear.utime[0]}.jpg")).shape == (48, 64, 3)


def test_a_seed_gives_the_same_files_however_many_draw(tmp_path, monkeypatch):
    monkeypatch.setattr("pilotage.simulate.pictures.CHUNK", 3)
    for name, seed, jobs in (("a", 1, 1), ("b", 1, 2), ("c", 2, 1)):
        take(tmp_path / name, seed=seed, jobs=jobs)
    a, b, c = (files(tmp_path / name) for name in "abc")
    assert a == b
    assert not {file for file in a if a[file] == c.get(file)} - {
        "front.yaml",
        "rear.yaml",
        "markers.yaml",
        "robot.yaml",
    }


def test_a_picture_is_what_is_seen_from_where_the_robot_is_at_its_stamp(tmp_path):
    scenario = small(camera={"noise": 0})
    front, _ = take(tmp_path, scenario)
    measured = measure(scenario, np.random.default_rng(1))
    world = scenario.scene.world(measured.true_markers)
    drawn = Renderer(front.camera.model, front.camera.mounting, world).draw(
        measured.drive.at(front.utime[5:6])[0]
    )
    picture = cv2.imread(str(tmp_path / "front" / f"{front.utime[5]}.png"))
    assert (picture == np.rint(drawn)).all()


def test_a_long_exposure_smears_what_moves(tmp_path):
    turning = {
        "drive": {"name": "circle", "radius_m": 0.5, "speed_m_s": 0.5},
        "site": [{"id": 1, "x": 0.3, "y": 3}],
    }
    spread = []
    for name, exposure_s in (("short", 0.0), ("long", 0.1)):
        camera = {"noise": 0, "exposure_s": exposure_s, "rate_hz": 10}
        front, _ = take(tmp_path / name, small(camera, **turning))
        pictures = [cv2.imread(str(tmp_path / name / "front" / f"{t}.png")) for t in front.utime]
        light = np.array([image[..., 2].astype(float) - image[..., 1] for image in pictures])
        spread.append(light[light > 0].max())
    assert spread[1] < 0.9 * spread[0]


def test_the_robots_files_are_read_and_say_what_was_drawn(tmp_path):
    front, rear = take(tmp_path)
    config = load_config(str(tmp_path / "robot.yaml"))
    assert config.map.ids.tolist() == [4, 6]
    points = np.array([[3.0, 0.5, -0.2], [2.0, -0.7, 0.1]])
    for one in (front, rear):
        np.testing.assert_allclose(
            config.camera(one.camera.name).project(points), one.camera.model.project(points)
        )
    assert config["sensors.rear.yaw_rad"] == 3.1
    assert config["sensors.front.sigma_pixel"] == 0.5
    discs = {"kind": "discs", "radius_m": 0.2, "colour": "red"}
    assert config.detectors == {"front": discs, "rear": discs}


def test_opencv_reads_the_intrinsics(tmp_path):
    front, _ = take(tmp_path)
    storage = cv2.FileStorage(str(tmp_path / "front.yaml"), cv2.FILE_STORAGE_READ)
    matrix = storage.getNode("camera_matrix").mat()
    assert (matrix[0, 0], matrix[1, 1], *matrix[:2, 2]) == front.camera.model.matrix
    assert storage.getNode("distortion_coefficients").mat().ravel().tolist() == [
        *front.camera.distortion,
        0.0,
    ]
    assert int(storage.getNode("image_width").real()) == 64


def test_the_drive_has_no_sightings_and_the_ideal_one_those_of_the_pictures(tmp_path):
    front, _ = take(tmp_path)
    drive, ideal = (
        messages(Recording.load(str(tmp_path / f"{name}.lcmlog"))) for name in ("drive", "ideal")
    )
    assert {*drive} == {"ENCODERS", "GYRO", "REFERENCE"}
    frames = [frame for frame in ideal["MARKERS"] if frame.sensor == "front"]
    assert sum(frame.n for frame in frames) == len(front.ideal) > 8
    measured = measure(small(), np.random.default_rng(1))
    exact = front.camera.sensor().look_at_all(
        measured.drive, measured.true_markers, front.ideal.utime
    )
    which = np.searchsorted(measured.markers.ids, front.ideal.id)
    np.testing.assert_allclose(
        front.ideal.value[:, :2], exact[np.arange(len(which)), which, :2], atol=1e-9
    )


def test_the_ideal_drive_replays_to_the_truth(tmp_path):
    scenario = small(duration_s=10)
    take(tmp_path, scenario)
    config = load_config(str(tmp_path / "robot.yaml"))
    run = replay(config, Recording.load(str(tmp_path / "ideal.lcmlog")))
    truth = measure(scenario, np.random.default_rng(1)).drive
    off = run.poses["x"] - truth.at(run.poses["utime"])[:, 0]
    assert np.abs(off[len(off) // 2 :]).max() < 0.02


def test_a_tag_behind_another_or_with_its_back_is_not_in_view():
    tags = [{"id": i, "x": x, "y": 0, "z": 0.3} for i, x in ((1, 2), (2, 3), (3, -2))]
    yaws = {1: np.pi, 2: np.pi, 3: np.pi}
    seen = []
    for site in (tags, tags[1:]):
        world = {"markers": {"kind": "tags", "size_m": 0.4, "yaw_rad": yaws}}
        scenario = small({"pitch_rad": 0.0}, site=site, world=world)
        measured = measure(scenario, np.random.default_rng(1))
        there = scenario.scene.world(measured.true_markers)
        first = measured.drive.utime[:1]
        seen.append(
            [
                in_view(camera, there, measured, first).id.tolist()
                for camera in scenario.scene.cameras
            ]
        )
    assert seen == [[[1], []], [[2], []]]


def test_pictures_are_not_mixed_with_others(tmp_path):
    take(tmp_path)
    with pytest.raises(ValueError, match="front is not empty: name another folder"):
        take(tmp_path)


def test_a_scenario_without_cameras_is_told_how_to_have_some(tmp_path):
    with pytest.raises(ValueError, match=r"yard has no cameras .* docs/camera-rendered\.md"):
        take(tmp_path, find_scenario("yard"))
