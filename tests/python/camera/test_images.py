"""Image files: their stamps, their order, and what cannot be used."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from pilotage.camera.images import STAMPS, ImageFiles, folder
from pilotage.camera.tally import Tally

PICTURE = np.full((6, 8, 3), 90, np.uint8)


def write(path: Path, shade: int = 90) -> None:
    cv2.imwrite(str(path), np.full((6, 8, 3), shade, np.uint8))


def read(source):
    return list(source.frames(Tally("front", lambda _: None)))


def test_the_name_is_the_time_and_gives_the_order(tmp_path: Path):
    for stamp in (1_000_417, 999_000, 20_000_000):
        write(tmp_path / f"{stamp}.png", stamp % 200)
    (tmp_path / "notes.txt").write_text("no image")
    source = folder(tmp_path)
    frames = read(source)
    assert [frame.utime for frame in frames] == [999_000, 1_000_417, 20_000_000]
    assert [int(frame.image[0, 0, 0]) for frame in frames] == [0, 1_000_417 % 200, 0]
    assert source.begin == 999_000


def test_the_list_beside_them_goes_before_the_name(tmp_path: Path):
    for name in ("b.png", "5.png", "a.png"):
        write(tmp_path / name)
    (tmp_path / "stamps.csv").write_text("utime, file\n300, b.png\n-20, a.png\n100, gone.png\n")
    frames = read(folder(tmp_path))
    assert [(f.utime, f.name, f.reason) for f in frames] == [
        (-20, "a.png", ""),
        (100, "gone.png", "unreadable"),
        (300, "b.png", ""),
        (0, "5.png", "no_stamp"),
    ]
    assert "gone.png cannot be read: No such file" in frames[1].words
    assert "name images by it in microseconds" in frames[3].words


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("name,time\n", "its first line has name, time, expected file,utime"),
        ("file,utime\na.png,1.5\n", "stamps.csv:2: utime is '1.5', expected whole µs"),
        ("file,utime\na.png\n", "stamps.csv:2: utime is None"),
    ],
)
def test_a_list_that_cannot_be_read_says_where(tmp_path: Path, content: str, words: str):
    write(tmp_path / "a.png")
    (tmp_path / "stamps.csv").write_text(content)
    with pytest.raises(ValueError, match=STAMPS) as error:
        folder(tmp_path)
    assert words in str(error.value)


def test_a_damaged_image_and_one_that_vanished_are_named(tmp_path: Path):
    for stamp in (1, 2, 3):
        write(tmp_path / f"{stamp}.png")
    content = (tmp_path / "1.png").read_bytes()
    (tmp_path / "1.png").write_bytes(content[:20])
    source = folder(tmp_path)
    (tmp_path / "3.png").unlink()
    damaged, good, gone = read(source)
    assert (damaged.reason, good.reason, gone.reason) == ("unreadable", "", "unreadable")
    assert "1.png is no image, or a damaged one" in damaged.words
    assert "3.png cannot be read" in gone.words


def test_an_empty_file_is_no_image(tmp_path: Path):
    write(tmp_path / "1.png")
    (tmp_path / "2.png").write_bytes(b"")
    assert [frame.reason for frame in read(folder(tmp_path))] == ["", "unreadable"]


def test_a_grey_image_has_three_channels(tmp_path: Path):
    cv2.imwrite(str(tmp_path / "1.png"), PICTURE[:, :, 0])
    [frame] = read(folder(tmp_path))
    assert frame.image.shape == (6, 8, 3)


def test_nothing_usable_is_an_error_with_the_way_out(tmp_path: Path):
    with pytest.raises(ValueError, match="no images there"):
        folder(tmp_path)
    write(tmp_path / "first.png")
    with pytest.raises(ValueError, match=r"first.png has no time of capture: name images"):
        folder(tmp_path)


def test_a_pattern_takes_some_and_the_rate_is_the_usual_step(tmp_path: Path):
    for stamp in (0, 100_000, 200_000, 900_000):
        write(tmp_path / f"{stamp}.png")
    source = ImageFiles(tmp_path.glob("?00000.png"), "?00000.png")
    assert [frame.utime for frame in read(source)] == [100_000, 200_000, 900_000]
    assert folder(tmp_path).rate_hz == 10


def test_a_closed_source_ends(tmp_path: Path):
    for stamp in (1, 2, 3):
        write(tmp_path / f"{stamp}.png")
    source = folder(tmp_path)
    frames = source.frames(Tally("front", lambda _: None))
    next(frames)
    source.close()
    assert list(frames) == []
