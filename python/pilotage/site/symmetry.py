"""Motions that bring markers onto markers: without ids, poses that nothing tells apart.

A motion is known from what it does to two markers. So a pair of markers (an anchor) is held
against all pairs that are as far apart, and each motion that this gives is tried on the others.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .layout import Indices, Layout
from .motion import Motion, Places

MANY = 0.7
"""The part of the markers that makes a motion of the whole map worth a word."""
ANCHORS = 16
PROBES = 16
"""Markers that a motion is tried on first."""
BLOCK = 128
"""Motions that are tried at once, where the first that fits is enough."""
BEST = 24
"""Of the motions of an anchor, so many are looked at closely: a large grid has hundreds."""


class Match(NamedTuple):
    """A motion with what it does to some of the markers."""

    motion: Motion
    origin: Indices
    """(k,) markers that fall on markers."""
    target: Indices
    """(k,) those they fall on, each once."""
    error_m: float
    """The furthest that one of them falls beside."""

    @property
    def ids_help(self) -> bool:
        """Whether a marker falls on another one, so that its id tells."""
        return bool(np.any(self.origin != self.target))


def symmetries(layout: Layout, tolerance_m: float, mirror: bool) -> list[Match]:
    """Find the motions that bring many of all markers onto markers, the best first.

    Anchors share no marker, so a motion that leaves out k markers spoils k of them at most: with
    k + 1 of them it is found. Maps of hundreds are content with `ANCHORS`.

    Parameters
    ----------
    layout : Layout
    tolerance_m : float
    mirror : bool
        Also look for mirrored layouts.
    """
    n = len(layout)
    needed = max(int(np.ceil(MANY * n)), min(n, 3), 2)
    everyone = np.arange(n)
    probes = everyone[:: -(-n // PROBES)] if n else everyone
    found: dict[bytes, Match] = {}
    for one, other in _anchors(layout, n - needed + 1):
        for flip in (False, True) if mirror else (False,):
            turn, shift = _candidates(layout, one, other, tolerance_m, flip)
            hits = _onto(layout, turn, shift, flip, probes, 2.0 * tolerance_m) < n
            hits = hits.sum(axis=1)
            best = np.argsort(-hits, kind="stable")[:BEST]
            best = best[hits[best] >= len(probes) * MANY / 2.0]
            for match in _settled(layout, turn[best], shift[best], flip, everyone, tolerance_m):
                if len(match.origin) >= needed:
                    found.setdefault(match.target.tobytes() + match.origin.tobytes(), match)
    return _distinct(layout, list(found.values()), tolerance_m)


def elsewhere(layout: Layout, seen: Indices, tolerance_m: float, mirror: bool) -> Match | None:
    """Find another place from which all markers seen look alike; (k,) indices, three or more."""
    z = layout.z[seen]
    one = int(np.argmax(np.abs(z - z.mean())))
    other = int(np.argmax(np.abs(z - z[one])))
    probes = seen[:: -(-len(seen) // PROBES)]
    for flip in (False, True) if mirror else (False,):
        turns, shifts = _candidates(layout, seen[one], seen[other], tolerance_m, flip)
        for start in range(0, len(turns), BLOCK):
            turn, shift = turns[start : start + BLOCK], shifts[start : start + BLOCK]
            for some in (probes[:3], probes):  # most fail by one of the first
                on = _onto(layout, turn, shift, flip, some, 2.0 * tolerance_m) < len(layout)
                turn, shift = turn[on.all(axis=1)], shift[on.all(axis=1)]
            for match in _settled(layout, turn, shift, flip, seen, tolerance_m):
                if len(match.origin) == len(seen):
                    return match
    return None


def _anchors(layout: Layout, wanted: int) -> Iterator[tuple[int, int]]:
    """Pair markers across the map, each in one pair only, and take some from all over it."""
    n = len(layout)
    spread = np.ptp(layout.z.real) >= np.ptp(layout.z.imag) if n else True
    order = np.argsort(layout.z.real if spread else layout.z.imag, kind="stable")
    count = min(wanted, ANCHORS, n // 2)
    for k in np.unique(np.linspace(0, n // 2 - 1, count).astype(int)) if count else ():
        yield int(order[k]), int(order[k + n // 2])


def _candidates(
    layout: Layout, one: int, other: int, tolerance_m: float, mirror: bool
) -> tuple[Places, Places]:
    """Return turn and shift (c,) of all motions that bring two markers onto a pair like them."""
    first, second = layout.like(one, other, 2.0 * tolerance_m)
    z = layout.z.conj() if mirror else layout.z
    arm = (layout.z[second] - layout.z[first]) * np.conj(z[other] - z[one])
    whole = np.abs(arm) > 0.0  # two markers in one place turn nothing
    first, second, arm = first[whole], second[whole], arm[whole]
    turn = arm / np.abs(arm)
    return turn, (layout.z[first] + layout.z[second] - turn * (z[one] + z[other])) / 2.0


def _onto(
    layout: Layout, turn: Places, shift: Places, mirror: bool, which: Indices, within_m: float
) -> Indices:
    """Return on which markers these (k,) fall by each motion (c,): (c, k), n for none."""
    z = layout.z[which].conj() if mirror else layout.z[which]
    image = turn[:, None] * z + shift[:, None]
    _, target = layout.tree.query(layout.points(image, which), distance_upper_bound=within_m)
    return np.asarray(target)


def _settled(
    layout: Layout, turn: Places, shift: Places, mirror: bool, which: Indices, tolerance_m: float
) -> Iterator[Match]:
    """Fit each motion to all markers that it brings onto markers, and look again."""
    n = len(layout)
    targets = _onto(layout, turn, shift, mirror, which, 2.0 * tolerance_m)
    for row in np.unique(targets, axis=0):
        for within in (2.0 * tolerance_m, tolerance_m):
            on = row < n
            motion = Motion.between(layout.z[which[on]], layout.z[row[on]], mirror)
            one = np.array([motion.turn]), np.array([motion.shift])
            row = _onto(layout, *one, mirror, which, within)[0]
            if not _moves(motion, layout.z[which], tolerance_m) or np.all(row == n):
                break
        else:
            _, first = np.unique(row, return_index=True)
            once = np.sort(first[row[first] < n])
            origin, target = which[once], row[once]
            beside = np.abs(motion(layout.z[origin]) - layout.z[target])
            yield Match(motion, origin, target, float(beside.max()))


def _moves(motion: Motion, z: Places, tolerance_m: float) -> bool:
    """Tell whether it takes a robot among these places elsewhere."""
    return motion.mirror or bool(np.max(np.abs(motion(z) - z)) > 2.0 * tolerance_m)


def _distinct(layout: Layout, matches: list[Match], tolerance_m: float) -> list[Match]:
    """Keep the best of those that do the same, the best first."""
    kept: list[Match] = []
    images: list[NDArray[np.complex128]] = []
    for match in sorted(matches, key=_rank):
        image = match.motion(layout.z)
        same = [
            match.motion.mirror == other.motion.mirror
            and float(np.max(np.abs(image - seen))) <= 2.0 * tolerance_m
            for other, seen in zip(kept, images, strict=True)
        ]
        if not any(same):
            kept.append(match)
            images.append(image)
    return kept


def _rank(match: Match) -> tuple[float, ...]:
    """Order matches: of most markers, not mirrored, by the least turn, to the left before right."""
    angle = round(match.motion.angle_rad, 3)
    return -len(match.origin), match.motion.mirror, abs(angle), -angle, match.error_m
