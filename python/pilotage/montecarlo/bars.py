"""The bars: what the localizer must show, row by row (`bars.yaml`)."""

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from .. import simulate
from ..fields import call, known_keys, mapping, read_yaml
from ..simulate import Scenario, parse_scenario
from .measures import MEASURES, Measure

BARS = Path(__file__).with_name("bars.yaml")
"""Those that are committed."""
ROW_KEYS = ("what", "change", "reference", "draws", "bars")


@dataclass(frozen=True)
class Bar:
    """What a measure has to be."""

    min: float | None = None
    max: float | None = None

    def met(self, values: list[float]) -> bool:
        """Whether all are within; what is not a number is not."""
        above = self.min is None or all(value >= self.min for value in values)
        return above and (self.max is None or all(value <= self.max for value in values))

    def text(self, measure: Measure[...]) -> str:
        """Write it: ``≤ 1.100``, ``0.950 to 1.060``."""
        if self.min is None or self.max is None:
            sign, limit = ("≤", self.max) if self.min is None else ("≥", self.min)
            return f"{sign} {measure.text(limit or 0.0)}"
        return f"{measure.text(self.min)} to {measure.text(self.max)}"


@dataclass(frozen=True)
class BarRow:
    """What is run, and what it has to show.

    Attributes
    ----------
    change, reference : dict or None
        What differs from the base scenario, and what differs in the one it is held against; nothing
        is driven where `change` is None.
    draws : int
        Of the gate, if that is what is asked.
    """

    name: str
    what: str
    change: dict[str, Any] | None
    reference: dict[str, Any] | None
    draws: int
    bars: dict[str, Bar]


@cache
def base() -> dict[str, Any]:
    """Return the scenario that the rows' scenarios differ from."""
    return mapping(read_yaml(BARS)["base"], f"{BARS}: base")


@cache
def bar_rows() -> dict[str, BarRow]:
    """Read the rows, by name."""
    return {
        name: _row(name, mapping(content, f"{BARS}: {name}"))
        for name, content in mapping(read_yaml(BARS)["rows"], f"{BARS}: rows").items()
    }


def bar_scenario(change: dict[str, Any], name: str) -> Scenario:
    """Return the base scenario with a change."""
    return parse_scenario(changed(base(), change), name)


def find_scenario(name: str) -> Scenario:
    """Return one of the simulator's scenarios, that of a row, or that of a file."""
    rows = bar_rows().values()
    driven = {r.name: changed(base(), r.change) for r in rows if r.change is not None}
    return simulate.find_scenario(name, driven)


def changed(content: dict[str, Any], change: dict[str, Any]) -> dict[str, Any]:
    """Return nested keys with some of them replaced; a None takes its key out."""
    result = dict(content)
    for key, value in change.items():
        if value is None:
            result.pop(key, None)
        elif isinstance(value, dict) and isinstance(result.get(key), dict):
            result[key] = changed(result[key], value)
        else:
            result[key] = value
    return result


def _row(name: str, content: dict[str, Any]) -> BarRow:
    where = f"{BARS}: {name}"
    known_keys(content, ROW_KEYS, where)
    asked = mapping(content["bars"], f"{where}.bars")
    known_keys(asked, MEASURES, f"{where}.bars")
    return BarRow(
        name,
        content["what"],
        None if "draws" in content else content.get("change", {}),
        content.get("reference"),
        content.get("draws", 0),
        {key: call(Bar, bar, f"{where}.bars.{key}") for key, bar in asked.items()},
    )
