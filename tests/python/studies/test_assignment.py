"""The assignment: its handout's numbers, and what its examples must show."""

import json

import numpy as np
import pytest

from pilotage.evaluate import ellipse_scale
from pilotage.studies.assignment_ends import (
    ASSIGNED,
    FORGOTTEN,
    GATED,
    MOVES,
    UNSCENTED,
    WEIGHTED,
    ends,
)
from pilotage.studies.assignment_handout import PRINTED, handout
from pilotage.studies.assignment_narrative import PROBABILITY
from pilotage.studies.study import Request, find_study

RUNS = 300


@pytest.fixture(scope="module")
def found():
    return find_study("assignment").run(Request(effort=0.05, jobs=1))


@pytest.mark.parametrize("name", [name for name, (_, wrong) in PRINTED.items() if not wrong])
def test_the_handouts_right_numbers_are_ours(name):
    _, _, ours = handout()
    assert ours[name] == pytest.approx(PRINTED[name][0], rel=2e-4, abs=1e-12)


def test_the_handouts_wrong_numbers_are_not_ours():
    _, _, ours = handout()
    wrong = [name for name, (_, why) in PRINTED.items() if why]
    assert len(wrong) == 10
    assert all(ours[name] != pytest.approx(PRINTED[name][0], rel=5e-3) for name in wrong)
    right = {
        "prior orientation, °": 176.68,
        "revised orientation, °": 1.317,
        "prior 2σ_θ, °": 12.886,
        "revised 2σ_θ, °": 12.523,
        "revised σ_x², m²": 0.019191,
        "revised σ_xy": 0.000433,
        "revised σ_xθ": -0.009148,
        "revised σ_y²": 0.000386,
        "revised σ_yθ": -0.000641,
        "revised σ_θ², rad²": 0.011942,
    }
    assert set(right) == set(wrong)
    for name, value in right.items():
        assert ours[name] == pytest.approx(value, abs=0.0051 if "°" in name else 6e-7)


@pytest.mark.parametrize("when", ["prior", "revised"])
def test_both_orientations_were_converted_to_degrees_twice(when):
    _, _, ours = handout()
    name = f"{when} orientation, °"
    angle = np.radians((ours[name] + 90.0) % 180.0 - 90.0)
    twice = np.degrees(np.degrees(angle)) % 360.0
    assert twice == pytest.approx(PRINTED[name][0], abs=0.15)


def test_the_printed_ellipse_is_of_our_revised_covariance_and_not_of_the_printed_one():
    xx, yy, xy = (PRINTED[f"revised σ_{at}"][0] for at in ("x², m²", "y²", "xy"))
    minor = ellipse_scale(PROBABILITY) * np.sqrt(np.linalg.eigvalsh([[xx, xy], [xy, yy]])[0])
    assert minor > 2.0 * PRINTED["revised minor radius, m"][0]


def test_an_update_never_lets_a_variance_grow_as_the_printed_one_does():
    prior, revised, _ = handout()
    assert (np.diag(revised.covariance) <= np.diag(prior.covariance)).all()
    assert PRINTED["revised σ_x², m²"][0] > PRINTED["prior σ_x², m²"][0]


def test_motion_without_noise_is_followed_exactly():
    exact = ends("exact", ASSIGNED, 1, 3)
    assert np.abs(exact.error).max() <= 1e-12
    assert (exact.covariance == 0).all()


def test_variance_adds_up_along_a_straight_way():
    straight = ends("straight", ASSIGNED, 1, RUNS)
    expected = np.zeros((3, 3))
    expected[0, 0] = 16 * 0.1**2
    np.testing.assert_allclose(straight.covariance[0], expected, atol=1e-15)
    assert straight.position_m == pytest.approx(0.4, rel=0.12)


def test_around_a_square_the_ellipse_and_the_cone_hold_what_they_say():
    square = ends("square", ASSIGNED, 1, 1000)
    assert 0.93 <= square.in_ellipse(PROBABILITY) <= 0.975
    assert 0.83 <= square.in_ellipse(1 - np.exp(-2)) <= 0.90, "a 2σ ellipse holds 86.5 %"
    assert 0.93 <= square.in_cone() <= 0.975


def test_ranges_to_the_sides_teach_across_and_the_heading_but_nothing_along():
    ranged = ends("corridor", ASSIGNED, 1, RUNS)
    unaided, forgotten = (ends("corridor", way, 1, RUNS) for way in (MOVES, FORGOTTEN))
    sigma, without = (np.sqrt(of.covariance.mean(axis=0).diagonal()) for of in (ranged, unaided))
    assert 0.98 <= sigma[0] / without[0] <= 1.0
    assert sigma[1] / without[1] <= 0.05
    assert ranged.heading_deg <= 0.1 * unaided.heading_deg
    assert forgotten.heading_deg == pytest.approx(unaided.heading_deg), "only σ_yθ carries it"


@pytest.mark.parametrize("seed", [1, 2])
def test_on_a_tour_the_estimate_stays_with_the_truth(seed):
    weighted = ends("tour", WEIGHTED, seed, RUNS)
    assert weighted.lost <= 0.02
    assert weighted.position_m <= 0.1 * ends("tour", MOVES, seed, RUNS).position_m


@pytest.mark.parametrize("seed", [1, 2])
def test_a_wide_heading_is_more_than_the_extended_filter_can_say(seed):
    assert ends("spread", ASSIGNED, seed, RUNS).in_ellipse(PROBABILITY) <= 0.85
    assert 0.90 <= ends("spread", UNSCENTED, seed, RUNS).in_ellipse(PROBABILITY) <= 0.985


@pytest.mark.parametrize("seed", [1, 2])
def test_the_filter_diverges_where_the_range_jumps(seed):
    assert ends("divergence", ASSIGNED, seed, RUNS).lost >= 0.8
    assert ends("divergence", GATED, seed, RUNS).lost <= 0.1


def test_the_study_leaves_results_tables_and_figures(found, tmp_path):
    paths = found.save(tmp_path)
    figures = {"narrative", "examples", "divergence", "limits"}
    assert {path.name for path in paths} == {"results.json", *(f"{name}.png" for name in figures)}
    stored = json.loads((tmp_path / "results.json").read_text())
    assert stored["results"]["ends"]["as assigned"]["exact"]["position_rms_m"] <= 1e-12
    assert stored["results"]["ends"]["as assigned"]["exact"]["in_ellipse"] is None
    assert len(stored["tables"]) == 4


def test_every_row_is_as_wide_as_its_head(found):
    for table in found.tables:
        assert table.rows
        assert all(len(row) == len(table.head) for row in table.rows)


def test_the_number_of_processes_changes_nothing(found):
    other = find_study("assignment").run(Request(effort=0.05, jobs=2))
    assert other.results == found.results


def test_another_seed_is_another_drive():
    one, other = (ends("square", ASSIGNED, seed, 2) for seed in (1, 2))
    assert (one.error != other.error).any()
