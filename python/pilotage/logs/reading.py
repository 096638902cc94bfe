"""Which reader a path is for."""

from pathlib import Path
from types import ModuleType

from . import lcmlog, mower, mrclam, plaza, woods
from .log import Log

_READERS = (mower, mrclam, woods, plaza, lcmlog)


def read(path: str | Path, robot: int | None = None) -> Log:
    """Read a recording of any known format.

    Parameters
    ----------
    path : path
        A file or folder of a known kind, or a folder that holds exactly one such file or folder.
    robot : int, optional
        Number of the robot, for data with several (``mrclam``).

    Raises
    ------
    FileNotFoundError
        If the path, or a file that belongs to it, does not exist.
    ValueError
        If the kind is not recognised, or the content is wrong; names the file and the place in it.
    """
    reader, found = _recognise(Path(path))
    if reader is mrclam:
        return mrclam.read(found, robot)
    if robot is not None:
        raise ValueError(f"{path} is of kind {reader.KIND}, which has one robot: leave robot out")
    log: Log = reader.read(found)
    return log


def _recognise(path: Path) -> tuple[ModuleType, Path]:
    if not path.exists():
        raise FileNotFoundError(f"{path}: no such file or folder")
    for candidates in ([path], sorted(path.iterdir()) if path.is_dir() else []):
        found = [(r, c) for c in candidates for r in _READERS if r.recognises(c)]
        if len(found) == 1:
            return found[0]
        if found:
            names = ", ".join(f"{c.name} ({r.KIND})" for r, c in found)
            raise ValueError(f"{path} holds more than one recording: {names}; name one of them")
    kinds = "\n".join(f"  {reader.KIND}: {reader.LOOKED_FOR}" for reader in _READERS)
    raise ValueError(f"{path}: not a recording of a known kind. Looked for\n{kinds}")
