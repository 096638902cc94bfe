"""Pictures one after the other: by key in a window, or as an animation."""

from collections.abc import Callable
from pathlib import Path

from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.backend_bases import Event, KeyEvent
from matplotlib.figure import Figure

from .window import put_in_window

PER_SECOND = 1
"""Pictures of an animation."""


def step_in_window(name: str, figure: Figure, show: Callable[[int], None], count: int) -> None:
    """Open a window and return when it is closed; keys as in `step_by_key`."""
    import matplotlib.pyplot as plt

    put_in_window(name, figure)
    step_by_key(figure, show, count, lambda: plt.close(name))
    plt.show()


def step_by_key(
    figure: Figure, show: Callable[[int], None], count: int, close: Callable[[], None]
) -> None:
    """Show picture 0, then at every 'n' the next up to `count`, and close at 'q'.

    Parameters
    ----------
    show : callable
        Draws the k-th picture into the figure.
    """
    at = 0

    def press(event: Event) -> None:
        nonlocal at
        key = event.key if isinstance(event, KeyEvent) else None
        if key == "q":
            close()
        elif key == "n" and at + 1 < count:
            at += 1
            show(at)
            figure.canvas.draw_idle()

    show(at)
    figure.canvas.mpl_connect("key_press_event", press)


def animate(figure: Figure, show: Callable[[int], None], count: int, path: Path) -> None:
    """Write all pictures as a GIF."""
    if path.suffix.lower() != ".gif":
        raise ValueError(f"'{path}' is no name of an animation, expected one that ends in .gif")
    path.parent.mkdir(parents=True, exist_ok=True)
    animation = FuncAnimation(figure, show, frames=count, init_func=lambda: None)
    animation.save(path, PillowWriter(fps=PER_SECOND))
