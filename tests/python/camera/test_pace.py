"""When recorded images are due."""

from threading import Event, Thread

from pilotage.camera import pace
from pilotage.camera.pace import DrivesPace, OwnPace


class Clock(Event):
    """Waits without waiting."""

    def __init__(self):
        super().__init__()
        self.waited: list[float] = []
        self.now = 100.0

    def wait(self, timeout=None):
        self.waited.append(timeout)
        self.now += timeout
        return self.is_set()


def test_images_keep_their_pauses(monkeypatch):
    clock = Clock()
    monkeypatch.setattr(pace, "monotonic", lambda: clock.now)
    own = OwnPace(5_000_000, 2.0, clock)
    assert [own(t) for t in (5_000_000, 5_500_000, 6_500_000)] == [True] * 3
    clock.now += 10
    assert own(7_000_000)
    assert clock.waited == [0.0, 0.25, 0.5, 0.0]
    clock.set()
    assert not own(8_000_000)


def test_an_image_waits_until_the_drive_has_come_to_its_time():
    stop = Event()
    drive = DrivesPace(stop.is_set)
    answers: list[bool] = []
    waiting = Thread(target=lambda: answers.append(drive(500)))
    waiting.start()
    for utime in (100, 499):
        drive.heard(utime)
    assert answers == []
    drive.heard(500)
    waiting.join(10)
    assert answers == [True]
    assert drive(400)


def test_a_drive_that_falls_silent_is_over_and_one_that_has_not_begun_is_not(monkeypatch):
    monkeypatch.setattr(pace, "PATIENCE_S", 0.05)
    stop = Event()
    drive = DrivesPace(stop.is_set)
    drive.heard(100)
    assert not drive(500)
    early = DrivesPace(stop.is_set)
    answers: list[bool] = []
    waiting = Thread(target=lambda: answers.append(early(500)))
    waiting.start()
    waiting.join(0.5)
    assert answers == []
    stop.set()
    waiting.join(10)
    assert answers == [False]
