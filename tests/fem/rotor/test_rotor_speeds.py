"""Campbell diagrams and critical speeds: branches that cross, speeds by both methods."""

import numpy as np
import pytest

from fem.rotor.campbell import campbell
from fem.rotor.critical import critical_speeds
from fem.rotor.model import Disc, Element, Link, Material, Rotor, Shaft, SpeedSupport, Support
from fem.rotor.modes import modes

E, NU = 210e9, 0.3
STEEL = Material(E=E, nu=NU, rho=7850.0)
LIGHT = Material(E=E, nu=NU)
ELS = [Element(0.1, 0.03, material=STEEL)] * 8
DISCS = [Disc(2, 5.0, 0.2, 0.1), Disc(5, 8.0, 0.4, 0.2)]
ISOTROPIC = Rotor([Shaft(ELS)], DISCS, [Support(0, 1e7), Support(8, 2e7)])
UNLIKE = Rotor([Shaft(ELS)], DISCS, [Support(0, 1e7, 2e7), Support(8, 2e7, 3e7)])
TWIN = Rotor(
    [Shaft(ELS), Shaft([Element(0.1, 0.06, 0.045, STEEL)] * 4, ratio=-1.4, z=0.2)],
    [*DISCS, Disc(10, 3.0, 0.05, 0.03)], [Support(0, 1e7), Support(8, 2e7), Support(9, 1e7)],
    [Link.bearing(6, 13, 5e6, k_tilt=300.0)],
)  # fmt: skip


def test_rising_and_falling_branches_cross():
    """Two weakly coupled shafts: by frequencies alone branches would be confused."""
    count, els = 9, [Element(0.25, 0.03, material=LIGHT)] * 4
    rotor = Rotor(
        [Shaft(els), Shaft(els)], [Disc(2, 20.0, 0.4, 0.3), Disc(7, 30.0, 0.3, 0.2)],
        [Support(n, 5e7, 6e7) for n in (0, 4, 5, 9)], [Link.bearing(1, 6, 1.0)],
    )  # fmt: skip
    single = [
        Rotor([Shaft(els)], [disc], [Support(n, 5e7, 6e7) for n in (0, 4)])
        for disc in (Disc(2, 20.0, 0.4, 0.3), Disc(2, 30.0, 0.3, 0.2))
    ]
    speeds = np.linspace(0, 500, count)
    found = campbell(rotor, speeds, 8).frequencies
    alone = np.concatenate([campbell(own, speeds, 4).frequencies for own in single], axis=1)
    assert (np.diff(np.argsort(alone, axis=1), axis=0) != 0).any()  # they do cross
    for branch in alone.T:
        assert abs(found - branch[:, None]).max(axis=0).min() < 1e-4 * branch.max()


@pytest.mark.parametrize(("rotor", "excitation"), [(ISOTROPIC, 2.0), (UNLIKE, 1.0), (TWIN, -1.4)])
def test_critical_speeds_are_where_a_frequency_meets_the_excitation(rotor, excitation):
    found = critical_speeds(rotor, 5, "both", excitation)
    assert found.speeds.size == 5
    for speed, sense in zip(found.speeds, found.whirl, strict=True):
        own = modes(rotor, speed, 20)
        k = np.argmin(abs(own.frequencies - abs(excitation) * speed))
        assert own.frequencies[k] == pytest.approx(abs(excitation) * speed, rel=1e-9)
        assert own.whirl[k] == sense
    crossings = campbell(rotor, np.linspace(0, 1.1 * found.speeds[-1], 160), 12).crossings(
        excitation
    )
    for speed in found.speeds:
        assert abs(crossings - speed).min() < 2e-5 * speed


def test_a_thin_overhung_disc_has_no_second_forward_critical_speed():
    """Stodola: with Ip > Id the equation in W^2 has one positive root; backwards it has two."""
    L, d, m, Ip, Id = 0.4, 0.03, 6.0, 0.12, 0.06
    clamp = Support(0, 1e14, k_tilt=1e13)
    rotor = Rotor(
        [Shaft([Element(L, d, material=LIGHT)])], [Disc(1, m, Ip, Id)], [clamp], theory="rayleigh"
    )  # fmt: skip
    stiff = E * np.pi * d**4 / 64
    K = stiff * np.array([[12 / L**3, -6 / L**2], [-6 / L**2, 4 / L]])
    for whirl, inertia in (("forward", Id - Ip), ("backward", Id + Ip)):
        squares = np.linalg.eigvals(np.linalg.solve(np.diag([m, inertia]), K)).real
        expected = np.sqrt(np.sort(squares[squares > 0]))
        found = critical_speeds(rotor, 3, whirl).speeds
        assert found.size == expected.size == (1 if whirl == "forward" else 2)
        np.testing.assert_allclose(found, expected, rtol=1e-6)


def test_supports_that_stiffen_with_the_speed():
    def at(speed):
        return Support(0, 1e6 + 20.0 * speed**2)

    rigid = Material(E=1e17, nu=NU)
    rotor = Rotor(
        [Shaft([Element(0.4, 0.1, material=rigid)] * 2)], [Disc(1, 20.0, 0.5, 0.5)],
        [SpeedSupport(0, at), SpeedSupport(2, at)],
    )  # fmt: skip
    for speed in (0.0, 300.0):
        k = 1e6 + 20.0 * speed**2
        w = modes(rotor, speed, 4).frequencies
        assert abs(w - np.sqrt(2 * k / 20.0)).min() < 1e-5 * w[0]
    found = campbell(rotor, np.linspace(0, 2000, 81), 4)
    # 2 (1e6 + 20 W^2) = 20 W^2 has no root: it runs away; at rest sqrt(1e5)
    assert found.frequencies[0, 0] == pytest.approx(np.sqrt(1e5), rel=1e-5)
    with pytest.raises(ValueError, match="depend on the speed"):
        critical_speeds(rotor)
