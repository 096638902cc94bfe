"""What every study is: a published system rerun on the core, with its tables beside ours."""

import json
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NAMES = ("kiriy-buehler", "kiriy-cameras", "sousa-poles", "kohler", "tamas", "assignment")


@dataclass(frozen=True)
class Request:
    """What a study is asked for.

    Attributes
    ----------
    seed : int
        Of all chance; the k-th run of a study draws from `numpy.random.default_rng((seed, k))`.
    effort : float
        Part of the usual number of runs, at least one of each: tests ask for less.
    jobs : int
        Processes; -1 for one a core.
    progress : callable
        Told the part that is done, 0 to 1.
    """

    seed: int = 1
    effort: float = 1.0
    jobs: int = -1
    progress: Callable[[float], None] = lambda _: None

    def runs(self, usual: int) -> int:
        """Return how many of them to do."""
        return max(1, math.ceil(self.effort * usual))


@dataclass(frozen=True)
class Table:
    """A table as it is printed and stored.

    Attributes
    ----------
    title : str
        What it compares, with units.
    head : sequence of str
        Names of the columns; the first one's cells name the rows.
    rows : sequence of sequences
        Text, or numbers as they came out.
    note : str
        What a reader has to know about it: why theirs and ours differ.
    """

    title: str
    head: Sequence[str]
    rows: Sequence[Sequence[str | float]]
    note: str = ""


@dataclass(frozen=True)
class Findings:
    """What a study found.

    Attributes
    ----------
    results : mapping
        Of numbers, text, lists and mappings, for results.json.
    tables : sequence of Table
    figures : mapping of name to a function that draws it
    """

    results: Mapping[str, Any]
    tables: Sequence[Table] = ()
    figures: Mapping[str, Callable[[], "Figure"]] = field(default_factory=dict)

    def save(self, folder: Path) -> list[Path]:
        """Write results.json and each figure as a PNG file."""
        from ..plot import style

        folder.mkdir(parents=True, exist_ok=True)
        paths = [folder / "results.json"]
        tables = [vars(table) for table in self.tables]
        stored = {"results": self.results, "tables": tables}
        paths[0].write_text(json.dumps(stored, indent=1, default=_plain) + "\n", encoding="utf-8")
        for name, draw in self.figures.items():
            paths.append(folder / f"{name}.png")
            style.save(draw(), paths[-1])
        return paths


@dataclass(frozen=True)
class Study:
    """A published system and how to rerun it.

    Attributes
    ----------
    title : str
        One line for the list.
    source : str
        Who published it, where and when.
    run : callable
    """

    title: str
    source: str
    run: Callable[[Request], Findings]


def find_study(name: str) -> Study:
    """Return the study of a name; raises ValueError naming those that there are."""
    if name not in NAMES:
        raise ValueError(f"no study is called '{name}'; there are {', '.join(NAMES)}")
    study: Study = import_module(f".{name.replace('-', '_')}", __package__).STUDY
    return study


def all_studies() -> Iterator[tuple[str, Study]]:
    """Yield every study with its name."""
    for name in NAMES:
        yield name, find_study(name)


def _plain(value: Any) -> Any:
    """What numpy holds, as JSON can."""
    return value.tolist()
