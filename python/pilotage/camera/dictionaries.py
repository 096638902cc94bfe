"""OpenCV's sets of tags by name: 4x4_50, apriltag_36h11, ..."""

from difflib import get_close_matches

import cv2

DICTIONARIES = {
    name.removeprefix("DICT_").lower(): getattr(cv2.aruco, name)
    for name in dir(cv2.aruco)
    if name.startswith("DICT_")
}


def dictionary_of(name: str) -> cv2.aruco.Dictionary:
    """Return a set of tags; a ValueError names the nearest known one."""
    known = name.removeprefix("DICT_").lower()
    if known not in DICTIONARIES:
        (near,) = get_close_matches(known, DICTIONARIES, n=1, cutoff=0.0)
        raise ValueError(
            f"dictionary is {name}; the nearest known one is '{near}' of {', '.join(DICTIONARIES)}"
        )
    return cv2.aruco.getPredefinedDictionary(DICTIONARIES[known])
