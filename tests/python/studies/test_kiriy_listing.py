"""The printed listing, reproduced through the core."""

import numpy as np

from pilotage.evaluate import wrap_angle
from pilotage.logs.mower import read_triple
from pilotage.studies import kiriy_listing
from support.datasets import dataset


def test_the_study_gives_the_listings_numbers(tmp_path):
    folder = dataset("mower-listing")
    kiriy_listing.run(read_triple(folder)).save(tmp_path)
    states = np.loadtxt(tmp_path / "states.csv", delimiter=",", skiprows=1)
    covariance = np.loadtxt(tmp_path / "final_covariance.csv", delimiter=",")

    golden = np.loadtxt(folder / "listing_states.txt.gz")
    assert states.shape == golden.shape
    assert np.abs(states[:, :2] - golden[:, :2]).max() <= 1e-9
    assert np.abs(wrap_angle(states[:, 2] - golden[:, 2])).max() <= 1e-9
    assert np.abs(covariance - np.loadtxt(folder / "listing_final_P.txt")).max() <= 1e-9
    assert (tmp_path / "states.csv").read_text().startswith("x,y,heading\n")
