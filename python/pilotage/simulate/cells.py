"""The cells of the campaign: a fault of an input, its size, and what is required meanwhile."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from ..evaluate import Required
from . import faults, marker_faults
from .faults import Fault, Strike
from .measuring import Measured
from .sensors import Camera
from .streams import Stream

CELLS = Path(__file__).with_name("faults.yaml")
"""The campaign that is committed."""

_ANY: dict[str, Fault] = {
    "off": faults.off,
    "stuck": faults.stuck,
    "garbage": faults.garbage,
    "wrong but plausible": faults.linear,
    "slow": faults.slow,
    "delayed": faults.delayed,
    "intermittent": faults.intermittent,
    "duplicate": faults.duplicate,
    "NaN": faults.nan,
    "stamp forward": faults.restamped,
    "stamp backward": faults.restamped,
    "out of order": faults.out_of_order,
    "wrong unit or sign": faults.linear,
    "drifting clock": faults.drifting,
    "burst": faults.burst,
}
FAULTS: dict[str, dict[str, Fault]] = {
    # Of totals, what is wrong is their growth.
    "encoders": _ANY | {"wrong but plausible": faults.travel, "wrong unit or sign": faults.travel},
    "gyro": _ANY,
    "markers": _ANY
    | {
        "wrong id": marker_faults.wrong_id,
        "swapped pair": marker_faults.swapped_pair,
        "moved": marker_faults.moved,
        "removed": marker_faults.removed,
        "phantom": marker_faults.phantom,
    },
}
"""Every fault by input and name."""


@dataclass(frozen=True)
class Window:
    """While the fault lasts, seconds from the beginning of the drive."""

    start_s: float
    end_s: float

    def at(self, begin: int) -> tuple[int, int]:
        """Return start and end [µs] of a drive that begins at `begin`."""
        return begin + round(self.start_s * 1e6), begin + round(self.end_s * 1e6)


@dataclass(frozen=True)
class Cell:
    """A fault of an input, and what is required while it lasts (see `faults.yaml`)."""

    stream: str
    fault: str
    size: dict[str, Any] = field(default_factory=dict)
    required: Required = field(default_factory=Required)
    note: str = ""
    """What explains the outcome, where it needs explaining."""

    @property
    def name(self) -> str:
        """The input and the fault."""
        return f"{self.stream} {self.fault}"

    @property
    def size_text(self) -> str:
        """The size in words: ``delay_s 0.5``."""
        return ", ".join(f"{key} {_in_words(value)}" for key, value in self.size.items())

    @property
    def title(self) -> str:
        """Name and size."""
        return f"{self.name} {self.size_text}".rstrip()

    @property
    def meaning(self) -> str:
        """What happens, in a sentence."""
        return (FAULTS[self.stream][self.fault].__doc__ or "").splitlines()[0]

    def strike(
        self,
        measured: Measured,
        cameras: Sequence[Camera],
        window: Window,
        rng: np.random.Generator,
    ) -> Measured:
        """Return what is sent when this goes wrong."""
        if self == NO_FAULT:
            return measured
        fault = partial(FAULTS[self.stream][self.fault], **self.size)
        start, end = window.at(int(measured.drive.utime[0]))

        def struck(stream: Stream, look: Any = None) -> Stream:
            hit = (stream.utime >= start) & (stream.utime < end)
            return fault(stream, Strike(hit, rng, measured.true_markers, look))

        if self.stream == "markers":
            looks = {camera.name: partial(camera.look, measured.drive) for camera in cameras}
            seen = {name: struck(s, looks[name]) for name, s in measured.sightings.items()}
            return replace(measured, sightings=seen)
        if self.stream == "gyro":
            return replace(measured, gyro=struck(measured.gyro))
        return replace(measured, encoders=struck(measured.encoders))

    def inputs(self, measured: Measured) -> list[str]:
        """Return the names that the fault's inputs have in the status; of no fault, all."""
        sensors = list(measured.sightings)
        all_inputs = ["encoders", "gyro", *sensors]
        return {NO_FAULT.stream: all_inputs, "markers": sensors}.get(self.stream, [self.stream])


def _in_words(size: faults.Size) -> str:
    return f"({', '.join(map(_in_words, size))})" if isinstance(size, list) else f"{size:g}"


NO_FAULT = Cell("no", "fault", required=Required("OK"))
"""What every figure is held against."""


@dataclass(frozen=True)
class Campaign:
    """All that is injected.

    Attributes
    ----------
    cells : list of Cell
    ladders : list of lists of Cell
        A fault each, in sizes from small to large, to find the smallest that is seen.
    policies : list of str
        Time policies to try beside the configured one,
    timely : list of Cell
        on these.
    """

    window: Window
    cells: list[Cell]
    ladders: list[list[Cell]]
    policies: list[str]
    timely: list[Cell]

    @classmethod
    def load(cls, path: Path = CELLS) -> "Campaign":
        """Read a file like `faults.yaml`."""
        content = yaml.safe_load(path.read_text(encoding="utf-8"))
        cells = [
            Cell(
                stream,
                fault,
                entry.pop("size", {}),
                note=entry.pop("note", ""),
                required=Required(**entry),
            )
            for stream, fault, entry in _entries(content["cells"])
        ]
        ladders = [
            [Cell(stream, fault, {key: size}) for key, sizes in entry.items() for size in sizes]
            for stream, fault, entry in _entries(content["smallest"])
        ]
        policies = content["policies"]
        timely = [cell for cell in cells if cell.fault in policies["faults"]]
        return cls(Window(**content["window"]), cells, ladders, policies["time"], timely)

    def cell(self, name: str) -> Cell:
        """Return the cell of that name; a ValueError names the inputs and faults that there are."""
        for cell in self.cells:
            if cell.name == name:
                return cell
        raise ValueError(f"no fault '{name}'; say an input and a fault: {self.words()}")

    def words(self) -> str:
        """Return the inputs and the faults that names are made of."""
        inputs = ", ".join(dict.fromkeys(cell.stream for cell in self.cells))
        return f"{inputs}; {', '.join(dict.fromkeys(cell.fault for cell in self.cells))}"


def _entries(by_stream: dict[str, dict[str, Any]]) -> Iterator[tuple[str, str, dict[str, Any]]]:
    for stream, by_fault in by_stream.items():
        for fault, entry in by_fault.items():
            if fault not in FAULTS.get(stream, {}):
                known = [f"{stream} {fault}" for stream in FAULTS for fault in FAULTS[stream]]
                raise ValueError(f"no fault '{stream} {fault}'; there are {', '.join(known)}")
            yield stream, fault, entry
