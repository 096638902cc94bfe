"""`pilotage assignment`: a robot commanded by a problem file, picture by picture."""

import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from ..studies.assignment_frames import Frame

LINE = "-- n: next, q: quit"


def assignment(
    problem: Annotated[
        str, typer.Argument(help="A problem file, the name of an example, or list.")
    ],
    step: Annotated[
        bool, typer.Option("--step", help="Wait in the terminal: n is next, q is quit.")
    ] = False,
    show: Annotated[
        bool, typer.Option("--show", help="Draw in a window and wait there: n is next, q is quit.")
    ] = False,
    animation: Annotated[
        Path | None, typer.Option("--animate", help="Write the pictures as an animation, a GIF.")
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Of the robot's noise.")] = 1,
) -> None:
    """Command a robot through a world of polygons and keep track of where it may be.

    A problem file holds the world, the start, three noise ratios, and commands move and sense;
    docs/studies/assignment.md shows one. Without --step or --show the whole narrative is printed.

    Example: pilotage assignment handout --show
    """
    import numpy as np

    from ..simulate.problem_file import read_problem
    from ..studies.assignment_filter import commanded
    from ..studies.assignment_frames import draw, frames, world_figure
    from ..studies.assignment_problems import PROBLEMS, find_problem

    if problem == "list":
        for path in PROBLEMS.values():
            typer.echo(f"{path.stem:<11} {read_problem(path).title}")
        typer.echo(f"\nThe files are in {path.parent}: copy one to begin with.")
        return
    if step and show:
        raise ValueError("--step waits in the terminal and --show in a window: give one of them")
    chosen = find_problem(problem)
    steps = commanded(chosen, np.random.default_rng((seed, 0)))
    told = list(frames(chosen, steps))
    if show:
        from ..plot.stepping import step_in_window

        def next_picture(k: int) -> None:
            _tell(told[k])
            draw(axes, chosen, told[k])

        figure, axes = world_figure(chosen)
        step_in_window(chosen.name, figure, next_picture, len(told))
    elif step:
        _step(told)
    else:
        for frame in told:
            _tell(frame)
    if animation is not None:
        from ..plot.stepping import animate

        figure, axes = world_figure(chosen)
        animate(figure, lambda k: draw(axes, chosen, told[k]), len(told), animation)
        typer.echo(animation)


def _tell(frame: "Frame") -> None:
    typer.echo(frame.text + "\n")


def _step(told: "Sequence[Frame]", key: "Callable[[], str] | None" = None) -> None:
    """Tell one after the other, at 'n', to the last or to 'q'."""
    key = key or (typer.getchar if sys.stdin.isatty() else lambda: sys.stdin.read(1) or "q")
    for k, frame in enumerate(told):
        _tell(frame)
        if k + 1 == len(told):
            return
        typer.echo(f"{LINE} ({k + 1} of {len(told)})", err=True)
        while (pressed := key()) != "n":
            if pressed == "q":
                return
