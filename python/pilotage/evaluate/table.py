"""Metrics as rows of text for a terminal."""

from typing import NamedTuple

from .metrics import Heading, Metrics, Position


class Row(NamedTuple):
    """One line of the table."""

    label: str
    value: str
    unit: str


def error_rows(position: Position | None, heading: Heading | None) -> list[Row]:
    """Return the rows of the errors."""
    rows = []
    if position:
        rows += [
            Row("position error, RMSE", f"{position.rmse_m:.3f}", "m"),
            Row("position error, mean", f"{position.mean_m:.3f}", "m"),
            Row("position error, standard deviation", f"{position.std_m:.3f}", "m"),
            Row("position error, 95th percentile", f"{position.p95_m:.3f}", "m"),
            Row("position error, largest", f"{position.max_m:.3f}", "m"),
        ]
    if heading:
        rows += [
            Row("heading error, RMSE", f"{heading.rmse_deg:.2f}", "deg"),
            Row("heading error, mean", f"{heading.mean_deg:+.2f}", "deg"),
            Row("heading error, standard deviation", f"{heading.std_deg:.2f}", "deg"),
            Row("heading error, median of magnitude", f"{heading.median_abs_deg:.2f}", "deg"),
        ]
    return rows


def table_rows(metrics: Metrics) -> list[Row]:
    """Return the rows to print, in order; what is not known does not appear."""
    rows = error_rows(metrics.position, metrics.heading)
    if nees := metrics.nees:
        rows.append(Row(f"NEES, mean (expected {nees.dof})", f"{nees.mean:.2f}", ""))
        if nees.singular:
            rows.append(Row("rows without NEES: singular covariance", f"{nees.singular}", ""))
    for sensor, nis in metrics.nis.items():
        expected = f" (expected {nis.dof:.3g})" if nis.dof is not None else ""
        mean = f"{nis.mean:.2f}" if nis.mean is not None else "none accepted"
        rows.append(Row(f"NIS of {sensor}, mean{expected}", mean, ""))

    counts = metrics.counts
    rows.append(Row("measured components", f"{counts.samples}", ""))
    rows.append(Row("measured components accepted", f"{counts.accepted}", ""))
    rows += [Row(f"rejected: {reason}", f"{n}", "") for reason, n in counts.rejected.items()]
    rows.append(Row("duration", f"{metrics.duration_s:.1f}", "s"))
    if metrics.messages_per_s is not None:
        rows.append(Row("speed", f"{metrics.messages_per_s:,.0f}", "messages/s"))
    return rows
