"""The tables of the assignment's study: its examples, and what each of them must show."""

from collections.abc import Mapping

import numpy as np

from ..evaluate import Ensemble
from ..simulate.problem_file import Move
from .assignment_ends import ASSIGNED, FORGOTTEN, GATED, MOVES, UNSCENTED, WAYS, WEIGHTED
from .assignment_handout import AGREES
from .assignment_narrative import PROBABILITY
from .assignment_problems import NAMES, find_problem
from .study import Table

TWO_SIGMA = 1.0 - float(np.exp(-2.0))  # of a plane Gaussian: 86.5 %
Found = Mapping[tuple[str, str], Ensemble]
"""By example and way to fuse."""
SHARES = ("ellipse", "cone", "lost")
Proof = tuple[str, float, float, float]
"""What, ours, at least, at most."""


def proofs_of(found: Found, apart: float) -> list[Proof]:
    """What each example must show, as a number, with the least and the most that it may be."""
    of = {name: found[name, ASSIGNED] for name in NAMES}
    straight, corridor = find_problem("straight"), of["corridor"]
    sigma = straight.distance_ratio * np.sqrt(len(straight.commands))  # moves of 1 m each
    along, across = np.sqrt(corridor.covariance.mean(axis=0)[(0, 1), (0, 1)])
    unaided = np.sqrt(found["corridor", MOVES].covariance.mean(axis=0)[(0, 1), (0, 1)])
    return [
        ("handout: right numbers of the print, relative difference", apart, 0, AGREES),
        ("exact: largest error, m or rad", np.abs(of["exact"].error).max(), 0, 1e-12),
        ("exact: largest element of P", np.abs(of["exact"].covariance).max(), 0, 0),
        (
            "straight: σ by eq. 7 / (0.1 m · √16) - 1",
            of["straight"].stated_m / sigma - 1,
            -1e-12,
            1e-12,
        ),
        ("straight: rms error / (0.1 m · √16)", of["straight"].position_m / sigma, 0.9, 1.1),
        (
            "square: true position in the 95.4 % ellipse",
            of["square"].in_ellipse(PROBABILITY),
            0.93,
            0.975,
        ),
        (
            "square: in an ellipse of 2 σ, which holds 86.5 %",
            of["square"].in_ellipse(TWO_SIGMA),
            0.83,
            0.90,
        ),
        ("square: true heading within ±2 σ", of["square"].in_cone(), 0.93, 0.975),
        ("corridor: σ along / without ranges", along / unaided[0], 0.98, 1.0),
        ("corridor: σ across / without ranges", across / unaided[1], 0, 0.05),
        (
            "corridor: heading error / without σ_xθ, σ_yθ",
            corridor.heading_deg / found["corridor", FORGOTTEN].heading_deg,
            0,
            0.1,
        ),
        ("tour: lost, with the weight", found["tour", WEIGHTED].lost, 0, 0.02),
        (
            "tour: position error, with the weight / moves only",
            found["tour", WEIGHTED].position_m / found["tour", MOVES].position_m,
            0,
            0.1,
        ),
        ("spread: in the ellipse, as assigned", of["spread"].in_ellipse(PROBABILITY), 0, 0.85),
        (
            "spread: in the ellipse, unscented",
            found["spread", UNSCENTED].in_ellipse(PROBABILITY),
            0.9,
            0.98,
        ),
        ("divergence: lost, as assigned", of["divergence"].lost, 0.8, 1.0),
        ("divergence: lost, with the gate", found["divergence", GATED].lost, 0, 0.1),
    ]


def examples(found: Found, runs: int) -> Table:
    """Tabulate where the examples end as assigned."""
    rows = []
    for name in NAMES:
        of, commands = found[name, ASSIGNED], find_problem(name).commands
        moves = sum(isinstance(command, Move) for command in commands)
        metres = (f"{value:.3f}" for value in (of.position_m, of.stated_m))
        degrees = (f"{value:.2f}" for value in (of.heading_deg, of.stated_deg))
        shares = map(_percent, (of.in_ellipse(PROBABILITY), of.in_cone(), of.lost))
        rows.append((name, f"{moves} + {len(commands) - moves}", *metres, *degrees, *shares))
    return Table(
        f"Examples as assigned, at the end of {runs} runs: rms error, and what P states",
        ("", "move + sense", "position, m", "stated", "heading, °", "stated", *SHARES),
        rows,
        "ellipse, cone: truth in the 95.4 % ellipse, heading within ±2 σ (95.4 %).\n"
        "lost: position or heading is where P leaves it one chance in a million.",
    )


def ways(found: Found) -> Table:
    """Tabulate other ways to fuse the same ranges."""
    rows = [
        (
            way,
            f"{found['corridor', way].heading_deg:.3f}",
            f"{found['tour', way].position_m:.3f}",
            _percent(found["tour", way].lost),
            _percent(found["spread", way].in_ellipse(PROBABILITY)),
            _percent(found["divergence", way].lost),
        )
        for way in WAYS
    ]
    return Table(
        "Other ways to fuse the same ranges",
        ("", "corridor: θ, °", "tour: position, m", "lost", "spread: ellipse", "divergence: lost"),
        rows,
    )


def must_show(proofs: list[Proof]) -> Table:
    """Tabulate the proofs with their bars."""
    return Table(
        "What it must show",
        ("", "ours", "at least", "at most", "met"),
        [
            (what, f"{value:.3g}", f"{low:g}", f"{high:g}", "yes" if low <= value <= high else "NO")
            for what, value, low, high in proofs
        ],
    )


def _percent(share: float) -> str:
    return "-" if np.isnan(share) else f"{share:.1%}"
