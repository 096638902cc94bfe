"""The numbers that a result comes down to, and that bars ask for."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Generic, ParamSpec

import numpy as np
from numpy.typing import NDArray

from ..evaluate import mean_of_known, root_mean_square
from ..lcmtypes import status_t
from .gate import false_rejects
from .result import MonteCarlo

DECIDED_FRAMES = 10
"""Of three markers or more, in which a start without a pose should be decided."""
RECOVERY_S = 5.0
"""With two markers in view, in which a robot that was carried away should be right again."""
NEVER = np.iinfo(np.int64).max

Of = ParamSpec("Of")


@dataclass(frozen=True)
class Measure(Generic[Of]):
    """A number, or some, of what was run; NaN where the scenario has no such thing."""

    words: str
    of: Callable[Of, float | list[float]]
    share: bool = False
    """Of the runs or of the time, 0 to 1, shown in percent."""

    def text(self, value: float) -> str:
        """Write a value with as many digits as it deserves."""
        return f"{100.0 * value:.2f} %" if self.share else f"{value:.3f}"


def ratio(rmse: NDArray[np.float64], smallest: NDArray[np.float64]) -> float:
    """Return errors (g,) as a multiple of others (g,), both by their root mean square over time."""
    return float(root_mean_square(rmse) / root_mean_square(smallest))


def rmse_m(result: MonteCarlo) -> float:
    """Return the root mean square over time of the position RMSE.

    That is, of every time in which a run has a pose, of the root mean square over those runs.
    """
    return float(root_mean_square(result.position_m))


def rmse_sigma_m(result: MonteCarlo) -> float:
    """Return how far it may be off because the runs are not more."""
    squares = mean_of_known(np.square(result.trials.distance), axis=1)
    spread = root_mean_square(squares - mean_of_known(squares)) / np.sqrt(result.runs)
    return float(spread / (2.0 * rmse_m(result)))


def over_bound(result: MonteCarlo) -> float:
    """Return it as a multiple of the smallest possible one."""
    bound = result.bound
    return np.nan if bound is None else ratio(result.position_m, bound.position_m)


def decided(result: MonteCarlo) -> NDArray[np.bool_]:
    """(n,) whether it came to be OK, and was right, within few frames."""
    frames = result.at_first_ok(result.trials.triples, NEVER)
    return np.asarray(~result.at_first_ok(result.trials.wrong, True) & (frames <= DECIDED_FRAMES))


def ambiguous(result: MonteCarlo) -> NDArray[np.bool_]:
    """(n,) whether it said AMBIGUOUS at the end, and never OK."""
    at_end = result.trials.status[:, -1] == status_t.AMBIGUOUS
    return np.asarray(at_end & ~result.ok.any(axis=1))


def _of_kidnaps(result: MonteCarlo, what: NDArray[np.bool_]) -> float:
    return float(what.mean()) if result.kidnapped else np.nan


def over_reference(result: MonteCarlo, reference: MonteCarlo) -> float:
    """Return the position RMSE as a multiple of another scenario's."""
    return ratio(result.position_m, reference.position_m)


OF_RUNS: dict[str, Measure[[MonteCarlo]]] = {
    "rmse_m": Measure("position RMSE, m", rmse_m),
    "over_bound": Measure("position RMSE / bound", over_bound),
    "anees": Measure("NEES/dof", lambda r: r.nees.mean),
    "nis": Measure("NIS/dof", lambda r: [nis.mean for nis in r.nis.values()]),
    "lost": Measure("lost runs", lambda r: len(r.lost) / r.runs, share=True),
    "ok": Measure("time OK", lambda r: float(r.ok.mean()), share=True),
    "wrong_ok": Measure("runs OK while wrong", lambda r: len(r.wrong_ok_runs) / r.runs, share=True),
    "right_or_undecided": Measure(
        "right or undecided",
        lambda r: 1.0 - float(r.at_first_ok(r.trials.wrong, False).mean()),
        share=True,
    ),
    "decided": Measure(
        f"decided right in {DECIDED_FRAMES} frames", lambda r: float(decided(r).mean()), share=True
    ),
    "recovered": Measure(
        f"recovered in {RECOVERY_S:g} s",
        lambda r: _of_kidnaps(r, r.recovery_s <= RECOVERY_S),
        share=True,
    ),
    "honest": Measure("not OK until then", lambda r: _of_kidnaps(r, r.honest), share=True),
    "ambiguous": Measure("AMBIGUOUS", lambda r: float(ambiguous(r).mean()), share=True),
}
"""Of a result, by the name that they have in bars.yaml and in montecarlo.json."""
OF_REFERENCE: dict[str, Measure[[MonteCarlo, MonteCarlo]]] = {
    "over_reference": Measure("position RMSE / reference", over_reference),
    "reference_anees": Measure("NEES/dof of the reference", lambda _, r: OF_RUNS["anees"].of(r)),
}
"""Of a result and another that it is held against."""
OF_GATE: dict[str, Measure[[int, np.random.Generator]]] = {
    f"gate_dof_{dof}": Measure(f"false rejects / setting, dof {dof}", partial(false_rejects, dof))
    for dof in (1, 2, 3)
}
"""Of a number of draws and their chance."""
MEASURES: dict[str, Measure[...]] = {**OF_RUNS, **OF_REFERENCE, **OF_GATE}
