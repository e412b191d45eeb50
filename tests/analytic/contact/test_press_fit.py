"""Press fits against textbook values and the walls' displacements as unknowns."""

from itertools import pairwise

import numpy as np
import pytest

from analytic.contact.press_fit import (
    Wall,
    contact_pressures,
    interferences_lost,
    opening_interference,
    pressure_of_overlap,
)

SHAFT = Wall(r_i=0.4, r_o=1.0, E=3.0, nu=0.2)
SLEEVE = Wall(r_i=1.0, r_o=1.3, E=1.0, nu=0.35)
HUB = Wall(r_i=1.3, r_o=2.5, E=2.0, nu=0.1)
STACK = [SHAFT, SLEEVE, HUB]
ASSUMPTIONS = ["plane stress", "plane strain"]


def test_pressure_of_two_unlike_rings_is_the_textbooks():
    """delta/p = r/E_o ((r_o² + r²)/(r_o² - r²) + nu_o) + r/E_i ((r² + r_i²)/(r² - r_i²) - nu_i)."""
    outer = 1 / 1.0 * ((1.3**2 + 1) / (1.3**2 - 1) + 0.35)
    inner = 1 / 3.0 * ((1 + 0.4**2) / (1 - 0.4**2) - 0.2)
    p = contact_pressures([SHAFT, SLEEVE], 1e-3, assumption="plane stress")
    np.testing.assert_allclose(p, 1e-3 / (outer + inner), rtol=1e-13)


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


@pytest.mark.parametrize("assumption", ASSUMPTIONS)
def test_the_walls_end_apart_by_the_interference(assumption):
    delta = np.array([1e-3, 2e-3])
    p = contact_pressures(STACK, delta, p_i=2e-4, assumption=assumption)
    p_1, p_2 = (float(v) for v in p)
    at_1 = SLEEVE.displacement(1.0, p_i=p_1, p_o=p_2, assumption=assumption)
    at_1 -= SHAFT.displacement(1.0, p_i=2e-4, p_o=p_1, assumption=assumption)
    at_2 = HUB.displacement(1.3, p_i=p_2, p_o=0.0, assumption=assumption)
    at_2 -= SLEEVE.displacement(1.3, p_i=p_1, p_o=p_2, assumption=assumption)
    np.testing.assert_allclose([at_1, at_2], delta, rtol=1e-12)


def test_one_ring_cut_in_two_carries_a_pressure_like_the_whole():
    """Without interference the cut has the radial stress of the uncut ring."""
    steel = {"E": 2.0, "nu": 0.3}
    halves = [Wall(r_i=1.0, r_o=1.5, **steel), Wall(r_i=1.5, r_o=2.0, **steel)]
    p = contact_pressures(halves, 0.0, p_i=3.0, assumption="plane strain")
    radial, _ = Wall(r_i=1.0, r_o=2.0, **steel).stresses(1.5, p_i=3.0, p_o=0.0)
    np.testing.assert_allclose(p, -radial, rtol=1e-13)


def test_a_solid_shaft_is_pressed_evenly_throughout():
    solid = Wall(r_i=0.0, r_o=1.0, E=2.0, nu=0.25)
    radial, hoop = solid.stresses([0.0, 0.5, 1.0], p_i=0.0, p_o=3.0)
    np.testing.assert_allclose([radial, hoop], -3.0, rtol=1e-15)
    u = solid.displacement([0.0, 1.0], p_i=0.0, p_o=3.0, assumption="plane stress")
    np.testing.assert_allclose(u, [0, -3.0 * 0.75 / 2.0], rtol=1e-15)  # -p (1 - nu) r/E


def test_hoop_stresses_balance_over_a_cut_through_the_assembly():
    """A press fit pulls and pushes its own cut surface by nothing in total."""
    p_1, p_2 = (float(v) for v in contact_pressures(STACK, [1e-3, 2e-3], assumption="plane stress"))
    x, w = np.polynomial.legendre.leggauss(60)
    total = 0.0
    for wall, p_i, p_o in zip(STACK, (0.0, p_1, p_2), (p_1, p_2, 0.0), strict=True):
        r = (wall.r_i + wall.r_o) / 2 + (wall.r_o - wall.r_i) / 2 * x
        total += (wall.r_o - wall.r_i) / 2 * w @ wall.stresses(r, p_i=p_i, p_o=p_o)[1]
    assert total == pytest.approx(0, abs=1e-15)


def test_pressure_in_the_bore_of_the_shaft_tightens_and_around_the_hub_too():
    pair = [SHAFT, SLEEVE]
    for load in ({"p_i": 1e-3}, {"p_o": 1e-3}):
        lost = interferences_lost(pair, **load, assumption="plane stress")
        assert float(lost[0]) < 0
    suction = {"p_o": -1e-3}  # a pull on the rim, as of a spinning or heated sleeve
    assert float(interferences_lost(pair, **suction, assumption="plane stress")[0]) > 0


@pytest.mark.parametrize("interface", [0, 1])
def test_a_contact_opens_at_its_opening_interference_and_not_above(interface):
    delta, loads = [1e-3, 2e-3], {"p_o": -3e-4, "assumption": "plane strain"}
    least = opening_interference(STACK, delta, interface=interface, **loads)
    delta[interface] = least + 1e-12
    assert abs(float(contact_pressures(STACK, delta, **loads)[interface])) < 1e-11
    delta[interface] = least - 1e-12
    with pytest.raises(ValueError, match=rf"interface {interface} \(from 0, innermost\)"):
        contact_pressures(STACK, delta, **loads)


def test_walls_that_just_touch_carry_nothing():
    p = contact_pressures(STACK, [0.0, 0.0], assumption="plane stress")
    np.testing.assert_array_equal(p, 0.0)


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_radii_may_differ_by_round_off_of_their_own_size_only(size):
    """A shared radius by 1e-6 of itself, a point by 1e-12 of the rim."""
    steel = {"E": 1.0, "nu": 0.3}
    shaft = Wall(r_i=0.0, r_o=size, **steel)
    near, far = (Wall(r_i=size * (1 + by), r_o=2 * size, **steel) for by in (9e-7, 2e-6))
    assert contact_pressures([shaft, near], 1e-3 * size, assumption="plane stress").shape == (1,)
    with pytest.raises(ValueError, match="share a nominal radius"):
        contact_pressures([shaft, far], 1e-3 * size, assumption="plane stress")
    radial, _ = shaft.stresses(size * (1 + 1e-13), p_i=0.0, p_o=1.0)
    assert float(radial) == pytest.approx(-1.0)
    with pytest.raises(ValueError, match="must lie in the wall"):
        shaft.stresses(size * (1 + 1e-11), p_i=0.0, p_o=1.0)


def test_the_message_of_an_open_contact_says_what_would_close_it():
    pair, pull = [SHAFT, SLEEVE], {"p_o": -1e-3, "assumption": "plane stress"}
    least = float(interferences_lost(pair, **pull)[0])
    assert least > 0
    with pytest.raises(ValueError, match=f"0 m must exceed {least:g} m"):
        contact_pressures(pair, 0.0, **pull)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: Wall(r_i=1.0, r_o=1.0, E=1.0, nu=0.3), "0 <= r_i < r_o"),
        (lambda: Wall(r_i=-1.0, r_o=1.0, E=1.0, nu=0.3), "0 <= r_i < r_o"),
        (lambda: Wall(r_i=0.0, r_o=np.inf, E=1.0, nu=0.3), "0 <= r_i < r_o"),
        (lambda: Wall(r_i=0.0, r_o=np.nan, E=1.0, nu=0.3), "0 <= r_i < r_o"),
        (lambda: Wall(r_i=0.0, r_o=1.0, E=np.inf, nu=0.3), "Young's modulus"),
        (lambda: Wall(r_i=0.0, r_o=1.0, E=1.0, nu=0.5), "Poisson's ratio"),
        (lambda: SHAFT.stresses(0.3, p_i=0.0, p_o=1.0), r"wall \[0.4, 1.0\] m, got 0.3 m"),
        (lambda: contact_pressures([SHAFT], [], assumption="plane stress"), "two walls"),
        (
            lambda: contact_pressures([SHAFT, HUB], 1e-3, assumption="plane stress"),
            "share a nominal radius, got r_o=1.0 m, r_i=1.3 m",
        ),
        (lambda: contact_pressures(STACK, 1e-3, assumption="plane stress"), "2 interferences"),
        (
            lambda: contact_pressures(STACK, [1e-3, np.nan], assumption="plane stress"),
            "interferences must be finite",
        ),
        (
            lambda: contact_pressures(STACK, [0, 0], p_i=np.inf, assumption="plane stress"),
            "pressures must be finite",
        ),
        (lambda: contact_pressures(STACK, [0, 0], assumption="closed"), "assumption is one of"),
        (
            lambda: opening_interference(
                STACK, [0, 0], interface=2, assumption="plane stress"
            ),
            "interface must be 0 to 1",
        ),
    ],
)  # fmt: skip
def test_input_that_makes_no_sense_is_refused(call, message):
    with pytest.raises(ValueError, match=message):
        call()


@pytest.mark.parametrize("assumption", ASSUMPTIONS)
def test_the_strain_energy_is_the_work_of_the_interference(assumption):
    """Without other loads both walls together store pi r p delta."""
    walls = [SHAFT, SLEEVE]
    p = float(contact_pressures(walls, 1e-3, assumption=assumption)[0])
    stored = SHAFT.strain_energy(p_i=0.0, p_o=p, assumption=assumption)
    stored += SLEEVE.strain_energy(p_i=p, p_o=0.0, assumption=assumption)
    assert stored == pytest.approx(np.pi * 1.0 * p * 1e-3, rel=1e-12)


def test_the_strain_energy_is_that_of_the_stresses():
    r, weight = np.polynomial.legendre.leggauss(40)
    r, weight = 0.7 + 0.3 * r, 0.3 * weight
    radial, hoop = SHAFT.stresses(r, p_i=2.0, p_o=5.0)
    density = (radial**2 + hoop**2 - 2 * 0.2 * radial * hoop) / (2 * 3.0)
    stored = SHAFT.strain_energy(p_i=2.0, p_o=5.0, assumption="plane stress")
    assert stored == pytest.approx(2 * np.pi * weight @ (density * r), rel=1e-12)


@pytest.mark.parametrize("assumption", ASSUMPTIONS)
def test_walls_that_overlap_carry_the_pressure_of_one_radius_in_the_limit(assumption):
    loads = {"assumption": assumption}

    def difference(overlap):
        hub = Wall(r_i=1.0 - overlap, r_o=1.3, E=1.0, nu=0.35)
        p = pressure_of_overlap(SHAFT, hub, **loads)
        return p / float(contact_pressures([SHAFT, SLEEVE], overlap, **loads)[0]) - 1

    assert difference(1e-3) == pytest.approx(10 * difference(1e-4), rel=0.02)
    assert 0 < abs(difference(1e-3)) < 0.02


def test_walls_that_overlap_end_at_one_radius():
    hub = Wall(r_i=0.98, r_o=1.3, E=1.0, nu=0.35)
    p = pressure_of_overlap(SHAFT, hub, p_i=0.02, assumption="plane strain")
    rim = SHAFT.displacement(1.0, p_i=0.02, p_o=p, assumption="plane strain")
    bore = hub.displacement(0.98, p_i=p / 0.98, p_o=0.0, assumption="plane strain")
    assert 1.0 + rim == pytest.approx(0.98 + bore, rel=1e-14)


@pytest.mark.parametrize(
    ("bore", "p_o", "message"),
    [(1.0, 0.0, "must overlap"), (0.5, 0.0, "less than a tenth"), (0.999, -9.0, "come apart")],
)
def test_walls_that_do_not_press_on_each_other_are_refused(bore, p_o, message):
    hub = Wall(r_i=bore, r_o=1.3, E=1.0, nu=0.35)
    with pytest.raises(ValueError, match=message):
        pressure_of_overlap(SHAFT, hub, p_o=p_o, assumption="plane stress")
