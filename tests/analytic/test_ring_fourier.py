"""The Fourier ring against statics, Lamé, thin rings and discs."""

import numpy as np
import pytest

from analytic.contact.disc_series import approach
from analytic.ring import lame
from analytic.ring.fourier_ring import FourierRing
from analytic.ring.loaded_race import LoadedRace

STEEL = {"E": 206e9, "nu": 0.3, "assumption": "plane stress"}
UNIT = {"E": 1.0, "nu": 0.3, "assumption": "plane strain"}
WAVES = np.array([1.0, -0.4, 0.7, 0.2, -0.1])


def waves(n, theta):
    return WAVES @ np.cos(np.outer(np.arange(WAVES.size), n * np.asarray(theta)))


@pytest.mark.parametrize("loaded", ["bore", "rim"])
@pytest.mark.parametrize("ratio", [1.02, 1.35, 4.0, 1e3])
@pytest.mark.parametrize("n", [2, 3, 12, 100_000])
def test_walls_carry_the_pressure_and_nothing_else(loaded, ratio, n):
    ring = FourierRing(r_i=1.0, r_o=ratio, loaded=loaded, n=n, p=WAVES, **UNIT)
    theta = np.linspace(0, 2.2 / n, 9)
    bore, rim = ring.at(1.0, theta), ring.at(ratio, theta)
    near, far = (bore, rim) if loaded == "bore" else (rim, bore)
    size = np.abs(bore.sigma_theta).max() + np.abs(rim.sigma_theta).max()
    exact = {"rtol": 0, "atol": 1e-13 * size * (ratio / (ratio - 1)) ** 1.5}
    np.testing.assert_allclose(near.sigma_r, -waves(n, theta), **exact)
    np.testing.assert_allclose([near.tau, far.sigma_r, far.tau], 0.0, **exact)


@pytest.mark.parametrize("loaded", ["bore", "rim"])
@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_the_field_is_in_equilibrium_and_obeys_hooke(loaded, assumption):
    ring = FourierRing(
        r_i=1.0, r_o=1.5, loaded=loaded, n=3, p=WAVES, E=1.0, nu=0.3, assumption=assumption
    )
    r, t, h = 1.2, 0.37, 1e-5
    E, nu = (1.0, 0.3) if assumption == "plane stress" else (1 / 0.91, 0.3 / 0.7)
    here = ring.at(r, t)

    def across(name):
        high, low = (getattr(ring.at(r + k, t), name) for k in (h, -h))
        return float(high - low) / (2 * h)

    def along(name):
        high, low = (getattr(ring.at(r, t + k), name) for k in (h, -h))
        return float(high - low) / (2 * h * r)

    size, near = float(abs(here.sigma_theta) + abs(here.tau)), {"abs": 1e-8}
    balance = (
        across("sigma_r") + along("tau") + float(here.sigma_r - here.sigma_theta) / r,
        across("tau") + along("sigma_theta") + 2 * float(here.tau) / r,
    )
    assert balance == pytest.approx((0, 0), abs=1e-7 * size)
    strains = (
        across("u_r"),
        float(here.u_r) / r + along("u_theta"),
        along("u_r") + across("u_theta") - float(here.u_theta) / r,
    )
    hooke = (
        float(here.sigma_r - nu * here.sigma_theta) / E,
        float(here.sigma_theta - nu * here.sigma_r) / E,
        float(here.tau) * 2 * 1.3,
    )
    assert strains == pytest.approx(hooke, **near)


def test_the_mean_is_lame_exactly():
    ring = FourierRing(r_i=1.0, r_o=1.5, loaded="rim", n=5, p=np.array([2.0, 9.0, 3.0]), **UNIT)
    theta = np.arange(40) * 2 * np.pi / 40  # the rule is exact for waves up to 10 and beyond
    u = ring.at(1.5, theta).u_r.mean()
    lamé = lame.radial_displacement(
        1.5, r_i=1.0, r_o=1.5, p_i=0.0, p_o=2.0, E=1.0, nu=0.3, ends="plane strain"
    )
    assert u == pytest.approx(float(lamé), rel=1e-14)


@pytest.mark.parametrize("n", [2, 3, 4])
@pytest.mark.parametrize("loaded", ["bore", "rim"])
def test_a_thin_ring_bends_as_timoshenko_has_it(n, loaded):
    """Inextensible ring under n radial forces: each wave of the load bends it by itself.

    The wave P n/(pi R) cos(m theta) of the load bends it by P n R³/(pi E I)/(m² - 1)².
    """
    h, R, P = 1e-3, 1.0, 1.0
    ring = LoadedRace(
        r_i=R - h / 2, r_o=R + h / 2, E=1.0, nu=0.3, assumption="plane stress", loaded=loaded,
        n=n, P=P, a=1e-3,
    )  # fmt: skip
    m = n * np.arange(1, 400)
    bend = P * n * R**3 / (np.pi * h**3 / 12)
    sign = 1.0 if loaded == "bore" else -1.0
    for theta in (0.0, np.pi / n):
        thin = sign * bend * np.sum(np.cos(m * theta) / (m**2 - 1) ** 2)
        assert float(ring.at(R, theta).u_r) == pytest.approx(thin, rel=2e-3)  # of the order h/R


def test_the_closed_form_of_a_thin_ring_under_two_forces():
    """Timoshenko, Strength of Materials II: the diameters' changes.

    Along the forces +(pi/4 - 2/pi) P R³/(E I), across them -(2/pi - 1/2) P R³/(E I).
    """
    h = 1e-3
    ring = LoadedRace(
        r_i=1 - h / 2, r_o=1 + h / 2, E=1.0, nu=0.3, assumption="plane stress", loaded="bore",
        n=2, P=1.0, a=1e-3,
    )  # fmt: skip
    bend = 12 / h**3
    assert float(ring.at(1.0, 0.0).u_r) == pytest.approx(
        (np.pi / 4 - 2 / np.pi) / 2 * bend, rel=2e-3
    )
    between = -(2 / np.pi - 1 / 2) / 2 * bend
    assert float(ring.at(1.0, np.pi / 2).u_r) == pytest.approx(between, rel=2e-3)


@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_two_loads_on_a_ring_without_bore_flatten_a_disc(assumption):
    """A disc between flats (its own series), and what the pressure's direction adds.

    The flats press along one line, the race's patch along the rim's normals: tangential forces
    q x/R, towards the middle, that lift the middle of a half plane by (1 - nu')/(2 E') times their
    sum, P <|t|> a/R with <|t|> = 4/(3 pi) of the semi-ellipse. What is left is of (a/R)².
    """
    E, nu, P, R = 1.0, 0.3, 1.0, 1.0
    plane, cross = (E, nu) if assumption == "plane stress" else (E / (1 - nu**2), nu / (1 - nu))
    for a in (0.04, 0.02, 0.01):
        race = LoadedRace(
            r_i=1e-6, r_o=R, E=E, nu=nu, assumption=assumption, loaded="rim", n=2, P=P, a=a
        )
        disc = float(approach(P=P, a=a, R=R, E_plane=plane))
        inclined = P * 4 / (3 * np.pi) * a / R * (1 - cross) / (2 * plane)
        assert -race.displacement(R, 0.0) == pytest.approx(disc + inclined, rel=a**2)


def test_n_of_one_and_overlapping_patches_are_refused():
    with pytest.raises(ValueError, match="from n = 2 on, got n=1"):
        FourierRing(r_i=1.0, r_o=2.0, loaded="bore", n=1, p=WAVES, **UNIT)
    with pytest.raises(ValueError, match="12 patches of half-width"):
        LoadedRace(r_i=1.0, r_o=2.0, loaded="bore", n=12, P=1.0, a=0.3, **UNIT)


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"r_o": 0.5}, "0 < r_i < r_o"),
        ({"loaded": "side"}, "'bore' or 'rim'"),
        ({"E": -1.0}, "Young's modulus"),
        ({"p": np.array([1.0, np.nan])}, "finite"),
    ],
)
def test_a_ring_without_sense_is_refused(wrong, said):
    right = {"r_i": 1.0, "r_o": 2.0, "loaded": "bore", "n": 2, "p": WAVES, **UNIT}
    with pytest.raises(ValueError, match=said):
        FourierRing(**right | wrong)
