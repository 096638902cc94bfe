"""Many runs of a scenario on the real core: errors beside the bound, consistency, honesty."""

from .bound import Bound
from .result import MonteCarlo
from .running import run_montecarlo

__all__ = ["Bound", "MonteCarlo", "run_montecarlo"]
