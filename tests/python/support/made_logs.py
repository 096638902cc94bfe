"""Small logs in the public formats, made by hand."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy.io import savemat


def pose_row(
    time: float,
    left: float = 0.0,
    right: float = 0.0,
    gyro: float = 0.0,
    truth: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> str:
    """A row of the first paper's pose log, 21 columns."""
    row = [0.0] * 21
    row[2], row[3], row[4], row[8] = time, left, right, gyro
    row[18:] = truth
    return " ".join(f"{v:.17g}" for v in row)


def mower(
    folder: Path,
    poselog: str | None = None,
    angles: str = "10.005 1 0.5 -0.1 0 0\n",
    markers: str = "0 1.0 2.0\n1 3.0 4.0\n",
) -> Path:
    """The first paper's three files; one of two rows unless given."""
    folder.mkdir(parents=True, exist_ok=True)
    if poselog is None:
        poselog = f"{pose_row(10.0)}\n{pose_row(10.01, 0.01, 0.02, 0.3, (1.0, 2.0, 7.0))}\n"
    (folder / "marker-001-poselog.txt").write_text(poselog)
    (folder / "marker-001-003-angles.txt").write_text(angles)
    (folder / "marker-001-map.txt").write_text(markers)
    return folder


def mrclam(
    folder: Path,
    robots: tuple[int, ...] = (1,),
    odometry: str = "100.0 0.1 0.2\n100.5 0.3 0.4\n101.0 0.5 0.6\n",
    measurement: str = "100.25 63 2.0 0.1\n100.25 5 3.0 0.2\n100.75 99 4.0 0.3\n",
    landmarks: str = "6 1.0 2.0 0.003 0.004\n7 3.0 4.0 0.0 0.0\n",
    barcodes: str = "# Subject Barcode\n1 5\n6 63\n7 81\n",
) -> Path:
    """A folder as of the UTIAS data set, the same files for each robot."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "Barcodes.dat").write_text(barcodes)
    (folder / "Landmark_Groundtruth.dat").write_text(landmarks)
    for n in robots:
        (folder / f"Robot{n}_Odometry.dat").write_text(odometry)
        (folder / f"Robot{n}_Measurement.dat").write_text(measurement)
        (folder / f"Robot{n}_Groundtruth.dat").write_text("99.5 1.0 2.0 7.0\n100.5 1.5 2.0 0.0\n")
    return folder


def woods(path: Path, **change: ArrayLike | None) -> Path:
    """A Lost in the Woods file of three steps and two landmarks; None leaves a variable out."""
    variables: dict[str, Any] = {
        "t": [[0.0], [0.1], [0.2]],
        "v": [[1.0], [2.0], [3.0]],
        "om": [[0.1], [0.2], [0.3]],
        "r": [[0.0, 5.0], [0.0, 0.0], [2.0, 4.0]],
        "b": [[0.0, 0.5], [0.0, 0.0], [-0.5, 0.0]],
        "l": [[1.0, 2.0], [3.0, 4.0]],
        "x_true": [[0.0], [0.1], [0.3]],
        "y_true": [[0.0], [0.0], [0.0]],
        "th_true": [[0.0], [0.0], [7.0]],
        "true_valid": np.array([[1], [0], [1]], np.uint8),
    }
    return _save(path, variables, change)


def plaza(path: Path, prefix: str = "", **change: ArrayLike | None) -> Path:
    """A Plaza file of a straight drive along +x; None leaves a variable out."""
    variables: dict[str, Any] = {
        "GT": [[9.8, 0.0, 0.0, 0.0], [10.0, 0.1, 0.0, 0.0], [10.2, 0.3, 0.0, 0.0]],
        "DR": [[10.0, 0.1, 0.0], [10.2, 0.2, 0.02], [10.7, 0.5, -0.01]],
        "TD": [[10.1, 2.0, 5.0, 7.5], [10.3, 2.0, 0.0, 8.5]],
        "TL": [[0.0, 1.0, 2.0], [5.0, 3.0, 4.0]],
    }
    return _save(path, variables, change, prefix)


def _save(
    path: Path, variables: dict[str, Any], change: dict[str, ArrayLike | None], prefix: str = ""
) -> Path:
    kept = {k: v for k, v in {**variables, **change}.items() if v is not None}
    savemat(path, {prefix + name: value for name, value in kept.items()})
    return path
