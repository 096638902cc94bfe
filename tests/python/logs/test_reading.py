import subprocess
import sys
from pathlib import Path

import pytest
from scipy.io import savemat

from pilotage.logs import read, write_lcmlog
from support import made_logs


def test_each_kind_is_recognised(tmp_path: Path) -> None:
    woods = made_logs.woods(tmp_path / "w.mat")
    write_lcmlog(read(woods), tmp_path / "lcmlog-2002-10-01.00")
    kinds = {
        made_logs.mower(tmp_path / "m"): "mower",
        made_logs.mrclam(tmp_path / "r"): "mrclam",
        woods: "woods",
        made_logs.plaza(tmp_path / "p.mat"): "plaza",
        tmp_path / "lcmlog-2002-10-01.00": "lcm",
    }
    assert [read(path).kind for path in kinds] == list(kinds.values())
    assert [read(str(path)).kind for path in kinds] == list(kinds.values())


def test_folder_that_holds_one_recording_stands_for_it(tmp_path: Path) -> None:
    (tmp_path / "README.md").write_text("where it came from")
    made_logs.mrclam(tmp_path / "MRCLAM_Dataset6", robots=(1, 2))
    assert read(tmp_path, robot=2).kind == "mrclam"


def test_folder_that_holds_several_recordings_lists_them(tmp_path: Path) -> None:
    made_logs.plaza(tmp_path / "Plaza1_.mat")
    made_logs.woods(tmp_path / "dataset2.mat")
    with pytest.raises(ValueError, match=r"Plaza1_\.mat \(plaza\), dataset2\.mat \(woods\)"):
        read(tmp_path)


def test_unknown_kind_is_told_what_was_looked_for(tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.write_text("nothing")
    with pytest.raises(ValueError, match=r"notes\.txt: not a recording of a known kind") as error:
        read(path)
    for kind in ("mower: ", "mrclam: ", "woods: ", "plaza: ", "lcm: "):
        assert kind in str(error.value)
    for what in ("*poselog*.txt", "Barcodes.dat", "r, b, l", "GT, DR, TD, TL", ".lcmlog"):
        assert what in str(error.value)


def test_empty_folder_is_no_recording(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="not a recording of a known kind"):
        read(tmp_path)


def test_path_that_does_not_exist_is_named(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"gone\.lcmlog: no such file or folder"):
        read(tmp_path / "gone.lcmlog")


def test_matlab_file_of_something_else_is_no_recording(tmp_path: Path) -> None:
    savemat(tmp_path / "a.mat", {"something": 1.0})
    with pytest.raises(ValueError, match="not a recording of a known kind"):
        read(tmp_path / "a.mat")


@pytest.mark.parametrize("content", [b"", b"no MATLAB file at all", b"MATLAB 5.0 MAT-file" * 20])
def test_matlab_file_that_cannot_be_read_is_named(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "a.mat").write_bytes(content)
    with pytest.raises(ValueError, match=r"a\.mat: cannot be read as a MATLAB file"):
        read(tmp_path / "a.mat")


def test_truncated_matlab_file_is_named(tmp_path: Path) -> None:
    path = made_logs.woods(tmp_path / "a.mat")
    path.write_bytes(path.read_bytes()[:-40])
    with pytest.raises(ValueError, match=r"a\.mat: (cannot be read as a MATLAB file|lacks)"):
        read(path)


def test_robot_is_asked_for_only_where_there_are_several(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="of kind mower, which has one robot"):
        read(made_logs.mower(tmp_path), robot=1)


def test_matlab_reader_is_loaded_only_where_it_is_needed(tmp_path: Path) -> None:
    """scipy costs more time to import than a whole replay takes."""
    folder = made_logs.mower(tmp_path)
    code = f"import sys; from pilotage.logs import read; read({str(folder)!r}); \
print([m for m in sys.modules if m.split('.')[0] in ('scipy', 'matplotlib')])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
