"""A roller on a half-space read off its ridge: far from its ends it is Hertz's line contact."""

import numpy as np
import pytest

from analytic.contact.crown_again import lundberg
from analytic.contact.half_space_ridge import press_ridge

ROLLER = {"load": 3407.0, "R": 2.95e-3, "length": 9e-3, "E_star": 113e9, "d": 0.5e-3}


@pytest.fixture(scope="module")
def even():
    law = {key: ROLLER[key] for key in ("load", "length", "E_star")}
    return press_ridge(lundberg(**law), across=8, along=128, **ROLLER)


def test_an_even_load_has_hertz_s_pressure_and_width(even):
    q = ROLLER["load"] / ROLLER["length"]
    p_0 = np.sqrt(q * ROLLER["E_star"] / (np.pi * ROLLER["R"]))
    b = np.sqrt(4 * q * ROLLER["R"] / (np.pi * ROLLER["E_star"]))
    found = even.values
    assert found["p_mid"] == pytest.approx(p_0, rel=0.01)
    assert found["b_mid"] == pytest.approx(b, rel=0.01)
    assert found["q_mid"] == pytest.approx(q, rel=0.01)
    assert even.unevenness < 0.02


def test_loads_and_places_are_those_of_a_roller_that_is_symmetric(even):
    found = even.values
    assert abs(found["balance"]) < 1e-8 * ROLLER["load"]
    assert found["F_low"] == pytest.approx(found["F_high"], rel=1e-6)
    assert found["F_d"] == found["F_low"] + found["F_high"]
    assert abs(found["M"]) < 1e-6 * ROLLER["load"] * ROLLER["length"]
    assert even.beyond(ROLLER["d"]).max() <= found["p_max"] <= found["p_top"] * (1 + 1e-12)


def test_a_roller_without_crown_is_uneven_and_loads_its_ends(even):
    flat = press_ridge(np.zeros_like, across=8, along=128, **ROLLER)
    assert flat.unevenness > even.unevenness
    assert flat.values["F_d"] > even.values["F_d"]
    assert flat.values["p_largest"] > 1.5 * flat.values["p_mid"]
