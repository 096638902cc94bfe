"""`pilotage assignment`, as a user types it."""

import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

import pilotage as installed
from pilotage.studies.assignment_problems import NAMES
from support.command import PILOTAGE, pilotage

SOURCE = Path(__file__).parents[3] / "python" / "pilotage" / "studies" / "problems"


def step(keys: str, *arguments: str) -> str:
    command = [*PILOTAGE, "assignment", *arguments, "--step"]
    done = subprocess.run(command, input=keys, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_examples_are_installed_and_listed():
    folder = Path(installed.__file__).parent / "studies" / "problems"
    files = {path.name for path in SOURCE.iterdir()}
    assert files == {path.name for path in folder.iterdir()} == {f"{name}.txt" for name in NAMES}
    said = pilotage("assignment", "list").stdout
    assert [line.split()[0] for line in said.splitlines()[: len(NAMES)]] == list(NAMES)
    assert str(folder) in said


def test_the_whole_narrative_is_printed_and_is_the_same_again():
    first, again, other = (
        pilotage("assignment", "handout", "--seed", seed).stdout for seed in (1, 1, 2)
    )
    assert first.count("==>") == 3
    assert "Revised covariance matrix is:" in first
    assert first == again != other


def test_a_file_of_ones_own_is_taken(tmp_path):
    (tmp_path / "mine.txt").write_text((SOURCE / "exact.txt").read_text())
    said = pilotage("assignment", "mine.txt", cwd=tmp_path)
    assert said.returncode == 0, said.stderr
    assert "True state is" in said.stdout


@pytest.mark.parametrize("keys", ["nnq", "n\nn\nq\n", "nxn", "nn"])
def test_n_is_next_and_q_or_the_end_of_input_quits(keys):
    assert step(keys, "handout").count("==>") == 2


def test_a_sense_command_waits_between_beam_and_revision():
    beam, revised = (step("n" * presses, "handout") for presses in (3, 4))
    assert "The predicted range was" in beam
    assert "Revised state estimate" not in beam
    assert revised.startswith(beam)
    assert "Revised state estimate" in revised


def test_an_animation_has_a_picture_for_each_key(tmp_path):
    said = pilotage("assignment", "handout", "--animate", "out.gif", cwd=tmp_path)
    assert said.returncode == 0, said.stderr
    with Image.open(tmp_path / "out.gif") as animation:
        assert animation.n_frames == 5


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nowhere"], ["'nowhere'", "no such file", "handout", "divergence"]),
        (["broken.txt"], ["broken.txt:2", "'strat'", "'start'"]),
        (["handout", "--step", "--show"], ["--step", "--show", "one of them"]),
        (["handout", "--animate", "out.avi"], ["out.avi", ".gif"]),
    ],
)
def test_what_cannot_be_done_is_said_in_a_line(tmp_path, arguments, words):
    (tmp_path / "broken.txt").write_text("# broken\nstrat 0 0 0\n")
    said = pilotage("assignment", *arguments, cwd=tmp_path)
    assert said.returncode == 2
    assert len(said.stderr.splitlines()) == 1
    assert all(word in said.stderr for word in words)


def test_without_a_display_show_says_so():
    program = "import matplotlib; matplotlib.use('agg'); from pilotage.cli.main import main; main()"
    command = [sys.executable, "-c", program, "assignment", "handout", "--show"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode == 2
    assert "no display" in done.stderr
    assert "==>" not in done.stdout
