from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat, savemat

from pilotage.logs.matlab import load_variables, variable_names
from support.datasets import dataset

VARIABLES = {
    "doubles": np.array([[1.5, np.nan, -0.0], [np.inf, 5e-324, 6.0]]),
    "row": np.arange(300.0)[None],
    "single": np.float32([[0.1]]),
    "whole": np.array([[-1, 2**40]]),
    "small": np.array([[1], [2]], np.uint8),
    "truth": np.array([[True, False]]),
    "none": np.zeros((0, 2)),
}
OTHERS = {
    "text": "abc",
    "struct": {"x": 1.0},
    "complex": np.array([[1j]]),
    "cube": np.ones((2, 2, 2)),
    "cell": np.array([["a", 1.0]], dtype=object),
}


@pytest.mark.parametrize("compressed", [False, True])
def test_numbers_come_as_scipy_reads_them(tmp_path: Path, compressed: bool) -> None:
    path = tmp_path / "a.mat"
    savemat(path, {**VARIABLES, **OTHERS}, do_compression=compressed)
    assert variable_names(path) == VARIABLES.keys() | OTHERS.keys()
    for name, values in load_variables(path, VARIABLES).items():
        assert values.dtype == np.float64
        np.testing.assert_array_equal(values, VARIABLES[name])


@pytest.mark.parametrize("name", OTHERS)
def test_what_is_no_matrix_of_real_numbers_is_named(tmp_path: Path, name: str) -> None:
    savemat(tmp_path / "a.mat", OTHERS)
    with pytest.raises(ValueError, match=rf"a\.mat: variable {name} is no matrix of real numbers"):
        load_variables(tmp_path / "a.mat", [name])


@pytest.mark.parametrize("name", ["plaza/Plaza1_.mat", "lost-in-the-woods/dataset2.mat"])
def test_real_file_comes_as_scipy_reads_it(name: str) -> None:
    path = dataset(name.split("/")[0]) / name.split("/")[1]
    expected = {name: v for name, v in loadmat(path).items() if not name.startswith("__")}
    found = load_variables(path, expected)
    for variable, values in expected.items():
        np.testing.assert_array_equal(found[variable], values)
