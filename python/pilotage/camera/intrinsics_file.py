"""A camera's intrinsics in a file, as OpenCV writes it and the configuration's loader reads it."""

from pathlib import Path

import cv2
import numpy as np

from .detection import Array


def write_intrinsics(
    file: Path,
    size: tuple[int, int],
    matrix: tuple[float, float, float, float],
    distortion: Array,
    rms_px: float | None = None,
) -> None:
    """Write image size, matrix fx, fy, cx, cy [px] and distortion (up to 8,), zeros filled in.

    `rms_px` is what was left of a calibration, which `cv2.calibrateCamera` returns.
    """
    fx, fy, cx, cy = matrix
    filled = np.zeros(8 if len(distortion) > 5 else 5)
    filled[: len(distortion)] = distortion
    storage = cv2.FileStorage(str(file), cv2.FILE_STORAGE_WRITE)
    if not storage.isOpened():
        raise ValueError(f"{file} cannot be written: name another place")
    storage.write("image_width", size[0])
    storage.write("image_height", size[1])
    storage.write("camera_matrix", np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]]))
    storage.write("distortion_coefficients", filled[None])
    if rms_px is not None:
        storage.write("avg_reprojection_error", rms_px)
    storage.release()
