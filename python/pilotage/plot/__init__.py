"""Figures of a run in one style. Needs matplotlib; import it only where figures are made."""

from .closeup import closeup_figure
from .errors import errors_figure
from .markers import markers_figure
from .nis import nis_figure
from .path import path_figure
from .save import save_all

__all__ = [
    "closeup_figure",
    "errors_figure",
    "markers_figure",
    "nis_figure",
    "path_figure",
    "save_all",
]
