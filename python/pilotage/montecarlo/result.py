"""What many runs say together: errors beside the bound, consistency, lost runs, honesty."""

import json
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..evaluate import mean_square_band
from ..lcmtypes import status_t
from ..simulate.sensors import COMPONENTS
from .bound import Bound
from .trial import Trial

POSE_STATES = 3
LOST_M = 1.0
"""A run is lost that is further off than this at some time of the last `LAST_S` seconds."""
LAST_S = 5.0
STEADY_S = 1.0
"""Recovered is to be OK and right for so long."""


@dataclass(frozen=True)
class Nis:
    """NIS per degree of freedom, of a sensor or of one of its components.

    Attributes
    ----------
    mean : float
        Over all sightings of all runs.
    band : (2,)
        In which 95 % of such means fall if the filter is consistent.
    over_time, low, high : (seconds,)
        The same for the sightings of each second.
    """

    mean: float
    band: tuple[float, float]
    over_time: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]

    @classmethod
    def of(cls, nis: NDArray[np.float64], dof: NDArray[np.float64]) -> "Nis | None":
        """Summarise sums (runs, seconds); None without sightings."""
        total, count = nis.sum(axis=0), dof.sum(axis=0)
        if not count.any():
            return None
        with np.errstate(invalid="ignore", divide="ignore"):
            over_time = total / count
        low, high = np.array([_band(c) if c else (np.nan, np.nan) for c in count]).T
        return cls(float(total.sum() / count.sum()), _band(count.sum()), over_time, low, high)


@dataclass(frozen=True)
class MonteCarlo:
    """All that came out.

    Attributes
    ----------
    time_s : (g,)
        Since the beginning of the drive.
    trials : Trial
        With the runs, n, as first axis of every array.
    sensors : list of (name, components)
    bound : Bound or None
        At the same times; None where the drive is another in every run.
    """

    scenario: str
    seed: int
    time_s: NDArray[np.float64]
    trials: Trial
    sensors: list[tuple[str, tuple[str, ...]]]
    bound: Bound | None

    @property
    def kidnapped(self) -> bool:
        """Whether the robot is carried away."""
        return bool((self.trials.kidnap_index < len(self.time_s)).any())

    @property
    def runs(self) -> int:
        """How many."""
        return len(self.trials.distance)

    @cached_property
    def position_m(self) -> NDArray[np.float64]:
        """(g,) root mean square over the runs of the position error; NaN before any has a pose."""
        return _rms(self.trials.distance)

    @cached_property
    def heading_rad(self) -> NDArray[np.float64]:
        """(g,) likewise of the heading."""
        return _rms(self.trials.heading)

    @cached_property
    def anees(self) -> NDArray[np.float64]:
        """(g,) mean over the runs of NEES per degree of freedom."""
        return _mean(self.trials.nees) / POSE_STATES

    @property
    def anees_band(self) -> tuple[float, float]:
        """In which 95 % of them fall if the filter is consistent."""
        low, high = mean_square_band(POSE_STATES, count=self.runs)
        return low / POSE_STATES, high / POSE_STATES

    @cached_property
    def nis(self) -> dict[str, Nis]:
        """By sensor, and where it measures more than one component, by ``sensor component``."""
        found: dict[str, Nis | None] = {}
        for i, (name, components) in enumerate(self.sensors):
            names = {name: 0} | {f"{name} {c}": 1 + COMPONENTS.index(c) for c in components}
            for key, part in names.items():
                if part == 0 or len(components) > 1:
                    found[key] = Nis.of(self.trials.nis[:, i, part], self.trials.dof[:, i, part])
        return {key: nis for key, nis in found.items() if nis is not None}

    @cached_property
    def lost(self) -> NDArray[np.intp]:
        """Numbers of the runs that are far off at the end, or have no pose."""
        end = self.trials.distance[:, self.time_s > self.time_s[-1] - LAST_S]
        return np.flatnonzero(~(end <= LOST_M).all(axis=1))

    @property
    def ok(self) -> NDArray[np.bool_]:
        """(n, g) whether the status was OK."""
        return np.asarray(self.trials.status == status_t.OK)

    @property
    def wrong_ok(self) -> NDArray[np.bool_]:
        """(n, g) whether it was OK while the error was outside what it stated."""
        return self.ok & self.trials.wrong

    @cached_property
    def first_ok(self) -> NDArray[np.intp]:
        """(n,) index of the first time that it was OK; g if it never was."""
        return _first(self.ok)

    def at_first_ok(self, values: NDArray[Any], never: Any) -> NDArray[Any]:
        """(n,) what (n, g) was then; `never` where it never was OK."""
        padded = np.column_stack([values, np.full(self.runs, never, values.dtype)])
        return np.asarray(padded[np.arange(self.runs), self.first_ok])

    @cached_property
    def recovery_s(self) -> NDArray[np.float64]:
        """(n,) time with two markers in view from the kidnap to OK and right; inf if never."""
        step_s = self.time_s[1]
        right = self.ok & ~self.trials.wrong & self._after
        steady = round(STEADY_S / step_s)
        # Right now and for a while: as many of the next ones as there are.
        total = np.cumsum(np.pad(right, ((0, 0), (1, 0))), axis=1)
        begun = np.zeros_like(right)
        begun[:, : right.shape[1] - steady + 1] = total[:, steady:] - total[:, :-steady] == steady
        again = _first(begun)
        waited = self._after & (np.arange(right.shape[1]) < again[:, None])
        spent = step_s * (waited & (self.trials.in_view >= 2)).sum(axis=1)
        return np.where(again < right.shape[1], spent, np.inf)

    @cached_property
    def honest(self) -> NDArray[np.bool_]:
        """(n,) not wrong and OK once three frames have shown two markers since the kidnap."""
        pairs, index = self.trials.pairs, self.trials.kidnap_index
        before = pairs[np.arange(self.runs), np.minimum(index, pairs.shape[1] - 1)]
        told = self._after & (pairs - before[:, None] >= 3)
        return np.asarray(~(told & self.wrong_ok).any(axis=1))

    @property
    def _after(self) -> NDArray[np.bool_]:
        """(n, g) whether the kidnap has been."""
        return np.asarray(np.arange(len(self.time_s)) >= self.trials.kidnap_index[:, None])

    def save(self, folder: Path) -> None:
        """Write `montecarlo.json` and `montecarlo.png`."""
        from ..plot.montecarlo import montecarlo_figure
        from ..plot.style import save
        from .summary import to_dict

        folder.mkdir(parents=True, exist_ok=True)
        text = json.dumps(to_dict(self), indent=1, allow_nan=False)
        (folder / "montecarlo.json").write_text(text + "\n", encoding="utf-8")
        save(montecarlo_figure(self), folder / "montecarlo.png")


def _first(what: NDArray[np.bool_]) -> NDArray[np.intp]:
    """(n,) first index at which (n, g) holds; g if nowhere."""
    return np.asarray(np.where(what.any(axis=1), what.argmax(axis=1), what.shape[1]))


def _mean(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """(g,) over the runs that have a value; NaN where none has."""
    known = np.isfinite(values)
    count = known.sum(axis=0)
    total = np.where(known, values, 0.0).sum(axis=0)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def _rms(values: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(np.sqrt(_mean(np.square(values))))


def _band(count: float) -> tuple[float, float]:
    return mean_square_band(1, count=int(count))
