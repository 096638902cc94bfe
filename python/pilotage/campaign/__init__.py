"""The campaign of faults: fifty cells, many runs each, and what the localizer said.

What can go wrong stands in `simulate`, how it is judged in `evaluate`; here it is run and reported.
"""

from .report import FaultReport
from .running import Task, run_once, run_tasks

__all__ = ["FaultReport", "Task", "run_once", "run_tasks"]
