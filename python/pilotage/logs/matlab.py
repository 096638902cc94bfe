"""Variables of a MATLAB file. scipy is imported here only, and only when such a file is read."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray


def is_matlab(path: Path) -> bool:
    """Whether the file's name says that it is a MATLAB file."""
    return path.suffix.lower() == ".mat" and path.is_file()


def variable_names(path: Path) -> set[str]:
    """Names of the variables of a MATLAB file; ValueError if it is none."""
    from scipy.io import whosmat

    return {name for name, _, _ in _readable(whosmat, path)}


def load_variables(path: Path, names: Iterable[str]) -> dict[str, NDArray[np.float64]]:
    """The named variables as two-dimensional arrays; ValueError names those that are missing."""
    from scipy.io import loadmat

    names = list(names)
    found = _readable(loadmat, path, variable_names=names)
    missing = [name for name in names if name not in found]
    if missing:
        there = ", ".join(sorted(variable_names(path)))
        raise ValueError(f"{path}: lacks the variables {', '.join(missing)}; it has {there}")
    return {name: np.asarray(found[name], dtype=np.float64) for name in names}


def _readable(function: Any, path: Path, **how: Any) -> Any:
    try:
        return function(str(path), **how)
    except Exception as error:  # scipy lets through whatever a damaged file makes it stumble over
        raise ValueError(f"{path}: cannot be read as a MATLAB file: {error}") from error
