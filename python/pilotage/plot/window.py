"""Figures in windows."""

from collections.abc import Callable, Mapping

from matplotlib.figure import Figure


def show_figures(figures: Mapping[str, Callable[[], Figure]]) -> None:
    """Show each figure in a window of its own until all are closed; needs a display."""
    import matplotlib.pyplot as plt

    for name, draw in figures.items():
        put_in_window(name, draw())
    plt.show()


def put_in_window(name: str, figure: Figure) -> None:
    """Give a figure a window, which `matplotlib.pyplot.show` opens."""
    import matplotlib.pyplot as plt

    canvas = plt.figure(num=name).canvas
    if canvas.manager is None or canvas.required_interactive_framework is None:
        plt.close(name)
        raise RuntimeError(
            f"there is no display to show figures on (matplotlib draws with {plt.get_backend()}); "
            "without --show everything works"
        )
    figure.set_label(name)  # by which pyplot finds the window
    canvas.figure = figure
    figure.set_canvas(canvas)
