"""Real recordings, which are no part of the project: tests use them where they are present."""

import os
from pathlib import Path

import pytest

FOLDER = Path(
    os.environ.get("PILOTAGE_DATASETS")
    or Path(__file__).resolve().parents[3].parent / "shared" / "datasets"
)


def dataset(name: str) -> Path:
    """The folder of a recording; without it the test skips and says where it was looked for."""
    path = FOLDER / name
    if not path.is_dir():
        pytest.skip(f"recording '{name}' is not in {FOLDER}; PILOTAGE_DATASETS can name its place")
    return path
