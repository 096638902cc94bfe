"""Functions run in a process of their own, in a network of its own where multicast works.

So tests of real processes over LCM disturb nobody and are disturbed by nobody, whatever the machine's
network.
"""

import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from pilotage import multicast

TESTS = Path(__file__).parents[1]
TIMEOUT_S = 120
LACKING = "needs unshare (util-linux), ip (iproute2) and a kernel that lets users make namespaces"


def run_privately(folder: Path, function: Callable[..., Any], *args: Any, **how: Any) -> Any:
    """What a function of an importable module returns there; the call is kept in `folder`."""
    command = multicast.private_network([sys.executable, "-m", __name__, str(folder)])
    if command is None:
        pytest.skip(LACKING)
    (folder / "call.pickle").write_bytes(pickle.dumps((function, args, how)))
    path = os.pathsep.join([str(TESTS), os.environ.get("PYTHONPATH", "")])
    subprocess.run(command, check=True, timeout=TIMEOUT_S, env={**os.environ, "PYTHONPATH": path})
    return pickle.loads((folder / "result.pickle").read_bytes())


if __name__ == "__main__":
    place = Path(sys.argv[1])
    call, arguments, keywords = pickle.loads((place / "call.pickle").read_bytes())
    (place / "result.pickle").write_bytes(pickle.dumps(call(*arguments, **keywords)))
