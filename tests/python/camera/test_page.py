"""What docs/camera.md shows can be done as it stands."""

import re
from pathlib import Path

import cv2

import pilotage
from pilotage.camera.eye import make_eye
from support.pictures import seen

ROOT = Path(__file__).parents[3]
PAGE = (ROOT / "docs" / "camera.md").read_text(encoding="utf-8")
LENS = """{image_width: 800, image_height: 800,
  camera_matrix: {rows: 3, cols: 3, data: [800, 0, 399.5, 0, 800, 399.5, 0, 0, 1]},
  distortion_coefficients: {rows: 1, cols: 4, data: [0, 0, 0, 0]}}"""


def block(language: str, *words: str) -> str:
    [found] = [
        text
        for text in re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)
        if all(word in text for word in words)
    ]
    return found


def test_the_tags_that_it_prints_are_found_by_the_configuration_that_it_shows(
    tmp_path: Path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    exec(block("python", "generateImageMarker"), {})
    Path("markers.yaml").write_text(block("yaml", "{id: 0"))
    Path("front.yaml").write_text(LENS)
    Path("robot.yaml").write_text(block("yaml", "detectors:"))
    eye = make_eye(pilotage.load_config("robot.yaml"), "front")
    for number in range(6):
        [tag] = eye.detector.detect(seen(cv2.imread(f"tag{number}.png").astype(float)))
        assert tag.id == number


def test_every_reason_for_leaving_out_an_image_is_on_the_page():
    sources = ROOT / "python" / "pilotage" / "camera"
    used = set()
    for file in sources.glob("*.py"):
        text = file.read_text(encoding="utf-8")
        used |= set(re.findall(r"(?:tally\.drop|settle)\(\s*\"(\w+)\"", text))
        used |= set(re.findall(r"reason=\"(\w+)\"", text))
    told = set()
    for row in PAGE.partition("| reason | meaning |")[2].splitlines()[2:]:
        if not row.startswith("|"):
            break
        told |= set(re.findall(r"`(\w+)`", row.split("|")[1]))
    assert used == told


def test_the_pages_that_it_names_are_there():
    for name in re.findall(r"\]\(([\w.-]+\.(?:md|jpg))", PAGE):
        assert (ROOT / "docs" / name).is_file(), name
