"""Simulated drives: sites, motion, sensors, and the recording that a robot would have made.

The truth is stepped by the core's motion model and seen through the core's measurement model; all
chance comes from the generator that is passed in.
"""

from .scenario import SCENARIOS, Scenario, Simulation, simulate
from .sensors import Camera, Encoders, Gyro

__all__ = ["SCENARIOS", "Camera", "Encoders", "Gyro", "Scenario", "Simulation", "simulate"]
