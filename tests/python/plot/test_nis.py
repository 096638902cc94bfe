import numpy as np
import pytest

from pilotage.plot import nis_figure
from support import runs
from support.artists import artist, texts


def test_each_sensor_and_number_of_components_has_its_band() -> None:
    run = runs.Run(
        poses=runs.poses([0, 4_000_000]),
        reports=runs.reports(
            [1_000_000, 2_000_000, 3_000_000], sensor=[1, 0, 1], dof=[1, 2, 2], nis=1.0
        ),
        sensors=("camera", "laser"),
    )
    figure = nis_figure(run)
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert titles == ["camera, 2 components", "laser, 1 component", "laser, 2 components"]
    bands = [artist(axes, "band").get_height() for axes in figure.axes]
    assert bands == pytest.approx([7.3272, 5.0229, 7.3272], rel=1e-3)
    assert "95 % band of χ²" in texts(figure)
    assert artist(figure.axes[0], "accepted").get_xdata() == [2.0]


def test_rejected_sightings_stand_out_by_reason() -> None:
    run, _, _ = runs.drive()
    run.reports["reason"][8] = 1
    figure = nis_figure(run)
    gate, unknown = (artist(figure.axes[0], f"rejected {reason}") for reason in (0, 1))
    assert (gate.get_xdata().size, unknown.get_xdata().size) == (9, 1)
    assert gate.get_color() != unknown.get_color()
    assert gate.get_marker() != unknown.get_marker()
    np.testing.assert_array_equal(gate.get_ydata(), 30.0)
    assert {"rejected: gate (9)", "rejected: unknown marker (1)"} <= set(texts(figure))


def test_headline_tells_share_and_mean_of_the_accepted() -> None:
    run, _, _ = runs.drive()
    accepted = run.reports["nis"][run.reports["accepted"]]
    inside = 100.0 * np.mean((accepted > 0.05064) & (accepted < 7.3778))
    assert nis_figure(run).axes[0].get_title(loc="right") == (
        f"{inside:.1f} % of 70 accepted in the band, mean {accepted.mean():.2f} (expected 2)"
    )


def test_rejected_sighting_without_a_nis_is_not_lost() -> None:
    run, _, _ = runs.drive()
    run.reports["dof"][0], run.reports["nis"][0] = 0, np.nan
    run.reports["nis"][8] = 1e12
    (axes,) = nis_figure(run).axes
    shown = artist(axes, "rejected 0").get_ydata()
    np.testing.assert_array_equal(shown[:2], axes.get_ylim()[1])


def test_sensor_that_never_had_a_component_is_shown() -> None:
    run = runs.Run(
        poses=runs.poses([0, 1]),
        reports=runs.reports([0], dof=0, nis=np.nan, accepted=False, reason=1),
    )
    figure = nis_figure(run)
    assert {"camera, 0 components", "none accepted"} <= set(texts(figure))
    figure.draw_without_rendering()


def test_no_sightings_are_said() -> None:
    assert "no sightings" in texts(nis_figure(runs.Run(poses=runs.poses([0]))))
