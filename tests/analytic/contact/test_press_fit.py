"""Press fits against textbook values and the walls' displacements as unknowns."""

from itertools import pairwise

import numpy as np
import pytest

from analytic.contact.press_fit import (
    Wall,
    contact_pressures,
    opening_interference,
    pressure_of_overlap,
)

SHAFT = Wall(r_i=0.4, r_o=1.0, E=3.0, nu=0.2)
SLEEVE = Wall(r_i=1.0, r_o=1.3, E=1.0, nu=0.35)
HUB = Wall(r_i=1.3, r_o=2.5, E=2.0, nu=0.1)
STACK = [SHAFT, SLEEVE, HUB]
ASSUMPTIONS = ["plane stress", "plane strain"]


def plane(wall, assumption):
    """Lamé's constants of the plane: sigma_r = (lam + 2G) u' + lam u/r."""
    G = wall.E / (2 * (1 + wall.nu))
    lam = 2 * G * wall.nu / (1 - (2 if assumption == "plane strain" else 1) * wall.nu)
    return lam, G


def displacement_method(walls, delta, p_i, p_o, assumption):
    """Every wall has u = A r + B/r, from continuity and balance at once; contact pressures."""
    n = len(walls)
    matrix, right = np.zeros((2 * n, 2 * n)), np.zeros(2 * n)

    def radial_stress(wall, r):
        lam, G = plane(wall, assumption)
        return np.array([2 * lam + 2 * G, -2 * G / r**2])

    matrix[0, :2], right[0] = radial_stress(walls[0], walls[0].r_i), -p_i
    matrix[1, -2:], right[1] = radial_stress(walls[-1], walls[-1].r_o), -p_o
    for j, (inner, outer) in enumerate(pairwise(walls)):
        r, gap, balance = inner.r_o, 2 + 2 * j, 3 + 2 * j
        both = slice(2 * j, 2 * j + 4)
        matrix[gap, both], right[gap] = [-r, -1 / r, r, 1 / r], delta[j]
        matrix[balance, both] = np.r_[-radial_stress(inner, r), radial_stress(outer, r)]
    constants = np.linalg.solve(matrix, right).reshape(n, 2)
    return [-radial_stress(w, w.r_o) @ c for w, c in zip(walls[:-1], constants[:-1], strict=True)]


@pytest.mark.parametrize("assumption", ASSUMPTIONS)
def test_a_stack_agrees_with_the_displacement_method(assumption):
    loads = {"p_i": 2e-4, "p_o": 1e-4, "assumption": assumption}
    p = contact_pressures(STACK, [1e-3, 2e-3], **loads)
    expected = displacement_method(STACK, [1e-3, 2e-3], **loads)
    np.testing.assert_allclose(p, expected, rtol=1e-12)


@pytest.mark.parametrize("interface", [0, 1])
def test_a_contact_opens_at_its_opening_interference_and_not_above(interface):
    delta, loads = [1e-3, 2e-3], {"p_o": -3e-4, "assumption": "plane strain"}
    least = opening_interference(STACK, delta, interface=interface, **loads)
    delta[interface] = least + 1e-12
    assert abs(float(contact_pressures(STACK, delta, **loads)[interface])) < 1e-11
    delta[interface] = least - 1e-12
    with pytest.raises(ValueError, match=rf"interface {interface} \(0 is the innermost\)"):
        contact_pressures(STACK, delta, **loads)


@pytest.mark.parametrize("assumption", ASSUMPTIONS)
def test_the_strain_energy_is_the_work_of_the_interference(assumption):
    """Without other loads both walls together store pi r p delta."""
    walls = [SHAFT, SLEEVE]
    p = float(contact_pressures(walls, 1e-3, assumption=assumption)[0])
    stored = SHAFT.strain_energy(p_i=0.0, p_o=p, assumption=assumption)
    stored += SLEEVE.strain_energy(p_i=p, p_o=0.0, assumption=assumption)
    assert stored == pytest.approx(np.pi * 1.0 * p * 1e-3, rel=1e-12)


def test_walls_that_overlap_end_at_one_radius():
    hub = Wall(r_i=0.98, r_o=1.3, E=1.0, nu=0.35)
    p = pressure_of_overlap(SHAFT, hub, p_i=0.02, assumption="plane strain")
    rim = SHAFT.displacement(1.0, p_i=0.02, p_o=p, assumption="plane strain")
    bore = hub.displacement(0.98, p_i=p / 0.98, p_o=0.0, assumption="plane strain")
    assert 1.0 + rim == pytest.approx(0.98 + bore, rel=1e-14)
