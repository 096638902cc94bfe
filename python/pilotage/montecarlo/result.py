"""What many runs say together: errors beside the bound, consistency, lost runs, honesty."""

import json
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..evaluate import root_mean_square
from ..evaluate.honesty import STEADY_S
from ..lcmtypes import status_t
from ..sensor_keys import COMPONENTS
from .bound import Bound
from .per_dof import PerDof
from .trial import NIS_S, Trial

POSE_STATES = 3
LOST_M = 1.0
"""A run is lost that is further off, or without a pose, at some time of its last `LAST_S`."""
LAST_S = 5.0


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
        return np.asarray(root_mean_square(self.trials.distance, axis=0))

    @cached_property
    def heading_rad(self) -> NDArray[np.float64]:
        """(g,) likewise of the heading."""
        return np.asarray(root_mean_square(self.trials.heading, axis=0))

    @cached_property
    def nees(self) -> PerDof:
        """Of the pose, over the runs that have one."""
        nees = self.trials.nees
        known = ~np.isnan(nees)
        total = np.where(known, nees, 0.0).sum(axis=0)
        return PerDof.of(self.time_s, total, POSE_STATES * known.sum(axis=0))

    @cached_property
    def nis(self) -> dict[str, PerDof]:
        """By sensor, and where it measures more than one component, by ``sensor component``.

        Of every sighting that was held against a marker, whether it was fused or not.
        """
        found = {}
        for i, (name, components) in enumerate(self.sensors):
            parts = {name: 0} | {f"{name} {c}": 1 + COMPONENTS.index(c) for c in components}
            for key, part in parts.items():
                nis, dof = (of[:, i, part].sum(axis=0) for of in (self.trials.nis, self.trials.dof))
                if dof.any() and (part == 0 or len(components) > 1):
                    middle_s = (np.arange(len(nis), dtype=np.float64) + 0.5) * NIS_S
                    found[key] = PerDof.of(middle_s, nis, dof)
        return found

    @cached_property
    def lost(self) -> NDArray[np.intp]:
        """Numbers of the runs that are far off, or have no pose, at some time of the last ones."""
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

    @property
    def wrong_ok_runs(self) -> NDArray[np.intp]:
        """Numbers of the runs that were so at some time."""
        return np.flatnonzero(self.wrong_ok.any(axis=1))

    @cached_property
    def first_ok(self) -> NDArray[np.intp]:
        """(n,) index of the first time that it was OK; g if it never was."""
        return _first(self.ok)

    @property
    def first_ok_s(self) -> NDArray[np.float64]:
        """(n,) when it was, since the beginning of the drive; inf if never."""
        return np.append(self.time_s, np.inf)[self.first_ok]

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
