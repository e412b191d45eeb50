"""A formula must not notice whether lengths are in m or mm, stresses in Pa or MPa."""

import math

import pytest

from analytic.ring import lame, rotating, smeared
from analytic.ring.loaded_race import LoadedRace
from analytic.spring import energy, frame

MM, MPA, N_PER_MM = 1e3, 1e-6, 1e-3  # from SI
RING = {"r_i": 0.04, "r_o": 0.06}
SPRING = {"b": 1e-4, "h": 0.056, "L1": 0.0116}
TURN = {"n": 10, "alpha": math.radians(80)}


def scaled(values, factor):
    return {name: value * factor for name, value in values.items()}


CASES = [
    pytest.param(
        lambda k, s: lame.stresses(0.05 * k, **scaled(RING, k), p_i=1e8 * s, p_o=1e7 * s)[1],
        MPA, id="hoop stress"),
    pytest.param(
        lambda k, s: lame.radial_displacement(
            0.05 * k, **scaled(RING, k), p_i=1e8 * s, E=2e11 * s, nu=0.3, ends="plane strain"),
        MM, id="radial displacement"),
    pytest.param(
        lambda k, s: lame.axial_stress(**scaled(RING, k), p_i=1e8 * s, nu=0.3, ends="closed ends"),
        MPA, id="axial stress"),
    pytest.param(
        lambda k, s: lame.strain_energy(
            **scaled(RING, k), p_i=1e8 * s, E=2e11 * s, nu=0.3, ends="plane stress"),
        1.0, id="strain energy per length (J/m is N)"),
    *(
        pytest.param(  # density is stress times time² over length²
            lambda k, s, part=part: part(
                **scaled(RING, k), rho=7850 * s / k**2, omega=600.0, E=2e11 * s, nu=0.3,
                assumption="plane strain"), factor, id=f"rotating ring, {name}")
        for part, factor, name in (
            (lambda **more: rotating.radial_displacement(more["r_i"], **more), MM, "growth"),
            (rotating.strain_energy, 1.0, "strain energy per length"),
        )
    ),
    *(
        pytest.param(
            lambda k, s, name=name: getattr(
                LoadedRace(**scaled(RING, k), E=2e11 * s, nu=0.3, assumption="plane stress",
                           loaded="bore", n=12, P=4e5 * s * k, a=2e-4 * k).at(0.04 * k, 1e-3),
                name),
            factor, id=f"race under loads, {name}")
        for name, factor in (("u_r", MM), ("u_theta", MM), ("sigma_theta", MPA))
    ),
    pytest.param(
        lambda k, s: smeared.race_deflection(
            P=4e5 * s * k, n=12, **scaled(RING, k), E=2e11 * s, nu=0.3, loaded="rim"),
        MM, id="Eq. 6"),
    pytest.param(
        lambda k, s: energy.stiffness(
            **scaled(SPRING, k), r=4.5e-4 * k, E=2e11 * s, **TURN), N_PER_MM, id="k_1"),
    pytest.param(
        lambda k, s: energy.deflection(
            F=3.0, **scaled(SPRING, k), r=4.5e-4 * k, E=2e11 * s, **TURN), MM, id="deflection"),
    pytest.param(
        lambda k, s: energy.bending_stress(F=3.0, **scaled(SPRING, k), r=4.5e-4 * k),
        MPA, id="bending stress"),
    *(
        pytest.param(
            lambda k, s, theory=theory: frame.stiffness(
                **scaled(SPRING, k), radius=5e-4 * k, E=2e11 * s, nu=0.3, theory=theory,
                head="guided", **TURN),
            N_PER_MM, id=f"frame, {theory}")
        for theory in ("bending", "thin", "shear", "thick")
    ),
    pytest.param(
        lambda k, s: frame.free_length(**{n: v for n, v in scaled(SPRING, k).items() if n != "h"},
                                       r=4.5e-4 * k, **TURN), MM, id="free length"),
]  # fmt: skip


@pytest.mark.parametrize(("formula", "factor"), CASES)
def test_formula_is_dimensionally_homogeneous(formula, factor):
    assert float(formula(MM, MPA)) == pytest.approx(factor * float(formula(1.0, 1.0)), rel=1e-12)
