"""Many runs of a scenario on the real core: errors beside the bound, consistency, honesty.

What is run stands in `simulate`; what must come out, in `bars.yaml`.
"""

from .bars import find_scenario
from .bound import Bound
from .result import MonteCarlo
from .running import run_montecarlo
from .trial import simulate_run

__all__ = ["Bound", "MonteCarlo", "find_scenario", "run_montecarlo", "simulate_run"]
