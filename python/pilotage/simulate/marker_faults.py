"""What goes wrong with markers: at the site, or in telling one from another."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap
from ..evaluate import wrap_angle
from .faults import Strike, joined
from .streams import Stream


def wrong_id(stream: Stream, strike: Strike, share: float) -> Stream:
    """Sightings carry the number of another marker, each with a probability."""
    other = other_ids(stream.id, strike.markers, strike.rng)
    wrong = strike.hit & (strike.rng.random(len(stream)) < share)
    return replace(stream, id=np.where(wrong, other, stream.id))


def swapped_pair(stream: Stream, strike: Strike) -> Stream:
    """Two markers carry each other's number."""
    one = _some_seen(stream, strike)
    other = _some_seen(stream, strike, besides=one)
    is_one, is_other = strike.hit & (stream.id == one), strike.hit & (stream.id == other)
    return replace(stream, id=np.where(is_one, other, np.where(is_other, one, stream.id)))


def moved(stream: Stream, strike: Strike, distance_m: float) -> Stream:
    """A marker stands elsewhere than surveyed, in some direction."""
    marker = _some_seen(stream, strike)
    before = strike.markers.positions[strike.markers.ids == marker][0]
    direction = strike.rng.uniform(-np.pi, np.pi)
    step = distance_m * np.array([np.cos(direction), np.sin(direction), 0.0])
    rows = np.flatnonzero(strike.hit & (stream.id == marker))
    utime = stream.utime[rows]
    value = stream.value.copy()
    value[rows] += strike.look(before + step, utime) - strike.look(before, utime)
    value[:, 0] = wrap_angle(value[:, 0])
    return replace(stream, value=value)


def removed(stream: Stream, strike: Strike) -> Stream:
    """A marker is gone."""
    return stream.rows(~strike.hit | (stream.id != _some_seen(stream, strike)))


def phantom(stream: Stream, strike: Strike, share: float, reach_m: float) -> Stream:
    """Frames show, each with a probability, a marker of the map where there is none."""
    _, first = np.unique(stream.seq, return_index=True)
    haunted = first[strike.hit[first] & (strike.rng.random(len(first)) < share)]
    ghosts = stream.rows(haunted)
    value = strike.rng.uniform((-np.pi / 2, -0.1, 1.0), (np.pi / 2, 0.1, reach_m), (len(ghosts), 3))
    value[np.isnan(ghosts.value)] = np.nan
    ghosts = replace(ghosts, value=value, id=strike.rng.choice(strike.markers.ids, len(ghosts)))
    together = joined(stream, ghosts)
    return together.rows(np.argsort(together.seq, kind="stable"))  # into the frames they haunt


def other_ids(
    ids: NDArray[np.int32], markers: MarkerMap, rng: np.random.Generator
) -> NDArray[np.int32]:
    """Return for each the number of another marker of the map, (n,)."""
    known: NDArray[np.int32] = np.sort(markers.ids)
    step = rng.integers(1, len(known), len(ids))
    return np.asarray(known[(np.searchsorted(known, ids) + step) % len(known)])


def _some_seen(stream: Stream, strike: Strike, besides: int | None = None) -> int:
    """Choose a marker that is seen while the fault lasts, the more likely the more it is seen."""
    seen: NDArray[np.int32] = stream.id[strike.hit & (stream.id != besides)]
    if len(seen) == 0:
        raise ValueError("too few markers are seen while the fault lasts: choose another scenario")
    return int(strike.rng.choice(seen))
