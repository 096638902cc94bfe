from dataclasses import replace

from pilotage.evaluate import Nees, Row, compute_metrics, table_rows
from support import runs


def one_row_run() -> runs.Run:
    return runs.Run(
        poses=runs.poses([0], x=0.5, heading=-0.1),
        reports=runs.reports([0], nis=1.25),
        counts={"messages": 3, "samples": 2, "accepted": 1, "rejected": {"gate": 4}},
        wall_s=0.001,
    )


def test_rows_carry_label_value_and_unit() -> None:
    rows = table_rows(compute_metrics(one_row_run(), runs.truth([0])))
    assert Row("position error, RMSE", "0.500", "m") in rows
    assert Row("heading error, mean", "-5.73", "deg") in rows
    assert Row("NEES, mean (expected 3)", "0.26", "") in rows
    assert Row("NIS of camera, mean (expected 1)", "1.25", "") in rows
    assert Row("rejected: gate", "4", "") in rows
    assert Row("speed", "3,000", "messages/s") in rows


def test_what_is_not_known_has_no_row() -> None:
    labels = [row.label for row in table_rows(compute_metrics(one_row_run(), None))]
    assert not any("error" in label or "NEES" in label for label in labels)


def test_left_out_rows_are_told() -> None:
    metrics = compute_metrics(one_row_run(), runs.truth([0]))
    told = table_rows(replace(metrics, nees=Nees(mean=3.0, dof=3, singular=2)))
    assert Row("rows without NEES: singular covariance", "2", "") in told


def test_sensor_that_was_never_fused_is_told() -> None:
    run = one_row_run()
    run.reports["accepted"] = False
    rows = table_rows(compute_metrics(run, None))
    assert Row("NIS of camera, mean", "none accepted", "") in rows
