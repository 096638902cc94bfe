"""The outcomes of a fault's runs as figures, held against what is required."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .outcome import Outcome

SILENT_SHARE = 0.005
"""Of the runs may fail silently."""
OK_SHARE = 0.99
"""Of the time without a fault is OK."""
MOST = 0.95
"""Of the runs do what is required."""
AGAIN_S = 10.0
"""After the fault's end it is OK again, s."""


@dataclass(frozen=True)
class Required:
    """What is required while a fault lasts; None is not required.

    Attributes
    ----------
    state : str
        ``OK``: most of the time; ``not OK``: at the end; ``any``: either, honestly.
    say_s : float or None, s
        Until the status names the input.
    error_m : float or None, m
        That the 95th percentile of the largest error stays below.
    """

    state: str = "any"
    say_s: float | None = None
    error_m: float | None = None


@dataclass(frozen=True)
class CellFigures:
    """Of the runs of one cell; shares are of its runs.

    Attributes
    ----------
    crashes, not_finite, silent : int
        Runs that ended in an exception, gave something else than numbers, failed silently.
    crash : str
        What the first exception said.
    ok : float
        Mean part of all the time in which it said OK.
    ok_during : float
        Mean part of the fault's time in which it said OK.
    ok_at_end : float
        Share that said OK when the fault ended.
    said : float
        Share that named the input in time; where no time is required, at any time.
    said_s : float or None, s
        Median time until they did, None where half of them or more did not.
    noticed : float
        Share that named the input or did not say OK, at some time of the fault.
    again : float
        Share that was OK again in time.
    error_m : float or None, m
        95th percentile of the largest error since the fault began.
    beyond_s : float, s
        The longest time of any run in which it said OK with an error outside what was stated.
    """

    runs: int
    crashes: int
    crash: str
    not_finite: int
    silent: int
    ok: float
    ok_during: float
    ok_at_end: float
    said: float
    said_s: float | None
    noticed: float
    again: float
    error_m: float | None
    beyond_s: float

    @classmethod
    def of(cls, outcomes: Sequence[Outcome | str], required: Required) -> "CellFigures":
        """Summarise runs; one that crashed left a text."""
        done = [outcome for outcome in outcomes if isinstance(outcome, Outcome)]

        def column(name: str) -> NDArray[np.float64]:
            return np.array([getattr(o, name) for o in done], dtype=np.float64)

        said_s, error_m = column("said_s"), column("error_m")
        error_m = error_m[np.isfinite(error_m)]
        limit_s = required.say_s if required.say_s is not None else np.finfo(np.float64).max
        median_s = float(np.median(said_s)) if done else np.inf
        return cls(
            runs=len(outcomes),
            crashes=len(outcomes) - len(done),
            crash=next((outcome for outcome in outcomes if isinstance(outcome, str)), ""),
            not_finite=sum(not o.finite for o in done),
            silent=sum(o.silent for o in done),
            ok=_mean(column("ok")),
            ok_during=_mean(column("ok_during")),
            ok_at_end=_mean(column("ok_at_end")),
            said=_mean(said_s <= limit_s),
            said_s=median_s if np.isfinite(median_s) else None,
            noticed=_mean(column("noticed")),
            again=_mean(column("again_s") <= AGAIN_S),
            error_m=float(np.percentile(error_m, 95.0)) if error_m.size else None,
            beyond_s=float(column("beyond_s").max(initial=0.0)),
        )

    def missed(self, required: Required) -> list[str]:
        """Return what is required and was not met, in words; empty if all was."""
        far = required.error_m is not None and (self.error_m or 0.0) > required.error_m
        checks = {
            "crashes": self.crashes > 0,
            "not a number": self.not_finite > 0,
            "silent": self.silent > SILENT_SHARE * self.runs,
            "not OK meanwhile": required.state == "OK" and self.ok_during < MOST,
            "still OK": required.state == "not OK" and self.ok_at_end > 1 - MOST,
            "unsaid": required.say_s is not None and self.said < MOST,
            "too far off": far,
            "no recovery": self.again < MOST,
        }
        return [what for what, wrong in checks.items() if wrong]


def _mean(values: NDArray[np.float64] | NDArray[np.bool_]) -> float:
    return float(np.mean(values)) if values.size else 0.0
