"""The command `pilotage-node`: becomes the C++ program that the wheel carries."""

from __future__ import annotations

import ctypes
import os
import sys
from pathlib import Path

from pilotage._glib import explain

BINARY = Path(__file__).parent / "bin" / "pilotage-node"


def main() -> None:
    """Replace this process by the program, with the same arguments."""
    try:
        ctypes.CDLL("libglib-2.0.so.0")  # after exec only the loader could complain
        os.execv(BINARY, ["pilotage-node", *sys.argv[1:]])
    except OSError as error:
        sys.exit(f"pilotage-node cannot start: {explain(error)}")
