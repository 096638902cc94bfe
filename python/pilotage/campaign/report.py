"""The campaign of faults: what to run, and all that came out."""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from ..evaluate import CellFigures
from ..evaluate.figures import AGAIN_S, MOST
from ..simulate import SCENARIOS, Campaign, Cell
from ..simulate.cells import NO_FAULT
from .running import Task, run_tasks

SAMPLE = 20
"""Runs, at most, of each size on a ladder and of each time policy."""


@dataclass(frozen=True)
class Ladder:
    """A fault in sizes from small to large."""

    rungs: list[Cell]
    figures: list[CellFigures]

    @property
    def unseen(self) -> int:
        """How many of the sizes are not noticed in most runs, up to the largest such."""
        return max((i for i, f in enumerate(self.figures, 1) if f.noticed < MOST), default=0)


@dataclass(frozen=True)
class FaultReport:
    """Everything that came out.

    Attributes
    ----------
    figures : CellFigures by cell's name
        Only of cells that were run.
    policies : CellFigures by time policy and cell's name
    """

    scenario: str
    seed: int
    runs: int
    campaign: Campaign
    no_fault: CellFigures
    figures: dict[str, CellFigures]
    ladders: list[Ladder]
    policies: dict[str, dict[str, CellFigures]]

    @classmethod
    def make(
        cls,
        scenario: str,
        runs: int,
        seed: int,
        jobs: int,
        only: str = "",
        progress: Callable[[float], None] | None = None,
    ) -> "FaultReport":
        """Run the campaign, or only the cells with `only` in their name.

        Raises
        ------
        ValueError
            If the scenario is not known or too short, or no cell has such a name.
        """
        if scenario not in SCENARIOS:
            raise ValueError(f"no scenario '{scenario}'; there are {', '.join(SCENARIOS)}")
        campaign = Campaign.load()
        needed_s = campaign.window.end_s + AGAIN_S
        if SCENARIOS[scenario].duration_s < needed_s:
            raise ValueError(
                f"scenario '{scenario}' lasts {SCENARIOS[scenario].duration_s:g} s, but the faults "
                f"and the recovery after them need {needed_s:g} s"
            )
        few = min(runs, SAMPLE)
        cells = [c for c in campaign.cells if only in c.name]
        if not cells:
            raise ValueError(
                f"no cell has '{only}' in its name, an input and a fault: {campaign.words()}"
            )
        timely = [c for c in campaign.timely if only in c.name]
        ladders = [ladder for ladder in campaign.ladders if only in ladder[0].name]
        tasks = [Task(NO_FAULT, runs)] + [Task(cell, runs) for cell in cells]
        tasks += [Task(cell, few) for ladder in ladders for cell in ladder]
        tasks += [Task(cell, few, time) for time in campaign.policies for cell in timely]
        figures = iter(run_tasks(scenario, tasks, campaign.window, seed, jobs, progress))
        return cls(
            scenario,
            seed,
            runs,
            campaign,
            no_fault=next(figures),
            figures={cell.name: next(figures) for cell in cells},
            ladders=[Ladder(ladder, [next(figures) for _ in ladder]) for ladder in ladders],
            policies={p: {c.name: next(figures) for c in timely} for p in campaign.policies},
        )

    def total(self, name: str) -> int:
        """Return the sum over the cells of a count."""
        return sum(getattr(figures, name) for figures in self.figures.values())

    def to_dict(self) -> dict[str, Any]:
        """Return the content of `faults.json`."""
        return {
            "scenario": self.scenario,
            "seed": self.seed,
            "runs": self.total("runs"),
            "silent_failures": self.total("silent"),
            "crashes": self.total("crashes"),
            "not_finite": self.total("not_finite"),
            "no_fault": asdict(self.no_fault),
            "cells": [self._cell_dict(cell) for cell in self.campaign.cells],
            "smallest": [
                {"cell": ladder.rungs[0].name}
                | {
                    "sizes": [
                        {"size": c.size} | asdict(f)
                        for c, f in zip(ladder.rungs, ladder.figures, strict=True)
                    ]
                }
                for ladder in self.ladders
            ],
            "policies": {
                time: {name: asdict(f) for name, f in by_name.items()}
                for time, by_name in self.policies.items()
            },
        }

    def _cell_dict(self, cell: Cell) -> dict[str, Any]:
        content: dict[str, Any] = {
            "cell": cell.name,
            "size": cell.size,
            "required": asdict(cell.required),
            "covered": cell.name in self.figures,
        }
        if figures := self.figures.get(cell.name):
            content |= asdict(figures) | {"missed": figures.missed(cell.required)}
        return content

    def save(self, folder: Path) -> None:
        """Write `faults.json` and the page `faults.md`."""
        from .page import page

        folder.mkdir(parents=True, exist_ok=True)
        text = json.dumps(self.to_dict(), indent=1, allow_nan=False)
        (folder / "faults.json").write_text(text + "\n", encoding="utf-8")
        (folder / "faults.md").write_text(page(self), encoding="utf-8")
