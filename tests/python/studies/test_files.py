"""A study reads like the paper it is of."""

from pathlib import Path

from pilotage import studies


def test_no_file_of_a_study_is_over_200_lines():
    files = list(Path(studies.__file__).parent.glob("*.py"))
    assert len(files) > 20
    assert [f.name for f in files if len(f.read_text().splitlines()) > 200] == []
