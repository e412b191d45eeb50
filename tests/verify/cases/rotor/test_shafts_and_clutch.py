"""Rotating shafts and the clutch between rotors: hand values, user inputs, refused inputs."""

import numpy as np
import pytest

from analytic.rotor.transfer_modes import whirl_frequencies
from verify.cases.rotor.clutch.case import CLUTCH, ClutchLink
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
    soft = ClutchLink(a=20e-6)  # a given deflection in place of Palmgren's: 1 kN by definition of a
    assert soft.k_n * 20e-6 ** (10 / 9) == pytest.approx(1000, rel=1e-12)
    assert CLUTCH.analytic(soft)["K_xx"] < v["K_xx"]


# The stepped shaft and its 45° rule.


def test_pieces_make_up_the_shaft_and_stiffness_grows_from_the_steps():
    q, short = SteppedBeam(), SteppedBeam(L_2=0.03, a=0.1)  # whose cones meet
    for one, cone in ((q, False), (q, True), (short, True)):
        pieces = one.shape.pieces(cone=cone)
        assert sum(p.length for p in pieces) == pytest.approx(one.L)
        assert sum(p.length * p.d**2 for p in pieces) == pytest.approx(
            sum(length * d**2 for length, d, _ in one.parts)
        )
        assert all(p.d_stiff == p.d for p in pieces) is not cone
    assert max(p.d_stiff for p in short.shape.pieces(cone=True)) < short.d_1 + 0.03
    stiff = [p.d_stiff for p in q.shape.pieces(cone=True)]
    assert stiff == pytest.approx(stiff[::-1])
    assert sorted(set(np.round(stiff, 9)))[:2] == pytest.approx([0.04, 0.04 + 0.04 / 32])


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
