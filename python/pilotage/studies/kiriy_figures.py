"""The first paper's figures 4 to 7, of a study's first drive."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..evaluate import TRAJECTORY
from ..logs.mower import Triple
from ..simulate.mower import BLIND_S
from . import kiriy_listing
from .kiriy_listing import IDEAL_NOISE, MENDED, Listing
from .kiriy_runs import Wish, drive_log, localize

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CLOSE_UP_S = (276.0, 308.0)


@dataclass(frozen=True)
class Estimate:
    """A filter's poses as figures take them, see `evaluate.HasPoses`."""

    poses: NDArray[Any]

    @classmethod
    def of(cls, listing: Listing, triple: Triple) -> "Estimate":
        """Take the rows after each step."""
        poses = np.empty(len(triple.time), [*TRAJECTORY.descr, ("covariance", "f8", (3, 3))])
        poses["utime"] = np.rint(triple.time * 1e6)
        poses["x"], poses["y"], poses["heading"] = listing.estimates.T
        poses["covariance"] = listing.covariances
        return cls(poses)


def figures(seed: int) -> dict[str, Callable[[], "Figure"]]:
    """Draw the paper's figures of the first drive."""

    @cache
    def shown() -> tuple[dict[str, NDArray[Any]], Any, Any, Triple]:
        triple = drive_log(seed, 0)
        run, log = localize(triple)
        mended = Estimate.of(kiriy_listing.run(triple, MENDED), triple).poses
        printed = Estimate.of(kiriy_listing.run(triple), triple).poses
        filters = {"the listing": printed, "the paper's filter": mended, "our defaults": run.poses}
        return filters, log.truth, log.map, triple

    def figure_4() -> "Figure":
        from ..plot.filters import paths_figure

        filters, truth, markers, _ = shown()
        return paths_figure(filters, truth, markers)

    def figure_5() -> "Figure":
        from ..plot.filters import convergence_figure

        filters, _, _, triple = shown()
        seen = np.rint(triple.sighting_time * 1e6).astype(np.int64)
        return convergence_figure(filters, seen, BLIND_S)

    def figure_6() -> "Figure":
        from ..plot.filters import filter_errors_figure

        filters, truth, _, _ = shown()
        return filter_errors_figure(filters, truth, BLIND_S)

    def figure_7() -> "Figure":
        from ..plot.closeup import closeup_figure

        triple = drive_log(seed, 0, Wish(noise=0.0))
        listing = kiriy_listing.run(triple, MENDED, IDEAL_NOISE)
        _, truth, markers, _ = shown()
        return closeup_figure(Estimate.of(listing, triple), truth, markers, CLOSE_UP_S)

    return {"figure-4": figure_4, "figure-5": figure_5, "figure-6": figure_6, "figure-7": figure_7}
