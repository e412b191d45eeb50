"""Wrong input is refused in one line that says what, where and in which unit."""

import numpy as np
import pytest

from fem.rotor.campbell import campbell
from fem.rotor.critical import critical_speeds
from fem.rotor.damping import Modal, Rayleigh
from fem.rotor.model import Disc, Element, Link, Material, Rotor, Shaft, Support
from fem.rotor.modes import modes
from fem.rotor.response import forced_response, unbalance_response

SHAFT = Shaft([Element(0.1, 0.03)] * 4)
HELD = [Support(0, 1e7), Support(4, 1e7)]
GOOD = Rotor([SHAFT], [Disc(2, 5.0, 0.1, 0.06)], HELD)
TWO = [SHAFT, Shaft([Element(0.1, 0.08, 0.06)] * 2, ratio=2.0)]


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Element(0.0, 0.03), "length > 0, got 0 m"),
        (lambda: Element(0.1, 0.03, 0.03), "0 <= d_i < d_o, got d_i=0.03 m, d_o=0.03 m"),
        (lambda: Element(0.1, 0.03, shear=0.0), "shear coefficient must be positive"),
        (lambda: Material(E=-1.0), "Young's modulus must be positive, got E=-1 Pa"),
        (lambda: Material(E=1.0, nu=0.6), "Poisson's ratio"),
        (lambda: Material(E=1.0, rho=-1.0), "a density is not negative, got rho=-1 kg/m"),
        (lambda: Disc.cylinder(0, 0.1, 0.2, 0.05, 7800.0), "0 <= d_i < d_o"),
        (lambda: Shaft([]), "at least one element"),
        (lambda: Shaft(SHAFT.elements, ratio=float("inf")), "ratio and z are finite"),
        (lambda: Disc(0, -1.0), "a disc's mass is not negative, got -1 kg"),
        (lambda: Support(0, -1e6), "a support's kxx is not negative, got -1e\\+06"),
        (lambda: Support(0, 1e6, kxy=float("nan")), "finite"),
        (lambda: Link(1, 1, np.eye(6)), "joins two nodes, got node 1 twice"),
        (lambda: Link(0, 1, np.eye(5)), r"\(6, 6\)"),
        (lambda: Link(0, 1, -np.eye(6)), "no negative diagonal, got -1"),
        (lambda: Rotor([]), "at least one shaft"),
        (lambda: Rotor([SHAFT], theory="vlasov"), "timoshenko, rayleigh, euler, got 'vlasov'"),
        (lambda: Rotor([SHAFT], refine=0), "refine is a whole number >= 1"),
        (lambda: Rotor([SHAFT], [Disc(5, 1.0)]), "a disc is at node 5, but nodes are 0 to 4"),
        (lambda: Rotor([SHAFT], links=[Link(0, 9, np.eye(6))]), "a link is at node 9"),
        (
            lambda: Rotor([SHAFT], [Disc(1, 1, width=0.12), Disc(2, 1, width=0.1)]),
            r"discs at nodes 1 and 2 overlap by 0.01 m",
        ),
        (lambda: Rayleigh(-1.0, 0.0), "Rayleigh damping is not negative"),
        (lambda: Rayleigh.at((100.0, 0.01), (100.0, 0.02)), "two different frequencies"),
        (lambda: Modal([]), "damping ratios"),
        (lambda: modes(GOOD, count=0), "at least one mode"),
        (lambda: modes(GOOD, plane="up"), "a plane is one of bending, torsion, axial, all"),
        (lambda: modes(GOOD, float("nan")), "finite numbers in rad/s"),
        (lambda: campbell(GOOD, [0.0, 2.0, 1.0]), "rise"),
        (lambda: critical_speeds(GOOD, whirl="up"), "forward, backward, both, got 'up'"),
        (lambda: critical_speeds(GOOD, excitation=0.0), "a ratio other than 0"),
        (lambda: critical_speeds(Rotor([SHAFT])), "it can move rigidly across its axis"),
        (lambda: critical_speeds(Rotor(TWO, supports=HELD)), "not supported"),
        (lambda: unbalance_response(GOOD, [1.0], {}), "needs an unbalance"),
        (lambda: unbalance_response(GOOD, [1.0], {7: 1e-4}), "node 7, but nodes are 0 to 4"),
        (lambda: unbalance_response(GOOD, [1.0], {2: float("nan")}), "not finite"),
        (lambda: unbalance_response(Rotor([SHAFT]), [1.0], {2: 1e-4}), "not supported"),
        (lambda: forced_response(GOOD, 1.0, 1.0, np.ones(3)), "forces have 30 unknowns, got 3"),
        (lambda: unbalance_response(GOOD, [1.0], {2: 1e-4}).at(5), "no node 5: they are 0 to 4"),
        (
            lambda: unbalance_response(GOOD, [1.0], {2: 1e-4}).support_load(2),
            "no support 2: they are 0 to 1",
        ),
    ],
)  # fmt: skip
def test_one_line_says_what_is_wrong(make, said):
    with pytest.raises(ValueError, match=said) as caught:
        make()
    assert "\n" not in str(caught.value)


def test_a_static_torque_on_a_rotor_that_may_turn_has_no_bounded_answer():
    torque = np.zeros(12)
    torque[5] = 10.0
    rotor = Rotor([Shaft([Element(0.5, 0.02)])], supports=[Support(0, 1e6), Support(1, 1e6)])
    with pytest.raises(ArithmeticError, match="no bounded response"):
        forced_response(rotor, 100.0, 0.0, torque)
    light = Element(0.5, 0.02, material=Material(E=210e9, nu=0.3))
    with pytest.raises(ArithmeticError, match="without mass are left free"):
        modes(Rotor([Shaft([light])], [Disc(0, 1.0, 0.1, 0.1)]), 10.0)
