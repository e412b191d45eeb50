"""Exact transfer matrices of one shaft against closed forms."""

import numpy as np
import pytest
from scipy.linalg import expm

from analytic.rotor.shafts import UniformShaft, hutchinson
from analytic.rotor.transfer_model import (
    Segment,
    SegmentedShaft,
    StationDisc,
    StationSupport,
    TransferMatrixRotor,
)
from analytic.rotor.transfer_modes import modes, transfer_critical_speeds, whirl_frequencies
from analytic.rotor.transfer_segment import transfer
from analytic.rotor.transfer_shapes import mode_lines

E, NU, RHO = 210e9, 0.3, 7850.0
RIGID = 1e12  # N/m, of bearings whose compliance is then taken out


def shaft(*, L=1.0, d=0.1, n=1, E=E, rho=RHO, ratio=1.0):
    piece = Segment(length=L / n, d_o=d, E=E, nu=NU, rho=rho)
    return SegmentedShaft(segments=(piece,) * n, ratio=ratio)


def supported(theory="timoshenko", *, n=1, d=0.1, k=1e8, kyy=None):
    ends = tuple(StationSupport(node=node, kxx=k, kyy=kyy) for node in (0, n))
    return TransferMatrixRotor(shafts=(shaft(n=n, d=d),), supports=ends, theory=theory)


def on_rigid(value):
    """What `value(k)` of a stiffness k goes to: its error falls with 1/k."""
    return (value(RIGID) - 6 * value(2 * RIGID) + 8 * value(4 * RIGID)) / 3


@pytest.mark.parametrize("theory", ["euler", "rayleigh", "timoshenko"])
@pytest.mark.parametrize("whirl", ["forward", "backward"])
def test_turning_simply_supported_shafts_have_their_closed_form(theory, whirl):
    simple = UniformShaft(
        L=1.0, d_o=0.1, d_i=0.0, E=E, nu=NU, rho=RHO, kappa=hutchinson(nu=NU, m=0.0)
    )
    speeds = [0.0, 3000.0]
    found = on_rigid(
        lambda k: whirl_frequencies(supported(theory, k=k), speeds, count=4, whirl=whirl)
    )
    for speed, row in zip(speeds, found, strict=True):
        both = [simple.whirl(j, Omega=speed, theory=theory) for j in (1, 2, 3, 4)]
        assert row == pytest.approx([pair[whirl == "backward"] for pair in both], rel=1e-8)


@pytest.mark.parametrize("Ip", [0.0, 0.05, 0.2])
def test_an_overhung_disc_has_stodola_s_critical_speeds(Ip):
    L, d, m, Id = 0.4, 0.03, 10.0, 0.1
    rotor = TransferMatrixRotor(
        shafts=(shaft(L=L, d=d, rho=1e-3),),
        discs=(StationDisc(node=1, mass=m, polar=Ip, diametral=Id),),
        supports=(StationSupport(node=0, kxx=1e12, k_tilt=1e12),), theory="euler",
    )  # fmt: skip
    EI = E * np.pi * d**4 / 64
    # det(K - W² diag(m, Id - Ip)) = 0, K = EI/L³ (12, -6L; -6L, 4L²)
    net = Id - Ip
    squares = np.roots([m * net, -EI / L**3 * (12 * net + 4 * L**2 * m), 12 * (EI / L**2) ** 2])
    exact = np.sort(np.sqrt(squares[squares > 0]))
    assert len(exact) == (1 if Ip > Id else 2)  # Stodola: a thin disc has one only
    found = transfer_critical_speeds(rotor, count=2, whirl="forward").w
    assert found[: len(exact)] == pytest.approx(exact, rel=1e-6)
    assert len(exact) == 2 or len(found) == 1 or found[1] > 100 * exact[0]


def test_a_top_on_unlike_springs_has_its_closed_form_and_sense():
    kx, ky, L, Id, Ip, Omega = 2e4, 1e4, 0.5, 0.4, 0.7, 60.0
    rotor = TransferMatrixRotor(
        shafts=(shaft(L=L, n=2, E=E * 1e3, rho=1e-6),),
        discs=(StationDisc(node=1, mass=1e-3, polar=Ip, diametral=Id),),
        supports=tuple(StationSupport(node=n, kxx=kx, kyy=ky) for n in (0, 2)),
    )
    tx, ty = kx * L**2 / 2, ky * L**2 / 2
    squares = np.roots([Id**2, -(Id * (tx + ty) + (Ip * Omega) ** 2), tx * ty])
    found = modes(rotor, Omega, count=2)
    assert found.w == pytest.approx(np.sort(np.sqrt(squares)), rel=1e-6)
    assert list(found.whirl) == [-1, 1]


def test_a_mode_is_carried_into_the_segments():
    found = modes(supported(d=0.05, k=1e13), 400.0, count=3)
    for k, half_waves in ((0, 1), (2, 2)):
        (line,) = mode_lines(found, k, points=11)
        assert len(line.z) % 11 == 0  # eleven to a piece
        r = line.plus + line.minus
        sine = np.sin(half_waves * np.pi * line.z)
        fitted = (r.real * sine).sum() / (sine**2).sum()  # places do not meet every peak
        assert r.real == pytest.approx(fitted * sine, abs=1e-4)
        assert abs(fitted) == pytest.approx(1, abs=5e-3)
        assert abs(r.imag).max() < 1e-9


@pytest.mark.parametrize("at", [0.3, 1.0])
def test_the_transfer_matrix_is_the_exponential_of_the_state_s_equation(at):
    s, b, t = 0.3, 9.0, -1.2
    A = np.array([[0, 1, s, 0], [0, 0, 0, 1], [-b, 0, 0, 0], [0, -t, -1, 0]])  # r, phi, Q, M
    assert transfer(s=s, b=b, t=t, at=at) == pytest.approx(expm(A * at), rel=1e-12, abs=1e-12)
