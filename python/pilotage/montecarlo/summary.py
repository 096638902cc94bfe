"""A result as rows for the terminal, and as the content of `montecarlo.json`."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..evaluate import Row
from .measures import OF_RUNS, RECOVERY_S, mean, over_bound, rmse_m, rmse_sigma_m, root_mean_square
from .result import LAST_S, LOST_M, MonteCarlo

NAMED = 10
"""Lost runs are named, up to so many."""


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
    yield Row("NEES/dof", f"{mean(result.anees):.3f}", "mean over time")
    low, high = result.anees_band
    inside = 100.0 * np.mean((result.anees >= low) & (result.anees <= high))
    yield Row(f"  in {low:.3f} to {high:.3f}", f"{inside:.1f}", "% of the time; 95 % expected")
    for name, nis in result.nis.items():
        low, high = nis.band
        yield Row(
            f"NIS/dof, {name}", f"{nis.mean:.3f}", f"95 % expected in {low:.3f} to {high:.3f}"
        )
    yield Row("lost", f"{len(result.lost)}", f"runs, over {LOST_M:g} m in the last {LAST_S:g} s")
    yield Row("OK", f"{100.0 * result.ok.mean():.2f}", "% of the time")
    wrong = result.wrong_ok
    yield Row("OK while wrong", f"{wrong.any(axis=1).sum()}", "runs")
    yield Row("", f"{100.0 * wrong.mean():.3f}", "% of the time")
    first = np.append(result.time_s, np.inf)[result.first_ok]
    yield Row("first OK", f"{np.median(first):.1f}", "s, median")
    if result.kidnapped:
        seconds = "s with two markers in view"
        yield Row("recovery", f"{np.median(result.recovery_s):.1f}", f"{seconds}, median")
        in_time = 100.0 * (result.recovery_s <= RECOVERY_S).mean()
        yield Row(f"  in {RECOVERY_S:g} s", f"{in_time:.1f}", "% of the runs")
        yield Row("  not OK until then", f"{100.0 * result.honest.mean():.1f}", "% of the runs")


def to_dict(result: MonteCarlo) -> dict[str, Any]:
    """Return the content of `montecarlo.json`; what is not known is null."""
    bound = result.bound
    over_time = {
        "time_s": result.time_s,
        "position_rmse_m": result.position_m,
        "heading_rmse_rad": result.heading_rad,
        "anees": result.anees,
    }
    if bound is not None:
        over_time |= {"position_bound_m": bound.position_m, "heading_bound_rad": bound.heading_rad}
    return {
        "scenario": result.scenario,
        "seed": result.seed,
        "runs": result.runs,
        **{name: known(measure.of(result)) for name, measure in OF_RUNS.items()},
        "rmse_sigma_m": known(rmse_sigma_m(result)),
        "bound_m": None if bound is None else root_mean_square(bound.position_m),
        "heading_rmse_rad": known(root_mean_square(result.heading_rad)),
        "anees_band": result.anees_band,
        "nis_by_sensor": {
            name: {"mean": nis.mean, "band": nis.band} for name, nis in result.nis.items()
        },
        "lost_runs": result.lost.tolist(),
        "wrong_ok_runs": np.flatnonzero(result.wrong_ok.any(axis=1)).tolist(),
        "over_time": {name: known(values.tolist()) for name, values in over_time.items()},
    }


def lost_text(result: MonteCarlo, scenario: str) -> str:
    """Name the lost runs, and say how to look at one."""
    names = ", ".join(map(str, result.lost[:NAMED])) + (", ..." if len(result.lost) > NAMED else "")
    return (
        f"lost: {names}; to look at one: pilotage simulate {scenario} --seed {result.seed} "
        f"--run {result.lost[0]} -o lost.lcmlog"
    )


def known(value: float | list[float]) -> Any:
    """Return numbers as JSON has them; what is none is null."""
    if isinstance(value, list):
        return [known(v) for v in value]
    return float(value) if np.isfinite(value) else None
