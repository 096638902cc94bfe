"""Chance that lasts: what is so now is still nearly so a little later."""

import numpy as np
from numpy.typing import NDArray


def gauss_markov(
    rms: float, tau_s: float, step_s: float, shape: tuple[int, int], rng: np.random.Generator
) -> NDArray[np.float64]:
    """Draw stationary Gauss-Markov processes, a column each.

    Parameters
    ----------
    rms : float
    tau_s : float, s
        Correlation time; 0: new at every step.
    step_s : float, s
        From one row to the next.
    shape : (steps, processes)
    """
    from scipy.signal import lfilter

    kept = np.exp(-step_s / tau_s) if tau_s > 0.0 else 0.0
    drawn = rms * rng.standard_normal(shape)
    drawn[1:] *= np.sqrt(1.0 - kept**2)
    return np.asarray(lfilter([1.0], [1.0, -kept], drawn, axis=0))
