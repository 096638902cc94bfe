"""A lens from views of a board: values, their standard deviations, and what is doubtful."""

import cv2
import numpy as np
import pytest

from pilotage.calibrate.boards import View
from pilotage.calibrate.doubts import coverage, doubts
from pilotage.calibrate.intrinsics import calibrate
from pilotage.camera.intrinsics_file import write_intrinsics

SIZE = (640, 480)
MATRIX = (500.0, 505.0, 318.0, 242.0)
LENS = (-0.25, 0.08, 0.001, -0.0005, 0.0)
NOISE_PX = 0.1


def views(rng, count=15, tilt=0.6, spread=0.15):
    """Corners of a board of 9 by 6, all in the picture, with noise."""
    fx, fy, cx, cy = MATRIX
    matrix = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1.0]])
    v, u = np.divmod(np.arange(54), 9)
    points = 0.03 * np.column_stack([u - 4.0, v - 2.5, np.zeros(54)])
    some = []
    while len(some) < count:
        place = np.array([*rng.uniform(-spread, spread, 2), rng.uniform(0.25, 0.5)])
        turn = rng.uniform(-tilt, tilt, 3)
        pixels = cv2.projectPoints(points, turn, place, matrix, np.array(LENS))[0].reshape(-1, 2)
        if (pixels > 0).all() and (pixels < np.array(SIZE) - 1).all():
            noise = NOISE_PX * rng.standard_normal(pixels.shape)
            some.append(View(f"{len(some)}.png", points, pixels + noise))
    return some


def test_values_are_off_by_what_their_standard_deviations_say():
    off = []
    for seed in range(40):
        found = calibrate(views(np.random.default_rng(seed)), SIZE)
        off.append((found.values - [*MATRIX, *LENS]) / found.sigmas)
    spread = np.sqrt(np.mean(np.square(off), axis=0))
    print("error by sigma, rms of 40:", dict(zip(found.names, spread.round(2), strict=True)))
    # Of 40 draws the spread itself is sure to a ninth.
    assert (np.abs(spread - 1) < 0.35).all()
    assert np.abs(off).max() < 4
    assert found.rms_px == pytest.approx(np.sqrt(2) * NOISE_PX, rel=0.1)


@pytest.mark.parametrize("coefficients", [0, 4, 5, 8])
def test_as_many_coefficients_as_asked_for(coefficients):
    found = calibrate(views(np.random.default_rng(1)), SIZE, coefficients)
    assert len(found.distortion) == coefficients
    assert len(found.names) == len(found.sigmas) == 4 + coefficients
    assert (found.rms_px > 1) == (coefficients == 0)


def test_a_good_set_has_no_doubts_and_covers_most_of_the_picture():
    found = calibrate(views(np.random.default_rng(2), count=40, spread=0.3), SIZE)
    assert doubts(found) == []
    assert coverage(found).mean() > 0.9
    assert coverage(found).shape == (6, 8)


def test_few_frontal_views_in_the_middle_are_told_of():
    found = calibrate(views(np.random.default_rng(3), count=4, tilt=0.05, spread=0.02), SIZE, 4)
    problems = {one.key: one.problem for one in doubts(found)}
    assert "4 pictures" in problems["views"]
    assert "faces the camera" in problems["tilt"]
    assert "bottom left, bottom right" in problems["coverage"]


def test_a_smeared_picture_is_named():
    some = views(np.random.default_rng(4))
    rng = np.random.default_rng(5)
    some[3] = View("smeared.png", some[3].points, some[3].pixels + rng.normal(0, 2, (54, 2)))
    assert "smeared.png" in [one.key for one in doubts(calibrate(some, SIZE))]


def test_too_few_views_are_refused():
    with pytest.raises(ValueError, match=r"found in 2 pictures, at least 3 are needed"):
        calibrate(views(np.random.default_rng(6), count=2), SIZE)


def test_what_is_written_is_what_opencv_reads(tmp_path):
    file = tmp_path / "camera.yaml"
    write_intrinsics(file, SIZE, MATRIX, np.array(LENS[:4]), 0.25)
    storage = cv2.FileStorage(str(file), cv2.FILE_STORAGE_READ)
    assert storage.getNode("camera_matrix").mat()[1].tolist() == [0, 505, 242]
    assert storage.getNode("distortion_coefficients").mat().ravel().tolist() == list(LENS)
    assert storage.getNode("avg_reprojection_error").real() == 0.25
