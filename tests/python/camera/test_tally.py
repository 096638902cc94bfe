"""Counts of frames, and words that are not repeated without end."""

from pilotage.camera import tally as module
from pilotage.camera.tally import Tally


def test_the_same_is_said_once_a_second_with_how_often_it_was_so(monkeypatch):
    now = [100.0]
    monkeypatch.setattr(module, "monotonic", lambda: now[0])
    said: list[str] = []
    tally = Tally("rear", said.append)
    for i in range(4):
        tally.drop("unreadable", f"{i}.png is no image")
    tally.drop("busy")
    tally.warn("clock", "behind")
    now[0] += 1.5
    tally.drop("unreadable", "4.png is no image")
    assert said == [
        "rear: 0.png is no image",
        "rear: behind",
        "rear: 4.png is no image (and 3 more since)",
    ]
    assert tally.dropped == {"unreadable": 5, "busy": 1}


def test_the_summary_has_every_frame():
    tally = Tally("rear", print)
    for _ in range(5):
        tally.frame()
    for _ in range(2):
        tally.publish(3)
    for reason in ("wrong_size", "busy", "busy"):
        tally.drop(reason)
    tally.settle("failed")
    assert tally.summary() == "5 frames = 2 published + 2 busy + 1 wrong_size; 6 detections"


def test_what_was_under_way_when_the_work_broke_off_is_counted():
    tally = Tally("rear", print)
    for _ in range(3):
        tally.frame()
    tally.publish(0)
    tally.settle("failed")
    assert tally.summary() == "3 frames = 1 published + 2 failed; 0 detections"
