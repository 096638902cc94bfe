"""What detection takes of one core: an ArUco ring, discs and poles at 640 by 480.

Prints the median and the longest process time of a frame, in which nothing that waits counts.
"""

import argparse
from time import process_time

import cv2
import numpy as np

from pilotage import CameraModel
from pilotage.camera.kinds import make_detector
from pilotage.simulate.appearance import Body, Disc, Pole, Tag
from pilotage.simulate.exposure import Exposure
from pilotage.simulate.paints import PAINTS
from pilotage.simulate.render import Renderer, World
from pilotage.simulate.surroundings import PLACES
from pilotage.simulate.worlds import mower_site, ring

HEIGHT = 0.3


def worlds() -> dict[str, tuple[list[Body], str, dict[str, object]]]:
    """What stands there, in which surroundings, and the detector's keys."""
    at = ring().positions + np.array([0, 0, 0.2])
    tags = [
        Tag(tuple(p), float(np.arctan2(-p[1], -p[0])), k, dictionary="4X4_50", size_m=0.3)
        for k, p in enumerate(at)
    ]
    discs = [
        Disc((x / 3, y / 3, 0.0), 0.15)
        for x, y, _ in mower_site(np.random.default_rng(1)).positions
    ]
    poles = [
        Pole((2.8 * np.cos(a), 2.8 * np.sin(a), 0.0), 0.8, 0.08, PAINTS["yellow"])
        for a in np.arange(8) * np.pi / 4
    ]
    return {
        "tags": (tags, "hall", {"dictionary": "4x4_50", "size_m": 0.3}),
        "discs": (discs, "lawn", {"radius_m": 0.15}),
        "poles": (poles, "lawn", {"height_m": 0.8, "colours": {0: "yellow"}, "radius_m": 0.08}),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--frames", type=int, default=40)
    frames: int = parser.parse_args().frames
    cv2.setNumThreads(1)
    camera = CameraModel((640, 480), (500.0, 500.0, 320.0, 240.0), (-0.2, 0.05, 0.0, 0.0), 0.0, 0.1)
    exposure, rng = Exposure(noise=4.0), np.random.default_rng(2)
    print(f"{'kind':6} {'seen a frame':>12} {'median':>10} {'longest':>10}")
    for kind, (bodies, place, keys) in worlds().items():
        renderer = Renderer(camera, (0.0, 0.0, HEIGHT, 0.0), World(bodies, PLACES[place]))
        detector = make_detector({"kind": kind, **keys}, camera, HEIGHT, kind)
        took, seen = [], []
        for turn in np.linspace(0, 2 * np.pi, frames, endpoint=False):
            image = exposure.develop(renderer.draw(np.array([0.8, 0.3, turn])), rng)
            began = process_time()
            seen.append(len(detector.detect(image)))
            took.append(1e3 * (process_time() - began))
        print(f"{kind:6} {np.mean(seen):12.1f} {np.median(took):7.1f} ms {max(took):7.1f} ms")


if __name__ == "__main__":
    main()
