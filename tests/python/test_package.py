"""What `pip install .` leaves in site-packages."""

import os
import re
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

import pilotage
from pilotage.lcmtypes import marker_frame_t, marker_sighting_t

ROOT = Path(__file__).parents[2]
INSTALLED = Path(pilotage.__file__).parent


def test_the_version_is_one():
    node = Path(sys.executable).parent / "pilotage-node"
    said = subprocess.run([node, "--version"], capture_output=True, text=True, check=True).stdout
    written = re.search(r'^version = "(.*)"$', (ROOT / "pyproject.toml").read_text(), re.M)
    assert written
    assert {version("pilotage"), pilotage.__version__, said.split()[-1]} == {written[1]}


def test_the_ready_configurations_are_there():
    names = {path.name for path in (ROOT / "configs").iterdir()}
    assert names
    assert {path.name for path in (INSTALLED / "configs").iterdir()} == names


def test_the_program_can_be_started():
    assert os.access(INSTALLED / "bin" / "pilotage-node", os.X_OK)


def test_the_types_are_there():
    assert (INSTALLED / "py.typed").exists()
    assert (INSTALLED / "_core.pyi").exists()


def test_a_message_within_a_message_comes_back():
    frame = marker_frame_t()
    sighting = marker_sighting_t()
    sighting.id = 7
    frame.sensor, frame.n, frame.sightings = "camera", 1, [sighting]
    assert marker_frame_t.decode(frame.encode()).sightings[0].id == 7


@pytest.mark.parametrize("file", ["bin/pilotage-node", "_core*.so"])
def test_libraries_are_found_next_door_wherever_the_environment_lies(file):
    (binary,) = INSTALLED.glob(file)
    dynamic = subprocess.run(["readelf", "-d", binary], capture_output=True, text=True, check=True)
    (found,) = re.findall(r"runpath: \[(.*)\]", dynamic.stdout)
    assert all(folder.startswith("$ORIGIN/..") for folder in found.split(":"))
