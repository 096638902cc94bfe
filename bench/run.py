"""Runs the benchmarks and prints one table, with the bar that each row is held against.

Times are medians of many short turns in which all contenders take part alternately, so that their
ratios hold on a busy machine. Nothing passes or fails: read the table.
"""

import argparse
import json
import platform
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from time import perf_counter

import numpy as np

from pilotage.montecarlo import find_scenario, run_montecarlo
from pilotage.montecarlo.summary import to_dict
from pilotage.simulate import SCENARIOS, simulate

HERE = Path(__file__).parent
COUNTED = {  # what callgrind counts, by the function's name
    **{
        step: f"bench::{step}(*"
        for step in (
            "predict_pilotage",
            "predict_by_hand",
            "predict_symforce",
            "predict_pilotage_wheels",
            "predict6_pilotage",
            "update_pilotage",
            "update_by_hand",
            "update_symforce",
            "update6_pilotage",
            "predict_ukf",
            "update_ukf",
            "predict6_ukf",
            "update6_ukf",
        )
    },
    "update_localizer": "pilotage::SightingReport pilotage::fuse_sighting*",
}


@dataclass(frozen=True)
class Row:
    what: str
    value: float
    unit: str
    bar: str = ""


def output_of(*command: str | Path) -> str:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def numbers(text: str) -> dict[str, float]:
    """Lines of `name value`."""
    return {name: float(value) for name, value in map(str.split, text.splitlines())}


def script(name: str, *arguments: str | Path) -> dict[str, float]:
    """What one of the scripts here prints, nothing where it cannot run."""
    run = subprocess.run(
        [sys.executable, HERE / name, *arguments], capture_output=True, text=True, check=False
    )
    if run.returncode != 0:
        print(f"{name} left out: {(run.stderr.strip() or '?').splitlines()[-1]}", file=sys.stderr)
        return {}
    return json.loads(run.stdout)


def instructions(steps: Path, names: list[str], turns: int = 200) -> dict[str, float]:
    """Instructions a step, by callgrind; nothing where valgrind is not installed."""
    if shutil.which("valgrind") is None:
        print("instructions left out: valgrind is not installed", file=sys.stderr)
        return {}
    counts = {}
    for name in names:
        with tempfile.NamedTemporaryFile("r", suffix=".callgrind") as file:
            output_of(
                "valgrind",
                "--tool=callgrind",
                f"--callgrind-out-file={file.name}",
                f"--toggle-collect={COUNTED[name]}",
                steps,
                name,
                str(turns),
            )
            summary = next(line for line in file if line.startswith(("summary:", "totals:")))
        counts[name] = int(summary.split()[1]) / (turns * 64)
    return counts


def engine(build: Path) -> dict[str, float]:
    simulation = simulate(SCENARIOS["mower-spiral"], np.random.default_rng(1))
    with tempfile.TemporaryDirectory() as folder:
        log, config = Path(folder, "run.lcmlog"), Path(folder, "run.yaml")
        simulation.recording.save(str(log))
        config.write_text(simulation.config.to_yaml(), encoding="utf-8")
        return numbers(output_of(build / "bench/bench_engine", config, log))


def montecarlo_s(runs: int = 1000) -> float:
    """The bars' base scenario, of 60 s at 100 Hz, in two processes."""
    start = perf_counter()
    to_dict(run_montecarlo(find_scenario("nominal"), runs, jobs=2))
    return perf_counter() - start


def step_rows(ns: dict[str, float], count: dict[str, float]) -> Iterator[Row]:
    for step, name, bar in (("predict", "predict", 260), ("update", "azimuth + elevation", 560)):
        title = f"Ekf<3> {name}"
        ours = ns[f"{step}_pilotage"]
        if count:
            yield Row(title, count[f"{step}_pilotage"], "instructions", f"≤ {bar}")
        yield Row(title, ours, "ns")
        for rival, label, limit in (
            ("by_hand", "by hand", "≤ 1.3"),
            ("symforce", "symforce's", "< 1"),
        ):
            key = f"{step}_{rival}"
            if key in count:
                yield Row(f"  the same, {label}", count[key], "instructions")
            if key in ns:
                yield Row(f"  the same, {label}", ns[key], "ns")
                yield Row(f"  ours over {label}", ours / ns[key], "", limit)
        if f"{step}_filterpy" in ns:
            theirs = ns[f"{step}_filterpy"]
            yield Row("  the same, filterpy's", theirs, "ns")
            yield Row("  filterpy's over ours", theirs / ours, "", "≥ 300")
        if step == "predict" and count:
            yield Row("  ours from two wheels", count["predict_pilotage_wheels"], "instructions")
        six = ns[f"{step}6_pilotage"]
        if count:
            yield Row(f"Ekf<6> {name}", count[f"{step}6_pilotage"], "instructions")
        yield Row(f"Ekf<6> {name}", six, "ns")
        yield Row("  six states over three", six / ours, "", "≤ 6")
    for states, six in ((3, ""), (6, "6")):
        title = f"Ukf<{states}> predict + update"
        keys = [f"{step}{six}_ukf" for step in ("predict", "update")]
        ukf = sum(ns[key] for key in keys)
        ekf = sum(ns[f"{step}{six}_pilotage"] for step in ("predict", "update"))
        if count:
            yield Row(title, sum(count[key] for key in keys), "instructions")
        yield Row(title, ukf, "ns")
        yield Row(f"  over Ekf<{states}>'s", ukf / ekf, "", "≤ 10" if states == 3 else "")
    title = "Localizer's update of one sighting"
    if count:
        yield Row(title, count["update_localizer"], "instructions", "≤ 950")
    yield Row(title, ns["update_localizer"], "ns")
    yield Row("  largest difference between the contenders", ns["difference"], "")


def rows(build: Path) -> Iterator[Row]:
    steps = build / "bench/bench_steps"
    ns = numbers(output_of(steps)) | script("filterpy_step.py")
    yield from step_rows(ns, instructions(steps, [name for name in COUNTED if name in ns]))
    late = numbers(output_of(build / "bench/bench_late"))
    for states in (3, 6):
        yield Row(f"a sighting 1 s late, Ekf<{states}>", late[f"late{states}_us"], "µs", "≤ 15")
        yield Row("  each frame fused again", late[f"late{states}_frame_us"], "µs", "≤ 1.5")
        unconfirmed = late[f"late{states}_unconfirmed_frame_us"]
        yield Row("  of a robot not confirmed before", unconfirmed, "µs")
        yield Row("  a sighting in order", late[f"in_order{states}_us"], "µs")
    million = 1e6
    association = numbers(output_of(build / "bench/bench_association"))
    for sightings in ("one", "two"):
        title = f"a frame of {sightings} without ids, ten markers"
        yield Row(title, association[f"{sightings}_ns"], "ns", "≤ 1500")
    rate = engine(build)["messages_per_s"] / million
    yield Row("engine on an LCM log file", rate, "million messages/s", "≥ 1.5")
    if batch := script("batch.py"):
        rate = batch["samples_per_s"] / million
        yield Row("Localizer.run from Python, three states", rate, "million samples/s", "≥ 10")
    if latency := script("latency.py", build):
        yield Row("encoder in, pose out over LCM", latency["node_us"], "µs")
        yield Row("  a bare echo", latency["echo_us"], "µs")
        yield Row("  node over echo", latency["node_us"] / latency["echo_us"], "", "≤ 1.15")
    # The last: its processes stay for a while, and race the node for the cores.
    yield Row("Monte Carlo, 1,000 runs of 60 s, two processes", montecarlo_s(), "s", "≤ 15")


def machine(build: Path) -> str:
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8").splitlines()
    compiler = next(c.split("=")[1] for c in cache if c.startswith("CMAKE_CXX_COMPILER:"))
    version = output_of(compiler, "--version").splitlines()[0]
    names = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    cpu = next((n.split(":")[1].strip() for n in names if n.startswith("model name")), "?")
    return f"{cpu} ({platform.machine()}), {version}"


def markdown(title: str, table: list[Row]) -> str:
    def number(row: Row) -> str:
        if row.value != 0 and abs(row.value) < 1e-3:
            return f"{row.value:.0e}"
        return f"{row.value:,.0f}" if row.value >= 100 else f"{row.value:.2f}"

    cells = [(r.what, f"{number(r)} {r.unit}".strip(), r.bar) for r in table]
    cells = [("what", "measured", "bar"), *cells]
    widths = [max(len(row[i]) for row in cells) for i in range(3)]
    lines = [f"| {a:<{widths[0]}} | {b:<{widths[1]}} | {c:<{widths[2]}} |" for a, b, c in cells]
    lines.insert(1, "|" + "|".join("-" * (w + 2) for w in widths) + "|")
    return f"{title}\n\n" + "\n".join(lines) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=HERE.parent / "build/bench")
    build: Path = parser.parse_args().build.resolve()
    title, table = machine(build), list(rows(build))
    text = markdown(title, table)
    print(text)
    (build / "results.md").write_text(text, encoding="utf-8")
    results = {"machine": title, "rows": [asdict(row) for row in table]}
    (build / "results.json").write_text(json.dumps(results, indent=2), encoding="utf-8")
    print(f"also in {build}/results.md and results.json")


if __name__ == "__main__":
    main()
