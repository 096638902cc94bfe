"""A detector that misses markers and sees some where there are none."""

from collections.abc import Sequence
from dataclasses import fields, replace
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ..fields import within


class Finds(Protocol):
    """Any detector of `pilotage.camera`."""

    def detect(self, image: NDArray[np.uint8]) -> Sequence[Any]:
        """Return the detections of an image (h, w, 3)."""


class Unreliable:
    """Stands for a detector, and spoils what it finds by chance.

    Each detection is missed with a probability. Each one, missed or not, has with another
    probability a false one beside it, anywhere in a part of the picture; so has a picture in which
    nothing was found, so that a false one may be alone. What is false looks like a true one: its
    covariance, label and kind are those of one that was found of late, its id is any of the map's,
    its range up to half as much or twice as long.

    Parameters
    ----------
    detector : its method ``detect`` is asked
    rng : Generator
        Of all chance.
    miss, false : float
        Probabilities, 0 to 1.
    top : float
        Part of the picture's height above which nothing false appears: 0.2 where ground markers are
        looked for and the horizon is at a fifth.
    ids : (n,) int
        Numbers that a false one may carry, if those found carry any.

    Attributes
    ----------
    asked, missed, made_up : int
        How many detections there were, how many of them were missed, how many are false.
    false_ones : list
        Those of the newest picture that are false.
    """

    def __init__(
        self,
        detector: Finds,
        rng: np.random.Generator,
        miss: float = 0.2,
        false: float = 0.2,
        top: float = 0.0,
        ids: Sequence[int] = (),
    ) -> None:
        within("miss", miss, 0.0, 1.0)
        within("false", false, 0.0, 1.0)
        within("top", top, 0.0, 0.99)
        self._detector, self._rng, self._miss, self._false = detector, rng, miss, false
        self._top, self._ids = top, list(ids)
        self._like: Any = None
        self.asked = self.missed = self.made_up = 0
        self.false_ones: list[Any] = []

    def detect(self, image: NDArray[np.uint8]) -> list[Any]:
        """Return what is left of the detections of an image (h, w, 3), and false ones."""
        found = list(self._detector.detect(image))
        if found:
            self._like = found[0]
        models = found or ([] if self._like is None else [self._like])
        kept = [one for one in found if self._rng.random() >= self._miss]
        haunted = [one for one in models if self._rng.random() < self._false]
        self.false_ones = [self._falsified(one, image) for one in haunted]
        self.asked += len(found)
        self.missed += len(found) - len(kept)
        self.made_up += len(self.false_ones)
        together = kept + self.false_ones
        return [together[i] for i in self._rng.permutation(len(together))]

    def _falsified(self, like: Any, image: NDArray[np.uint8]) -> Any:
        height, width = image.shape[:2]
        pixel = self._rng.uniform((-0.5, self._top * height - 0.5), (width - 0.5, height - 0.5))
        changes: dict[str, Any] = {
            "pixel": pixel,
            "outline": like.outline + (pixel - like.pixel),
            "range_m": like.range_m * self._rng.uniform(0.5, 2.0),
        }
        if like.id >= 0 and self._ids:
            changes["id"] = int(self._rng.choice(self._ids))
        # A tag's pose is not of that place.
        known = {field.name for field in fields(like)}
        changes |= {name: none for name, none in (("poses", ()), ("pose", None)) if name in known}
        return replace(like, **changes)
