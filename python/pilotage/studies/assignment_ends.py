"""Where the example problems end, run many times, with the ranges fused in several ways."""

from dataclasses import replace
from typing import Any

import numpy as np

from .. import Policy, Ukf3
from ..evaluate import Ensemble, wrap_angle
from ..simulate.problem_file import Move
from .assignment_filter import commanded
from .assignment_problems import find_problem

GATE = 0.001  # of false rejections
ASSIGNED, GATED, WEIGHTED, UNSCENTED, FORGOTTEN, MOVES = WAYS = (
    "as assigned",
    "gate, 99.9 %",
    "Student-t weight",
    "unscented",
    "no σ_xθ, σ_yθ",
    "moves only",
)
"""How ranges are fused."""


def ends(name: str, way: str, seed: int, runs: int) -> Ensemble:
    """Run an example many times, to its end."""
    problem = find_problem(name)
    if way == MOVES:
        moves = tuple(command for command in problem.commands if isinstance(command, Move))
        problem = replace(problem, commands=moves)
    ways: dict[str, dict[str, Any]] = {
        GATED: {"policy": Policy.gate(GATE)},
        WEIGHTED: {"policy": Policy.student_t()},
        UNSCENTED: {"kind": Ukf3},
        FORGOTTEN: {"joint": False},
    }
    error, covariance = np.empty((runs, 3)), np.empty((runs, 3, 3))
    for k in range(runs):
        *_, last = commanded(problem, np.random.default_rng((seed, k)), **ways.get(way, {}))
        error[k] = last.truth - last.after.state
        covariance[k] = last.after.covariance
    error[:, 2] = wrap_angle(error[:, 2])
    return Ensemble(error, covariance)
