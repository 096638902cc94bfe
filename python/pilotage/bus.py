"""LCM's bus, joined with a word about the way out where that fails."""

import os
from typing import Any

import lcm

from . import multicast

DEFAULT_URL = f"udpm://{multicast.GROUP}:{multicast.PORT}?ttl=0"
"""LCM's own, where neither an option nor LCM_DEFAULT_URL names another."""


def resolved(url: str | None) -> str:
    """Return the URL that is used where this one is asked for."""
    return url or os.environ.get("LCM_DEFAULT_URL") or DEFAULT_URL


def connect(url: str | None = None) -> Any:
    """Join the bus.

    Raises
    ------
    RuntimeError
        If LCM cannot use the URL.
    """
    try:
        return lcm.LCM(resolved(url))
    except RuntimeError as error:
        usual = f"is it a URL like {DEFAULT_URL}?"
        advice = usual if multicast.available() else multicast.ADVICE
        raise RuntimeError(f"LCM cannot use {resolved(url)}: {advice}") from error
