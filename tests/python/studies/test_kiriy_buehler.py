"""The first paper's study: what it writes, what it must show, and what the printed forms do."""

import json
from dataclasses import replace

import numpy as np
import pytest

from pilotage import MarkerModel
from pilotage.logs.mower import Triple
from pilotage.studies import kiriy_listing
from pilotage.studies.kiriy_buehler import (
    HEADING_BAR_DEG,
    PAPER,
    POSITION_BAR_M,
    STUDY,
)
from pilotage.studies.kiriy_listing import INPUT_NOISE, PROCESS_NOISE, TRACK_WIDTH_M, Mends
from pilotage.studies.kiriy_runs import (
    DEFAULTS,
    EKFS,
    WISHES,
    Wish,
    drive_log,
    errors_of,
    errors_of_run,
    localize,
    measures,
    one_run,
)
from pilotage.studies.study import Request


@pytest.fixture(scope="module")
def found():
    told = []
    findings = STUDY.run(Request(seed=3, effort=0.04, jobs=2, progress=told.append))
    assert told[-1] == 1.0
    return findings


def test_it_writes_results_tables_and_figures(found, tmp_path):
    paths = found.save(tmp_path)
    assert {path.name for path in paths} == {"results.json"} | {
        f"figure-{n}.png" for n in (4, 5, 6, 7)
    }
    assert all(path.stat().st_size > 5000 for path in paths)
    stored = json.loads((tmp_path / "results.json").read_text())
    assert stored["results"]["runs"] == 2
    assert stored["results"]["bars"]["position_mean_m"]["is"] > 0.0
    titles = [table["title"] for table in stored["tables"]]
    assert [title.split()[0] for title in titles] == ["Table", "The", "What", "What"]
    for table in stored["tables"]:
        assert all(len(row) == len(table["head"]) for row in table["rows"])


def test_a_run_depends_on_seed_and_number_alone(found):
    alone = one_run(3, 1, False)
    for name, values in alone.items():
        assert found.results["of_each_run"][name][1] == pytest.approx(values, abs=0.0), name


def test_velocities_in_the_state_leave_the_pose_as_it_is(found):
    pose, velocities = (found.results["of_each_run"][name][0] for name in EKFS)
    assert velocities[0] == pytest.approx(pose[0], rel=0.25)
    assert velocities[0] != pose[0]
    assert pose[0] < 0.6


def test_our_defaults_keep_the_bar():
    of_runs = np.mean([_ours(k) for k in range(20)], axis=0)
    assert of_runs[0] <= POSITION_BAR_M
    assert of_runs[3] <= HEADING_BAR_DEG


def test_faster_and_better_marker_data_help_as_the_paper_expects():
    usual = np.mean([_ours(k)[0] for k in range(4)])
    for name, part in (("markers 10 times as often", 0.7), ("a tenth of it", 0.6)):
        assert np.mean([_ours(k, WISHES[name])[0] for k in range(4)]) < part * usual


def test_the_uniform_clock_that_the_paper_warns_of_costs_metres():
    assert _ours(0, WISHES["uniform clock, 5 s behind"])[0] > 4 * _ours(0)[0]


def test_the_filter_of_the_text_is_near_the_papers_row_with_ideal_angles():
    triple = drive_log(1, 0, Wish(noise=0.0))
    mended = kiriy_listing.run(triple, kiriy_listing.MENDED, kiriy_listing.IDEAL_NOISE)
    position, _, _, heading, _ = measures(errors_of(mended.estimates, triple))
    assert PAPER["ideal"][0] / 3 < position < PAPER["ideal"][0] * 1.5
    assert heading < PAPER["ideal"][3]


# What the errata say of the printed forms.


def test_eq_22_with_a_gyro_makes_more_than_half_of_the_headings_noise():
    triple = _first_rows(drive_log(1, 0), 100)
    as_wheels = 2 * INPUT_NOISE[0, 0] / TRACK_WIDTH_M**2
    assert as_wheels == pytest.approx(1.0e-4, rel=0.01)
    assert as_wheels / (as_wheels + PROCESS_NOISE[2]) == pytest.approx(0.57, abs=0.005)
    before_any_sighting = 5
    for mends, a_step in (
        (Mends(), as_wheels + PROCESS_NOISE[2]),
        (Mends(gyro_noise=True), PROCESS_NOISE[2]),
    ):
        variance = kiriy_listing.run(triple, mends).covariances[:before_any_sighting, 2, 2]
        assert np.diff(variance) == pytest.approx(np.full(before_any_sighting - 1, a_step))


def test_eq_25_has_a_minus_where_the_paper_prints_a_plus():
    model = MarkerModel([5.0, 2.0, 0.0], ["elevation"], [0.0, 0.0, 0.226, 0.0])
    pose, step = np.array([1.0, 1.0, 0.3]), 1e-6
    _, jacobian, _ = model.linearize(pose)
    dx, dy, mu = 4.0, 1.0, 0.226
    d = np.hypot(dx, dy)
    printed = np.array([mu * dx, mu * dy]) / (d * (mu**2 + d**2))
    assert jacobian[0, :2] == pytest.approx(-printed)
    moved = model.predict(pose + np.array([[step, 0, 0], [-step, 0, 0]]))[:, 0]
    assert (moved[0] - moved[1]) / (2 * step) == pytest.approx(-printed[0], rel=1e-6)


def test_the_listing_fuses_a_sighting_never_once_or_twice():
    triple = drive_log(1, 0)

    def times_fused(once: bool) -> np.ndarray:
        due = kiriy_listing.sightings_by_row(triple, once)
        fused = [k for row, seen in due.items() if row < len(triple.time) for k in seen]
        return np.bincount(fused, minlength=len(triple.sighting_time))

    assert {0, 1, 2} <= set(times_fused(once=False).tolist())
    assert set(times_fused(once=True).tolist()) <= {0, 1}  # 0: after the last row
    assert times_fused(once=True).mean() > 0.99


def test_each_mend_of_the_listing_changes_it():
    triple = _first_rows(drive_log(1, 0), 12_000)
    printed = kiriy_listing.run(triple).estimates
    for mend in ("fuse_once", "gyro_noise", "refreshed", "stamped"):
        assert not np.allclose(kiriy_listing.run(triple, Mends(**{mend: True})).estimates, printed)


def test_table_1_prints_a_variance_that_lacks_its_first_digit():
    assert PAPER["real"][3] ** 2 == pytest.approx(12.168, abs=0.01)
    assert PAPER["ideal"][3] ** 2 == pytest.approx(1.695, abs=0.01)


def _first_rows(triple: Triple, rows: int) -> Triple:
    log = replace(triple, time=triple.time[:rows], motion=triple.motion[:rows])
    return replace(log, truth=triple.truth[:rows])


def _ours(run: int, wish: Wish = DEFAULTS) -> np.ndarray:
    return measures(errors_of_run(*localize(drive_log(1, run, wish), wish)))
