"""Printed equations of the paper against statics solved here by vectors and quadrature."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.polyhedral import forces, torque
from analytic.polyhedral.design import PolyhedralClutch
from analytic.polyhedral.parts import PolyhedralParts

PARTS = PolyhedralParts(z=6, d_i=0.072, d_e=0.08, D_i=0.10006, d=0.01, b=0.03, e=0.009)
PHI_1 = float(np.arctan(0.05))
LOADS = {"p_t": 30e6, "E": 210e9, "nu": 0.3, "mu": 0.08, "phi_1": PHI_1}
CORNERS = pytest.mark.parametrize("z", [3, 4, 6, 12, 48])
IN_CORNERS = 0.018  # e at the end of the sharp flat


def test_no_equation_of_the_chain_fixes_the_wedge_angle():
    narrow, wide = (
        PolyhedralClutch(PARTS, **LOADS, alpha=np.radians(alpha)) for alpha in (3.0, 6.0)
    )
    for value in ("sigma_t", "p_1", "p_1r", "p_2", "F", "arm"):
        assert getattr(narrow, value) == getattr(wide, value)
    assert wide.M_t > 1.5 * narrow.M_t


def side_force(z, d_i, rho):
    """Resultant of a unit pressure along the normal of a side, fillets and all, per width.

    From the unfilleted corner R_u: the flat, then the arc about the fillet's centre.
    """
    half = np.pi / z
    R_u = d_i / 2 + rho * (1 / np.cos(half) - 1)
    flat = R_u * np.sin(half) - rho * np.tan(half)
    return 2 * (flat + quad(lambda t: rho * np.cos(t), 0, half)[0])


@CORNERS
@pytest.mark.parametrize("rho", [0.0, 2e-3, 30e-3])
def test_the_force_on_a_side_is_that_on_its_chord_not_on_its_arc(z, rho):
    F = 3e6 * 0.03 * side_force(z, 0.072, rho)
    ours = float(forces.pressure_force(p_2=3e6, b=0.03, d_i=0.072, z=z))
    assert ours == pytest.approx(F, rel=1e-12)
    printed = np.pi * 0.072 * 0.03 * 3e6 / z
    assert printed / F - 1 == pytest.approx((np.pi / z) / np.sin(np.pi / z) - 1, rel=1e-9)


# The hub: it touches at (apothem, e) and turns clockwise; R makes phi_1 with the normal, +x.


def hub(parts, phi_1=PHI_1):
    """Contact point and unit force of the hub, its friction against the normal by phi_1."""
    at = np.array([parts.d_i / 2 * np.cos(np.pi / parts.z), parts.e])
    return at, np.array([np.cos(phi_1), -np.sin(phi_1)])


def clockwise(at, force):
    return -np.linalg.det([at, force])


@pytest.mark.parametrize("e", [0.003, 0.009, 0.015, IN_CORNERS])
def test_psi_is_the_angle_and_r_plus_r_1_the_radius_of_the_hub_s_contact(e):
    parts = replace(PARTS, e=e)
    at, _ = hub(parts)
    assert parts.psi == pytest.approx(np.arctan2(at[1], at[0]), rel=1e-12)
    lever = float(forces.contact_radius(apothem=parts.apothem, psi=parts.psi))
    assert lever == pytest.approx(np.hypot(*at), rel=1e-12)
    in_corner = lever == pytest.approx(parts.d_i / 2, rel=1e-12)
    assert in_corner == (e == IN_CORNERS)  # as printed only there


@pytest.mark.parametrize("e", [0.006, 0.009, IN_CORNERS])
def test_hub_s_forces_carry_the_torque_on_the_exact_lever(e):
    parts, M_t = replace(PARTS, e=e), 400.0
    at, unit = hub(parts)
    R = M_t / 6 / clockwise(at, unit)
    radial = at / np.hypot(*at)
    lever = float(np.hypot(*at))
    angles = {"psi": parts.psi, "phi_1": PHI_1}
    F_s = float(forces.radial_force(M_t=M_t, z=6, lever=lever, **angles))
    assert F_s == pytest.approx(R * unit @ radial, rel=1e-12)
    assert float(forces.contact_force(F_s=F_s, **angles)) == pytest.approx(R, rel=1e-12)
    tangential = R * abs(np.linalg.det([radial, unit]))
    assert M_t / (6 * lever) == pytest.approx(tangential, rel=1e-12)  # T of Eq. 14
    printed = float(forces.radial_force(M_t=M_t, z=6, lever=0.036, **angles))
    assert (printed == pytest.approx(F_s, rel=1e-6)) == (e == IN_CORNERS)


def test_the_lever_d_i_over_2_is_a_tenth_too_long_and_costs_a_twentieth_of_the_torque():
    paper = PolyhedralClutch(PARTS, **LOADS, lever="d_i/2", gamma="radius")
    exact = replace(paper, lever="exact")
    assert paper.arm / exact.arm == pytest.approx(1.109, abs=5e-4)
    assert exact.M_t == pytest.approx(equilibrium(PARTS, "radius", exact.p_2)[1], rel=1e-12)
    assert exact.M_t / paper.M_t == pytest.approx(1.055, abs=5e-4)


def test_gamma_is_zero_on_the_normal_of_the_flat():
    at, unit = hub(PARTS)
    R, F = 6000.0, 12000.0
    along = {"F": F, "R": R, "phi_1": PHI_1}
    on_normal = F + R * unit @ [1.0, 0.0]
    on_radius = F + R * unit @ at / np.hypot(*at)
    assert float(forces.normal_force(**along, gamma=0.0)) == pytest.approx(on_normal, rel=1e-12)
    printed = float(forces.normal_force(**along, gamma=PARTS.psi))
    assert printed == pytest.approx(on_radius, rel=1e-12)
    assert on_normal > 1.01 * printed


def test_hub_with_its_friction_reversed_turns_the_ring_back_only_for_psi_above_phi_1():
    at, _ = hub(PARTS)
    for phi_1, back in ((PARTS.psi - 0.01, True), (PARTS.psi, False), (PARTS.psi + 0.01, False)):
        _, unit = hub(PARTS, phi_1=-phi_1)
        assert (clockwise(at, unit) > 1e-12) == back
        assert bool(torque.hub_releases(psi=PARTS.psi, phi_1=phi_1)) == back
    with pytest.raises(ValueError, match="hub locks: psi must exceed"):
        replace(
            PolyhedralClutch(PARTS, **LOADS), phi_1=PARTS.psi
        )  # the printed psi >= phi_1 lets it pass


def test_d_i_through_the_corners_makes_delta_1_the_least_wall():
    corners = [0.036 * np.exp(1j * (2 * k - 1) * np.pi / 6) for k in range(2)]
    side = np.array([corners[0] + t * (corners[1] - corners[0]) for t in np.linspace(0, 1, 201)])
    walls = 0.04 - abs(side)
    assert walls.min() == pytest.approx(PARTS.delta_1, rel=1e-12)
    assert walls.max() == pytest.approx(PARTS.delta_mid, rel=1e-12)
    across_flats = 0.04 - abs(side / np.cos(np.pi / 6))  # the same d_i as distance of the flats
    assert across_flats.min() < 0  # cuts through the ring


def equilibrium(parts, gamma, p_2, mu=0.08):
    """N, M_t and R of one roller's sector as a linear system, F by quadrature."""
    at, unit = hub(parts)
    F = p_2 * parts.b * side_force(parts.z, parts.d_i, 0.0)
    toward = np.array([1.0, 0.0]) if gamma == "normal" else at / np.hypot(*at)
    system = [
        [1.0, 0.0, -unit @ toward],  # N = F + R along the direction
        [-mu * parts.z * parts.D_i / 2, 1.0, 0.0],  # all rollers slip on the race
        [0.0, 1.0, -parts.z * clockwise(at, unit)],  # the hub brings the torque
    ]
    return np.linalg.solve(system, [F, 0.0, 0.0])


@pytest.mark.parametrize("gamma", ["normal", "radius"])
@pytest.mark.parametrize(("z", "e"), [(3, 0.02), (6, 0.009), (6, IN_CORNERS), (8, 0.005)])
def test_torque_under_a_pressure_is_that_of_ring_rollers_and_hub_in_balance(z, e, gamma):
    clutch = PolyhedralClutch(replace(PARTS, z=z, e=e), **LOADS, gamma=gamma)
    N, M_t, R = equilibrium(clutch.parts, gamma, clutch.p_2)
    assert (clutch.N, clutch.M_t, clutch.R) == pytest.approx((N, M_t, R), rel=1e-12)
    # Eqs. 17 and 20 as printed, with the circumference
    right = 2 / (0.08 * clutch.parts.D_i) - np.cos(clutch.direction + PHI_1) / (
        clutch.arm * np.sin(clutch.parts.psi + PHI_1)
    )
    printed = np.pi * 0.072 * 0.03 * clutch.p_2 / right
    assert M_t / printed == pytest.approx(z * np.sin(np.pi / z) / np.pi, rel=1e-9)


def test_eq_17_holds_with_eq_14_and_not_with_eq_15():
    psi, lever, M_t = PARTS.psi, float(np.hypot(*hub(PARTS)[0])), 400.0
    term = M_t * np.cos(PHI_1) / (6 * lever * np.sin(psi + PHI_1))  # N - F as Eq. 17 has it
    for arm, same in ((lever, True), (0.036, False)):
        F_s = float(forces.radial_force(M_t=M_t, z=6, lever=arm, psi=psi, phi_1=PHI_1))
        by_eq_16 = F_s * np.cos(PHI_1) / np.cos(psi + PHI_1)
        assert (by_eq_16 == pytest.approx(term, rel=1e-9)) == same


def test_eq_21_as_printed_is_z_times_too_small():
    first = PolyhedralClutch(PARTS, **LOADS, lever="d_i/2", gamma="radius")
    corner = replace(PARTS, e=IN_CORNERS)  # lever d_i/2 exactly, so that statics may judge
    by_statics = equilibrium(corner, "radius", first.p_2)[1]
    right = 2 / (0.08 * 0.10006) - 2 / (0.072 * np.tan(corner.psi + PHI_1))
    printed = np.pi * (360 / 6) * 0.072 * 0.03 / 360 * first.p_2 / right
    with_side = printed * np.sin(np.pi / 6) / (np.pi / 6)
    assert by_statics == pytest.approx(6 * with_side, rel=1e-9)
    named = {"d_i": 0.072, "d_e": 0.08, "D_i": 0.10006, "b": 0.03, "j_D": PARTS.j_D}
    ours = torque.first_torque(
        p_t=30e6, z=6, **named, E=210e9, mu=0.08, psi=corner.psi, phi_1=PHI_1
    )
    assert float(ours) == pytest.approx(by_statics, rel=1e-9)
    assert replace(first, parts=corner).M_t == pytest.approx(by_statics, rel=1e-9)


@pytest.mark.parametrize(("psi", "limited"), [(3.48, False), (3.49, True), (2.87, False)])
def test_below_a_bound_the_hub_alone_wedges_the_rollers(psi, limited):
    """Forces in turn: the rollers' torque loads the hub, the hub's force the rollers."""
    e = 0.036 * np.cos(np.pi / 6) * np.tan(np.radians(psi))
    clutch = PolyhedralClutch(replace(PARTS, e=e), **LOADS, lever="d_i/2", gamma="radius")
    added = [clutch.F]
    for _ in range(10):
        M_t = 0.08 * added[-1] * 6 * 0.10006 / 2
        added.append(M_t / (6 * 0.036 * np.tan(np.radians(psi) + PHI_1)))
    assert np.all(np.diff(added) < 0) == limited  # settles, or grows for ever
    assert (np.tan(np.radians(psi) + PHI_1) > 0.08 * 0.10006 / 0.072) == limited
    assert np.isfinite(clutch.M_t) == limited
    assert bool(torque.self_locking(clutch.hub_share)) == (not limited)
    wanted = replace(clutch, M_wanted=100.0)
    assert (wanted.p_required > clutch.p_1r) == limited
