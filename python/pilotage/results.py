"""The folder that a run leaves behind; `stored` reads it again."""

from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from . import Config, Run
from .evaluate import Row, compute_metrics, table_rows


def save_results(
    run: Run,
    config: Config,
    truth: NDArray[Any] | None,
    folder: Path | None,
    figures: bool = True,
) -> list[Row]:
    """Write poses, reports, metrics, the configuration as used and figures into a folder.

    Returns the table's rows; without a folder only these are made.
    """
    metrics = compute_metrics(run, truth)
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        run.write_poses_csv(str(folder / "pose.csv"))
        run.write_poses_tum(str(folder / "pose.tum"))
        run.write_reports_csv(str(folder / "reports.csv"))
        (folder / "config.yaml").write_text(config.to_yaml(), encoding="utf-8")
        metrics.save(folder / "metrics.json")
        if truth is not None:
            _write_truth(truth, folder / "truth.csv")
        if figures:
            from .plot import save_all

            save_all(run, truth, config.map, folder)
    return table_rows(metrics)


def _write_truth(truth: NDArray[Any], path: Path) -> None:
    rows = "".join(f"{t},{x},{y},{heading}\n" for t, x, y, heading in truth.tolist())
    path.write_text("utime,x,y,heading\n" + rows, encoding="utf-8")
