"""Problem files: what they mean, and what is said of those that cannot be used."""

import pickle

import numpy as np
import pytest

from pilotage.simulate.problem_file import Move, Sense, parse_problem, read_problem
from pilotage.studies.assignment_problems import PROBLEMS

LINES = """\
# A room with a table
boundary  0,0  4,0  4,3  0,3
obstacle  1,1  2,1  2,2
start     0.5 0.5 90    # looking up
commandDstSigmaRatio 0.03
commandAngSigmaRatio 0.05
rangeSigmaRatio      0.01

move   1.75  90
sense  -45
""".splitlines()


def text(line: int = 0, instead: str = "") -> str:
    lines = list(LINES)
    if line:
        lines[line - 1] = instead
    return "\n".join(lines)


def test_a_file_says_what_it_says():
    problem = parse_problem(text(), "rooms/room.txt")
    assert (problem.name, problem.title) == ("room", "A room with a table")
    np.testing.assert_array_equal(problem.world.boundary, [[0, 0], [4, 0], [4, 3], [0, 3]])
    assert len(problem.world.obstacles) == 1
    np.testing.assert_allclose(problem.start, [0.5, 0.5, np.pi / 2])
    ratios = problem.distance_ratio, problem.turn_ratio, problem.range_ratio
    assert ratios == (0.03, 0.05, 0.01)
    assert problem.commands == (Move(1.75, np.pi / 2), Sense(-np.pi / 4))


def test_commas_blanks_and_tabs_are_alike():
    one = parse_problem(text(2, "boundary 0 0 4 0, 4 3\t0,3"), "x")
    np.testing.assert_array_equal(one.world.boundary, parse_problem(text(), "x").world.boundary)


@pytest.mark.parametrize(
    ("line", "instead", "words"),
    [
        (2, "bondary 0,0 4,0 4,3", ["room.txt:2", "'bondary'", "nearest", "'boundary'"]),
        (2, "boundary 0,0 4,0 4", ["room.txt:2", "5 numbers", "x,y x,y"]),
        (2, "boundary 0,0 4,0", ["room.txt:2", "2 corners", "3 or more"]),
        (2, "boundary 0,0 4,3 4,0 0,3", ["room.txt:2", "Self-intersection[2 1.5]", "in order"]),
        (2, "", ["room.txt:", "'boundary' is missing", "add a line 'boundary x,y"]),
        (3, "obstacle 1,1 2,1 2,x2", ["room.txt:3", "obstacle", "'x2' is no number"]),
        (3, "obstacle 1,1 1,1 1,1", ["room.txt:3", "no simple polygon"]),
        (4, "start 0.5 0.5", ["room.txt:4", "2 numbers", "start x y heading (m, m, degrees)"]),
        (4, "start 1.9 1.2 0", ["room.txt:4", "(1.9, 1.2)", "start in the open"]),
        (4, "start 9 9 0", ["room.txt:4", "(9, 9)", "outside of the boundary"]),
        (4, "start 0 1 0", ["room.txt:4", "(0, 1)", "on a wall"]),
        (4, "start nan 1 0", ["room.txt:4", "'nan' is no number"]),
        (5, "commandDstSigmaRatio 3", ["room.txt:5", "is 3", "0 to 1", "0.02 is 2 %"]),
        (6, "commandAngSigmaRatio -0.1", ["room.txt:6", "is -0.1", "0 to 1"]),
        (7, "# rangeSigmaRatio 0.01", ["room.txt", "'rangeSigmaRatio' is missing"]),
        (8, "start 1 0.5 0", ["room.txt:8", "twice", "room.txt:4", "keep one"]),
        (9, "move 1.75", ["room.txt:9", "1 number,", "move distance turn (m, degrees)"]),
        (10, "sense", ["room.txt:10", "0 numbers", "sense angle (degrees)"]),
        (10, "sense 1e999", ["room.txt:10", "'1e999' is no number"]),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named_with_file_line_value_and_way_out(line, instead, words):
    with pytest.raises(ValueError, match=r"room\.txt") as error:
        parse_problem(text(line, instead), "room.txt")
    for word in words:
        assert word in str(error.value)


def test_a_file_that_is_no_text_is_named(tmp_path):
    (tmp_path / "room.txt").write_bytes(b"\x00\xff\xfe\n")
    with pytest.raises(ValueError, match=r"room\.txt:1: unknown keyword"):
        read_problem(tmp_path / "room.txt")


@pytest.mark.parametrize("name", PROBLEMS)
def test_examples_can_be_read_and_go_to_other_processes(name):
    problem = pickle.loads(pickle.dumps(read_problem(PROBLEMS[name])))
    assert problem.name == name
    assert problem.title
    assert problem.commands
