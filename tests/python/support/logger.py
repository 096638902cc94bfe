"""lcm-logger beside a test."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pilotage.live import URL

LOGGER = Path(sys.executable).parent / "lcm-logger"


@contextmanager
def lcm_logger(log: Path) -> Iterator[None]:
    """lcm-logger, which is a script around the program: both are ended, as one group."""
    command = [str(LOGGER), "--quiet", "--flush-interval=10", f"--lcm-url={URL}", str(log)]
    process = subprocess.Popen(command, start_new_session=True)
    try:
        yield
    finally:
        os.killpg(process.pid, signal.SIGINT)
        process.wait(timeout=10)
