"""A formula must not notice whether lengths are in m or mm, stresses in Pa or MPa."""

import pytest

from analytic.polyhedral import expansion, forces, torque, wedging

MM, MPA = 1e3, 1e-6  # from SI; N stays N, N m becomes N mm
ANGLES = {"psi": 0.28, "phi_1": 0.05}


def ring(k):
    return {"d_i": 0.072 * k, "d_e": 0.08 * k}


def growing(k, s):
    return {"j_D": 6e-5 * k, "E": 2.1e11 * s, **ring(k)}


def race(k):
    return {"z": 6, "D_i": 0.1 * k}


def chain(k, s):
    return {"p_1r": 1.8e7 * s, "share": 0.4, "mu": 0.08, "d_i": 0.072 * k, "b": 0.03 * k, **race(k)}


def hub(k):
    return {"M_t": 400 * k, "z": 6, "lever": 0.03 * k, **ANGLES}


CASES = [
    (lambda k, s: wedging.cage_force(N=1e4, alpha=0.1, mu=0.08), 1.0),
    (lambda k, s: wedging.tangential_force(N=1e4, alpha=0.1), 1.0),
    (lambda k, s: wedging.torque(N=1e4, alpha=0.1, **race(k)), MM),
    (lambda k, s: wedging.largest_torque(N=1e4, mu=0.08, **race(k)), MM),
    (lambda k, s: wedging.normal_force(M_t=400 * k, alpha=0.1, **race(k)), 1.0),
    (lambda k, s: wedging.least_normal_force(M_t=400 * k, mu=0.08, **race(k)), 1.0),
    (lambda k, s: expansion.mean_diameter(**ring(k)), MM),
    (lambda k, s: expansion.clearance(D_i=0.101 * k, d_e=0.08 * k, d=0.01 * k), MM),
    (lambda k, s: expansion.growth(sigma_t=1e8 * s, d_m=0.076 * k, E=2e11 * s), MM),
    (lambda k, s: expansion.hoop_stress(j_D=6e-5 * k, d_m=0.076 * k, E=2e11 * s), MPA),
    (lambda k, s: expansion.pressure(sigma=1e8 * s, **ring(k)), MPA),
    (lambda k, s: expansion.mean_hoop_stress(p=1e7 * s, **ring(k)), MPA),
    (lambda k, s: expansion.touching_pressure(**growing(k, s), K=1.1), MPA),
    (lambda k, s: expansion.many_corners_factor(**ring(k)), 1.0),
    (lambda k, s: expansion.round_ring_pressure(**growing(k, s), nu=0.3, ends="plane stress"), MPA),
    (lambda k, s: forces.apothem(d_i=0.072 * k, z=6, rho=2e-3 * k), MM),
    (lambda k, s: forces.half_flat(d_i=0.072 * k, z=6, rho=2e-3 * k), MM),
    (lambda k, s: forces.contact_angle(e=0.009 * k, apothem=0.03 * k), 1.0),
    (lambda k, s: forces.contact_radius(apothem=0.03 * k, psi=0.28), MM),
    (lambda k, s: forces.pressure_force(p_2=1e7 * s, b=0.03 * k, d_i=0.072 * k, z=6), MM**2 * MPA),
    (lambda k, s: forces.radial_force(**hub(k)), 1.0),
    (lambda k, s: torque.hub_share(
        mu=0.08, D_i=0.1 * k, lever=0.03 * k, gamma=0.0, **ANGLES), 1.0),
    (lambda k, s: torque.torque(p_t=3e7 * s, **chain(k, s)), MM**3 * MPA),
    (lambda k, s: torque.required_pressure(M_t=400 * s * k**3, **chain(k, s)), MPA),
    (lambda k, s: torque.first_torque(
        p_t=3e7 * s, mu=0.08, b=0.03 * k, **growing(k, s), **race(k), **ANGLES), MM**3 * MPA),
]  # fmt: skip


@pytest.mark.parametrize(("formula", "factor"), CASES)
def test_formula_is_dimensionally_homogeneous(formula, factor):
    assert float(formula(MM, MPA)) == pytest.approx(factor * float(formula(1.0, 1.0)), rel=1e-12)
