"""Exact transfer matrices of one shaft against closed forms."""

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.optimize import brentq

from analytic.rotor.transfer_bending import Bending, numbers
from analytic.rotor.transfer_model import Disc, Rotor, Segment, Shaft, Support
from analytic.rotor.transfer_modes import (
    critical_speeds,
    modes,
    natural_frequencies,
    whirl_frequencies,
)
from analytic.rotor.transfer_roots import count_below, roots_below
from analytic.rotor.transfer_segment import dynamic_stiffness, pieces, transfer
from analytic.rotor.transfer_shapes import mode_lines

E, NU, RHO = 210e9, 0.3, 7850.0
RIGID = 1e12  # N/m, of bearings whose compliance is then taken out


def shaft(*, L=1.0, d=0.1, n=1, E=E, rho=RHO, ratio=1.0):
    piece = Segment(length=L / n, d_o=d, E=E, nu=NU, rho=rho)
    return Shaft(segments=(piece,) * n, ratio=ratio)


def supported(theory="timoshenko", *, n=1, d=0.1, k=1e8, kyy=None):
    ends = tuple(Support(node=node, kxx=k, kyy=kyy) for node in (0, n))
    return Rotor(shafts=(shaft(n=n, d=d),), supports=ends, theory=theory)


def on_rigid(value):
    """What `value(k)` of a stiffness k goes to: its error falls with 1/k."""
    return (value(RIGID) - 6 * value(2 * RIGID) + 8 * value(4 * RIGID)) / 3


@pytest.mark.parametrize("at", [0.3, 1.0])
def test_the_transfer_matrix_is_the_exponential_of_the_state_s_equation(at):
    s, b, t = 0.3, 9.0, -1.2
    A = np.array([[0, 1, s, 0], [0, 0, 0, 1], [-b, 0, 0, 0], [0, -t, -1, 0]])  # r, phi, Q, M
    assert transfer(s=s, b=b, t=t, at=at) == pytest.approx(expm(A * at), rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("s", [0.0, 0.4])
def test_at_rest_the_stiffness_is_timoshenko_s(s):
    f = 12 * s  # Przemieniecki: 12, 6, 4 + f, 2 - f over 1 + f
    D = dynamic_stiffness(s=s, b=0.0, t=0.0) * (1 + f)
    known = [[12, 6, -12, 6], [6, 4 + f, -6, 2 - f], [-12, -6, 12, -6], [6, 2 - f, -6, 4 + f]]
    assert pytest.approx(np.array(known), rel=1e-13) == D


@pytest.mark.parametrize(("s", "t"), [(0.0, 0.0), (0.02, 0.5), (0.3, 4.0), (0.05, -5.0)])
@pytest.mark.parametrize("b", [1.0, 40.0, 900.0, 2e4])
def test_pieces_have_no_clamped_root_below(s, b, t):
    n = int(pieces(s=s, b=b, t=t))
    share = np.linspace(1e-3, 1.0, 200)  # of omega: b, t grow with its square at most
    T = transfer(s=s * n**2, b=share**2 * b / n**4, t=max(t, 0.0) * share**2 / n**2)
    assert (np.linalg.det(T[:, :2, 2:]) > 0).all()  # of r, phi over Q, M: 1/12 + s at rest


def closed_form(j, Omega, whirl, theory, d=0.1, L=1.0):
    """Root of the frequency equation of simply supported turning shafts."""
    k, A, Iy = j * np.pi / L, np.pi * d**2 / 4, np.pi * d**4 / 64
    kappa = 6 * (1 + NU) ** 2 / (7 + 12 * NU + 4 * NU**2)  # Hutchinson, solid
    S = np.inf if theory != "timoshenko" else kappa * E / 2 / (1 + NU) * A
    rotary = 0.0 if theory == "euler" else RHO * Iy
    sign = 1 if whirl == "forward" else -1

    def residual(w):
        tau = rotary * (w**2 - 2 * sign * Omega * w)
        # r = a sin kz, phi = b cos kz: k S (k a - b) = rho A w² a, E I k² b - S (k a - b) = tau b
        shear = RHO * A * w**2 / k  # S (k - b/a)
        b = k - shear / S
        return E * Iy * k**2 * b - shear - tau * b

    return brentq(residual, 1e-3, 1.2 * k**2 * np.sqrt(E * Iy / RHO / A) + 2 * Omega, xtol=1e-9)


@pytest.mark.parametrize("theory", ["euler", "rayleigh", "timoshenko"])
@pytest.mark.parametrize("whirl", ["forward", "backward"])
def test_turning_simply_supported_shafts_have_their_closed_form(theory, whirl):
    Omega = 3000.0
    found = on_rigid(
        lambda k: whirl_frequencies(supported(theory, k=k), [0.0, Omega], count=4, whirl=whirl)
    )
    for speed, row in zip((0.0, Omega), found, strict=True):
        exact = [closed_form(j, speed, whirl, theory) for j in (1, 2, 3, 4)]
        assert row == pytest.approx(exact, rel=1e-8)


def test_forward_whirl_is_the_faster_one():
    forward, backward = (
        whirl_frequencies(supported(), 2000.0, whirl=w) for w in ("forward", "backward")
    )
    assert (forward > backward * 1.001).all()


def test_ten_bending_frequencies_of_a_slender_shaft_are_all_there():
    w = on_rigid(lambda k: whirl_frequencies(supported("euler", d=0.02, k=k), 0.0, count=10)[0])
    base = np.pi**2 * np.sqrt(E / RHO) * 0.02 / 4
    assert w == pytest.approx(base * np.arange(1, 11) ** 2, rel=1e-8)


def test_roots_of_two_equal_shafts_come_twice():
    ends = tuple(Support(node=k, kxx=1e8) for k in range(4))
    twice = Rotor(shafts=(shaft(), shaft()), supports=ends)
    once = whirl_frequencies(supported(k=1e8), 500.0, count=3)[0]
    assert whirl_frequencies(twice, 500.0, count=6)[0] == pytest.approx(np.repeat(once, 2))


def test_more_stations_change_nothing():
    one, many = supported(k=1e8), supported(k=1e8, n=7)
    assert whirl_frequencies(many, 900.0, count=5)[0] == pytest.approx(
        whirl_frequencies(one, 900.0, count=5)[0], rel=1e-10
    )


def test_the_count_rises_by_one_at_each_root():
    rotor = supported(k=1e8)
    roots = whirl_frequencies(rotor, 700.0, count=4)[0]
    bending = Bending.up_to(rotor, 1.01 * roots[-1], 700.0)
    for k, root in enumerate(roots):
        below, above = bending.stiffness(root * np.array([1 - 1e-9, 1 + 1e-9]), [700.0] * 2)
        assert (count_below(below), count_below(above)) == (k, k + 1)


def test_a_cantilever_has_the_roots_of_its_transcendental_equation():
    def found(k):
        built_in = Support(node=0, kxx=k, k_tilt=k)
        slender = Rotor(shafts=(shaft(d=0.02),), supports=(built_in,), theory="euler")
        return whirl_frequencies(slender, 0.0)[0]

    base = np.sqrt(E / RHO) * 0.02 / 4
    beta = [brentq(lambda x: np.cos(x) * np.cosh(x) + 1, *b) for b in ((1, 3), (4, 5), (7, 8))]
    assert on_rigid(found) / base == pytest.approx(np.square(beta), rel=1e-7)


def test_jeffcott_s_rotor_has_its_closed_form():
    light = shaft(n=2, rho=1e-6, d=0.05)
    rotor = Rotor(
        shafts=(light,), discs=(Disc(node=1, mass=20.0, polar=0.0, diametral=0.0),),
        supports=(Support(node=0, kxx=2e6), Support(node=2, kxx=2e6)), theory="euler",
    )  # fmt: skip
    k = 1 / (1 / 4e6 + 1 / (48 * E * np.pi * 0.05**4 / 64))
    assert whirl_frequencies(rotor, 0.0, count=1)[0, 0] == pytest.approx(np.sqrt(k / 20), rel=1e-8)
    assert critical_speeds(rotor, count=1).w[0] == pytest.approx(np.sqrt(k / 20), rel=1e-8)


def test_a_rigid_rotor_on_springs_shifts_and_tilts_as_a_top():
    k, L, m, Id, Ip, Omega = 1e4, 0.5, 30.0, 0.4, 0.7, 150.0
    rotor = Rotor(
        shafts=(shaft(L=L, n=2, E=E * 1e3, rho=1e-6),),
        discs=(Disc(node=1, mass=m, polar=Ip, diametral=Id),),
        supports=(Support(node=0, kxx=k), Support(node=2, kxx=k)),
    )
    tilt = k * L**2 / 2
    for sign, whirl in ((1, "forward"), (-1, "backward")):
        top = (sign * Ip * Omega + np.sqrt((Ip * Omega) ** 2 + 4 * Id * tilt)) / (2 * Id)
        exact = sorted([np.sqrt(2 * k / m), top])
        found = whirl_frequencies(rotor, Omega, count=2, whirl=whirl)[0]
        assert found == pytest.approx(exact, rel=1e-6)


@pytest.mark.parametrize("Ip", [0.0, 0.05, 0.2])
def test_an_overhung_disc_has_stodola_s_critical_speeds(Ip):
    L, d, m, Id = 0.4, 0.03, 10.0, 0.1
    rotor = Rotor(
        shafts=(shaft(L=L, d=d, rho=1e-3),),
        discs=(Disc(node=1, mass=m, polar=Ip, diametral=Id),),
        supports=(Support(node=0, kxx=1e12, k_tilt=1e12),), theory="euler",
    )  # fmt: skip
    EI = E * np.pi * d**4 / 64
    # det(K - W² diag(m, Id - Ip)) = 0, K = EI/L³ (12, -6L; -6L, 4L²)
    net = Id - Ip
    squares = np.roots([m * net, -EI / L**3 * (12 * net + 4 * L**2 * m), 12 * (EI / L**2) ** 2])
    exact = np.sort(np.sqrt(squares[squares > 0]))
    assert len(exact) == (1 if Ip > Id else 2)  # Stodola: a thin disc has one only
    found = critical_speeds(rotor, count=2, whirl="forward").w
    assert found[: len(exact)] == pytest.approx(exact, rel=1e-6)
    assert len(exact) == 2 or len(found) == 1 or found[1] > 100 * exact[0]


def test_critical_speeds_meet_the_campbell_diagram():
    rotor = supported(k=5e7, d=0.08)
    for whirl in ("forward", "backward"):
        found = critical_speeds(rotor, count=2, whirl=whirl, excitation=2.0)
        for k, speed in enumerate(found.speeds):
            w = whirl_frequencies(rotor, speed, count=2, whirl=whirl)[0, k]
            assert w == pytest.approx(2 * speed, rel=1e-9)


def test_bearings_that_differ_split_a_shaft_at_rest_into_two_planes():
    x, y = (natural_frequencies(supported(k=k), 0.0, count=4)[0, ::2] for k in (1e8, 3e7))
    found = modes(supported(k=1e8, kyy=3e7), 0.0, count=4)
    assert found.w == pytest.approx(np.sort(np.concatenate([x, y])), rel=1e-9)
    assert list(found.whirl) == [0, 0, 0, 0]


def test_a_top_on_unlike_springs_has_its_closed_form_and_sense():
    kx, ky, L, Id, Ip, Omega = 2e4, 1e4, 0.5, 0.4, 0.7, 60.0
    rotor = Rotor(
        shafts=(shaft(L=L, n=2, E=E * 1e3, rho=1e-6),),
        discs=(Disc(node=1, mass=1e-3, polar=Ip, diametral=Id),),
        supports=tuple(Support(node=n, kxx=kx, kyy=ky) for n in (0, 2)),
    )
    tx, ty = kx * L**2 / 2, ky * L**2 / 2
    squares = np.roots([Id**2, -(Id * (tx + ty) + (Ip * Omega) ** 2), tx * ty])
    found = modes(rotor, Omega, count=2)
    assert found.w == pytest.approx(np.sort(np.sqrt(squares)), rel=1e-6)
    assert list(found.whirl) == [-1, 1]


def test_coupling_of_x_and_y_turns_the_axes_of_a_bearing():
    kx, ky, angle = 1e8, 3e7, 0.7
    c, s = np.cos(angle), np.sin(angle)
    turned = Support(
        node=0, kxx=kx * c**2 + ky * s**2, kyy=kx * s**2 + ky * c**2, kxy=(kx - ky) * c * s
    )
    rotor = Rotor(shafts=(shaft(),), supports=(turned, Support(node=1, kxx=1e8)))
    plain = Rotor(
        shafts=(shaft(),), supports=(Support(node=0, kxx=kx, kyy=ky), Support(node=1, kxx=1e8))
    )
    assert natural_frequencies(rotor, 800.0) == pytest.approx(natural_frequencies(plain, 800.0))


def test_unlike_bearings_become_alike_in_the_limit():
    alike, unlike = supported(k=1e8), supported(k=1e8, kyy=1e8 * (1 + 1e-9))
    one, other = modes(alike, 1500.0), modes(unlike, 1500.0)
    assert other.w == pytest.approx(one.w, rel=1e-8)
    assert list(other.whirl) == list(one.whirl)


def test_a_mode_is_carried_into_the_segments():
    found = modes(supported(d=0.05, k=1e13), 400.0, count=3)
    for k, half_waves in ((0, 1), (2, 2)):
        (line,) = mode_lines(found, k, points=11)
        r = line.plus + line.minus
        sine = np.sin(half_waves * np.pi * line.z)
        fitted = (r.real * sine).sum() / (sine**2).sum()  # places do not meet every peak
        assert r.real == pytest.approx(fitted * sine, abs=1e-4)
        assert abs(fitted) == pytest.approx(1, abs=5e-3)
        assert abs(r.imag).max() < 1e-9


@pytest.mark.parametrize("kyy", [None, 3e7])
def test_the_largest_unknown_of_a_mode_of_one_sense_is_1(kyy):
    found = modes(supported(kyy=kyy), 0.0 if kyy else 400.0, count=3)
    sizes = np.abs(found.unknowns).max(axis=1)
    assert sizes[found.whirl != 0] == pytest.approx(1, rel=1e-12)
    assert np.all(sizes <= 1 + 1e-12)


def test_items_without_the_roots_that_are_asked_for_have_none():
    """A spring of 4 N/m under 1 kg: one root at 2 rad/s, above what is searched or below it."""

    def stiffness(w, _item):
        return (4 - w**2)[:, None, None] * np.eye(1)

    none = roots_below(stiffness, np.array([1.0, 1.5]), np.arange(1))
    assert none.shape == (2, 1)
    assert np.isnan(none).all()
    stiff = roots_below(lambda w, _: np.ones_like(w)[:, None, None] * np.eye(3), np.ones(2),
                        np.arange(3))  # fmt: skip
    assert stiff.shape == (2, 3)
    one = roots_below(stiffness, np.array([1.0, 3.0]), np.arange(1))
    assert np.isnan(one[0, 0])
    assert one[1, 0] == pytest.approx(2, rel=1e-12)


def test_the_unit_of_length_is_free():
    """Millimetres, tonnes and newtons, MPa: the same frequencies."""
    mm = Rotor(
        shafts=(Shaft(segments=(Segment(length=1000.0, d_o=100.0, E=E * 1e-6, rho=RHO * 1e-12),)),),
        discs=(Disc(node=1, mass=0.01, polar=40.0, diametral=25.0),),
        supports=(Support(node=0, kxx=1e5), Support(node=1, kxx=1e5, k_tilt=1e9)),
    )
    m = Rotor(
        shafts=(shaft(),), discs=(Disc(node=1, mass=10.0, polar=0.04, diametral=0.025),),
        supports=(Support(node=0, kxx=1e8), Support(node=1, kxx=1e8, k_tilt=1e6)),
    )  # fmt: skip
    assert natural_frequencies(mm, 300.0) == pytest.approx(natural_frequencies(m, 300.0), rel=1e-9)
    assert numbers(mm, 50.0, 300.0)[1] == pytest.approx(numbers(m, 50.0, 300.0)[1], rel=1e-12)
