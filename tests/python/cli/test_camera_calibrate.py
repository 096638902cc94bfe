"""`pilotage camera-calibrate`, as a user types it."""

from dataclasses import replace

import cv2
import numpy as np
import pytest
import yaml

from pilotage import CameraModel, Recording, lcmtypes
from pilotage.simulate import find_scenario
from pilotage.simulate.pictures import take_pictures
from support.boards import BoardCamera, charuco, stances
from support.command import pilotage

BOARD = "charuco 7x5 0.04 0.03 4x4_50"


@pytest.fixture(scope="module")
def boards(tmp_path_factory):
    """Pictures of a ChArUco board, and one of nothing."""
    folder = tmp_path_factory.mktemp("boards")
    rng = np.random.default_rng(2)
    camera, texture = BoardCamera(), charuco(7, 5, 0.75, cv2.aruco.DICT_4X4_50)
    for k, (turn, place) in enumerate(stances(8, (2.5, 1.5), rng, far=(4.0, 7.0))):
        picture = camera.look(texture, 0.04, turn, 0.04 * place, rng=rng)
        cv2.imwrite(str(folder / f"{k}.png"), picture)
    cv2.imwrite(str(folder / "wall.png"), np.full((240, 320), 90, np.uint8))
    return folder


@pytest.fixture(scope="module")
def drive(tmp_path_factory):
    """A rendered drive past discs, seen by one camera, and a configuration that is a bit off."""
    folder = tmp_path_factory.mktemp("drive")
    scenario = find_scenario("mower-cameras")
    scene = replace(scenario.scene, cameras=scenario.scene.cameras[:1])
    take_pictures(
        replace(scenario, scene=scene, duration_s=90.0), np.random.default_rng(1), folder, jobs=2
    )
    text = (folder / "robot.yaml").read_text()
    for true, wrong in (("x_m: 0.5", "x_m: 0.45"), ("y_m: 0\n", "y_m: 0.02\n")):
        text = text.replace(f"    {true}", f"    {wrong}", 1)
    (folder / "off.yaml").write_text(text.replace("pitch_rad: 0.22", "pitch_rad: 0.2"))
    return folder


def test_a_lens_from_pictures(boards, tmp_path):
    file = tmp_path / "front.yaml"
    done = pilotage(
        "camera-calibrate", "intrinsics", boards, "--board", BOARD, "-o", file,
        "--coefficients", 4,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert "8 pictures of 320 by 240 with the board" in done.stdout
    assert f"not in {boards}/wall.png" in done.stdout
    assert "reprojection error 0.0" in done.stdout
    assert "views: the board was found in 8 pictures" in done.stdout
    for name in ("fx", "cy", "k1", "p2"):
        assert f"\n  {name} " in done.stdout
    storage = cv2.FileStorage(str(file), cv2.FILE_STORAGE_READ)
    assert storage.getNode("camera_matrix").mat()[0, 0] == pytest.approx(260, abs=3)
    assert cv2.imread(str(tmp_path / "front.png")) is not None


def test_a_lens_from_a_video(boards, tmp_path):
    video = tmp_path / "board.avi"
    writer = cv2.VideoWriter(str(video), cv2.VideoWriter_fourcc(*"MJPG"), 1.0, (320, 240))
    for k in range(4):
        writer.write(cv2.imread(str(boards / f"{k}.png")))
    writer.release()
    done = pilotage(
        "camera-calibrate", "intrinsics", video, "--board", BOARD, "-o", tmp_path / "front.yaml"
    )
    assert done.returncode == 0, done.stderr
    assert "4 pictures of 320 by 240 with the board" in done.stdout


@pytest.mark.parametrize(
    ("inputs", "board", "said"),
    [
        (["nowhere"], BOARD, "nowhere: no picture is there"),
        (["0.png", "1.png"], BOARD, "found in 2 pictures, at least 3 are needed"),
        (["wall.png"], BOARD, "in none of the pictures: there is no tag of 4x4_50"),
        (["[0-3].png"], "chessboard 9x6 0.025", "in none of the pictures: is all of it in view"),
        (["0.png"], "chess", "--board is 'chess', expected 'chessboard"),
        (["text.png"], BOARD, "text.png cannot be read as a picture"),
    ],
)
def test_what_is_no_use_is_told_in_a_line(boards, inputs, board, said):
    (boards / "text.png").write_text("no picture")
    try:
        done = pilotage("camera-calibrate", "intrinsics", *inputs, "--board", board, cwd=boards)
    finally:
        (boards / "text.png").unlink()
    assert done.returncode == 2
    assert done.stderr.startswith("pilotage: ")
    assert said in done.stderr
    assert done.stderr.count("\n") == 1
    assert not (boards / "camera.yaml").exists()


def test_a_mounting_from_the_pictures_of_a_drive(drive, tmp_path):
    done = pilotage(
        "camera-calibrate", "extrinsics", drive / "off.yaml", drive / "drive.lcmlog",
        "--pictures", drive / "front", "-o", tmp_path,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    lines = yaml.safe_load((tmp_path / "extrinsics.yaml").read_text())["sensors"]["front"]
    assert "\n    pitch_rad: 0.22" in done.stdout
    truth = {"x_m": 0.5, "y_m": 0.0, "z_m": 1.2, "roll_rad": 0.0, "pitch_rad": 0.22, "yaw_rad": 0.0}
    assert set(lines) == set(truth)
    for key, value in truth.items():
        assert lines[key] == pytest.approx(value, abs=2e-3 if key.endswith("_m") else 2e-4), key
    assert cv2.imread(str(tmp_path / "extrinsics.png")) is not None


@pytest.mark.parametrize("kind", ["pixels", "markers"])
def test_a_mounting_from_what_a_log_has_of_the_camera(drive, tmp_path, kind):
    """Both kinds of frames, made of the same exact pixels and of poses that a node sent."""
    ideal = Recording.load(str(drive / "ideal.lcmlog"))
    log = Recording()
    for k in range(len(ideal)):
        received, channel, data = ideal[k]
        if channel == "MARKERS":
            data = _as_seen(lcmtypes.marker_frame_t.decode(data), kind == "pixels")
        if channel == "REFERENCE":
            true = lcmtypes.reference_t.decode(data)
            pose = lcmtypes.pose_t()
            pose.utime, pose.x, pose.y, pose.heading = true.utime, true.x, true.y, true.heading
            channel, data = "POSE", pose.encode()
        log.add(received, channel, data)
    log.save(str(tmp_path / "drive.lcmlog"))
    done = pilotage(
        "camera-calibrate", "extrinsics", drive / "off.yaml", tmp_path / "drive.lcmlog",
        "--sensor", "front",
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found = yaml.safe_load(done.stdout[done.stdout.index("sensors:") :])["sensors"]["front"]
    assert found["x_m"] == pytest.approx(0.5, abs=1e-4)
    assert found["y_m"] == pytest.approx(0.0, abs=1e-4)
    assert found["pitch_rad"] == pytest.approx(0.22, abs=1e-5)


def _as_seen(frame, as_pixels):
    """A frame as a camera of the wrong configuration sends it: right pixels, its own angles."""
    scene = find_scenario("mower-cameras").scene.cameras[0]
    told = CameraModel(scene.model.size, scene.model.matrix, list(scene.model.distortion), 0.0, 0.2)
    bearing, elevation = np.array([(s.bearing, s.elevation) for s in frame.sightings]).T
    flat = np.cos(elevation)
    rays = np.column_stack([flat * np.cos(bearing), flat * np.sin(bearing), np.sin(elevation)])
    pixels = scene.model.project(rays)
    if not as_pixels:
        for sighting, angles in zip(frame.sightings, told.angles(pixels), strict=True):
            sighting.bearing, sighting.elevation = angles
        return frame.encode()
    made = lcmtypes.pixel_frame_t()
    made.utime, made.seq, made.sensor, made.n = frame.utime, frame.seq, frame.sensor, frame.n
    for sighting, (u, v) in zip(frame.sightings, pixels, strict=True):
        one = lcmtypes.pixel_observation_t()
        one.id, one.label, one.u, one.v = sighting.id, -1, u, v
        one.sigma_u = one.sigma_v = np.nan
        made.observations.append(one)
    return made.encode()


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ([], "the log has no pixels, nor bearings with elevations, of 'front'"),
        (["--sensor", "fornt"], "no sensor is called 'fornt'; there are front"),
        (["--hold", "x_cm"], "unknown key 'x_cm'; the nearest known key is 'x_m'"),
        (["--hold", "x_m,y_m,z_m,roll_rad,pitch_rad,yaw_rad"], "all parameters are held"),
        (["--radius", "0"], "--radius is 0, expected"),
        (["--pictures", "empty"], "no images there"),
    ],
)
def test_what_a_drive_lacks_is_told_in_a_line(drive, tmp_path, more, said):
    (tmp_path / "empty").mkdir()
    log = drive / ("ideal" if "all parameters" in said else "drive")
    done = pilotage(
        "camera-calibrate", "extrinsics", drive / "off.yaml", f"{log}.lcmlog", *more, cwd=tmp_path
    )
    assert done.returncode == 2
    assert said in done.stderr
    assert done.stderr.count("\n") == 1
