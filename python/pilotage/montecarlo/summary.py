"""A result as rows for the terminal, and as the content of `montecarlo.json`."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..evaluate import Row, root_mean_square
from .measures import OF_RUNS, RECOVERY_S, over_bound, rmse_m, rmse_sigma_m
from .per_dof import PerDof
from .result import LAST_S, LOST_M, MonteCarlo

NAMED = 10
"""Runs to look at are named, up to so many."""


def rows(result: MonteCarlo) -> Iterator[Row]:
    """Yield label, value and unit."""
    yield Row("position RMSE", f"{rmse_m(result):.4f}", "m")
    if result.bound is not None:
        smallest = root_mean_square(result.bound.position_m)
        of_it = f"{over_bound(result):.3f} ± {2.0 * rmse_sigma_m(result) / smallest:.3f}"
        yield Row("  smallest possible", f"{smallest:.4f}", f"m; {of_it} times it")
    yield Row("heading RMSE", f"{np.degrees(root_mean_square(result.heading_rad)):.3f}", "deg")
    if result.bound is not None:
        smallest = np.degrees(root_mean_square(result.bound.heading_rad))
        yield Row("  smallest possible", f"{smallest:.3f}", "deg")
    yield Row("NEES/dof", f"{result.nees.mean:.3f}", "mean over time")
    yield Row("  in its band", f"{100.0 * result.nees.inside:.1f}", "% of the time; 95 % expected")
    for name, nis in result.nis.items():
        low, high = nis.band
        yield Row(
            f"NIS/dof, {name}", f"{nis.mean:.3f}", f"95 % expected in {low:.3f} to {high:.3f}"
        )
    where = f"over {LOST_M:g} m or without a pose in the last {LAST_S:g} s"
    yield Row("lost", f"{len(result.lost)}", f"runs, {where}")
    yield Row("OK", f"{100.0 * result.ok.mean():.2f}", "% of the time")
    yield Row("OK while wrong", f"{len(result.wrong_ok_runs)}", "runs")
    yield Row("", f"{100.0 * result.wrong_ok.mean():.3f}", "% of the time")
    yield Row("first OK", f"{np.median(result.first_ok_s):.1f}", "s, median")
    if result.kidnapped:
        seconds = "s with two markers in view"
        yield Row("recovery", f"{np.median(result.recovery_s):.1f}", f"{seconds}, median")
        in_time = 100.0 * (result.recovery_s <= RECOVERY_S).mean()
        yield Row(f"  in {RECOVERY_S:g} s", f"{in_time:.1f}", "% of the runs")
        yield Row("  not OK until then", f"{100.0 * result.honest.mean():.1f}", "% of the runs")


def runs_to_look_at(result: MonteCarlo, scenario: str) -> Iterator[str]:
    """Name the runs that are lost, and those that were OK while wrong, and say how to see one."""
    for what, runs in (("lost", result.lost), ("OK while wrong", result.wrong_ok_runs)):
        if len(runs):
            names = ", ".join(map(str, runs[:NAMED])) + (", ..." if len(runs) > NAMED else "")
            yield (
                f"{what}: {names}; to look at one: pilotage simulate {scenario} "
                f"--seed {result.seed} --run {runs[0]} -o run-{runs[0]}.lcmlog"
            )


def to_dict(result: MonteCarlo) -> dict[str, Any]:
    """Return the content of `montecarlo.json`; what is not known, or never was, is null."""
    bound, nees = result.bound, result.nees
    over_time = {
        "time_s": result.time_s,
        "position_rmse_m": result.position_m,
        "heading_rmse_rad": result.heading_rad,
        "anees": nees.over_time,
        "anees_low": nees.low,
        "anees_high": nees.high,
    }
    if bound is not None:
        over_time |= {"position_bound_m": bound.position_m, "heading_bound_rad": bound.heading_rad}
    return {
        "scenario": result.scenario,
        "seed": result.seed,
        "runs": result.runs,
        **{name: or_null(m.of(result)) for name, m in OF_RUNS.items() if name != "nis"},
        "nis": {name: _nis(nis) for name, nis in result.nis.items()},
        "rmse_sigma_m": or_null(rmse_sigma_m(result)),
        "bound_m": None if bound is None else root_mean_square(bound.position_m),
        "heading_rmse_rad": or_null(root_mean_square(result.heading_rad)),
        "anees_in_band": or_null(nees.inside),
        "wrong_ok_time": float(result.wrong_ok.mean()),
        "lost_runs": result.lost.tolist(),
        "wrong_ok_runs": result.wrong_ok_runs.tolist(),
        "first_ok_s": or_null(result.first_ok_s.tolist()),
        "recovery_s": or_null(result.recovery_s.tolist()) if result.kidnapped else None,
        "over_time": {name: or_null(values.tolist()) for name, values in over_time.items()},
    }


def or_null(value: float | list[float]) -> Any:
    """Return numbers as JSON has them; what is none is null."""
    if isinstance(value, list):
        return [or_null(v) for v in value]
    return float(value) if np.isfinite(value) else None


def _nis(nis: PerDof) -> dict[str, Any]:
    """Return a sensor's, or a component's; periods without a sighting are null."""
    over_time = {"time_s": nis.time_s, "nis": nis.over_time, "low": nis.low, "high": nis.high}
    return {
        "mean": nis.mean,
        "band": nis.band,
        "over_time": {name: or_null(values.tolist()) for name, values in over_time.items()},
    }
