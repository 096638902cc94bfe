"""Recorded images to logs: association by the first paper, frames in the log of a drive."""

from dataclasses import replace

import numpy as np
import pytest

from pilotage import CameraModel, Config, MarkerMap, Recording
from pilotage.camera.association import RADIUS_PIXEL, associated, radius_pixel
from pilotage.camera.detection import Detection
from pilotage.camera.eye import Eye
from pilotage.camera.frame import Frame
from pilotage.camera.mounting import MountingNoise
from pilotage.camera.offline import Found, as_log, find, merged
from pilotage.camera.poses import Poses
from pilotage.camera.shutter import Shutter
from pilotage.camera.tally import Tally
from pilotage.lcmtypes import marker_frame_t
from pilotage.simulate.view import sight

CAMERA = CameraModel((640, 480), (500, 500, 319.5, 239.5), pitch_rad=0.3)
MOUNTING = (0.3, 0.1, 1.0, 0.2)
MARKERS = MarkerMap([5, 6, 7], [[4.0, 1.0, 0], [5.0, 0.0, 0], [7.0, 2.0, 0]], labels=[1, 2, 1])
POSE = np.array([0.4, -0.2, 0.05])
IMAGE = np.zeros((480, 640, 3), np.uint8)


class Fixed:
    def __init__(self, *detections: Detection):
        self.detections = detections

    def detect(self, image):
        return list(self.detections)


def eye(*detections: Detection, measures: str = "markers") -> Eye:
    found = Fixed(*detections)
    return Eye("front", CAMERA, found, MountingNoise(), Shutter(), measures, "MARKERS", MOUNTING)


def shown(marker: int, off: tuple[float, float] = (0, 0), **more) -> Detection:
    """A detection so many pixels beside where a marker shows from the pose."""
    place, rotation = sight(MOUNTING, POSE)
    [point] = MARKERS.positions[MARKERS.ids == marker]
    [pixel] = CAMERA.project((point - place)[None] @ rotation)
    return Detection(pixel + off, np.eye(2), **more)


def ids(*detections: Detection, radius: float = 64) -> list[int]:
    return [one.id for one in associated(eye(), detections, POSE, MARKERS, radius)]


def test_the_nearest_projection_within_the_radius_gives_the_id():
    assert ids(shown(5, (20, -10)), shown(6, (-30, 0)), shown(7)) == [5, 6, 7]
    assert ids(shown(6, (0, 63.9))) == [6]
    assert ids(shown(6, (0, 64.1))) == [-1]
    assert ids(shown(6, (0, 63.9)), radius=60) == [-1]
    assert ids() == []


def test_an_id_of_the_detectors_own_stays_and_labels_narrow_the_choice():
    assert ids(shown(5, id=9), shown(6)) == [9, 6]
    assert ids(shown(6, label=1), radius=20) == [-1]
    assert ids(shown(6, label=2), radius=20) == [6]


def test_the_radius_is_the_papers_unless_a_sensor_of_pixels_has_its_own():
    config = Config()
    config["sensors.front.measures"] = "pixels"
    assert radius_pixel(config, eye(measures="pixels")) == RADIUS_PIXEL == 64
    config["sensors.front.association_radius_pixel"] = 40
    assert radius_pixel(config, eye(measures="pixels")) == 40
    assert radius_pixel(config, eye()) == 64


class Given:
    rate_hz, begin = 10.0, 0

    def frames(self, tally):
        for utime in (100_000, 300_000, 900_000):
            yield Frame(utime, f"{utime}.png", IMAGE)

    def close(self):
        pass


def run(poses: Poses | None, *detections: Detection):
    config = Config()
    config.map = MARKERS
    said: list[str] = []
    tally = Tally("front", said.append)
    found = list(find(config, eye(*detections), Given(), tally, poses))
    return [marker_frame_t.decode(one.data) for one in found], said, tally


def test_each_image_is_associated_from_the_first_pose_at_or_after_it():
    away = POSE + np.array([3.0, 3.0, 1.0])
    poses = Poses()
    for utime, pose in ((99_999, away), (100_000, POSE), (299_999, away), (310_000, POSE)):
        poses.add(utime, tuple(pose))
    frames, said, tally = run(poses, shown(6))
    assert [frame.sightings[0].id for frame in frames] == [6, 6, -1]
    assert [frame.seq for frame in frames] == [0, 1, 2]
    assert [frame.utime for frame in frames] == [100_000, 300_000, 900_000]
    assert said == ["front: of 1 images no pose is known: what is found in them has no new ids"]
    assert tally.summary() == "3 frames = 3 published; 3 detections"


def test_without_poses_there_are_no_ids_and_empty_frames_are_kept():
    frames, said, _ = run(None, shown(6))
    assert [frame.sightings[0].id for frame in frames] == [-1, -1, -1]
    assert said == []
    frames, _, _ = run(None)
    assert [frame.n for frame in frames] == [0, 0, 0]


def frame(utime: int, sensor: str = "front", seq: int = 0) -> bytes:
    message = marker_frame_t()
    message.utime, message.seq, message.sensor = utime, seq, sensor
    return message.encode()


def test_the_messages_of_several_cameras_are_put_in_order():
    found = [Found(300, "A", frame(300)), Found(100, "B", frame(100)), Found(200, "A", frame(200))]
    log = as_log(found)
    assert [log[i][:2] for i in range(3)] == [(100, "B"), (200, "A"), (300, "A")]


@pytest.fixture
def drive(tmp_path):
    """Received 5 s late by its sender's clock, then 5.1 s; it holds frames of two cameras."""
    recording = Recording()
    utime = np.arange(0, 100_000, 10_000)
    late = np.where(utime < 50_000, 5_000_000, 5_100_000)
    recording.add_encoders("ENCODERS", utime, utime, utime, received=utime + late)
    for sensor in ("front", "rear"):
        recording.add(5_020_001, "MARKERS", frame(20_000, sensor, seq=7))
    recording.sort()
    recording.save(str(tmp_path / "drive.lcmlog"))
    return tmp_path / "drive.lcmlog"


def test_frames_arrive_as_the_drives_motion_does_and_replace_the_cameras_old_ones(drive):
    found = [Found(t, "MARKERS", frame(t)) for t in (35_000, 45_000, 60_000, 500_000)]
    log, replaced = merged(Config(), drive, found, ["front"])
    assert replaced == 1
    arrivals = {}
    for i in range(len(log)):
        received, channel, data = log[i]
        if channel == "MARKERS":
            message = marker_frame_t.decode(data)
            arrivals[message.sensor, message.utime] = received
    assert arrivals == {
        ("rear", 20_000): 5_020_001,
        ("front", 35_000): 5_035_000,
        ("front", 45_000): 5_145_000,
        ("front", 60_000): 5_160_000,
        ("front", 500_000): 5_600_000,
    }
    times = [log[i][0] for i in range(len(log))]
    assert times == sorted(times)
    assert len(log) == 10 + 1 + 4


def test_a_drive_without_motion_is_refused(tmp_path):
    recording = Recording()
    recording.add_gyro("GYRO", [1], [0.0])
    recording.save(str(tmp_path / "gyro.lcmlog"))
    with pytest.raises(ValueError, match="no ENCODERS in it, by which the images could be put"):
        merged(Config(), tmp_path / "gyro.lcmlog", [], [])


def test_what_measures_the_pose_and_finds_none_is_counted():
    config = Config()
    config.map = MARKERS
    tally = Tally("front", lambda _: None)
    blind = replace(eye(shown(6)), measures="pose")
    assert list(find(config, blind, Given(), tally, None)) == []
    assert (tally.read, tally.published, tally.dropped) == (3, 0, {"no_fix": 3})
