"""The type stub of the extension is the one that its code gives."""

import subprocess
import sys
from pathlib import Path

import pytest

COMMITTED = Path(__file__).parents[2] / "python" / "pilotage" / "_core.pyi"


def test_the_stub_is_up_to_date(tmp_path):
    stubgen = [sys.executable, "-m", "pybind11_stubgen", "pilotage._core", "-o", str(tmp_path)]
    subprocess.run(stubgen, check=True)
    generated = (tmp_path / "pilotage" / "_core.pyi").read_text()
    if generated != COMMITTED.read_text():
        pytest.fail(f"{COMMITTED} is not what the extension gives; write it anew: make stubs")
