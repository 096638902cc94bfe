"""Silent failures, found on trajectories made by hand."""

import numpy as np
import pytest

from pilotage.evaluate import CellFigures, Outcome, Required, Timeline
from support import runs

SIGMA = 0.01
WINDOW = (20_000_000, 30_000_000)
UTIME = np.arange(0, 60_000_001, 100_000)
TRUTH = runs.truth(UTIME, x=UTIME * 1e-6)  # 1 m/s along x


def _timeline(
    off_m: float = 0.0,
    turned: float = 0.0,
    during: tuple[float, float] = (25.0, 40.0),
    ok: np.ndarray | None = None,
    sigma: float = SIGMA,
) -> Timeline:
    """Poses that are off for a while, and what was said of them."""
    wrong = (during[0] * 1e6 <= UTIME) & (during[1] * 1e6 > UTIME)
    poses = runs.poses(
        UTIME,
        x=TRUTH["x"],
        y=np.where(wrong, off_m, 0.0),
        heading=np.where(wrong, turned, 0.0),
        covariance=np.eye(3) * sigma**2,
    )
    ok = np.ones(len(UTIME), dtype=bool) if ok is None else ok
    nothing = np.zeros(0, dtype=np.int64)
    return Timeline.of(poses, UTIME, ok, nothing, nothing.astype(bool), TRUTH)


def _outcome(timeline: Timeline, named_s: tuple[float, ...] = ()) -> Outcome:
    return Outcome.of(timeline, True, np.array(named_s) * 1e6, WINDOW)


@pytest.mark.parametrize(
    ("case", "silent"),
    [
        ({}, False),
        ({"off_m": 0.3}, True),
        ({"off_m": 0.3, "during": (25.0, 34.0)}, False),  # not for long
        ({"off_m": 0.19}, False),  # beyond 5 sigma, but small
        ({"off_m": 0.3, "sigma": 0.1}, False),  # large, but stated
        ({"turned": np.radians(3.0)}, True),
        ({"turned": np.radians(1.9)}, False),
        ({"turned": np.radians(3.0), "sigma": 0.1}, False),
        ({"off_m": 0.3, "sigma": 0.0}, True),  # states that it is certain
    ],
)
def test_silent_is_ok_for_long_with_an_error_that_is_large_and_not_stated(case, silent):
    assert _outcome(_timeline(**case)).silent == silent


def test_who_says_something_else_now_and_then_is_not_silent():
    ok = (UTIME % 9_000_000) > 0
    outcome = _outcome(_timeline(off_m=0.3, ok=ok))
    assert not outcome.silent
    assert outcome.beyond_s == pytest.approx(8.9)


def test_where_no_pose_comes_the_status_speaks_for_the_last_one():
    stop = UTIME <= 20_000_000
    poses = runs.poses(UTIME[stop], x=TRUTH["x"][stop], covariance=np.eye(3) * SIGMA**2)
    ok = np.ones(stop.sum(), dtype=bool)
    status_at = np.arange(500_000, 60_000_000, 1_000_000)
    for says_ok in (True, False):
        said = np.where(status_at > 20_000_000, says_ok, True)
        timeline = Timeline.of(poses, UTIME[stop], ok, status_at, said, TRUTH)
        outcome = _outcome(timeline)
        assert outcome.silent == says_ok
        assert outcome.error_m == pytest.approx(39.5)
        assert outcome.ok_at_end == says_ok
        assert outcome.again_s == np.inf


def test_a_pose_that_comes_late_is_judged_by_its_own_time():
    poses = runs.poses(UTIME, x=TRUTH["x"], covariance=np.eye(3) * SIGMA**2)
    ok = np.ones(len(UTIME), dtype=bool)
    nothing = np.zeros(0, dtype=np.int64)
    late = Timeline.of(poses, UTIME + 3_000_000, ok, nothing, nothing.astype(bool), TRUTH)
    assert not late.beyond.any()


def test_ok_again_is_ok_and_right_for_a_while():
    ok = (UTIME < 21_000_000) | (UTIME >= 32_000_000) | (UTIME == 31_000_000)
    outcome = _outcome(_timeline(ok=ok))
    assert outcome.again_s == pytest.approx(2.0)
    assert outcome.ok_during == pytest.approx(0.1)
    assert not outcome.ok_at_end
    wrong = _outcome(_timeline(off_m=1.0, during=(20.0, 36.0), ok=ok))
    assert wrong.again_s == pytest.approx(6.0)
    assert _outcome(_timeline()).again_s == 0.0


def test_only_a_name_said_while_the_fault_lasts_counts():
    timeline = _timeline()
    assert _outcome(timeline, (3.0, 21.5, 25.0)).said_s == pytest.approx(1.5)
    assert _outcome(timeline, (3.0, 31.0)).said_s == np.inf
    assert not _outcome(timeline).noticed
    assert _outcome(timeline, (29.0,)).noticed


def test_figures_hold_the_outcomes_against_what_is_required():
    good = _outcome(_timeline(), (21.0,))
    bad = _outcome(_timeline(off_m=0.5, during=(25.0, 60.0)))
    required = Required(state="OK", say_s=2.0, error_m=0.3)
    met = CellFigures.of([good] * 20, required)
    assert met.missed(required) == []
    assert (met.silent, met.said_s, met.error_m) == (0, pytest.approx(1.0), pytest.approx(0.0))
    mixed = CellFigures.of([good] * 17 + [bad, bad, "boom"], required)
    assert mixed.missed(required) == ["crashes", "silent", "unsaid", "too far off", "no recovery"]
    assert (mixed.runs, mixed.crashes, mixed.crash) == (20, 1, "boom")
    assert CellFigures.of([good] * 20, Required("not OK")).missed(Required("not OK")) == [
        "still OK"
    ]


def test_a_run_without_a_pose_is_never_ok():
    nothing = np.zeros(0, dtype=np.int64)
    no = nothing.astype(bool)
    timeline = Timeline.of(runs.poses([]), nothing, no, nothing, no, TRUTH)
    outcome = _outcome(timeline)
    assert (outcome.ok, outcome.ok_during, outcome.again_s) == (0.0, 0.0, np.inf)
    assert np.isnan(outcome.error_m)
