"""The committed campaign: three inputs in fifteen ways, and markers in five more."""

from pathlib import Path

import pytest

from pilotage.simulate import Campaign

FILE = """
window: {start_s: 1, end_s: 2}
cells: {gyro: {slw: {}}}
smallest: {}
policies: {time: [], faults: []}
"""


def test_there_are_fifty_cells():
    cells = Campaign.load().cells
    assert len({cell.name for cell in cells}) == len(cells) == 50
    common = [{c.fault for c in cells if c.stream == s} for s in ("encoders", "gyro", "markers")]
    assert len(common[0]) == 15
    assert common[0] == common[1]
    assert common[2] - common[0] == {"wrong id", "swapped pair", "moved", "removed", "phantom"}


def test_sizes_on_a_ladder_grow_up_to_the_cells():
    campaign = Campaign.load()
    cells = {cell.name: cell for cell in campaign.cells}
    for ladder in campaign.ladders:
        assert {rung.name for rung in ladder} == {ladder[0].name}
        assert ladder[0].name in cells
        sizes = [next(iter(rung.size.values())) for rung in ladder]
        assert sizes == sorted(sizes)


def test_an_unknown_fault_is_named(tmp_path: Path):
    file = tmp_path / "faults.yaml"
    file.write_text(FILE)
    with pytest.raises(ValueError, match="no fault 'gyro slw'; there are encoders off"):
        Campaign.load(file)


def test_a_cell_is_found_by_its_name():
    assert Campaign.load().cell("gyro stuck").stream == "gyro"
    with pytest.raises(
        ValueError, match=r"no fault 'gyro dead'; say .* encoders, gyro, markers; off"
    ):
        Campaign.load().cell("gyro dead")
