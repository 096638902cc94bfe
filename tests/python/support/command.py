"""The command `pilotage`, as a user types it."""

import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

PILOTAGE = [sys.executable, "-c", "from pilotage.cli.main import main; main()"]


def pilotage(
    *arguments: object,
    cwd: Path | None = None,
    env: Mapping[str, str] | None = None,
    within: Sequence[str] = (),
) -> "subprocess.CompletedProcess[str]":
    """Run it to its end; `within` is a command that runs commands, such as unshare."""
    return subprocess.run(
        [*within, *PILOTAGE, *map(str, arguments)],
        capture_output=True,
        text=True,
        cwd=cwd,
        env=env,
        timeout=120,
    )
