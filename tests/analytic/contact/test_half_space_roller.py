"""A roller of finite length on a half-space."""

import numpy as np
import pytest

from analytic.contact.half_space_roller import press_roller

R, LENGTH, E_STAR, LOAD = 2.9519e-3, 9e-3, 1.1319e11, 3400.0  # the sprag's roller on its race, SI
B = np.sqrt(4 * LOAD * R / (np.pi * E_STAR * LENGTH))  # Hertz's line contact
PEAK = np.sqrt(LOAD * E_STAR / (np.pi * R * LENGTH))
ROLLER = {"R": R, "length": LENGTH, "E_star": E_STAR}
UNIT = LOAD / (np.pi * LENGTH * E_STAR)


def lundberg(y: np.ndarray) -> np.ndarray:
    return -UNIT * np.log(1 - (2 * y / LENGTH) ** 2)


def logarithmic(y: np.ndarray, z_m: float = 10e-6) -> np.ndarray:
    """The paper's crown with K_1 = 1, K_2 = 0.7, designed for the load."""
    t = np.maximum(0.0, (np.abs(y) - LENGTH / 2) / (0.35 * LENGTH) + 1)
    return -UNIT * np.log(1 - (1 - np.exp(-z_m / UNIT)) * t**2)


def test_the_middle_of_a_long_roller_is_hertzs_line_contact() -> None:
    found = press_roller(
        R=R, length=300 * B, E_star=E_STAR, load=LOAD * 300 * B / LENGTH, cells=(96, 600)
    )
    middle = len(found.y) // 2
    q = found.line_load[middle]
    assert 0.9 < q / (LOAD / LENGTH) < 1  # the ends carry more
    assert found.mid_pressure == pytest.approx(np.sqrt(q * E_STAR / (np.pi * R)), rel=1e-3)
    assert found.half_width[middle] == pytest.approx(
        np.sqrt(4 * q * R / (np.pi * E_STAR)), rel=2e-3
    )


def test_lundbergs_crown_leaves_nearly_uniform_pressure() -> None:
    found = press_roller(lundberg, **ROLLER, load=LOAD, cells=(96, 512))
    inner = np.abs(found.y) < 0.9 * LENGTH / 2
    assert found.centre_pressure[inner] == pytest.approx(PEAK, rel=0.012)
    assert found.mid_pressure == pytest.approx(PEAK, rel=0.003)
    # his rectangle of pressure is Hertz's across up to the very end: there it errs
    assert 1.1 < found.peak_pressure / PEAK < 1.2


def test_the_peak_of_a_flat_roller_grows_as_one_over_the_root_of_the_cell() -> None:
    fine = np.array([12, 16, 24, 32])  # cells in b, both ways
    peaks = [
        press_roller(
            R=R, length=20 * B, E_star=E_STAR, load=LOAD * 20 * B / LENGTH, cells=(3 * n, 20 * n),
            width=3 * B,
        ).contact.pressure.max()
        for n in fine
    ]  # fmt: skip
    slope = np.polyfit(np.log(B / fine), np.log(peaks), 1)[0]
    assert slope == pytest.approx(-0.50, abs=0.02), peaks


def test_mid_pressure_approach_and_end_load_of_a_flat_roller_converge() -> None:
    runs = [press_roller(**ROLLER, load=LOAD, cells=(n, 4 * n), width=4 * B) for n in (48, 96, 192)]
    values = np.array([(r.mid_pressure, r.contact.approach, r.end_load(0.5e-3)[0]) for r in runs])
    first, second = np.abs(np.diff(values, axis=0) / values[-1])
    assert np.all(second < 0.75 * first), (first, second)
    assert np.all(second < [5e-4, 5e-4, 4e-3])


def test_a_crowned_roller_whose_ends_stay_free_converges() -> None:
    def crown(y: np.ndarray) -> np.ndarray:
        return logarithmic(y, 25e-6)

    runs = [
        press_roller(crown, **ROLLER, load=LOAD, cells=(n, 16 * n), width=2.6 * B)
        for n in (32, 64, 128)  # the pressure ends within half a width b of the crown's end
    ]
    values = np.array([(r.mid_pressure, r.peak_pressure, r.contact.approach) for r in runs])
    assert runs[-1].line_load[0] == 0
    # the peak lies at the rim, whose steps make it waver: no order, but no drift either
    assert np.all(np.abs(values[-1] / values[-2] - 1) < [2e-4, 6e-3, 5e-5]), values


def test_stretches_from_both_ends_add_up_to_the_load() -> None:
    found = press_roller(logarithmic, **ROLLER, load=LOAD, cells=(32, 90), tilt=3e-4)
    left, right = found.end_load(LENGTH / 3.3)[0], found.end_load(LENGTH - LENGTH / 3.3)[1]
    assert left + right == pytest.approx(LOAD, rel=1e-12)
    assert found.end_load(LENGTH) == pytest.approx((LOAD, LOAD), rel=1e-12)


def test_a_tilt_loads_the_end_where_the_gap_closes() -> None:
    up, down = (
        press_roller(logarithmic, **ROLLER, load=LOAD, cells=(32, 128), tilt=t)
        for t in (3e-4, -3e-4)
    )
    assert up.contact.moments[0] < -0.1 * LOAD * 1e-3
    assert up.contact.moments[0] == pytest.approx(-down.contact.moments[0], rel=1e-6)
    assert up.line_load == pytest.approx(down.line_load[::-1], abs=1e-6 * up.line_load.max())


def test_load_and_approach_give_back_each_other() -> None:
    by_load = press_roller(logarithmic, **ROLLER, load=LOAD, cells=(32, 128), width=3 * B)
    by_approach = press_roller(
        logarithmic, **ROLLER, approach=by_load.contact.approach, cells=(32, 128), width=3 * B
    )
    assert by_approach.contact.load == pytest.approx(LOAD, rel=1e-7)


def test_an_approach_finds_its_patch_by_itself() -> None:
    found = press_roller(logarithmic, **ROLLER, approach=11.677e-6, cells=(32, 128))
    assert found.contact.load == pytest.approx(LOAD, rel=2e-3)
    assert not found.contact.carries[[0, -1]].any()
    assert found.contact.carries.any(axis=1).sum() > 20


def test_a_patch_too_narrow_is_made_wider() -> None:
    narrow = press_roller(logarithmic, **ROLLER, load=LOAD, cells=(64, 128), width=0.5 * B)
    assert narrow.contact.cell[0] * 64 > 2 * B
    assert not narrow.contact.carries[[0, -1]].any()


def test_odd_and_even_counts_of_cells_agree_in_the_middle() -> None:
    even, odd = (
        press_roller(logarithmic, **ROLLER, load=LOAD, cells=c, width=2.6 * B)
        for c in ((64, 200), (65, 201))
    )
    assert even.mid_pressure == pytest.approx(odd.mid_pressure, rel=1e-4)


def test_a_light_load_touches_the_straight_part_alone() -> None:
    found = press_roller(logarithmic, **ROLLER, load=0.01, cells=(32, 128))
    assert found.contact.load == pytest.approx(0.01, rel=1e-12)
    assert 0 < found.contact.carries.any(axis=0).sum() < 64
    assert found.half_width[0] == 0


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"R": 0.0}, "relative radius must be positive"),
        ({"length": -1.0}, "length must be positive"),
        ({"load": -1.0}, "load must be positive"),
        ({"load": None}, "either load or approach"),
        ({"crown": np.zeros(7)}, "a height a cell along"),
        ({"crown": [np.nan] * 16}, "crown must be finite"),
        ({"tilt": np.inf}, "tilt must be finite"),
        ({"width": 0.0}, "width of the patch must be positive"),
        ({"cells": (0, 16)}, "whole numbers from 1"),
    ],
)
def test_wrong_input_is_refused_by_name(change: dict[str, object], message: str) -> None:
    right = {**ROLLER, "load": LOAD, "cells": (16, 16)}
    with pytest.raises(ValueError, match=message):
        press_roller(**right | change)  # type: ignore[arg-type]


def test_a_stretch_beyond_the_roller_is_refused() -> None:
    found = press_roller(**ROLLER, load=LOAD, cells=(16, 16))
    with pytest.raises(ValueError, match="stretch is at most the length"):
        found.end_load(2 * LENGTH)
