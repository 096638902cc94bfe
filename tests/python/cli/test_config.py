"""`pilotage config`: a file to start from."""

from typer.testing import CliRunner

from pilotage import Config
from pilotage.cli.main import app


def _printed(*arguments: str) -> str:
    result = CliRunner().invoke(app, ["config", *arguments])
    assert result.exit_code == 0, result.output
    return result.output


def test_the_printed_defaults_are_a_configuration_with_every_key():
    text = _printed()
    config = Config.parse(text)
    reference = Config()
    reference["sensors.camera.z_m"] = 0.0
    assert config.to_yaml() == reference.to_yaml()
    for key, _, meaning in config.describe():
        assert f"{key.split('.')[-1]}:" in text
        assert f"# {meaning}" in text


def test_a_file_is_printed_with_its_values_and_the_defaults_around_them(tmp_path):
    file = tmp_path / "robot.yaml"
    file.write_text("encoders: {track_width_m: 1.25}\nsensors: {scanner: {yaw_rad: 3.0}}\n")
    config = Config.parse(_printed(str(file)))
    assert config["encoders.track_width_m"] == 1.25
    assert config.sensors == ["scanner"]
    assert config["sensors.scanner.yaw_rad"] == 3.0
