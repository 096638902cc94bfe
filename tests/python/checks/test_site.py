"""Each finding of a survey, where it belongs and nowhere else."""

from dataclasses import replace

import numpy as np
import pytest

from pilotage import MarkerMap
from pilotage.checks import check_config
from pilotage.checks.site import check_survey
from pilotage.simulate import worlds
from pilotage.site import Survey
from support.sites import BEARINGS, GRID, LINE, RANGES, RECTANGLE, SQUARE, site

YARD = worlds.yard().positions[:, :2]
TWINS = [*YARD, YARD[4] + [0.2, 0.0]]
MATTERS = "It matters only where ids are not known"


def _found(config, **how) -> list:
    return check_survey(Survey.of(config, **how))


def test_a_good_map_seen_all_round_has_no_finding():
    assert _found(site(YARD)) == []


@pytest.mark.parametrize(
    ("xy", "words"),
    [
        (SQUARE, "turned by 90° about (2.0, 2.0) m, all 4 markers fall on markers; "
                 "so do 2 other motions"),
        (RECTANGLE, "turned by 180° about (3.0, 1.5) m, all 4 markers fall on markers."),
        ([(0, 0), (4, 0), (4, 4), (0, 4), (2, 9)],
         "turned by 90° about (2.0, 2.0) m, 4 of 5 markers fall on markers; "),
        ([(0, 0), (4, 0), (4.1, 4), (0, 4)], "all 4 markers fall on markers within 0.0"),
    ],
)  # fmt: skip
def test_a_layout_that_repeats_is_a_note_while_ids_are_known(xy, words: str):
    (finding,) = _found(site(xy))
    assert words in finding.problem
    assert MATTERS in finding.problem
    assert finding.note
    assert "0.15 m" in finding.remedy


def test_a_layout_that_repeats_is_a_warning_where_labels_stand_for_ids():
    survey = Survey.of(site(SQUARE))
    (finding,) = check_survey(replace(survey, layout=replace(survey.layout, labelled=True)))
    assert not finding.note
    assert MATTERS not in finding.problem


def test_views_that_repeat_name_their_markers():
    found = _found(site([*GRID, (2.0, 80.0)]), reach_m=8.0, area=(0, 0, 19, 42))
    views = [finding for finding in found if "what is seen looks as it would" in finding.problem]
    assert len(views) == 1
    assert "of all poses" in views[0].problem
    assert " like " in views[0].problem
    assert views[0].note


def test_twins_are_named_with_what_the_sensor_tells_apart():
    sensor = {"sigma_bearing_rad": 0.02, "sigma_range_m": 0.08}
    (finding,) = _found(site(TWINS, sensor))
    assert "markers 4 and 10 are 0.2 m apart" in finding.problem
    assert "eye tells apart 0.24 m (3 σ)" in finding.problem
    assert not finding.note
    assert _found(site(TWINS)) == []  # a sensor of 5 cm tells them apart


def test_twins_are_told_apart_by_height_where_elevations_are_measured():
    sensor = {"sigma_bearing_rad": 0.02, "sigma_range_m": 0.08}
    config = site(TWINS, sensor)
    positions = config.map.positions
    positions[10, 2] += 0.1
    config.map = MarkerMap(config.map.ids, positions)
    (flat,) = _found(config)
    assert "markers 4 and 10 are 0.2 m apart" in flat.problem
    config["sensors.eye.sigma_elevation_rad"] = 0.01
    (high,) = _found(config)
    assert "markers 4 and 10 are 0.224 m apart" in high.problem
    positions[10, 2] += 3.0
    config.map = MarkerMap(config.map.ids, positions)
    assert _found(config) == []
    assert [f for f in check_config(config) if f.key == "map"] == []


def test_what_is_told_of_the_sensor_counts_for_twins():
    sensor = {"sigma_bearing_rad": 0.02, "sigma_range_m": 0.5}
    assert any("apart" in f.problem for f in _found(site(TWINS, sensor)))
    found = _found(site(TWINS, sensor), components=["bearing"])
    assert not any("0.5" in f.problem for f in found if "tells apart" in f.problem)


def test_ranges_from_a_line_are_a_warning_with_or_without_ids():
    (finding,) = (f for f in _found(site(LINE, RANGES)) if not f.note)
    assert "all markers stand in a line" in finding.problem
    assert "with or without ids" in finding.problem


def test_bearings_from_a_line_are_a_warning():
    found = [f for f in _found(site(LINE, BEARINGS)) if not f.note]
    assert [f.problem.startswith("all markers stand in a line, and only bearings") for f in found]


def test_the_danger_circle_is_told_by_its_markers():
    xy = [(0, 0), (5, 0), (2, 4)]
    found = [f.problem for f in _found(site(xy, BEARINGS)) if "circle" in f.problem]
    assert len(found) == 1
    assert "most near that of 0, 1, 2, 2.8 m about (2.5, 1.3) m" in found[0]
    assert _found(site(xy)) == []  # ranges fix the position there too


def test_a_blind_zone_and_an_unsure_position_are_parts_of_the_area():
    blind, unsure = _found(site([(0, 0)], RANGES), reach_m=2.0, area=(-5, -5, 5, 5))
    assert "from 88 % of the area no marker is in view, whichever way" in blind.problem
    assert not blind.note
    assert "in 12 % of the area there are markers in view, but no frame" in unsure.problem
    assert "to 1 m (95 %, status.alert_limit_m)" in unsure.problem
    assert unsure.note


def test_a_narrow_view_is_not_called_blind():
    assert [f for f in _found(site(YARD), view_rad=np.radians(57)) if not f.note] == []
