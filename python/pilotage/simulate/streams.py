"""The messages of an input as arrays, between the sensor that measured and the encoding."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Stream:
    """Messages of one input; rows that follow each other with equal `seq` are one message.

    Attributes
    ----------
    utime : (n,) int, µs
        The sender's stamp.
    received : (n,) int, µs
        Time of arrival.
    seq : (n,) int
        The sender's count of messages.
    value : (n, k) float
        Ticks left and right, or the rate [rad/s], or bearing, elevation [rad] and range [m].
    id : (n,) int
        The marker's; empty where the input is no marker sensor.
    """

    utime: NDArray[np.int64]
    received: NDArray[np.int64]
    seq: NDArray[np.int32]
    value: NDArray[np.float64]
    id: NDArray[np.int32]

    @classmethod
    def sent(
        cls,
        utime: NDArray[np.int64],
        value: NDArray[np.float64],
        id: NDArray[np.int32] | None = None,
    ) -> "Stream":
        """Return messages that arrive as they are sent; rows of equal stamp are one message."""
        seq = np.unique(utime, return_inverse=True)[1].astype(np.int32)
        return cls(utime, utime, seq, value, np.zeros(0, np.int32) if id is None else id)

    def __len__(self) -> int:
        return len(self.utime)

    def rows(self, index: NDArray[np.bool_] | NDArray[np.intp]) -> "Stream":
        """Return the rows of a mask or of indices."""
        return Stream(
            self.utime[index],
            self.received[index],
            self.seq[index],
            self.value[index],
            self.id[index] if len(self.id) else self.id,
        )

    def by_message(
        self, draw: Callable[[int], NDArray[np.float64]], of: NDArray[np.bool_]
    ) -> NDArray[np.float64]:
        """Return one number of ``draw(count)`` for each message of the rows `of`, row by row."""
        message = np.unique(self.seq[of], return_inverse=True)[1]
        return draw(int(message.max(initial=-1)) + 1)[message]

    def late(self, delay_s: float, jitter_s: float, rng: np.random.Generator) -> "Stream":
        """Return the messages after their way: a delay and an exponential rest, in order."""
        everything = np.ones(len(self), dtype=bool)
        rest_s = self.by_message(lambda n: rng.exponential(jitter_s, n), everything)
        way = np.rint((delay_s + rest_s) * 1e6).astype(np.int64)
        return replace(self, received=self.received + way).in_order()

    def in_order(self) -> "Stream":
        """Return the same where no message overtakes another on its way."""
        return replace(self, received=np.maximum.accumulate(self.received))
