"""All figures of a run into a folder."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..evaluate import MapLike, RunLike
from . import style
from .closeup import closeup_figure
from .errors import errors_figure
from .markers import markers_figure
from .nis import nis_figure
from .path import path_figure


def save_all(
    run: RunLike,
    truth: NDArray[Any] | None,
    markers: MapLike | None,
    folder: str | Path,
    window_s: tuple[float, float] | None = None,
) -> list[Path]:
    """Write path, closeup, markers, errors and nis as PNG files.

    Parameters
    ----------
    run : RunLike
    truth : structured array with utime, x, y, heading, or None
    markers : MapLike or None
    folder : path
        Made if it is not there.
    window_s : (from, to), s since the first pose
        What the close-up shows; by default where the error is largest.

    Returns
    -------
    list of Path
        What was written: nothing if the run has no pose.
    """
    if run.poses.size == 0:
        return []
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    figures: dict[str, Callable[[], Figure]] = {
        "path": lambda: path_figure(run, truth, markers),
        "closeup": lambda: closeup_figure(run, truth, markers, window_s),
        "markers": lambda: markers_figure(run),
        "errors": lambda: errors_figure(run, truth),
        "nis": lambda: nis_figure(run),
    }
    paths = []
    for name, make in figures.items():
        paths.append(folder / f"{name}.png")
        style.save(make(), paths[-1])
    return paths
