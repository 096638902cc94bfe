"""What is allowed but hardly meant, found without a robot.

Each check is a function from a configuration to its findings, and stands in the list of its file.
What is plainly wrong is refused by C++ when the file is loaded, and not looked for again here.
"""

from collections.abc import Callable, Iterable
from itertools import chain

from .. import Config
from . import cameras, markers, motion, sensors, timing
from .finding import Finding
from .summary import summarize
from .timing import no_multicast

__all__ = ["Check", "Finding", "check_config", "no_multicast", "summarize"]

Check = Callable[[Config], Iterable[Finding]]
CHECKS: tuple[Check, ...] = (
    *motion.CHECKS,
    *sensors.CHECKS,
    *cameras.CHECKS,
    *markers.CHECKS,
    *timing.CHECKS,
)


def check_config(config: Config) -> list[Finding]:
    """Return the findings of all checks."""
    return list(chain.from_iterable(check(config) for check in CHECKS))
