import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import matplotlib as mpl
import pytest
from matplotlib.image import imread

from pilotage.plot import save_all
from support import runs

NAMES = ["path.png", "closeup.png", "markers.png", "errors.png", "nis.png"]


def test_all_figures_are_written_at_150_dpi(tmp_path: Path) -> None:
    run, truth, markers = runs.drive()
    paths = save_all(run, truth, markers, tmp_path / "figures")
    assert [path.name for path in paths] == NAMES
    for path in paths:
        assert imread(path).shape[1] == 975  # 6.5 inches


def test_figures_do_without_truth_map_and_sightings(tmp_path: Path) -> None:
    paths = save_all(runs.Run(poses=runs.poses([0, 50_000])), None, None, tmp_path)
    assert [path.name for path in paths] == NAMES


def test_run_without_a_pose_has_no_figures(tmp_path: Path) -> None:
    assert save_all(runs.Run(poses=runs.poses([])), None, None, tmp_path / "none") == []
    assert not (tmp_path / "none").exists()


def test_long_run_is_thinned(tmp_path: Path) -> None:
    run, truth, markers = runs.drive(55_000)
    paths = save_all(run, truth, markers, tmp_path)
    assert all(path.stat().st_size < 500_000 for path in paths)


def test_figures_in_threads_are_the_same(tmp_path: Path) -> None:
    run, truth, markers = runs.drive()
    once = save_all(run, truth, markers, tmp_path / "once")
    with ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(save_all, run, truth, markers, tmp_path / str(i)) for i in range(2)]
        for job in jobs:
            for path, expected in zip(job.result(), once, strict=True):
                assert path.read_bytes() == expected.read_bytes()


def test_global_state_of_matplotlib_is_left_alone(tmp_path: Path) -> None:
    names = set(mpl.rcParams) - {"backend"}  # reading that one alone would settle it
    before = {name: mpl.rcParams[name] for name in names}
    run, truth, markers = runs.drive()
    save_all(run, truth, markers, tmp_path)
    assert {name: mpl.rcParams[name] for name in names} == before


def test_pyplot_is_never_imported() -> None:
    code = "import pilotage.plot, sys; print('matplotlib.pyplot' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


@pytest.mark.filterwarnings("error")
def test_nothing_warns(tmp_path: Path) -> None:
    run, truth, markers = runs.drive()
    truth["x"][100:200] = float("nan")
    save_all(run, truth, markers, tmp_path)
    save_all(runs.Run(poses=runs.poses([0])), None, None, tmp_path)
