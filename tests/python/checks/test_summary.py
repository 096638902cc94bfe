"""The summary says what the configuration means."""

from pilotage import MarkerMap
from pilotage.checks import summarize
from support.configs import sound


def test_each_section_says_what_is_configured():
    config = sound(gyro__time="mapped", sensors__camera__latency_s=0.04)
    summary = summarize(config, "markers.yaml")
    assert summary["motion"] == [
        "encoders, heading from the gyro",
        "estimated on the way: gyro_bias",
    ]
    assert summary["inputs"] == [
        "encoders    ENCODERS    dated by the sender's stamp",
        "gyro        GYRO        dated by the sender's stamp, mapped to our clock",
        "camera      MARKERS     dated by the sender's stamp, less 40 ms",
        "pose_reset  POSE_RESET  dated by the sender's stamp",
    ]
    assert summary["sensors"][0] == "camera at x 0.2 m, y 0 m, z 0.35 m, yaw 0°"
    assert "bearing 0.573°" in summary["sensors"][1]
    assert summary["start"] == ["x 0 m, y 0 m, σ 0.1 m; heading 0°, σ 3°"]
    assert summary["outputs"] == [
        "pose_t on POSE, odometry_t on ODOMETRY, pose_jump_t on POSE_JUMP",
        "marker_report_t on MARKER_REPORT, status_t on STATUS",
    ]


def test_a_sensor_of_pixels_is_described_by_its_height_and_noise():
    film = {"measures": "pixels", "z_m": 1.0, "sigma_pixel": 0.5}
    summary = summarize(sound(**{f"sensors__film__{key}": value for key, value in film.items()}))
    assert summary["sensors"][2:] == [
        "film at x 0 m, y 0 m, z 1 m, yaw 0°, pixels of markers",
        "  σ of u and v 0.5 px; fusion student_t",
    ]


def test_the_map_is_counted_and_measured():
    assert summarize(sound(), "markers.yaml")["map"] == [
        "3 markers from markers.yaml",
        "over 8.1 m × 7.1 m, at a height of 0.5 m",
        "ids 1 to 5, 2 missing in between, the first 3",
        "closest: 1 and 2, 5.57 m",
    ]


def test_a_map_of_one_marker_has_no_closest_pair():
    summary = summarize(sound(MarkerMap([7], [[1, 2, 0]])))
    assert summary["map"][-1] == "ids 7 to 7, none missing"


def test_velocity_needs_no_gyro():
    summary = summarize(sound(motion__source="velocity", motion__heading="wheels"))
    assert summary["motion"][0] == "velocity, heading from its omega"
    assert not any(line.startswith("gyro") for line in summary["inputs"])


def test_without_a_start_the_pose_is_found_or_set():
    summary = summarize(sound(without="initial.", pose_reset__channel="START"))
    assert summary["start"] == ["anywhere: found from sightings, or set by a pose_reset_t on START"]
