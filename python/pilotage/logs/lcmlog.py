"""LCM log files, as lcm-logger and this package write them."""

from pathlib import Path

from .. import Recording
from .columns import trajectory
from .log import Log

KIND = "lcm"
LOOKED_FOR = "an LCM log file (.lcmlog, or any name if it begins as one)"

_ENOUGH = 20
_SYNC_WORD = b"\xed\xa1\xda\x01"


def recognises(path: Path) -> bool:
    """Whether this is such a file; lcm-logger's own names (lcmlog-2002-10-01.00) have no ending."""
    if not path.is_file():
        return False
    if path.suffix == ".lcmlog":
        return True
    with path.open("rb") as file:
        return file.read(len(_SYNC_WORD)) == _SYNC_WORD


def read(path: Path) -> Log:
    """The messages as they are; truth from reference_t in them, damaged places in the notes."""
    recording = Recording.load(str(path))
    reference = recording.reference()
    truth = trajectory(*(reference[name] for name in ("utime", "x", "y", "heading")))
    return Log(
        kind=KIND,
        recording=recording,
        truth=truth if truth.size else None,
        map=None,
        notes=_notes(path, recording.damage),
    )


def _notes(path: Path, damage: list[str]) -> tuple[str, ...]:
    """How many places are damaged, and which; of very many the first."""
    if not damage:
        return ()
    count = f"{path}: damaged in {len(damage)} places, everything else was read"
    more = [f"... and {len(damage) - _ENOUGH} more"] if len(damage) > _ENOUGH else []
    return (count, *damage[:_ENOUGH], *more)
