"""Real recordings without ids: what association costs, and that it is never sure of wrong."""

from pathlib import Path

import numpy as np
import pytest

from pilotage import Run
from pilotage.evaluate import Timeline, compute_metrics
from pilotage.logs import Log, read, without_ids
from pilotage.replaying import replay_log
from support import made_logs
from support.datasets import dataset
from support.messages import messages

_OK = 2


def test_only_the_ids_are_taken_out(tmp_path: Path):
    log = read(made_logs.woods(tmp_path / "a.mat"))
    before, after = messages(log.recording), messages(without_ids(log).recording)
    assert before.keys() == after.keys()
    assert len(before["MARKERS"]) == len(after["MARKERS"]) > 0
    for one, other in zip(before["MARKERS"], after["MARKERS"], strict=True):
        assert {s.id for s in other.sightings} == {-1}
        for seen, anonymous in zip(one.sightings, other.sightings, strict=True):
            anonymous.id = seen.id
        assert one.encode() == other.encode()


def _position_rmse_m(log: Log, run: Run) -> float:
    position = compute_metrics(run, log.truth).position
    assert position is not None
    return position.rmse_m


def _wrong(with_ids: Run, without: Run) -> tuple[int, int]:
    """How many sightings were fused as of another marker than the ids say, and how many in all."""
    true, found = (
        {
            (r["utime"], r["index"]): int(r["id"])
            for r in run.reports
            if run is with_ids or r["accepted"]
        }
        for run in (with_ids, without)
    )
    return sum(true[key] != id for key, id in found.items()), len(found)


def test_lost_in_the_woods_needs_no_ids():
    log = read(dataset("lost-in-the-woods") / "dataset2.mat")
    known, found = replay_log(log).run, replay_log(without_ids(log)).run
    assert _position_rmse_m(log, found) <= 1.1 * _position_rmse_m(log, known)
    wrong, fused = _wrong(known, found)
    assert wrong <= 0.002 * fused
    assert fused >= 0.95 * np.count_nonzero(known.reports["accepted"])


@pytest.mark.parametrize("robot", [1, 2, 3])
def test_mrclam_without_ids_is_never_long_sure_of_a_wrong_place(robot: int):
    """Markers stand 0.2 m apart, a fifth of the detections are other robots."""
    log = read(dataset("mrclam") / "MRCLAM_Dataset6", robot=robot)
    assert log.truth is not None
    run = replay_log(without_ids(log)).run
    nothing = np.empty(0, np.int64)
    timeline = Timeline.of(
        run.poses,
        run.poses["utime"],
        run.poses["status"] == _OK,
        nothing,
        nothing.astype(bool),
        log.truth,
    )
    assert timeline.longest_s(timeline.ok & (timeline.distance > 1.0)) <= 10.0
