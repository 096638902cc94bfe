"""Runs the bars' scenarios and holds what comes out against what is asked."""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .bars import Bar, BarRow, bar_rows, bar_scenario
from .measures import OF_GATE, OF_REFERENCE, OF_RUNS, Measure
from .result import MonteCarlo
from .running import run_montecarlo
from .summary import known

HEAD = ["row", "measure", "measured", "bar", ""]


@dataclass(frozen=True)
class Finding:
    """A measure of a row beside its bar; without values the row could not be run, for a reason."""

    row: BarRow
    measure: Measure
    bar: Bar
    values: list[float]
    reason: str = ""

    @property
    def met(self) -> bool:
        """Whether it is what it has to be."""
        return bool(self.values) and self.bar.met(self.values)

    def cells(self) -> list[str]:
        """Return the columns of the table."""
        measured = ", ".join(map(self.measure.text, self.values))
        verdict = "not run" if self.reason else "met" if self.met else "missed"
        bar = self.bar.text(self.measure)
        return [self.row.name, self.measure.words, measured, bar, verdict]


@dataclass(frozen=True)
class Verdict:
    """All findings."""

    runs: int
    seed: int
    findings: list[Finding]

    def table(self) -> list[list[str]]:
        """Return rows of text; a row's name stands only at its first measure."""
        table, last = [HEAD], ""
        for finding in self.findings:
            cells = finding.cells()
            table.append(["", *cells[1:]] if cells[0] == last else cells)
            last = cells[0]
        return table

    def reasons(self) -> list[str]:
        """Return why rows were not run, each reason once."""
        return list(dict.fromkeys(f"not run: {f.reason}" for f in self.findings if f.reason))

    def save(self, folder: Path) -> None:
        """Write `bars.json`."""
        folder.mkdir(parents=True, exist_ok=True)
        content: dict[str, Any] = {"runs": self.runs, "seed": self.seed}
        content["findings"] = [
            {
                "row": f.row.name,
                "what": f.row.what,
                "measure": f.measure.words,
                "values": known(f.values),
                **asdict(f.bar),
                "met": f.met,
                "reason": f.reason,
            }
            for f in self.findings
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
    findings: list[Finding] = []
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

        try:
            values, reason = _values(row, run, seed, folder), ""
        except KeyError as error:  # a key of the configuration that this version does not have
            values, reason = {}, str(error.args[0])
        measures = OF_RUNS | OF_REFERENCE | OF_GATE
        findings += [
            Finding(row, measures[name], bar, values.get(name, []), reason)
            for name, bar in row.bars.items()
        ]
        progress((i + 1) / len(rows))
    verdict = Verdict(runs, seed, findings)
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
        reference = None if row.reference is None else run(row.reference)
        if folder is not None:
            result.save(folder / row.name)
        values = {
            name: OF_RUNS[name].of(result)
            if name in OF_RUNS
            else OF_REFERENCE[name].of(result, reference)
            for name in row.bars
        }
    return {name: v if isinstance(v, list) else [v] for name, v in values.items()}
