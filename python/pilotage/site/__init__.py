"""How well a map serves the sensors that look at it: symmetric layouts, views, blind zones."""

from .coverage import Coverage
from .ground import Area, Ground
from .layout import APART, Layout
from .motion import Motion
from .sight import Sight, guessed
from .survey import Survey
from .symmetry import Match, elsewhere, symmetries
from .views import View, Views

__all__ = [
    "APART",
    "Area",
    "Coverage",
    "Ground",
    "Layout",
    "Match",
    "Motion",
    "Sight",
    "Survey",
    "View",
    "Views",
    "elsewhere",
    "guessed",
    "symmetries",
]
