"""Runs the bars' scenarios and holds what comes out against what is asked."""

import json
from collections.abc import Callable, Iterator
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
    """All findings, and the results that they are taken from by the row's name."""

    runs: int
    seed: int
    findings: list[Finding]
    results: dict[str, MonteCarlo]

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
        """Write `bars.json`, and a folder with the result of each row."""
        for name, result in self.results.items():
            result.save(folder / name)
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
) -> Verdict:
    """Run the rows with `only` in their name."""
    rows = [row for row in bar_rows().values() if only in row.name]
    if not rows:
        raise ValueError(f"no row has '{only}' in its name; there are {', '.join(bar_rows())}")
    known: dict[str, MonteCarlo] = {}
    findings, results = [], {}
    for i, row in enumerate(rows):

        def result_of(change: dict[str, Any], i: int = i, row: BarRow = row) -> MonteCarlo:
            key = json.dumps(change, sort_keys=True)
            if key not in known:
                scenario = bar_scenario(change, row.name)
                known[key] = run_montecarlo(
                    scenario, runs, seed, jobs, lambda done: progress((i + done) / len(rows))
                )
            return known[key]

        try:
            if row.change is not None:
                results[row.name] = result_of(row.change)
            values = dict(_values(row, result_of, seed))
            reason = ""
        except KeyError as error:  # a key of the configuration that this version does not have
            values, reason = {}, str(error.args[0])
        measures = OF_RUNS | OF_REFERENCE | OF_GATE
        findings += [
            Finding(row, measures[name], bar, values.get(name, []), reason)
            for name, bar in row.bars.items()
        ]
        progress((i + 1) / len(rows))
    return Verdict(runs, seed, findings, results)


def _values(
    row: BarRow, result_of: Callable[[dict[str, Any]], MonteCarlo], seed: int
) -> Iterator[tuple[str, list[float]]]:
    """Yield every measure that is asked for; some are several numbers."""
    for name in row.bars:
        if row.change is None:
            value = OF_GATE[name].of(row.draws, np.random.default_rng(seed))
        elif name in OF_RUNS:
            value = OF_RUNS[name].of(result_of(row.change))
        else:
            value = OF_REFERENCE[name].of(result_of(row.change), result_of(row.reference or {}))
        yield name, value if isinstance(value, list) else [value]
