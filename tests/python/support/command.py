"""The commands `pilotage` and `pilotage-camera`, as a user types them."""

import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

PILOTAGE = [sys.executable, "-c", "from pilotage.cli.main import main; main()"]

CAMERA = [sys.executable, "-c", "from pilotage.cli.camera import main; main()"]


def pilotage(
    *arguments: object,
    cwd: Path | None = None,
    env: Mapping[str, str] | None = None,
    within: Sequence[str] = (),
) -> "subprocess.CompletedProcess[str]":
    """Run it to its end; `within` is a command that runs commands, such as unshare."""
    return _run([*within, *PILOTAGE, *map(str, arguments)], cwd, env)


def pilotage_camera(
    *arguments: object, cwd: Path | None = None, env: Mapping[str, str] | None = None
) -> "subprocess.CompletedProcess[str]":
    """Run that to its end."""
    return _run([*CAMERA, *map(str, arguments)], cwd, env)


def _run(
    command: Sequence[str], cwd: Path | None, env: Mapping[str, str] | None
) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        command,
        capture_output=True,
        text=True,
        cwd=cwd,
        env=env,
        timeout=120,
    )
