"""Simulated drives: sites, motion, sensors, and the recording that a robot would have made.

The truth is stepped by the core's motion model and seen through the core's measurement model; all
chance comes from the generator that is passed in.
"""

from .cells import Campaign, Cell, Window
from .measuring import Measured, Simulation, measure, simulate, suitable_config
from .scenario import SCENARIOS, Scenario
from .sensors import Camera, Encoders, Gyro
from .streams import Stream

__all__ = [
    "SCENARIOS",
    "Camera",
    "Campaign",
    "Cell",
    "Encoders",
    "Gyro",
    "Measured",
    "Scenario",
    "Simulation",
    "Stream",
    "Window",
    "measure",
    "simulate",
    "suitable_config",
]
