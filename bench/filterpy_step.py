"""The three-state step as filterpy's ExtendedKalmanFilter does it: ns a predict and an update."""

import json
import math
import statistics
import time
from collections.abc import Callable

import numpy as np
from filterpy.kalman import ExtendedKalmanFilter

MARKER = np.array([5.0, 6.0, -1.0])  # m, the last above the camera
Z = np.array([0.7, -0.2])
DISTANCE, TURN = 0.02, 0.01
GAMMA = np.diag([1e-6, 1e-7])
Q = np.diag([1e-8, 1e-8, 1e-9])
R = np.diag([1e-4, 1e-4])


def wrap(angle: float) -> float:
    return math.remainder(angle, math.tau)


class Robot(ExtendedKalmanFilter):
    def __init__(self) -> None:
        super().__init__(dim_x=3, dim_z=2)
        self.x = np.array([1.0, 2.0, 0.3])
        self.P = np.diag([0.04, 0.04, 0.0025])
        self.R = R

    def predict_x(self, u: float = 0) -> None:
        self.x[0] += self.dx
        self.x[1] += self.dy
        self.x[2] = wrap(self.x[2] + TURN)

    def step(self) -> None:
        direction = self.x[2] + TURN / 2
        c, s = math.cos(direction), math.sin(direction)
        self.dx, self.dy = DISTANCE * c, DISTANCE * s
        self.F = np.array([[1.0, 0.0, -self.dy], [0.0, 1.0, self.dx], [0.0, 0.0, 1.0]])
        b = np.array([[c, -self.dy / 2], [s, self.dx / 2], [0.0, 1.0]])
        self.Q = b @ GAMMA @ b.T + Q
        self.predict()


def h(x: np.ndarray) -> np.ndarray:
    dx, dy = MARKER[0] - x[0], MARKER[1] - x[1]
    return np.array([math.atan2(dy, dx) - x[2], math.atan(MARKER[2] / math.hypot(dx, dy))])


def jacobian(x: np.ndarray) -> np.ndarray:
    dx, dy, dz = MARKER[0] - x[0], MARKER[1] - x[1], MARKER[2]
    d2 = dx * dx + dy * dy
    factor = dz / (math.sqrt(d2) * (d2 + dz * dz))
    return np.array([[dy / d2, -dx / d2, -1.0], [dx * factor, dy * factor, 0.0]])


def residual(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    difference = a - b
    difference[0] = wrap(difference[0])
    return difference


def median_ns(action: Callable[[], None]) -> float:
    times = []
    for _ in range(2000):
        start = time.perf_counter_ns()
        action()
        times.append(time.perf_counter_ns() - start)
    return statistics.median(times)


def main() -> None:
    robot = Robot()
    predict = median_ns(robot.step)
    update = median_ns(lambda: robot.update(Z, jacobian, h, residual=residual))
    print(json.dumps({"predict_filterpy": predict, "update_filterpy": update}))


if __name__ == "__main__":
    main()
