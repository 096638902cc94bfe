"""Runs the bars' scenarios and holds what comes out against what is asked."""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .bars import Bar, BarRow, bar_rows, bar_scenario
from .measures import MEASURES, OF_GATE, OF_REFERENCE, OF_RUNS, Measure
from .result import MonteCarlo
from .running import run_montecarlo
from .summary import or_null

HEAD = ["row", "measure", "measured", "bar", ""]


@dataclass(frozen=True)
class Judgement:
    """A measure of a row beside its bar."""

    row: BarRow
    measure: Measure[...]
    bar: Bar
    values: list[float]

    @property
    def met(self) -> bool:
        """Whether it is what it has to be."""
        return self.bar.met(self.values)

    def cells(self) -> list[str]:
        """Return the columns of the table."""
        measured = ", ".join(map(self.measure.text, self.values))
        bar = self.bar.text(self.measure)
        return [self.row.name, self.measure.words, measured, bar, "met" if self.met else "missed"]


@dataclass(frozen=True)
class Verdict:
    """All judgements."""

    runs: int
    seed: int
    judgements: list[Judgement]

    @property
    def met(self) -> bool:
        """Whether every bar is."""
        return all(judgement.met for judgement in self.judgements)

    def table(self) -> list[list[str]]:
        """Return rows of text; a row's name stands only at its first measure."""
        table, last = [HEAD], ""
        for judgement in self.judgements:
            cells = judgement.cells()
            table.append(["", *cells[1:]] if cells[0] == last else cells)
            last = cells[0]
        return table

    def save(self, folder: Path) -> None:
        """Write `bars.json`."""
        folder.mkdir(parents=True, exist_ok=True)
        content: dict[str, Any] = {"runs": self.runs, "seed": self.seed}
        content["judgements"] = [
            {
                "row": j.row.name,
                "what": j.row.what,
                "measure": j.measure.words,
                "values": or_null(j.values),
                **asdict(j.bar),
                "met": j.met,
            }
            for j in self.judgements
        ]
        text = json.dumps(content, indent=1, allow_nan=False)
        (folder / "bars.json").write_text(text + "\n", encoding="utf-8")


def judge(
    only: str,
    runs: int,
    seed: int,
    jobs: int,
    progress: Callable[[float], None] = lambda _: None,
    folder: Path | None = None,
) -> Verdict:
    """Run the rows with `only` in their name; what comes out of each goes into a folder in one."""
    rows = [row for row in bar_rows().values() if only in row.name]
    if not rows:
        raise ValueError(f"no row has '{only}' in its name; there are {', '.join(bar_rows())}")
    judgements: list[Judgement] = []
    base: list[MonteCarlo] = []  # many rows are held against it; the others are too large to keep
    for i, row in enumerate(rows):

        def run(change: dict[str, Any], i: int = i, row: BarRow = row) -> MonteCarlo:
            if not change and base:
                return base[0]
            scenario = bar_scenario(change, row.name)
            result = run_montecarlo(
                scenario, runs, seed, jobs, lambda done: progress((i + done) / len(rows))
            )
            if not change:
                base.append(result)
            return result

        values = _values(row, run, seed, folder)
        judgements += [
            Judgement(row, MEASURES[name], bar, values[name]) for name, bar in row.bars.items()
        ]
        progress((i + 1) / len(rows))
    verdict = Verdict(runs, seed, judgements)
    if folder is not None:
        verdict.save(folder)
    return verdict


def _values(
    row: BarRow,
    run: Callable[[dict[str, Any]], MonteCarlo],
    seed: int,
    folder: Path | None,
) -> dict[str, list[float]]:
    """Return every measure that is asked for; some are several numbers."""
    values: dict[str, float | list[float]]
    if row.change is None:
        rng = np.random.default_rng(seed)
        values = {name: OF_GATE[name].of(row.draws, rng) for name in row.bars}
    else:
        result = run(row.change)
        # A row without a reference asks for nothing of one.
        reference = result if row.reference is None else run(row.reference)
        if folder is not None:
            result.save(folder / row.name)
        values = {
            name: OF_RUNS[name].of(result)
            if name in OF_RUNS
            else OF_REFERENCE[name].of(result, reference)
            for name in row.bars
        }
    return {name: v if isinstance(v, list) else [v] for name, v in values.items()}
