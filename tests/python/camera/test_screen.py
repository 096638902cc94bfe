"""Windows and video files."""

import cv2
import numpy as np
import pytest

from pilotage.camera import screen
from pilotage.camera.screen import Screen

PICTURE = np.full((48, 64, 3), 100, np.uint8)


def read(path):
    video = cv2.VideoCapture(str(path))
    frames = []
    while (taken := video.read())[0]:
        frames.append(taken[1])
    return frames, video.get(cv2.CAP_PROP_FPS)


def test_without_windows_there_is_a_clear_word(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    with pytest.raises(ValueError, match="--show needs an OpenCV with windows and a screen"):
        Screen(["front"], True, None)


def test_an_opencv_without_windows_gives_the_same_word(monkeypatch):
    def refuse(_):
        raise cv2.error("The function is not implemented")

    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(screen.cv2, "namedWindow", refuse)
    with pytest.raises(ValueError, match="install opencv-python instead of"):
        Screen(["front"], True, None)


def test_windows_are_used_where_there_are_some(monkeypatch):
    shown = []
    monkeypatch.setenv("DISPLAY", ":0")
    for name in ("namedWindow", "destroyWindow", "destroyAllWindows", "waitKey"):
        monkeypatch.setattr(screen.cv2, name, lambda *_: None)
    monkeypatch.setattr(screen.cv2, "imshow", lambda name, picture: shown.append(name))
    window = Screen(["front"], True, None)
    assert window
    window.put("front", PICTURE, 10.0)
    window.close()
    assert shown == ["front"]


@pytest.mark.parametrize("suffix", [".mp4", ".avi"])
def test_a_video_has_the_pictures_at_their_rate(tmp_path, suffix: str):
    file = tmp_path / f"seen{suffix}"
    video = Screen(["front"], False, file)
    for shade in (50, 100, 150):
        video.put("front", np.full_like(PICTURE, shade), 5.0)
    assert video.close() == [file]
    frames, rate = read(file)
    np.testing.assert_allclose([frame.mean() for frame in frames], [50, 100, 150], atol=4)
    assert rate == 5


def test_each_of_several_cameras_has_its_video_and_an_unknown_rate_a_usual_one(tmp_path):
    video = Screen(["front", "rear"], False, tmp_path / "seen.avi")
    video.put("rear", PICTURE, float("nan"))
    assert video.close() == [tmp_path / "seen-rear.avi"]
    assert read(tmp_path / "seen-rear.avi")[1] == 10


def test_another_ending_is_refused():
    with pytest.raises(ValueError, match=r"seen.gif: expected .mp4 or .avi"):
        Screen(["front"], False, screen.Path("seen.gif"))


def test_a_file_that_cannot_be_written_is_an_error(tmp_path):
    video = Screen(["front"], False, tmp_path / "nowhere" / "seen.avi")
    with pytest.raises(OSError, match=r"seen.avi cannot be written: is its folder there"):
        video.put("front", PICTURE, 5.0)


def test_nobody_looks_unless_asked():
    assert not Screen(["front"], False, None)
