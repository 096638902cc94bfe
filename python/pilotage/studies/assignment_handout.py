"""The narrative that the handout prints, reproduced from its first line.

Its poses follow from the start (-0.6, -1.25, 0°) with P = 0 and the moves between them. The true
poses are exactly what was commanded, 1.75 m and 90°: the printed run has the noise in the
estimate's input, where the text has it in the robot, and P_u in proportion to the noisy input. The
ratios are not printed; 0.03, 0.05 and 0.01 give every digit that is right.
"""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from .. import Ekf3, MoveAndTurn, WallMap, WallRange
from .assignment_filter import Belief
from .assignment_narrative import uncertainty
from .study import Table

POSES_DEG = ((-0.6, -1.25, 0.0), (1.10114, -1.25, 86.0965), (1.22095, 0.505793, 181.969))
TRUTH_DEG = (1.15, 0.5, 180.0)
RATIOS = 0.03, 0.05, 0.01  # distance, turn, range
BEAM_DEG, RANGE_M = 90.0, 2.00572
WALL = (-3.0, -1.5, 3.0, -1.5)
AGREES = 1e-3
"""Relative: all is printed with six digits or fewer, and the moves come from printed poses."""

TWICE = "converted to degrees twice"
PRINTED: dict[str, tuple[float, str]] = {
    "prior σ_x², m²": (0.0200199, ""),
    "prior σ_y²": (0.00285555, ""),
    "prior σ_θ², rad²": (0.0126447, ""),
    "prior σ_xy": (-0.000998142, ""),
    "prior σ_xθ": (-0.00991148, ""),
    "prior σ_yθ": (0.000676311, ""),
    "prior minor radius, m": (0.131259, ""),
    "prior major radius": (0.35163, ""),
    "prior orientation, °": (169.91084, TWICE),
    "prior 2σ_θ, °": (12.44284, "not 2 √0.0126447"),
    "predicted range, m": (2.00698, ""),
    "dh/dx": (0.0, ""),
    "dh/dy": (1.00059, ""),
    "dh/dθ, m/rad": (0.0689879, ""),
    "revised x, m": (1.22157, ""),
    "revised y": (0.504722, ""),
    "revised θ, °": (181.936, ""),
    "revised σ_x², m²": (0.0203742, "grows: an update cannot"),
    "revised σ_y²": (0.0301436, "grows; its ellipse is of 0.000386"),
    "revised σ_θ², rad²": (0.0181603, "grows"),
    "revised σ_xy": (0.0134885, "of these"),
    "revised σ_xθ": (-0.00853237, "of these"),
    "revised σ_yθ": (-0.0188613, "of these"),
    "revised minor radius, m": (0.0481291, ""),
    "revised major radius": (0.343865, ""),
    "revised orientation, °": (75.51344, TWICE),
    "revised 2σ_θ, °": (10.01445, "of no printed σ_θ²"),
}
"""What the handout prints, and what is wrong with it."""


def handout() -> tuple[Belief, Belief, dict[str, float]]:
    """Compute the narrative: belief before and after the range, and its numbers by name."""
    poses = [np.array([x, y, np.radians(heading)]) for x, y, heading in POSES_DEG]
    ekf, motion = Ekf3(poses[0], np.zeros((3, 3))), MoveAndTurn()
    for start, end in pairwise(poses):
        u = np.array([np.hypot(*(end - start)[:2]), end[2] - start[2]])
        ekf.predict(motion, u, np.diag(np.square(RATIOS[:2] * u)), np.zeros(3))
    prior = Belief.of(ekf)
    beam = WallRange(WallMap([WALL]), np.radians(BEAM_DEG))
    (predicted,), (derivatives,), _ = beam.linearize(prior.state)
    ekf.update(beam, [RANGE_M], [[(RATIOS[2] * RANGE_M) ** 2]])
    revised = Belief.of(ekf)
    x, y, heading = revised.state
    found = dict(_uncertain("prior", prior)) | {"predicted range, m": float(predicted)}
    found |= zip(("dh/dx", "dh/dy", "dh/dθ, m/rad"), derivatives, strict=True)
    found |= {"revised x, m": x, "revised y": y, "revised θ, °": np.degrees(heading) % 360.0}
    found |= _uncertain("revised", revised)
    return prior, revised, {name: float(found[name]) for name in PRINTED}


def handout_table() -> tuple[Table, float]:
    """Compare it with the print; also the largest relative difference where that is right."""
    _, _, ours = handout()
    apart = {
        name: abs(ours[name] - printed) / (abs(printed) or 1.0)
        for name, (printed, wrong) in PRINTED.items()
        if not wrong
    }
    rows = [
        (name, f"{printed:.6g}", f"{ours[name] + 0.0:.6g}", wrong)
        for name, (printed, wrong) in PRINTED.items()
    ]
    note = (
        f"The {len(apart)} numbers with nothing wrong agree to {max(apart.values()):.1e}. The "
        "handout's estimate moved\n1.7011 m, 86.10° and 1.7599 m, 95.87°; its true robot 1.75 m, "
        "90° both times, as commanded."
    )
    head = ("", "printed", "ours", "what is wrong with the print")
    table = Table("The handout's narrative", head, rows, note)
    return table, max(apart.values())


def _uncertain(when: str, belief: Belief) -> Iterator[tuple[str, float]]:
    p, shown = belief.covariance, uncertainty(belief)
    yield f"{when} σ_x², m²", p[0, 0]
    yield f"{when} σ_y²", p[1, 1]
    yield f"{when} σ_θ², rad²", p[2, 2]
    yield f"{when} σ_xy", p[0, 1]
    yield f"{when} σ_xθ", p[0, 2]
    yield f"{when} σ_yθ", p[1, 2]
    yield f"{when} minor radius, m", shown["minor_m"]
    yield f"{when} major radius", shown["major_m"]
    yield f"{when} orientation, °", shown["orientation_deg"]
    yield f"{when} 2σ_θ, °", shown["cone_deg"]
