"""What needs OpenCV says so where it is missing."""

from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def needs_opencv(what: str) -> Iterator[None]:
    """Import in here: where OpenCV is missing the error tells what needs it, and the way out."""
    try:
        yield
    except ImportError as error:
        if "cv2" not in str(error) and "libGL" not in str(error):
            raise
        raise ImportError(
            f"{what} needs OpenCV ({error}): pip install 'pilotage[camera]', or, on a machine "
            "without a screen, pip install opencv-python-headless"
        ) from error
