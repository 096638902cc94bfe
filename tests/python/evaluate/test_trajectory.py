from pathlib import Path

import numpy as np
import pytest

from pilotage.evaluate import read_csv, read_trajectory, read_tum


def test_tum_file_gives_microseconds_and_heading(tmp_path: Path) -> None:
    path = tmp_path / "pose.tum"
    half = np.radians(-100.0) / 2.0
    path.write_text(
        "# t x y z qx qy qz qw\n"
        f"1760000000.123457 1.5 -2.5 0 0 0 {np.sin(half)!s} {np.cos(half)!s}\n"
        "1760000000.223457 1 2 0 0 0 1 0\n"
    )
    rows = read_tum(path)
    np.testing.assert_array_equal(rows["utime"], [1760000000123457, 1760000000223457])
    np.testing.assert_array_equal(rows["x"], [1.5, 1.0])
    np.testing.assert_array_equal(rows["y"], [-2.5, 2.0])
    np.testing.assert_allclose(rows["heading"], [np.radians(-100.0), np.pi], atol=1e-15)


def test_csv_file_is_read_by_its_header(tmp_path: Path) -> None:
    path = tmp_path / "truth.csv"
    path.write_text("heading,v,utime,x,y\n0.5,9,1760000000123457,1.25,nan\n")
    rows = read_csv(path)
    assert rows.shape == (1,)
    assert rows["utime"][0] == 1760000000123457
    assert (rows["x"][0], rows["heading"][0]) == (1.25, 0.5)
    assert np.isnan(rows["y"][0])


def test_kind_follows_the_name(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("utime,x,y,heading\n7,1,2,3\n")
    (tmp_path / "a.txt").write_text("7 1 2 0 0 0 0 1\n")
    assert read_trajectory(tmp_path / "a.csv")["utime"][0] == 7
    assert read_trajectory(tmp_path / "a.txt")["utime"][0] == 7_000_000


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.csv", "utime,x,y\n1,2,3\n", "no column 'heading'"),
        ("a.csv", "", "no column 'utime'"),
        ("a.csv", "utime,x,y,heading\n1,2,3,west\n", "west"),
        ("a.csv", "utime,x,y,heading\n", "no rows"),
        ("a.tum", "1 2 3\n", "column"),
        ("a.tum", "1 2 3 four 0 0 0 1\n", "four"),
        ("a.tum", "", "no rows"),
    ],
)
def test_bad_file_is_named(tmp_path: Path, name: str, content: str, says: str) -> None:
    path = tmp_path / name
    path.write_text(content)
    with pytest.raises(ValueError, match=says) as caught:
        read_trajectory(path)
    assert str(path) in str(caught.value)


def test_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="nowhere"):
        read_trajectory(tmp_path / "nowhere.tum")
