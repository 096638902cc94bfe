"""Images as they come, to messages over LCM."""

import re
import signal
from collections import deque
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from queue import Empty, Full, Queue
from select import select
from struct import error as StructError
from threading import Event, Lock, Thread
from time import monotonic, time_ns
from typing import Any, NamedTuple

from .. import Config, load_config
from ..bus import connect, resolved
from ..lcmtypes import marker_report_t, pose_t
from .annotate import Answer
from .looking import Seen, look
from .messages import message
from .offline import STAMP
from .pace import DrivesPace, OwnPace
from .poses import Poses
from .program import Options, Watched, conclude, picture, watched
from .screen import Screen, save_image
from .tally import Tally

STATUS_S = 1.0
ANSWER_S = 0.3
"""A picture is drawn so long after its message was sent: the node has answered by then."""
WAITING = 30
"""Pictures that wait to be drawn; then the camera waits."""
REMEMBERED = 200
"""Messages of which the answers are kept."""


class Drawable(NamedTuple):
    """An image that is to be drawn, from a moment on."""

    camera: Watched
    seen: Seen
    seq: int
    due: float


class Listener:
    """What a node says over LCM: poses, what became of detections, and how the drive goes on."""

    def __init__(self, url: str | None, config: Config, stop: Event):
        self.poses = Poses()
        self.drive = DrivesPace(stop.is_set)
        self._answers: dict[tuple[str, int], dict[int, Answer]] = {}
        self._order: deque[tuple[str, int]] = deque()
        self._lock = Lock()
        self._stop = stop
        self._bus = connect(url)
        motion = config[f"{config['motion.source']}.channel"]
        for channel, take in (
            (config["output.pose"], self._pose),
            (config["output.report"], self._report),
            (motion, self._motion),
        ):
            subscription = self._bus.subscribe(re.escape(channel), _if_sound(take))
            subscription.set_queue_capacity(0)

    def run(self) -> None:
        """Listen until the end."""
        while not self._stop.is_set():
            if select([self._bus], [], [], 0.1)[0]:
                self._bus.handle()

    def answers(self, sensor: str, seq: int) -> Mapping[int, Answer]:
        """Return what became of the detections of a message, by index."""
        with self._lock:
            return dict(self._answers.get((sensor, seq), {}))

    def _pose(self, data: bytes) -> None:
        pose = pose_t.decode(data)
        self.poses.add(pose.utime, (pose.x, pose.y, pose.heading))

    def _report(self, data: bytes) -> None:
        report = marker_report_t.decode(data)
        key = (report.sensor, report.frame_seq)
        with self._lock:
            if key not in self._answers:
                self._answers[key] = {}
                self._order.append(key)
                if len(self._order) > REMEMBERED:
                    del self._answers[self._order.popleft()]
            self._answers[key][report.index] = Answer(report.id, report.reason)

    def _motion(self, data: bytes) -> None:
        self.drive.heard(STAMP.unpack_from(data)[0])


def _if_sound(take: Callable[[bytes], None]) -> Callable[[str, bytes], None]:
    def taken(_: str, data: bytes) -> None:
        with suppress(ValueError, StructError):  # another program's message on this channel
            take(data)

    return taken


def look_live(options: Options, speed: float, follow: bool, url: str | None) -> bool:
    """Send what is found until the images end or the user ends it; whether any could be used."""
    config = load_config(str(options.config))
    cameras = watched(config, options, time_ns() // 1000)
    screen = Screen([camera.eye.name for camera in cameras], options.show, options.save_video)
    if options.save_images is not None:
        for camera in cameras:
            (options.save_images / camera.eye.name).mkdir(parents=True, exist_ok=True)
    stop = Event()
    _stop_on_signals(stop)
    listener = Listener(url, config, stop)
    listening = Thread(target=listener.run, daemon=True)
    listening.start()
    bus = connect(url)
    begins = [c.source.begin for c in cameras if c.source.begin is not None]
    own_pace = OwnPace(min(begins, default=0), speed, stop)
    pictures: Queue[Drawable] = Queue(WAITING)

    def work(camera: Watched) -> None:
        recorded = camera.source.begin is not None
        pace = (listener.drive if follow else own_pace) if recorded else lambda _: True
        try:
            for seen in look(camera.eye, camera.source, camera.tally, pace):
                if options.save_images is not None:
                    _save(options.save_images / camera.eye.name, seen, camera.tally)
                seq = camera.tally.published
                if _send(config, camera, seen, bus, listener.poses) and screen:
                    due = monotonic() + ANSWER_S
                    _put(pictures, Drawable(camera, seen, seq, due), stop)
        except Exception as error:
            camera.tally.settle("failed")
            camera.tally.say(f"ended: {type(error).__name__}: {error}")

    threads = [Thread(target=work, args=(camera,), daemon=True) for camera in cameras]
    options.say(f"sending {', '.join(c.eye.channel for c in cameras)} on {resolved(url)}")
    for thread in threads:
        thread.start()
    _attend(config, options, cameras, threads, listener, screen, pictures, stop)
    stop.set()
    listening.join()
    conclude(cameras, screen, options.say)
    return any(camera.tally.published > 0 for camera in cameras)


def _send(config: Config, camera: Watched, seen: Seen, bus: Any, poses: Poses) -> bool:
    """Send what was found in an image, and say if its time is not that of the poses."""
    eye, tally = camera.eye, camera.tally
    sent = message(eye, seen.utime, tally.published, seen.detections, config.map)
    if sent is None:
        tally.drop("no_fix")
        return False
    bus.publish(eye.channel, sent.encode())
    tally.publish(len(seen.detections))
    newest, window_s = poses.newest, config["history.window_s"]
    if newest is not None and config[f"sensors.{eye.name}.time"] == "utime":
        behind_s = (newest - seen.utime) * 1e-6
        if abs(behind_s) > window_s:
            side = "behind" if behind_s > 0 else "ahead of"
            tally.warn(
                "clock",
                f"its images are {abs(behind_s):.6g} s {side} the poses, more than "
                f"history.window_s ({window_s:g} s): the node cannot use them; set the camera's "
                f"clock, or sensors.{eye.name}.time to mapped",
            )
    return True


def _save(folder: Path, seen: Seen, tally: Tally) -> None:
    image = seen.frame.image
    if image is None or not save_image(folder, seen.frame.utime, image):
        tally.warn("not_saved", f"{folder / str(seen.frame.utime)}.png cannot be written")


def _put(pictures: "Queue[Drawable]", one: Drawable, stop: Event) -> None:
    while not stop.is_set():
        with suppress(Full):
            pictures.put(one, timeout=0.2)
            return


def _attend(
    config: Config,
    options: Options,
    cameras: list[Watched],
    threads: list[Thread],
    listener: Listener,
    screen: Screen,
    pictures: "Queue[Drawable]",
    stop: Event,
) -> None:
    """Draw pictures and say how it goes, until all cameras have ended."""
    next_status, before = monotonic() + STATUS_S, [0] * len(cameras)
    closed = False
    while any(thread.is_alive() for thread in threads) or not pictures.empty():
        if stop.is_set() and not closed:
            closed = True
            for camera in cameras:
                camera.source.close()
        _draw(config, listener, screen, pictures)
        if monotonic() >= next_status:
            next_status += STATUS_S
            for i, camera in enumerate(cameras):
                sent = camera.tally.published
                rate, before[i] = (sent - before[i]) / STATUS_S, sent
                camera.tally.say(f"{rate:.3g} Hz; {camera.tally.summary()}")


def _draw(config: Config, listener: Listener, screen: Screen, pictures: "Queue[Drawable]") -> None:
    try:
        one = pictures.get(timeout=0.1)
    except Empty:
        return
    eye = one.camera.eye
    Event().wait(max(one.due - monotonic(), 0.0))
    pose = listener.poses.at(one.seen.utime, or_before=True)
    answers = listener.answers(eye.name, one.seq)
    screen.put(eye.name, picture(config, eye, one.seen, pose, answers), one.camera.source.rate_hz)


def _stop_on_signals(stop: Event) -> None:
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stop.set())
