"""Pictures by key, in windows and as animations."""

import matplotlib.pyplot as plt
import pytest
from matplotlib.backend_bases import KeyEvent
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from pilotage.plot.stepping import animate, step_by_key, step_in_window
from pilotage.plot.window import put_in_window


class Shown:
    """A figure in a window that is not there, and what was drawn into it."""

    def __init__(self, count: int) -> None:
        self.figure = Figure()
        self.pictures: list[int] = []
        self.closed = False
        step_by_key(self.figure, self.pictures.append, count, self.close)

    def close(self) -> None:
        self.closed = True

    def press(self, *keys: str) -> None:
        for key in keys:
            event = KeyEvent("key_press_event", self.figure.canvas, key)
            self.figure.canvas.callbacks.process("key_press_event", event)


def test_the_first_picture_is_there_at_once():
    assert Shown(3).pictures == [0]


def test_n_shows_the_next_up_to_the_last():
    shown = Shown(3)
    shown.press("n", "x", "n", "n", "n")
    assert shown.pictures == [0, 1, 2]
    assert not shown.closed


def test_q_closes():
    shown = Shown(3)
    shown.press("n", "q")
    assert shown.closed
    assert shown.pictures == [0, 1]


def test_an_animation_has_every_picture(tmp_path):
    figure = Figure(figsize=(2, 1))
    axes = figure.subplots()
    path = tmp_path / "new" / "out.gif"
    animate(figure, lambda k: axes.set_title(f"picture {k}"), 4, path)
    with Image.open(path) as animation:
        assert animation.n_frames == 4


def test_an_animation_of_another_kind_is_refused(tmp_path):
    with pytest.raises(ValueError, match=r"out\.mp4.*expected one that ends in \.gif"):
        animate(Figure(), lambda k: None, 1, tmp_path / "out.mp4")


def test_a_window_is_stepped_through_and_closed(monkeypatch):
    plt.switch_backend("agg")  # with a display that is not there
    monkeypatch.setattr(FigureCanvasAgg, "required_interactive_framework", "none", raising=False)
    figure, pictures, open_after = Figure(), [], []

    def show() -> None:
        for key in "nnq":
            canvas = plt.figure("steps").canvas  # the window's own
            canvas.callbacks.process("key_press_event", KeyEvent("key_press_event", canvas, key))
        open_after.extend(plt.get_fignums())

    monkeypatch.setattr(plt, "show", show)
    step_in_window("steps", figure, pictures.append, 3)
    assert pictures == [0, 1, 2]
    assert open_after == []


def test_without_a_display_it_is_said():
    before = plt.get_backend()
    plt.switch_backend("agg")
    try:
        with pytest.raises(RuntimeError, match=r"no display .* agg"):
            put_in_window("name", Figure())
        assert plt.get_fignums() == []
    finally:
        plt.switch_backend(before)
