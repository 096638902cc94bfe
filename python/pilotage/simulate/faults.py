"""What goes wrong with an input: each fault changes the messages that were sent while it lasts.

A fault of values changes values, a fault of time stamps or times of arrival. Its size is its
parameters; those of the campaign stand in `faults.yaml`.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap
from .streams import Stream


@dataclass(frozen=True)
class Strike:
    """When a fault strikes a stream, and what it may need to know.

    Attributes
    ----------
    hit : (n,) bool
        The stream's rows that were captured while the fault lasts.
    rng : numpy.random.Generator
        All chance.
    markers : MarkerMap
        Where they are.
    look : callable
        What the sensor would measure exactly, (k, 3), of a marker at x, y, z [m] at times (k,) µs.
    """

    hit: NDArray[np.bool_]
    rng: np.random.Generator
    markers: MarkerMap
    look: Callable[[NDArray[np.float64], NDArray[np.int64]], NDArray[np.float64]]


Size = float | list[float]
"""Of all values, or one of each column."""
Fault = Callable[..., Stream]
"""Of a stream and a strike, with its sizes as keywords."""


def off(stream: Stream, strike: Strike) -> Stream:
    """Nothing is sent."""
    return stream.rows(~strike.hit)


def stuck(stream: Stream, strike: Strike) -> Stream:
    """What was measured last is sent again and again, with stamps and counts that go on."""
    start = int(np.argmax(strike.hit))
    last = np.flatnonzero(stream.seq == stream.seq[start - 1])
    _, first = np.unique(stream.seq[strike.hit], return_index=True)
    held = np.tile(last, len(first))
    header = np.repeat(np.flatnonzero(strike.hit)[first], len(last))
    repeated = replace(
        stream.rows(held),
        utime=stream.utime[header],
        received=stream.received[header],
        seq=stream.seq[header],
    )
    end = start + int(strike.hit.sum())
    return joined(stream.rows(np.arange(start)), repeated, stream.rows(np.arange(end, len(stream))))


def garbage(stream: Stream, strike: Strike, low: Size, high: Size) -> Stream:
    """Values are anything between two bounds."""
    return _with_values(stream, strike, strike.rng.uniform(low, high, stream.value.shape))


def nan(stream: Stream, strike: Strike) -> Stream:
    """Values are not numbers."""
    return _with_values(stream, strike, np.full(stream.value.shape, np.nan))


def linear(stream: Stream, strike: Strike, factor: Size = 1.0, offset: Size = 0.0) -> Stream:
    """Values are off by a factor and an offset."""
    return _with_values(stream, strike, stream.value * np.array(factor) + np.array(offset))


def travel(stream: Stream, strike: Strike, factor: Size) -> Stream:
    """Totals grow by too much or too little; they do not jump, neither then nor after."""
    growth = np.diff(stream.value, axis=0, prepend=stream.value[:1])
    growth[strike.hit] *= np.array(factor)
    return replace(stream, value=np.rint(stream.value[0] + np.cumsum(growth, axis=0)))


def slow(stream: Stream, strike: Strike, one_of: int) -> Stream:
    """Only one of so many messages is sent."""
    return stream.rows(~strike.hit | (stream.seq % one_of == 0))


def intermittent(stream: Stream, strike: Strike, off_s: float, on_s: float) -> Stream:
    """Silent and sending by turns."""
    since_s = _since_us(stream, strike) * 1e-6 + strike.rng.uniform(0.0, off_s + on_s)
    return stream.rows(~strike.hit | (since_s % (off_s + on_s) >= off_s))


def delayed(stream: Stream, strike: Strike, delay_s: float) -> Stream:
    """Messages take longer; none overtakes another, so the first ones after it come late too."""
    return _arriving(stream, strike.hit * delay_s).in_order()


def out_of_order(stream: Stream, strike: Strike, delay_s: float) -> Stream:
    """Messages take longer, each by another time up to a limit: they overtake each other."""
    extra_s = np.zeros(len(stream))
    extra_s[strike.hit] = stream.by_message(
        lambda n: strike.rng.uniform(0.0, delay_s, n), strike.hit
    )
    return _arriving(stream, extra_s)


def burst(stream: Stream, strike: Strike, hold_s: float) -> Stream:
    """Messages are held back, and those of `hold_s` seconds arrive at once."""
    hold_us = round(hold_s * 1e6)
    wait_us = hold_us - _since_us(stream, strike) % hold_us
    return _arriving(stream, strike.hit * wait_us * 1e-6).in_order()


def duplicate(stream: Stream, strike: Strike, copies: int, apart_s: float) -> Stream:
    """Each message comes again, the same in every byte."""
    again = (
        _arriving(stream.rows(strike.hit), np.full(strike.hit.sum(), (i + 1) * apart_s))
        for i in range(copies)
    )
    return joined(stream, *again)


def restamped(stream: Stream, strike: Strike, ahead_s: float) -> Stream:
    """Stamps are ahead (or, negative, behind) by a constant."""
    return _stamped(stream, strike.hit * ahead_s)


def drifting(stream: Stream, strike: Strike, ppm: float) -> Stream:
    """The sender's clock runs fast, and is set right at the end."""
    return _stamped(stream, strike.hit * _since_us(stream, strike) * 1e-6 * ppm * 1e-6)


def joined(*streams: Stream) -> Stream:
    """One stream of several."""
    columns: dict[str, Any] = {
        name: np.concatenate([getattr(stream, name) for stream in streams])
        for name in ("utime", "received", "seq", "value", "id")
    }
    return Stream(**columns)


def _with_values(stream: Stream, strike: Strike, value: NDArray[np.float64]) -> Stream:
    struck = strike.hit[:, None] & ~np.isnan(stream.value)  # what is not measured stays so
    return replace(stream, value=np.where(struck, value, stream.value))


def _since_us(stream: Stream, strike: Strike) -> NDArray[np.int64]:
    """(n,) µs since the fault's first row."""
    return np.asarray(stream.utime - stream.utime[int(np.argmax(strike.hit))])


def _arriving(stream: Stream, later_s: NDArray[np.floating[Any]]) -> Stream:
    return replace(stream, received=stream.received + np.rint(later_s * 1e6).astype(np.int64))


def _stamped(stream: Stream, ahead_s: NDArray[np.floating[Any]]) -> Stream:
    return replace(stream, utime=stream.utime + np.rint(ahead_s * 1e6).astype(np.int64))
