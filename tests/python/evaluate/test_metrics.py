import json
import math
from pathlib import Path

import numpy as np
import pytest

from pilotage.evaluate import Nees, Nis, compute_metrics, pose_errors
from support import runs

COUNTS = {"messages": 500, "samples": 400, "accepted": 90, "rejected": {"gate": 7}}


def small_run() -> runs.Run:
    """Four poses 0.5 s apart: off by 3 m, 4 m, 0 m, and one beyond the truth."""
    return runs.Run(
        poses=runs.poses(
            [0, 500_000, 1_000_000, 9_000_000],
            x=[3.0, 0.0, 0.0, 100.0],
            y=[0.0, -4.0, 0.0, 0.0],
            heading=np.radians([1.0, -3.0, 5.0, 90.0]),
            covariance=np.diag([1.0, 4.0, np.radians(1.0) ** 2]),
        ),
        reports=runs.reports(
            [0, 1, 2, 3],
            sensor=[0, 0, 0, 1],
            nis=[1.0, 4.0, 50.0, 9.0],
            dof=[1, 2, 2, 3],
            accepted=[True, True, False, False],
        ),
        sensors=("camera", "laser"),
        counts=COUNTS,
        wall_s=0.25,
    )


TRUTH = runs.truth([0, 500_000, 1_000_000])


def test_position_and_heading_by_hand() -> None:
    metrics = compute_metrics(small_run(), TRUTH)
    position, heading = metrics.position, metrics.heading
    assert position is not None
    assert position.rmse_m == pytest.approx(math.sqrt(25.0 / 3.0))
    assert position.mean_m == pytest.approx(7.0 / 3.0)
    assert position.std_m == pytest.approx(math.sqrt(25.0 / 3.0 - 49.0 / 9.0))
    assert position.p95_m == pytest.approx(3.9)
    assert position.max_m == 4.0
    assert heading is not None
    assert heading.rmse_deg == pytest.approx(math.sqrt(35.0 / 3.0))
    assert heading.mean_deg == pytest.approx(1.0)
    assert heading.std_deg == pytest.approx(math.sqrt(35.0 / 3.0 - 1.0))
    assert heading.median_abs_deg == pytest.approx(3.0)


def test_mean_of_heading_errors_keeps_its_sign_across_pi() -> None:
    run = small_run()
    run.poses["heading"] = np.radians([-179.0, -178.0, -179.0, 0.0])
    heading = compute_metrics(run, runs.truth([0, 500_000, 1_000_000], heading=np.pi)).heading
    assert heading is not None
    assert heading.mean_deg == pytest.approx(4.0 / 3.0)


def test_nees_by_hand() -> None:
    # 3²/1 + 1², 4²/4 + 3², 0 + 5²
    nees = compute_metrics(small_run(), TRUTH).nees
    assert nees is not None
    assert nees.mean == pytest.approx((10.0 + 13.0 + 25.0) / 3.0)
    assert (nees.dof, nees.singular) == (3, 0)


def test_rows_of_singular_covariance_are_left_out_of_the_nees_and_counted() -> None:
    run = small_run()
    run.poses["covariance"][0] = 0.0
    nees = compute_metrics(run, TRUTH).nees
    assert nees is not None
    assert nees.mean == pytest.approx(19.0)
    assert nees.singular == 1
    run.poses["covariance"] = 0.0
    assert compute_metrics(run, TRUTH).nees is None


def test_nis_is_a_mean_over_accepted_sightings_of_each_sensor() -> None:
    assert compute_metrics(small_run(), TRUTH).nis == {
        "camera": Nis(mean=2.5, dof=1.5, count=2),
        "laser": Nis(mean=None, dof=None, count=0),
    }


def test_counts_duration_and_speed() -> None:
    metrics = compute_metrics(small_run(), TRUTH)
    assert metrics.duration_s == 9.0
    assert metrics.messages_per_s == 2000.0
    assert (metrics.counts.samples, metrics.counts.accepted) == (400, 90)
    assert metrics.counts.rejected == {"gate": 7}


def test_heading_is_known_apart_from_position() -> None:
    truth = TRUTH.copy()
    truth["heading"] = np.nan
    metrics = compute_metrics(small_run(), truth)
    assert metrics.position is not None
    assert metrics.heading is None
    assert metrics.nees is None


def test_file_has_the_agreed_keys_and_null_without_truth(tmp_path: Path) -> None:
    path = tmp_path / "metrics.json"
    compute_metrics(small_run(), TRUTH).save(path)
    content = json.loads(path.read_text())
    assert list(content) == [
        "position", "heading", "nees", "nis", "counts", "duration_s", "messages_per_s",
    ]  # fmt: skip
    assert list(content["position"]) == ["rmse_m", "mean_m", "std_m", "p95_m", "max_m"]
    assert list(content["heading"]) == ["rmse_deg", "mean_deg", "std_deg", "median_abs_deg"]
    assert list(content["nees"]) == ["mean", "dof"]
    assert list(content["nis"]["camera"]) == ["mean", "dof", "count"]
    assert list(content["counts"]) == ["samples", "accepted", "rejected"]

    compute_metrics(small_run(), None).save(path)
    content = json.loads(path.read_text())
    assert content["position"] is content["heading"] is content["nees"] is None


def test_run_without_a_pose_still_has_metrics() -> None:
    run = runs.Run(poses=runs.poses([]))
    metrics = compute_metrics(run, TRUTH)
    assert metrics.position is None
    assert metrics.duration_s == 0.0
    assert metrics.messages_per_s is None


def test_nees_of_a_true_filter_is_its_dof() -> None:
    covariance = np.diag([0.04, 0.09, 0.001])
    error = np.random.default_rng(5).multivariate_normal(np.zeros(3), covariance, size=4000)
    utime = np.arange(4000)
    poses = runs.poses(utime, error[:, 0], error[:, 1], error[:, 2], covariance)
    nees = Nees.of(pose_errors(poses, runs.truth(utime)), poses["covariance"])
    assert nees is not None
    assert nees.mean == pytest.approx(3.0, abs=0.12)  # three sigma: 3 · sqrt(6 / 4000)
