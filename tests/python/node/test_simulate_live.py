"""`pilotage simulate --live` beside a node: what a user types in two terminals."""

from pathlib import Path

from pilotage.live import URL
from support.bus import node
from support.command import pilotage


def test_a_live_simulation_is_localized_by_the_node(tmp_path: Path):
    drive = ("simulate", "figure-eight", "--duration", 5, "--speed", 20)
    log = tmp_path / "eight.lcmlog"
    assert pilotage(*drive, "-o", log).returncode == 0
    with node(tmp_path, (tmp_path / "eight.yaml").read_text()) as running:
        running.wait(lambda: running.messages["STATUS"], "a status")
        result = pilotage(*drive, "--live", "--lcm-url", URL, cwd=tmp_path)
        assert result.returncode == 0, result.stderr
        running.wait(lambda: len(running.messages["POSE"]) == 501, "poses")
        assert running.messages["POSE"][0].utime == 1_000_000
        assert running.messages["POSE"][-1].status == 2  # OK
    assert "pilotage-node --config figure-eight.yaml" in result.stdout
    assert (tmp_path / "figure-eight.yaml").read_text() == (tmp_path / "eight.yaml").read_text()


def test_without_waiting_it_sends_to_nobody(tmp_path: Path):
    drive = ("simulate", "figure-eight", "--duration", 5, "--speed", 100)
    result = pilotage(*drive, "--live", "--no-wait", "--lcm-url", URL, cwd=tmp_path)
    assert result.returncode == 0, result.stderr
