"""A mounting from sightings of surveyed markers on a drive."""

import numpy as np
import pytest

from pilotage import CameraModel, MarkerMap
from pilotage.calibrate.extrinsics import calibrate
from pilotage.calibrate.reprojection import NAMES
from pilotage.calibrate.sightings import Sightings
from pilotage.calibrate.weak import weaknesses
from pilotage.evaluate.trajectory import trajectory
from pilotage.evaluate.truth import interpolate
from pilotage.simulate.view import sight

LENS = ((640, 480), (500.0, 505.0, 318.0, 242.0), (-0.2, 0.05, 0.0, 0.0))
TRUE = np.array([0.30, -0.05, 0.60, 0.02, 0.15, 0.10, 0.04])
START = np.array([0.25, 0.0, 0.55, 0.0, 0.12, 0.13, 0.0])
SIGMA_PX = 0.3


def eight(duration_s=60.0):
    """A figure of eight of 4 m by 2 m at changing speed, a pose every 20 ms."""
    t = np.arange(0, duration_s, 0.02)
    phase = 2 * np.pi * (t / 30 + 0.05 * np.sin(2 * np.pi * t / 11))
    x, y = 2 * np.sin(phase), np.sin(2 * phase)
    heading = np.arctan2(np.gradient(y), np.gradient(x))
    return trajectory(np.rint(1e6 * t).astype(np.int64), np.column_stack([x, y, heading]))


def straight(duration_s=20.0):
    """A line at one speed."""
    t = np.arange(0, duration_s, 0.02)
    pose = np.column_stack([-3 + 0.2 * t, 0 * t, 0 * t])
    return trajectory(np.rint(1e6 * t).astype(np.int64), pose)


def ring(rng, count=24):
    """Markers on walls and on the ground."""
    turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
    away = rng.uniform(3.0, 5.0, count)
    at = np.column_stack(
        [away * np.cos(turn), away * np.sin(turn), rng.choice([0.0, 0.6, 1.0], count)]
    )
    return MarkerMap(np.arange(count), at)


def seen_on(poses, markers, rng, ids=True, sigma_px=SIGMA_PX, every=20):
    """What a camera sees whose stamps are late by its latency."""
    camera = CameraModel(*LENS, TRUE[3], TRUE[4])
    rows = []
    for row in poses[10:-10:every]:
        at = int(row["utime"])
        (pose,) = interpolate(poses, [at - round(1e6 * TRUE[6])])
        eye, turn = sight((*TRUE[:3], TRUE[5]), pose)
        level = (markers.positions - eye) @ turn
        pixels = camera.project(level) + sigma_px * rng.standard_normal((len(level), 2))
        near = np.linalg.norm(level, axis=1) < 6
        inside = ((pixels > 0) & (pixels < (639, 479))).all(axis=1) & near
        rows += [
            (at, markers.ids[k] if ids else -1, -1, *pixels[k], sigma_px, sigma_px)
            for k in np.flatnonzero(inside)
        ]
    return Sightings.of(rows)


def fit(seed=1, hold=(), way=eight, **keys):
    rng = np.random.default_rng(seed)
    poses, markers = way(), ring(rng)
    seen = seen_on(poses, markers, rng, **keys)
    start = np.where([name in hold for name in NAMES], TRUE, START)
    return calibrate(CameraModel(*LENS), seen, poses, markers, start, hold)


def test_mountings_are_off_by_what_their_standard_deviations_say():
    off = []
    for seed in range(8):
        found = fit(seed)
        off.append((found.values - TRUE) / found.sigmas)
        assert weaknesses(found) == []
    print("error by sigma, rms of 8:", dict(zip(NAMES, np.std(off, axis=0).round(2), strict=True)))
    assert np.abs(off).max() < 4
    # Of 56 draws the spread is sure to a tenth.
    assert np.sqrt(np.mean(np.square(off))) == pytest.approx(1, abs=0.3)
    assert found.sigmas[:3].max() < 2e-3
    assert found.sigmas[3:6].max() < 1e-3


def test_residuals_tell_what_was_gained():
    found = fit()
    before, after = (np.sqrt((left**2).mean()) for left in (found.before, found.after))
    assert before > 10
    assert after == pytest.approx(SIGMA_PX, rel=0.1)


def test_markers_without_ids_are_found_from_a_start_that_is_nearly_right():
    found = fit(ids=False, sigma_px=0.1)
    assert found.used.mean() > 0.9
    assert (np.abs(found.values - TRUE) < 4 * found.sigmas).all()


def test_outliers_are_left_out():
    rng = np.random.default_rng(3)
    poses, markers = eight(), ring(rng)
    seen = seen_on(poses, markers, rng)
    wrong = rng.random(len(seen)) < 0.05
    seen.pixel[wrong] += rng.uniform(-100, 100, (wrong.sum(), 2))
    found = calibrate(CameraModel(*LENS), seen, poses, markers, START, ())
    assert (np.abs(found.values - TRUE) < 4 * found.sigmas).all()
    assert (~found.used).sum() >= 0.9 * wrong.sum()


def test_what_is_held_stays():
    found = fit(hold=("x_m", "latency_s"))
    assert found.values[[0, 6]].tolist() == TRUE[[0, 6]].tolist()
    assert found.sigmas[[0, 6]].tolist() == [0, 0]


def test_a_straight_drive_at_one_speed_does_not_tell_place_from_latency():
    found = fit(way=straight)
    problems = {one.key: one.problem for one in weaknesses(found)}
    assert "apart from latency_s" in problems["x_m"]
    assert "apart from x_m" in problems["latency_s"]
    assert set(problems) == {"x_m", "latency_s"}
    # Held, it is told.
    assert weaknesses(fit(way=straight, hold=("latency_s",))) == []


def test_poses_of_another_clock_are_refused():
    rng = np.random.default_rng(1)
    poses, markers = eight(), ring(rng)
    seen = seen_on(poses, markers, rng)
    poses["utime"] += 10**12
    with pytest.raises(ValueError, match=r"no pose at their time\)\. Do poses and pictures"):
        calibrate(CameraModel(*LENS), seen, poses, markers, START)


def test_unknown_ids_are_of_no_marker():
    rng = np.random.default_rng(1)
    poses, markers = eight(), ring(rng)
    seen = seen_on(poses, markers, rng)
    seen.id[:] += 1000
    with pytest.raises(ValueError, match=rf"{len(seen)} of no marker"):
        calibrate(CameraModel(*LENS), seen, poses, markers, START)
