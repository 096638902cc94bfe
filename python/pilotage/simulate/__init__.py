"""Simulated drives: sites, motion, sensors, and the recording that a robot would have made.

The truth is stepped by the core's motion model and seen through the core's measurement model; all
chance comes from the generator that is passed in.
"""

from .cells import Campaign, Cell, Window
from .chances import Kidnap, Outliers, Start
from .measuring import Measured, Simulation, measure, simulate, suitable_config
from .scenario import SCENARIOS, Scenario
from .scenario_file import find_scenario, parse_scenario
from .sensors import Camera, Encoders, Gyro
from .streams import Stream
from .tilt import Tilt

__all__ = [
    "SCENARIOS",
    "Camera",
    "Campaign",
    "Cell",
    "Encoders",
    "Gyro",
    "Kidnap",
    "Measured",
    "Outliers",
    "Scenario",
    "Simulation",
    "Start",
    "Stream",
    "Tilt",
    "Window",
    "find_scenario",
    "measure",
    "parse_scenario",
    "simulate",
    "suitable_config",
]
