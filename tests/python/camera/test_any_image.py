"""Whatever is in an image, a detector answers, with numbers that hold together."""

import warnings

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2")

from pilotage.camera.colour import COLOURS  # noqa: E402
from pilotage.camera.discs import DiscDetector  # noqa: E402
from pilotage.camera.poles import PoleDetector  # noqa: E402
from pilotage.camera.tags import TagDetector  # noqa: E402
from support.optics import Optics  # noqa: E402

CAMERA = Optics().window((200, 150), (440, 330))
DETECTORS = [
    DiscDetector(CAMERA, 0.5, 0.1, size_ratio=20.0, min_fill=0.1, min_area_px=1.0),
    PoleDetector(CAMERA, 1.0, {0: COLOURS["red"]}, 0.1, min_area_px=1.0, min_aspect=0.5),
    TagDetector(CAMERA, "4x4_50", 0.2),
]


def scribble(rng):
    """Shapes in any colour, red ones and tags among them, over noise or over nothing."""
    width, height = CAMERA.size
    image = np.full((height, width, 3), rng.integers(0, 256, 3), np.uint8)
    for _ in range(rng.integers(0, 25)):
        colour = (20, 20, 220) if rng.random() < 0.6 else rng.integers(0, 256, 3).tolist()
        at = [tuple(int(x) for x in rng.integers((-20, -20), CAMERA.size)) for _ in range(2)]
        size = tuple(int(x) for x in rng.integers(1, 60, 2))
        kind = rng.integers(4)
        if kind == 0:
            cv2.ellipse(image, at[0], size, float(rng.uniform(0, 180)), 0, 360, colour, -1)
        elif kind == 1:
            cv2.line(image, at[0], at[1], colour, int(rng.integers(1, 6)))
        elif kind == 2:
            low, high = at[0], (at[0][0] + size[0] // 4, at[0][1] + size[1])
            cv2.rectangle(image, low, high, colour, -1)
        else:
            marker = cv2.copyMakeBorder(TAG, 8, 8, 8, 8, cv2.BORDER_CONSTANT, value=(255, 255, 255))
            corners = np.float32([[0, 0], [64, 0], [64, 64], [0, 64]])
            bent = corners + rng.uniform(-25, 25, (4, 2)).astype(np.float32) + np.float32(at[0])
            warp = cv2.getPerspectiveTransform(corners, bent)
            cv2.warpPerspective(
                marker, warp, (width, height), image, borderMode=cv2.BORDER_TRANSPARENT
            )
    if rng.random() < 0.5:
        noise = rng.integers(0, 2 + int(rng.integers(1, 80)), image.shape)
        image = np.clip(image + noise, 0, 255).astype(np.uint8)
    return image


TAG = cv2.cvtColor(
    cv2.aruco.generateImageMarker(cv2.aruco.getPredefinedDictionary(0), 7, 48), cv2.COLOR_GRAY2BGR
)


def test_of_any_image():
    rng = np.random.default_rng(11)
    found = {type(detector): 0 for detector in DETECTORS}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for _ in range(300):
            image = scribble(rng)
            for detector in DETECTORS:
                for one in detector.detect(image):
                    found[type(detector)] += 1
                    assert np.isfinite(one.pixel).all()
                    assert np.linalg.eigvalsh(one.covariance).min() > 0
                    assert np.isnan(one.range_m) == np.isnan(one.sigma_range_m)
                    assert np.isnan(one.range_m) or min(one.range_m, one.sigma_range_m) > 0
                    assert np.isfinite(one.outline).all()
    print(found)
    assert min(found.values()) > 20
