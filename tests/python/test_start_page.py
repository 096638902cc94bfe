"""What docs/start.md shows of a start without a pose is what the program says."""

import re
from pathlib import Path

from support.command import pilotage

PAGE = (Path(__file__).parents[2] / "docs" / "start.md").read_text(encoding="utf-8")


def test_its_example_is_found_and_found_again(tmp_path: Path):
    (tmp_path / "anywhere.yaml").write_text(
        re.findall(r"^```yaml\n(.*?)^```", PAGE, re.M | re.S)[0]
    )
    shown = re.search(r"^\$ pilotage montecarlo site/(.*?)\n(.*?)^```", PAGE, re.M | re.S)
    assert shown
    said = pilotage("montecarlo", *shown[1].split(), cwd=tmp_path).stdout
    assert [line for line in shown[2].splitlines() if line not in said] == []
