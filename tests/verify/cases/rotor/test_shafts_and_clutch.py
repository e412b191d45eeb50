"""Turning shafts and the clutch between rotors: values by hand, own inputs, what is refused."""

import numpy as np
import pytest

from analytic.rotor.transfer_modes import whirl_frequencies
from verify.cases.rotor.clutch.case import CLUTCH, ClutchLink
from verify.cases.rotor.shaft.case import UniformShaft
from verify.cases.rotor.step import reference
from verify.cases.rotor.step.case import SteppedBeam


def test_values_of_the_clutch_are_those_of_a_pocket_calculator():
    v = CLUTCH.analytic(ClutchLink())
    # 15/(12 * 11.11e-3 * 0.0550333) N; twice 3.84e-5 N^0.9/9^0.8 mm
    assert v["N"] == pytest.approx(2044.4, rel=1e-4)
    assert v["delta_0"] == pytest.approx(2 * 3.84e-8 * 2044.4**0.9 / 9**0.8, rel=1e-4)
    k = 10 / 9 * v["N"] / v["delta_0"]
    assert v["K_xx"] == pytest.approx(6 * k, rel=1e-12)
    assert v["K_zz"] == pytest.approx(12 * k * (11.11e-3 * 0.0550333) ** 2, rel=1e-5)
    soft = ClutchLink(a=20e-6)  # own yield in place of Palmgren's: 1 kN by definition of a
    assert soft.k_n * 20e-6 ** (10 / 9) == pytest.approx(1000, rel=1e-12)
    assert CLUTCH.analytic(soft)["K_xx"] < v["K_xx"]


def test_an_interval_of_a_stubby_shaft_has_no_series():
    row = "Euler's beam, mode 1, at rest"
    for q, sharp in ((UniformShaft(), True), (UniformShaft(L=0.13), False)):
        check = next(c.check for c in q.stated() if c.name == row)
        interval = check.interval(None)
        assert (interval is not None) is sharp
        assert not sharp or 0.015 < interval[0] < interval[1] < 0.02


# The stepped shaft and its 45° rule.


def test_cones_of_many_slices_and_the_weak_form_agree():
    q = SteppedBeam(a=0.1)
    fine, few = (
        whirl_frequencies(q.rotor(cone=True, **more), [q.n], count=3)[0]
        for more in ({"slices": 32}, {})
    )
    assert few == pytest.approx(fine, rel=1e-4)
    found = reference.weak_form(q, 3, cone=True).whirl(q.n)[0]
    assert found == pytest.approx(fine, rel=1e-4)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("cone", [False, True])
def test_cells_are_as_many_where_inputs_differ_by_round_off(seed, cone):
    """Both cones of a short thick part end in one station, and counts of cells are whole."""
    q = SteppedBeam().with_middle(3.0, 0.1)
    noise = 1 + 1e-13 * np.random.default_rng(seed).standard_normal(5)
    names = ("L", "d_1", "d_2", "L_2", "b")
    near = q.model_copy(update={n: getattr(q, n) * x for n, x in zip(names, noise, strict=True)})
    meshes = [reference.weak_form(one, 1, cone=cone).basis.mesh for one in (q, near)]
    assert meshes[0].nelements == meshes[1].nelements
    assert np.diff(np.sort(meshes[1].p[0])).min() > 1e-4 * q.L
