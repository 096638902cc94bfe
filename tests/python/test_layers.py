"""Dependencies point one way: the core knows neither messages, nor files, nor Python."""

import re
from pathlib import Path

import pytest

CPP = Path(__file__).parents[2] / "cpp"
FOREIGN = re.compile(
    r'#include [<"](lcm/|yaml-cpp/|pybind11/|iostream|fstream|engine/|node/|.*_t\.hpp)'
)


@pytest.mark.parametrize("room", ["include", "src"])
def test_the_core_includes_nothing_of_the_rooms_above(room):
    files = [path for path in (CPP / room).rglob("*") if path.suffix in {".hpp", ".cpp"}]
    assert files
    assert [path for path in files if FOREIGN.search(path.read_text())] == []


def test_the_engine_does_not_know_the_node():
    assert [path for path in (CPP / "engine").iterdir() if "node/" in path.read_text()] == []
