import numpy as np
import pytest

cv2 = pytest.importorskip("cv2")

from pilotage.camera.discs import DiscDetector  # noqa: E402
from support.optics import Optics  # noqa: E402
from support.pictures import GRASS, disc, draw, pole, seen  # noqa: E402

HEIGHT, RADIUS = 0.5, 0.1
TURN = np.linspace(0, 2 * np.pi, 60)
ROUND = np.column_stack([np.cos(TURN), np.sin(TURN), 0 * TURN])
WIDE, STRAIGHT = Optics(), Optics(distortion=(), roll_rad=0.0)


def on_ground(optics, pixel):
    """The point (3,) of the ground that shows at a pixel of the whole image."""
    ray = optics.whole.rays(np.array([pixel]))[0]
    return ray * -HEIGHT / ray[2]


def picture(optics, pixel, samples=10):
    centre = on_ground(optics, pixel)
    camera = optics.around(centre + RADIUS * ROUND)
    return (
        camera,
        camera.project(centre[None])[0],
        draw(camera, disc(centre, RADIUS), samples=samples),
    )


@pytest.mark.parametrize("optics", [WIDE, STRAIGHT], ids=["barrel", "straight"])
@pytest.mark.parametrize("blur", [0.0, 0.7])
def test_without_noise_the_centre_is_within_a_tenth_of_a_pixel(optics, blur):
    worst = 0.0
    for u in (60.3, 320.6, 590.2):
        for v in (225.4, 260.8, 330.1, 420.7):
            camera, truth, image = picture(optics, (u, v))
            (found,) = DiscDetector(camera, HEIGHT, RADIUS).detect(seen(image, blur))
            worst = max(worst, np.abs(found.pixel - truth).max())
    print(f"worst error {worst:.3f} px")
    assert worst < 0.05


def test_the_blobs_middle_is_not_the_centre():
    """What the slant does is more than the bar: a detector without the correction fails it."""
    _, truth, image = picture(STRAIGHT, (320, 400))
    red = (image[..., 2] - GRASS[2]).clip(0)
    v = np.arange(image.shape[0]) @ red.sum(axis=1) / red.sum()
    assert v - truth[1] > 0.5


@pytest.mark.parametrize("quarter", range(4))
def test_a_disc_at_the_border_is_none(quarter):
    camera, truth, image = picture(WIDE, (320, 330))
    cut = int(truth[1 - quarter % 2])
    half = [image[:cut], image[:, :cut], image[cut:], image[:, cut:]][quarter]
    shift = [(0, 0), (0, 0), (0, cut), (cut, 0)][quarter]
    fx, fy, cx, cy = camera.matrix
    size = (half.shape[1], half.shape[0])
    cropped = type(camera)(
        size, (fx, fy, cx - shift[0], cy - shift[1]), camera.distortion, 0.02, 0.15
    )
    assert DiscDetector(cropped, HEIGHT, RADIUS).detect(seen(half)) == []


def test_red_things_of_another_size_or_shape_are_none():
    optics = STRAIGHT
    centre = on_ground(optics, (320, 330))
    camera = optics.around(centre + 4 * RADIUS * ROUND)
    for thing in (
        disc(centre, 3 * RADIUS),
        disc(centre, RADIUS / 3),
        pole(centre, 4 * RADIUS, RADIUS / 2),
    ):
        assert DiscDetector(camera, HEIGHT, RADIUS).detect(seen(draw(camera, thing))) == []
    bent = draw(camera, disc(centre, RADIUS), disc(centre + np.array([0.08, 0, 0]), RADIUS, GRASS))
    assert DiscDetector(camera, HEIGHT, RADIUS).detect(seen(bent)) == []


def test_each_of_several_discs_is_found():
    camera = STRAIGHT.window((100, 220), (540, 400))
    truth = np.array([on_ground(STRAIGHT, p) for p in ((200.2, 260.5), (330, 300), (450, 350))])
    image = seen(draw(camera, *(disc(c, RADIUS) for c in truth), samples=4))
    found = DiscDetector(camera, HEIGHT, RADIUS).detect(image)
    pixels = np.array(sorted((d.pixel for d in found), key=lambda p: p[0]))
    np.testing.assert_allclose(pixels, camera.project(truth), atol=0.1)


def test_an_image_of_another_size_is_an_error_that_names_both():
    detector = DiscDetector(STRAIGHT.whole, HEIGHT, RADIUS)
    with pytest.raises(ValueError, match=r"320 by 240 pixels, .* calibrated at 640 by 480"):
        detector.detect(np.zeros((240, 320, 3), np.uint8))
    with pytest.raises(ValueError, match=r"\(480, 640\) of uint8, expected \(h, w, 3\)"):
        detector.detect(np.zeros((480, 640), np.uint8))


def test_a_camera_below_the_discs_is_an_error():
    with pytest.raises(ValueError, match="z_m of the discs is 0 and of the camera 0"):
        DiscDetector(STRAIGHT.whole, 0.0, RADIUS)
