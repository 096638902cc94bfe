"""The example problems that come with the assignment."""

from pathlib import Path

from ..simulate.problem_file import Problem, read_problem

NAMES = ("handout", "exact", "straight", "square", "corridor", "tour", "spread", "divergence")
PROBLEMS = {name: Path(__file__).parent / "problems" / f"{name}.txt" for name in NAMES}


def find_problem(name: str) -> Problem:
    """Read an example by its name, or a file by its path; ValueError if there is neither."""
    if name not in PROBLEMS and not Path(name).exists():
        raise ValueError(
            f"no example is called '{name}', and there is no such file; "
            f"there are {', '.join(PROBLEMS)}; docs/studies/assignment.md shows a file of your own"
        )
    return read_problem(PROBLEMS.get(name, Path(name)))
