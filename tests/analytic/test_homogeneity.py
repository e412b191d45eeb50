"""A formula must not depend on the units: lengths in m or mm, stresses in Pa or MPa."""

from typing import NamedTuple

import numpy as np
import pytest

from analytic.contact import (
    crown,
    disc_series,
    hertz_line,
    hertz_line_approach,
    hertz_point,
    partial_slip,
    tangential_cycle,
)
from analytic.freewheel import criterion, tilt
from analytic.polyhedral import expansion, forces, torque, wedging
from analytic.ring import lame, rotating, smeared
from analytic.spring import energy, frame


class Size(NamedTuple):
    """A number in SI, and its powers of length and stress (time stays in s)."""

    value: float
    length: float
    stress: float

    def scaled(self, k: float, s: float) -> float:
        return self.value * k**self.length * s**self.stress


def m(value=1.0):
    return Size(value, 1, 0)


def Pa(value=1.0):
    return Size(value, 0, 1)


def N(value=1.0):
    return Size(value, 2, 1)


def per_m(value=1.0):  # N/m
    return Size(value, 1, 1)


def N_m(value=1.0):
    return Size(value, 3, 1)


PURE = Size(1.0, 0, 0)
LINE = {"P": per_m(1e5), "R": m(0.01), "E_star": Pa(1.1e11)}
POINT = {"P": N(1e3), "R": m(0.01), "E_star": Pa(1.1e11)}
SLIDING = {"P": per_m(1e5), "mu": 0.1, "E_star": Pa(1e11)}
SWING = {"Q_max": per_m(5e3), **SLIDING}
RING = {"r_i": m(0.04), "r_o": m(0.06)}
STEEL = {"E": Pa(2e11), "nu": 0.3}
DESIGN = {"load": N(3400.0), "length": m(9e-3), "E_star": Pa(1.13e11)}
SPRING = {"n": 10, "alpha": 1.4, "b": m(1e-4), "h": m(0.056), "L1": m(0.0116), "E": Pa(2e11)}
BORE = {"d_i": m(0.072), "d_e": m(0.08)}
HUB = {"z": 6, "lever": m(0.03), "psi": 0.28, "phi_1": 0.05}

FORMULAS = [
    (hertz_line.peak_pressure, LINE, Pa()),
    (hertz_line_approach.approach_to_depth,
     {"d": m(0.01), "P": per_m(1e5), "a": m(1e-4), **STEEL, "assumption": "plane strain"}, m()),
    (disc_series.approach, {"P": per_m(1e5), "a": m(1e-3), "R": m(0.01), "E_plane": Pa(2e11)}, m()),
    (hertz_point.approach, POINT, m()),
    (partial_slip.slip, {"x": m(9e-5), "a": m(1e-4), "Q": per_m(5e3), **SLIDING}, m()),
    (partial_slip.rigid_displacement_beyond_stick, {"Q": per_m(5e3), **SLIDING}, m()),
    (tangential_cycle.dissipation, SWING, N()),
    (crown.johns_gohar, {"y": m(4e-3), "half_width": m(1e-4), **DESIGN}, m()),
    (crown.logarithmic, {"y": m(4e-3), "K_1": 2.0, "K_2": 0.7, "z_m": m(1e-5), **DESIGN}, m()),
    (lame.radial_displacement,
     {"r": m(0.05), **RING, "p_i": Pa(1e8), **STEEL, "ends": "plane strain"}, m()),
    (rotating.radial_displacement,
     {"r": m(0.04), **RING, "rho": Size(7850.0, -2, 1), "omega": 600.0, **STEEL,
      "assumption": "plane strain"}, m()),
    (smeared.race_deflection,
     {"P": per_m(4e5), "n": 12, **RING, **STEEL, "loaded": "rim"}, m()),
    (energy.stiffness, {**SPRING, "r": m(4.5e-4)}, per_m()),
    (frame.stiffness, {**SPRING, "radius": m(5e-4), "nu": 0.3, "theory": "thick"}, per_m()),
    (frame.free_length,
     {"n": 10, "alpha": 1.4, "L1": m(0.0116), "b": m(1e-4), "r": m(4.5e-4)}, m()),
    (criterion.required_friction,
     {"alpha": 0.06, "T": N_m(9.0), "F_ax": N(50.0), "R": m(0.0165)}, PURE),
    (tilt.offset, {"F_a": N(3.0), "F_n": N(90.0), "r": m(2.5e-3), "alpha": 0.06}, m()),
    (wedging.torque, {"N": N(1e4), "alpha": 0.1, "z": 6, "D_i": m(0.1)}, N_m()),
    (expansion.touching_pressure, {"j_D": m(6e-5), **BORE, "E": Pa(2.1e11), "K": 1.1}, Pa()),
    (forces.radial_force, {"M_t": N_m(400.0), **HUB}, N()),
    (torque.first_torque,
     {"p_t": Pa(3e7), "z": 6, "mu": 0.08, "b": m(0.03), "D_i": m(0.1), "j_D": m(6e-5), **BORE,
      "E": Pa(2.1e11), "psi": 0.28, "phi_1": 0.05}, N_m()),
]  # fmt: skip


@pytest.mark.parametrize(
    ("formula", "given", "found"), FORMULAS,
    ids=[f"{row[0].__module__}.{row[0].__name__}" for row in FORMULAS],
)  # fmt: skip
def test_formula_is_dimensionally_homogeneous(formula, given, found):
    def value(k, s):
        arguments = {
            name: one.scaled(k, s) if isinstance(one, Size) else one for name, one in given.items()
        }
        return float(np.asarray(formula(**arguments)))

    assert value(1e3, 1e-6) == pytest.approx(value(1.0, 1.0) * found.scaled(1e3, 1e-6), rel=1e-11)
