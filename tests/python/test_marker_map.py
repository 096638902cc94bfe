from pathlib import Path

import pytest

from pilotage import MarkerMap

PLACES = [[1, 2, 0], [3, 4, 0]]


def test_labels_survive_saving_and_loading(tmp_path: Path):
    MarkerMap([5, 2], PLACES, labels=[7, -1]).save(str(tmp_path / "map.yaml"))
    again = MarkerMap.load(str(tmp_path / "map.yaml"))
    assert again.ids.tolist() == [2, 5]
    assert again.labels.tolist() == [-1, 7]


def test_a_map_has_no_labels_unless_it_is_told():
    assert MarkerMap([5, 2], PLACES).labels.tolist() == [-1, -1]


def test_labels_that_do_not_fit_are_refused():
    with pytest.raises(ValueError, match=r"labels must have shape \(2,\)"):
        MarkerMap([5, 2], PLACES, labels=[1])
    with pytest.raises(ValueError, match="marker 5: a label is 0 or more"):
        MarkerMap([5, 2], PLACES, labels=[-2, 1])
