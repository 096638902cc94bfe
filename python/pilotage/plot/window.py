"""Figures in windows."""

from collections.abc import Callable, Mapping

from matplotlib.figure import Figure


def show_figures(figures: Mapping[str, Callable[[], Figure]]) -> None:
    """Show each figure in a window of its own until all are closed; needs a display."""
    import matplotlib.pyplot as plt

    for name, draw in figures.items():
        figure = draw()
        manager = plt.figure(num=name).canvas.manager
        if manager is None:
            raise RuntimeError("there is no display to show figures on; give -o DIR instead")
        manager.canvas.figure = figure
        figure.set_canvas(manager.canvas)
    plt.show()
