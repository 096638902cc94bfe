"""Starts the node and a bare echo in a private network and races them: encoder in, pose out."""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from pilotage import multicast

CONFIG = """\
motion: {source: encoders, heading: wheels}
encoders: {left_m_per_tick: 0.001, right_m_per_tick: 0.001, track_width_m: 0.5}
sensors: {camera: {}}
initial: {x_m: 0, y_m: 0, heading_rad: 0}
map:
- {id: 1, x: 5, y: 0}
"""
NODE_URL, ECHO_URL = (f"udpm://{multicast.GROUP}:{port}?ttl=0" for port in (7667, 7668))


def race(build: Path) -> dict[str, float]:
    with tempfile.TemporaryDirectory() as folder:
        config = Path(folder, "robot.yaml")
        config.write_text(CONFIG, encoding="utf-8")
        node = [build / "cpp/pilotage-node", "--config", config, "--lcm-url", NODE_URL]
        processes = [
            subprocess.Popen(command, stderr=subprocess.DEVNULL)
            for command in (node, [build / "bench/bench_echo", ECHO_URL])
        ]
        try:
            answer = subprocess.run(
                [build / "bench/bench_latency", NODE_URL, ECHO_URL],
                capture_output=True,
                text=True,
                check=True,
                timeout=120,
            )
        finally:
            for process in processes:
                process.terminate()
                process.wait()
    return {key: float(value) for key, value in map(str.split, answer.stdout.splitlines())}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    build: Path = parser.parse_args().build.resolve()
    if not multicast.available():
        status = multicast.rerun_in_private_network()
        if status is None:
            sys.exit(multicast.ADVICE)
        sys.exit(status)
    print(json.dumps(race(build)))


if __name__ == "__main__":
    main()
