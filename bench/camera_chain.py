"""From an image to a pose on one core: the ring of tags at 30 Hz, 640 by 480.

Prints the median process time of a frame, in which nothing that waits counts: detection, message,
and all that the engine does with it and with the wheels and gyro until the next; and that no frame
and no detection is lost on the way without a word.
"""

import argparse
import json
import tempfile
from collections import Counter
from dataclasses import replace
from pathlib import Path
from time import process_time

import cv2
import numpy as np

from pilotage import Engine, Recording, lcmtypes, load_config
from pilotage.camera import images
from pilotage.camera.eye import make_eye
from pilotage.camera.looking import look
from pilotage.camera.messages import message
from pilotage.camera.tally import Tally
from pilotage.simulate import find_scenario
from pilotage.simulate.pictures import take_pictures

BAR_MS = 15.0
REPORT = "MARKER_REPORT"


def chain(folder: Path) -> dict[str, float]:
    config = load_config(str(folder / "robot.yaml"))
    eye = make_eye(config, "camera")
    engine, drive = Engine(config), Recording.load(str(folder / "drive.lcmlog"))
    own = [m for m in (drive[i] for i in range(len(drive))) if m[1] != "REFERENCE"]
    tally, became, row = Tally("camera", print), Counter(), 0
    took: dict[str, list[float]] = {"detect": [], "send": [], "fuse": []}

    def hand(received: int, channel: str, data: bytes) -> None:
        for sent, answer in engine.handle(channel, received, data):
            if sent == REPORT:
                report = lcmtypes.marker_report_t.decode(answer)
                became[report.reason or "fused"] += report.revision == 0

    class Watched:
        def detect(self, image):
            began = process_time()
            found = eye.detector.detect(image)
            took["detect"].append(1e3 * (process_time() - began))
            return found

    watched = replace(eye, detector=Watched())
    for seq, seen in enumerate(look(watched, images.folder(folder / "camera"), tally)):
        began = process_time()
        data = message(eye, seen.utime, seq, seen.detections, config.map).encode()
        took["send"].append(1e3 * (process_time() - began))
        tally.publish(len(seen.detections))
        began = process_time()
        while row < len(own) and own[row][0] < seen.utime:
            hand(*own[row])
            row += 1
        hand(seen.utime, eye.channel, data)
        took["fuse"].append(1e3 * (process_time() - began))
    # The last ones wait for motion that comes after them.
    for rest in own[row:]:
        hand(*rest)
    whole = np.sum(list(took.values()), axis=0)
    print(tally.summary())
    print(f"of the detections: {', '.join(f'{n} {what}' for what, n in became.items())}")
    lost = tally.read - tally.published - sum(tally.dropped.values())
    unsaid = tally.detections - sum(became.values())
    return {
        **{f"{name}_ms": float(np.median(times)) for name, times in took.items()},
        "median_ms": float(np.median(whole)),
        "p95_ms": float(np.percentile(whole, 95)),
        "frames_lost": lost,
        "detections_lost": unsaid,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    cv2.setNumThreads(1)
    scenario = replace(find_scenario("aruco-ring"), duration_s=arguments.seconds)
    with tempfile.TemporaryDirectory() as folder:
        take_pictures(scenario, np.random.default_rng(arguments.seed), Path(folder), jobs=-1)
        figures = chain(Path(folder))
    rounded = {name: round(value, 2) for name, value in figures.items()}
    print(json.dumps({**rounded, "bar_ms": BAR_MS, "seed": arguments.seed}))


if __name__ == "__main__":
    main()
