"""What came out of one run with a fault."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .honesty import Timeline

SILENT_S = 10.0
"""To say OK for longer than this, s, with an error outside what is stated is a silent failure."""


@dataclass(frozen=True)
class Outcome:
    """What came out of one run with a fault; times in s.

    Attributes
    ----------
    silent : bool
        A silent failure.
    finite : bool
        Whether every pose and covariance was a number.
    beyond_s : float
        The longest time of saying OK with an error outside what was stated.
    ok, ok_during : float
        Parts of all the time, and of the fault's, in which it said OK.
    ok_at_end : bool
        Whether it said OK when the fault ended.
    said_s : float
        From the fault's beginning until the status named the input, inf if it did not meanwhile.
    again_s : float
        From the fault's end until OK again, inf if never.
    error_m : float
        The largest since the fault began.
    """

    silent: bool
    finite: bool
    beyond_s: float
    ok: float
    ok_during: float
    ok_at_end: bool
    said_s: float
    again_s: float
    error_m: float

    @property
    def noticed(self) -> bool:
        """Whether anything was said while the fault lasted."""
        return self.ok_during < 1.0 or np.isfinite(self.said_s)

    @classmethod
    def of(
        cls, timeline: Timeline, finite: bool, named_at: NDArray[np.int64], window: tuple[int, int]
    ) -> "Outcome":
        """Judge a run with a fault from ``window[0]`` to ``window[1]`` [µs].

        Parameters
        ----------
        named_at : (k,) int, µs
            When a status named the input.
        """
        start, end = window
        named = named_at[(named_at >= start) & (named_at < end)]
        beyond_s = timeline.longest_s(timeline.ok & timeline.beyond)
        since = timeline.distance[timeline.at >= start]
        first = int(timeline.at[0]) if len(timeline.at) else 0
        return cls(
            silent=beyond_s > SILENT_S,
            finite=finite,
            beyond_s=beyond_s,
            ok=timeline.share(timeline.ok, first, timeline.end),
            ok_during=timeline.share(timeline.ok, start, end),
            ok_at_end=timeline.at_time(timeline.ok, end),
            said_s=float(named[0] - start) * 1e-6 if len(named) else float("inf"),
            again_s=timeline.again_s(end),
            error_m=float(np.nanmax(since)) if np.isfinite(since).any() else float("nan"),
        )
