"""Writes symforce_step.hpp: the three-state step as symforce generates it, to race against ours.

Its update is the shorter (I - K H) P without any check, the least that could be asked of it.
"""

import argparse
from pathlib import Path

import symforce

symforce.set_epsilon_to_number()

import symforce.symbolic as sf  # noqa: E402  (symforce wants its epsilon first)
from symforce import codegen  # noqa: E402


def symmetric(p: sf.M33) -> sf.M33:
    """P from its lower triangle, so that no product is computed twice."""
    return sf.M33([[p[max(i, j), min(i, j)] for j in range(3)] for i in range(3)])


def predict(x: sf.V3, p: sf.M33, u: sf.V2, gamma: sf.M22, q: sf.V3) -> tuple[sf.V3, sf.M33]:
    direction = x[2] + u[1] / 2
    step = sf.V3(
        x[0] + u[0] * sf.cos(direction),
        x[1] + u[0] * sf.sin(direction),
        x[2] + u[1],
    )
    a, b = step.jacobian(x), step.jacobian(u)
    step[2] = sf.wrap_angle(step[2])
    g = sf.M22([[gamma[0, 0], gamma[1, 0]], [gamma[1, 0], gamma[1, 1]]])
    p_next = a * symmetric(p) * a.T + b * g * b.T + sf.M33.diag(list(q))
    return step, symmetric(p_next)


def update(x: sf.V3, p: sf.M33, marker: sf.V3, z: sf.V2, variances: sf.V2) -> tuple[sf.V3, sf.M33]:
    dx, dy = marker[0] - x[0], marker[1] - x[1]
    predicted = sf.V2(
        sf.atan2(dy, dx, epsilon=0) - x[2],
        sf.atan2(marker[2], sf.sqrt(dx**2 + dy**2), epsilon=0),
    )
    h = predicted.jacobian(x)
    innovation = sf.V2(sf.wrap_angle(z[0] - predicted[0]), z[1] - predicted[1])
    p = symmetric(p)
    ph = p * h.T
    s = h * ph + sf.M22.diag(list(variances))
    determinant = s[0, 0] * s[1, 1] - s[1, 0] ** 2
    k = ph * sf.M22([[s[1, 1], -s[1, 0]], [-s[1, 0], s[0, 0]]]) / determinant
    x_next = x + k * innovation
    x_next[2] = sf.wrap_angle(x_next[2])
    return x_next, symmetric(p - k * ph.T)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path)
    output: Path = parser.parse_args().output
    functions = []
    for function in (predict, update):
        generator = codegen.Codegen.function(
            function, config=codegen.CppConfig(), output_names=["x_next", "p_next"]
        )
        generator.generate_function(output_dir=output.parent, skip_directory_nesting=True)
        functions.append(f'#include "{function.__name__}.h"\n')
    output.write_text("#pragma once\n" + "".join(functions))


if __name__ == "__main__":
    main()
