"""Finds what a figure shows."""

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text


def artist(axes: Axes, gid: str) -> Any:
    """The one artist of a panel with that gid."""
    found = [child for child in axes.get_children() if child.get_gid() == gid]
    assert len(found) == 1, f"{len(found)} artists are called {gid}"
    return found[0]


def has(axes: Axes, gid: str) -> bool:
    return any(child.get_gid() == gid for child in axes.get_children())


def texts(figure: Figure) -> list[str]:
    """All that is written in a figure."""
    return [text.get_text() for text in figure.findobj(Text) if text.get_text()]
