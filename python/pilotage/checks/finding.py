"""What a check finds."""

from typing import NamedTuple


class Finding(NamedTuple):
    """Something that deserves a second look."""

    key: str
    """Where: a dotted key, or a section."""
    problem: str
    remedy: str
    note: bool = False
    """Worth knowing, but no fault of what is configured."""
