"""What a survey of a map finds: layouts that repeat, lines, circles, and where little is seen."""

from collections.abc import Callable, Iterable, Iterator
from itertools import chain

import numpy as np

from ..site import Survey, View
from ..site.words import match_words, motion_words, percent
from .finding import Finding
from .markers import too_close

WORTH = 0.01
"""A part of the poses or of the area that is less than this is not worth a finding."""


def map_repeats(survey: Survey) -> Iterator[Finding]:
    """Find a map that looks like itself from another place."""
    told = [match for match in survey.symmetries if match.ids_help]
    if not told:
        return
    others = len(told) - 1
    does = "does 1 other motion" if others == 1 else f"do {others} other motions"
    yield Finding(
        "map",
        match_words(survey, told[0]) + (f"; so {does}" if others else "") + _matters(survey),
        "where ids are not known, move a marker, or add one, so that the layout no longer repeats: "
        f"by more than {survey.tolerance_m:.2g} m",
        note=not survey.layout.labelled,
    )


def views_repeat(survey: Survey) -> Iterator[Finding]:
    """Find views that look like views from elsewhere, in a map that does not repeat as a whole."""
    views = [view for view in survey.views.alike if view.alike and view.alike.ids_help]
    part = survey.views.part(views)
    whole = any(len(match.origin) == len(survey.layout) for match in survey.symmetries)
    if whole or part < WORTH:
        return
    view = views[0]
    assert view.alike is not None
    names = survey.layout.ids
    yield Finding(
        "map",
        f"from {percent(part)} of all poses, what is seen looks as it would from elsewhere: "
        f"markers {_ids(names[view.alike.origin])} like {_ids(names[view.alike.target])}, "
        f"{motion_words(survey, view.alike)}" + _matters(survey),
        "add a marker off the pattern, or let the robot start where more markers are seen",
        note=not survey.layout.labelled,
    )


def in_line(survey: Survey) -> Iterator[Finding]:
    """Find markers in a line, where only ranges, or only bearings, are measured."""
    part = survey.views.part(survey.views.in_line)
    where = (
        "all markers stand"
        if survey.in_line
        else f"from {percent(part)} of all poses those seen stand"
    )
    if survey.mirror and (survey.in_line or part >= WORTH):
        yield Finding(
            "map",
            f"{where} in a line, and no bearing is measured: no frame tells on which side of it "
            "the robot is, with or without ids",
            f"move a marker away from the line, by more than {survey.tolerance_m:.2g} m",
        )
    if survey.bearings_only and survey.in_line:
        yield Finding(
            "map",
            f"{where} in a line, and only bearings are measured: who drives along the line sees "
            "them all ahead or behind, which does not tell how far",
            f"move a marker away from the line, by more than {survey.tolerance_m:.2g} m",
        )


def danger_circle(survey: Survey) -> Iterator[Finding]:
    """Find poses on the circle through all markers in view, where bearings fix no position.

    The danger circle of three-point resection: on it, all places see the same angles between them.
    """
    views = survey.views.on_circle
    part = survey.views.part(views, on_circle=True)
    if survey.bearings_only and part >= WORTH:
        view: View = views[0]
        assert view.circle is not None
        x, y = view.circle.centre.real, view.circle.centre.imag
        yield Finding(
            "map",
            f"{percent(part)} of all poses are near the circle through the markers they see, where "
            f"bearings alone do not fix the position; most near that of "
            f"{_ids(survey.layout.ids[view.seen])}, {view.circle.radius:.1f} m about "
            f"({x:.1f}, {y:.1f}) m",
            "add a marker inside the circle, or far outside",
        )


def blind_zone(survey: Survey) -> Iterator[Finding]:
    """Find places from which no marker is seen."""
    never = survey.coverage.fewer(1).best_heading
    if never >= WORTH:
        yield Finding(
            "map",
            f"from {percent(never)} of the area no marker is in view, whichever way the robot "
            "heads: only dead reckoning leads through",
            "add a marker there, or say with --area where the robot drives",
        )


def position_unsure(survey: Survey) -> Iterator[Finding]:
    """Find places with markers in view at which one frame is not enough, however one heads."""
    unsure = survey.coverage.radius_m.min(axis=-1) > survey.alert_limit_m
    part = float(np.mean(unsure & survey.coverage.count.any(axis=-1)))
    if part >= WORTH:
        yield Finding(
            "map",
            f"in {percent(part)} of the area there are markers in view, but no frame alone fixes "
            f"the position to {survey.alert_limit_m:g} m (95 %, status.alert_limit_m)",
            "nothing, where the robot comes from places that are better; else add markers there",
            note=True,
        )


CHECKS: tuple[Callable[[Survey], Iterable[Finding]], ...] = (
    map_repeats,
    views_repeat,
    lambda survey: too_close(survey.config.map, survey.sights),
    in_line,
    danger_circle,
    blind_zone,
    position_unsure,
)


def check_survey(survey: Survey) -> list[Finding]:
    """Return the findings of all checks."""
    return list(chain.from_iterable(check(survey) for check in CHECKS))


def _matters(survey: Survey) -> str:
    return "" if survey.layout.labelled else ". It matters only where ids are not known"


def _ids(ids: "np.ndarray[tuple[int], np.dtype[np.int32]]") -> str:
    """Name markers, not too many of them."""
    names = [str(marker) for marker in ids[:5]]
    rest = f" and {len(ids) - 5} more" if len(ids) > 5 else ""
    return ", ".join(names) + rest
