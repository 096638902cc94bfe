"""How good an estimate is: errors against truth, consistency, metrics.

This package imports numpy only, so that a replay starts quickly; nothing here prints.
"""

from .angles import wrap_angle
from .consistency import ellipse_scale, mahalanobis_squared, mean_square_band, sigma_probability
from .ellipse import ellipse_axes
from .ensemble import Ensemble
from .errors import PoseErrors, pose_errors
from .figures import CellFigures, Required
from .honesty import Timeline, beyond
from .means import mean_of_known, root_mean_square
from .metrics import Counts, Heading, Metrics, Nees, Nis, Position, compute_metrics
from .outcome import Outcome
from .run import HasPoses, MapLike, RunLike
from .table import Row, error_rows, table_rows
from .trajectory import TRAJECTORY, read_csv, read_trajectory, read_tum
from .truth import MAX_GAP_S, interpolate

__all__ = [
    "MAX_GAP_S",
    "TRAJECTORY",
    "CellFigures",
    "Counts",
    "Ensemble",
    "HasPoses",
    "Heading",
    "MapLike",
    "Metrics",
    "Nees",
    "Nis",
    "Outcome",
    "PoseErrors",
    "Position",
    "Required",
    "Row",
    "RunLike",
    "Timeline",
    "beyond",
    "compute_metrics",
    "ellipse_axes",
    "ellipse_scale",
    "error_rows",
    "interpolate",
    "mahalanobis_squared",
    "mean_of_known",
    "mean_square_band",
    "pose_errors",
    "read_csv",
    "read_trajectory",
    "read_tum",
    "root_mean_square",
    "sigma_probability",
    "table_rows",
    "wrap_angle",
]
