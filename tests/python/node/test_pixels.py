"""A robot whose camera's program knows nothing of the pose, live: pixels in, poses out."""

import math
import time
from pathlib import Path

import numpy as np
import pytest

import pilotage
from pilotage.lcmtypes import pixel_frame_t, pixel_observation_t, status_t
from pilotage.logs import Log
from pilotage.replaying import recorded_config
from support.bus import Node, node
from support.driving import MARKERS, TRACK_M, Robot

NAN = math.nan
HEIGHT_M, PITCH_RAD = 1.0, 0.1
SIZE, FOCAL_PX = (640, 480), 200.0  # wide: there are four markers only

CALIBRATION = f"""%YAML:1.0
---
image_width: {SIZE[0]}
image_height: {SIZE[1]}
camera_matrix: !!opencv-matrix
   {{rows: 3, cols: 3, dt: d, data: [{FOCAL_PX}, 0., 320., 0., {FOCAL_PX}, 240., 0., 0., 1.]}}
distortion_coefficients: !!opencv-matrix
   {{rows: 1, cols: 5, dt: d, data: [-0.02, 0., 0.001, 0., 0.]}}
"""
CONFIG = f"""
map: [{", ".join(f"{{id: {i}, x: {x}, y: {y}, z: 0.5}}" for i, (x, y) in MARKERS.items())}]
encoders: {{left_m_per_tick: 0.001, right_m_per_tick: 0.001, track_width_m: {TRACK_M}}}
filter: FILTER
detectors: {{film: {{kind: discs}}}}
sensors:
  film: {{measures: pixels, x_m: 0.2, z_m: {HEIGHT_M}, yaw_rad: 0.3, pitch_rad: {PITCH_RAD},
          intrinsics: film.yaml, sigma_pixel: 0.5, association_radius_pixel: RADIUS}}
"""
START = "initial: {x_m: 0.1, y_m: -0.1, heading_rad: 0.03, sigma_position_m: 0.2}\n"


class Film:
    """What the camera sees, half a pixel noisy."""

    def __init__(self, ids: bool):
        self.ids = ids
        self.camera = pilotage.CameraModel(
            SIZE, (FOCAL_PX, FOCAL_PX, 320, 240), (-0.02, 0, 0.001, 0), pitch_rad=PITCH_RAD
        )
        self.rng = np.random.default_rng(3)
        self.frames = self.sent = 0

    def __call__(self, robot: Robot) -> pixel_frame_t:
        x, y, heading = robot.pose(robot.utime)
        x, y = x + 0.2 * math.cos(heading), y + 0.2 * math.sin(heading)
        c, s = math.cos(heading + 0.3), math.sin(heading + 0.3)
        message = pixel_frame_t()
        message.utime, message.seq, message.sensor = robot.utime, self.frames, "film"
        for marker, (mx, my) in MARKERS.items():
            dx, dy = mx - x, my - y
            [uv] = self.camera.project([[c * dx + s * dy, c * dy - s * dx, 0.5 - HEIGHT_M]])
            uv += 0.5 * self.rng.standard_normal(2)
            if np.all(uv >= 0) and np.all(uv < np.array(SIZE) - 1):
                message.observations.append(observation(marker if self.ids else -1, *uv))
        message.n = len(message.observations)
        self.frames += 1
        self.sent += message.n
        return message


def observation(marker: int, u: float, v: float) -> pixel_observation_t:
    o = pixel_observation_t()
    o.id, o.label, o.u, o.v, o.sigma_u, o.sigma_v = marker, -1, u, v, NAN, NAN
    return o


def configured(folder: Path, start: str = START, filter: str = "ekf", radius: float = 0) -> str:
    (folder / "film.yaml").write_text(CALIBRATION)
    return start + CONFIG.replace("FILTER", filter).replace("RADIUS", str(radius))


def drive(running: Node, robot: Robot, film: Film, steps: int) -> None:
    """Send motion at every step, an image at every fifth."""
    first = robot.step
    for step in range(first, first + steps):
        if step % 5 == 2:
            running.send("PIXELS", film(robot))
        for channel, message in robot.messages(sightings=False):
            running.send(channel, message)
        if (robot.step - first) % 100 == 0:  # no faster than it can be read
            poses = running.messages["POSE"]
            running.wait(
                lambda poses=poses: poses and poses[-1].utime == robot.utime - robot.period_us,
                "the newest pose",
            )


@pytest.mark.parametrize(
    ("ids", "radius", "filter"),
    [(True, 0, "ekf"), (False, 0, "ekf"), (False, 0, "ukf"), (False, 64, "ekf")],
)
def test_pixels_localize_a_robot_and_its_recording_needs_no_other_file(
    tmp_path: Path, ids: bool, radius: float, filter: str
):
    log, robot, film = str(tmp_path / "run.lcmlog"), Robot(), Film(ids)
    with node(tmp_path, configured(tmp_path, START, filter, radius), "--record", log) as running:
        drive(running, robot, film, 900)
        newest = running.messages["POSE"][-1]
        assert robot.distance(newest) < 0.05
        assert newest.status == status_t.OK
        running.process.terminate()
        assert running.process.wait(timeout=10) == 0
    (tmp_path / "film.yaml").unlink()
    (tmp_path / "robot.yaml").unlink()
    recorded = pilotage.Recording.load(log)
    config = recorded_config(Log("lcm", recorded, truth=None, map=None))
    assert config is not None
    assert config.camera("film").matrix == (FOCAL_PX, FOCAL_PX, 320, 240)
    assert config.detectors == {"film": {"kind": "discs"}}
    run = pilotage.replay(config, recorded, keep_messages=True)
    for channel in ("POSE", "MARKER_REPORT"):
        assert run.published.messages(channel) == recorded.messages(channel)
    assert film.sent > 150
    assert run.reports["accepted"].sum() > 0.9 * film.sent


def test_pixels_alone_find_the_pose(tmp_path: Path):
    robot, film = Robot(), Film(ids=True)
    with node(tmp_path, configured(tmp_path, start="")) as running:
        for _ in range(30):
            if robot.step > 0 and running.messages["POSE"]:
                break
            drive_blind(running, robot, film, 50)
        drive(running, robot, film, 900)
        newest = running.messages["POSE"][-1]
        assert robot.distance(newest) < 0.1
        assert newest.status == status_t.OK


def drive_blind(running: Node, robot: Robot, film: Film, steps: int) -> None:
    """The same where no pose may come yet."""
    for _ in range(steps):
        if robot.step % 5 == 2:
            running.send("PIXELS", film(robot))
        for channel, message in robot.messages(sightings=False):
            running.send(channel, message)
    running.bus.handle_timeout(200)


def test_bad_pixels_are_counted_by_their_reason(tmp_path: Path):
    robot, film = Robot(), Film(ids=True)
    with node(tmp_path, configured(tmp_path)) as running:
        drive(running, robot, film, 100)
        before = film.sent
        bad = film(robot)
        bad.observations = [
            observation(1, NAN, 5.0),
            observation(1, -3.0, 5.0),
            observation(2, 5.0, 480.0),
            observation(77, 5.0, 5.0),
        ]
        bad.n = 4
        running.send("PIXELS", bad)
        stranger = film(robot)
        stranger.sensor = "rear"
        running.send("PIXELS", stranger)
        film.sent = before
        drive(running, robot, film, 100)
        running.wait(lambda: "rear" in running.said, "words")
        [status] = [
            entry for entry in running.status_after(time.time()).inputs if entry.name == "film"
        ]
        rejected = {r.reason: r.count for r in status.rejected}
        for reason, count in {"bad_value": 1, "outside_image": 2, "unknown_marker": 1}.items():
            assert rejected.pop(reason) == count
        assert rejected.pop("unknown_sensor") == 1
        assert status.received == status.fused + status.pending + sum(rejected.values()) + 5


def test_a_camera_without_calibration_is_said_at_the_start(tmp_path: Path):
    config = configured(tmp_path).replace("intrinsics: film.yaml, ", "")
    with pytest.raises(AssertionError), node(tmp_path, config) as running:
        running.wait(lambda: running.process.poll() is None, "nothing", 0.1)
    assert "'sensors.film.intrinsics' is missing" in (tmp_path / "said.txt").read_text()
