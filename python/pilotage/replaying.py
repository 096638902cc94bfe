"""From a recording of any kind to its replay: which configuration, which map, which start."""

import struct
from collections.abc import Callable
from dataclasses import dataclass
from math import isnan
from pathlib import Path

from . import Config, Run, lcmtypes, load_config, replay
from .logs import Log

READY = Path(__file__).parent / "configs"
SETUP_CHANNEL = "PILOTAGE_SETUP"


@dataclass(frozen=True)
class Replay:
    """A log with the configuration that it was replayed with, and what came out."""

    log: Log
    config: Config
    run: Run


def replay_log(
    log: Log, config_file: Path | None = None, progress: Callable[[float], None] | None = None
) -> Replay:
    """Replay a log with a configuration file, or with the one that suits its kind."""
    config = prepared_config(log, config_file)
    return Replay(log, config, replay(config, log.recording, progress=progress))


def prepared_config(log: Log, config_file: Path | None = None) -> Config:
    """Return the configuration that a log is replayed with.

    Where the configuration has no map, the log's is used; where it has no start, the first true
    pose is, with the configured standard deviations.

    Raises
    ------
    ValueError
        If there is no configuration or no map.
    """
    config = choose_config(log, config_file)
    if len(config.map) == 0:
        if log.map is None:
            raise ValueError("no marker map: name one with `map:` in the configuration")
        config.map = log.map
    if isnan(config["initial.x_m"]) and log.truth is not None and len(log.truth) > 0:
        first = log.truth[0]
        for key, column in (("x_m", "x"), ("y_m", "y"), ("heading_rad", "heading")):
            config[f"initial.{key}"] = float(first[column])
    return config


def choose_config(log: Log, config_file: Path | None) -> Config:
    """Return the file's configuration, else the recorded one, else the ready one of the kind."""
    if config_file is not None:
        return load_config(str(config_file))
    recorded = recorded_config(log)
    if recorded is not None:
        return recorded
    ready = READY / f"{log.kind}.yaml"
    if not ready.exists():
        raise ValueError(
            f"there is no ready configuration for a log of kind '{log.kind}', and it holds no "
            f"recorded one (pilotage-node --record writes it): name one with --config"
        )
    return load_config(str(ready))


def recorded_config(log: Log) -> Config | None:
    """Return the configuration that a recording of `pilotage-node` opens with, if it does.

    Raises
    ------
    ValueError
        If it is damaged.
    """
    if len(log.recording) == 0:
        return None
    _, channel, data = log.recording[0]
    if channel != SETUP_CHANNEL:
        return None
    try:
        return Config.parse(lcmtypes.setup_t.decode(data).config)
    except (ValueError, struct.error) as error:
        raise ValueError(
            f"the configuration that the recording opens with cannot be used ({error}): "
            f"name one with --config"
        ) from error
