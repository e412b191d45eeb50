"""A roller on a half-space: Hertz far from its ends, tilt, its readings on the ridge."""

import numpy as np
import pytest

from analytic.contact.crown_again import lundberg
from analytic.contact.half_space_ridge import press_ridge
from analytic.contact.half_space_roller import press_roller

R, LENGTH, E_STAR, LOAD = 2.9519e-3, 9e-3, 1.1319e11, 3400.0  # the sprag's roller on its race, SI
ROLLER = {"R": R, "length": LENGTH, "E_star": E_STAR}
UNIT = LOAD / (np.pi * LENGTH * E_STAR)


def logarithmic(y: np.ndarray, z_m: float = 10e-6) -> np.ndarray:
    """The paper's crown with K_1 = 1, K_2 = 0.7, designed for the load."""
    t = np.maximum(0.0, (np.abs(y) - LENGTH / 2) / (0.35 * LENGTH) + 1)
    return -UNIT * np.log(1 - (1 - np.exp(-z_m / UNIT)) * t**2)


def test_a_tilt_loads_the_end_where_the_gap_closes() -> None:
    up, down = (
        press_roller(logarithmic, **ROLLER, load=LOAD, cells=(32, 128), tilt=t)
        for t in (3e-4, -3e-4)
    )
    assert up.contact.moments[0] < -0.1 * LOAD * 1e-3
    assert up.contact.moments[0] == pytest.approx(-down.contact.moments[0], rel=1e-6)
    assert up.line_load == pytest.approx(down.line_load[::-1], abs=1e-6 * up.line_load.max())


RIDGE_ROLLER = {"load": 3407.0, "R": 2.95e-3, "length": 9e-3, "E_star": 113e9, "d": 0.5e-3}


def test_an_even_load_is_symmetric_and_has_hertz_s_pressure_and_width() -> None:
    law = {key: RIDGE_ROLLER[key] for key in ("load", "length", "E_star")}
    even = press_ridge(lundberg(**law), across=8, along=128, **RIDGE_ROLLER)
    q = RIDGE_ROLLER["load"] / RIDGE_ROLLER["length"]
    p_0 = np.sqrt(q * RIDGE_ROLLER["E_star"] / (np.pi * RIDGE_ROLLER["R"]))
    b = np.sqrt(4 * q * RIDGE_ROLLER["R"] / (np.pi * RIDGE_ROLLER["E_star"]))
    found = even.values
    assert found["p_mid"] == pytest.approx(p_0, rel=0.01)
    assert found["b_mid"] == pytest.approx(b, rel=0.01)
    assert found["q_mid"] == pytest.approx(q, rel=0.01)
    assert even.unevenness < 0.02
    assert abs(found["balance"]) < 1e-8 * RIDGE_ROLLER["load"]
    assert found["F_low"] == pytest.approx(found["F_high"], rel=1e-6)
    assert found["F_d"] == found["F_low"] + found["F_high"]
    assert abs(found["M"]) < 1e-6 * RIDGE_ROLLER["load"] * RIDGE_ROLLER["length"]
    assert even.beyond(RIDGE_ROLLER["d"]).max() <= found["p_max"] <= found["p_top"] * (1 + 1e-12)
