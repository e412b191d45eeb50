"""Log-spiral sprags against drawn spirals; derivatives of the wedge angle."""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from analytic.sprag.geometry import LogSprag, strut, triangle
from analytic.sprag.tolerance import wedge_angle_sensitivities

TABLE = {"R_i": 11.11, "R_e": 19.44, "r_i": 4.02}  # lengths in mm here


def spiral(sprag, angle):
    """Points of the inner flank at first contact, `angle` anticlockwise from A seen from C_e."""
    pole = np.array([0.0, float(sprag.OC_e)])
    first = np.array([np.sin(sprag.eta_0), -np.cos(sprag.eta_0)])
    turned = np.array(
        [
            first[0] * np.cos(angle) - first[1] * np.sin(angle),
            first[0] * np.sin(angle) + first[1] * np.cos(angle),
        ]
    )
    return pole[:, None] + sprag.rho_0 * np.exp(sprag.m * angle) * turned


def test_the_spiral_touches_the_inner_race_at_a_and_nowhere_goes_into_it():
    sprag = LogSprag(m=0.0892, **TABLE)
    found = minimize_scalar(
        lambda at: np.hypot(*spiral(sprag, np.array([at])))[0],
        bounds=(-0.5, 0.5), method="bounded", options={"xatol": 1e-10},
    )  # fmt: skip
    assert found.x == pytest.approx(0.0, abs=1e-6)
    assert found.fun == pytest.approx(11.11, rel=1e-13)
    x, y = spiral(sprag, np.array([found.x]))[:, 0]
    assert np.arctan2(x, y) == pytest.approx(float(sprag.beta_0), abs=1e-6)


def test_the_spiral_s_radius_of_curvature_at_first_contact_is_r_i():
    """Three near points of the drawn flank; Table 1's 4.02 mm (erratum table-1-radii)."""
    points = spiral(LogSprag(m=0.0892, **TABLE), np.array([-1e-3, 0.0, 1e-3]))
    a, b, c = (np.hypot(*(points[:, i] - points[:, j])) for i, j in ((0, 1), (1, 2), (0, 2)))
    (ux, uy), (vx, vy) = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    assert a * b * c / (2 * abs(ux * vy - uy * vx)) == pytest.approx(4.02, rel=1e-6)


def test_eq_10_s_eta_is_the_angle_at_the_pole_and_not_that_between_ab_and_ac_e():
    """Erratum eq-10-eta: with m = 0.0892 the one is 3.75 deg, the other 1.95."""
    sprag = LogSprag(m=0.0892, **TABLE)
    A = 11.11 * np.array([np.sin(sprag.beta_0), np.cos(sprag.beta_0)])
    to_B, to_pole = np.array([0.0, 19.44]) - A, np.array([0.0, float(sprag.OC_e)]) - A
    named = np.arccos(to_B @ to_pole / np.linalg.norm(to_B) / np.linalg.norm(to_pole))
    assert np.degrees(named) == pytest.approx(1.95, abs=0.01)
    assert named == pytest.approx(float(np.arctan(0.0892) - sprag.nu_0), rel=1e-6)
    assert np.degrees(float(sprag.eta_0)) == pytest.approx(3.75, abs=0.01)


def test_eq_10_as_printed_gives_the_same_triangle():
    """Arcsin and sine rule of the print; the explicit root keeps more digits."""
    OA, OC_e, m = 11.0, 15.0, np.array([0.05, 0.1, 0.4])
    found = triangle(OA=OA, OC_e=OC_e, m=m)
    eta = np.arcsin(m * OA / (OC_e * np.sqrt(1 + m**2)))
    beta = np.arctan(m) - eta
    assert found.eta == pytest.approx(eta, rel=1e-12)
    assert found.beta == pytest.approx(beta, rel=1e-11)
    assert found.rho == pytest.approx(OA * np.sin(beta) / np.sin(eta), rel=1e-11)
    nu, omega = strut(OA=OA, OB=19.0, beta=beta)
    printed = -np.arctan(19 * np.sin(beta) / (OA - 19 * np.cos(beta)))
    assert nu == pytest.approx(printed, rel=1e-12)
    assert omega == pytest.approx(nu - beta)


STEP = 1e-5


@pytest.mark.parametrize("m", [0.03, 0.0892, 0.3])
@pytest.mark.parametrize("name", ["R_i", "R_e", "r_e", "m"])
def test_derivatives_are_those_of_the_angle(m, name):
    sprag = LogSprag(R_i=11.11, R_e=19.44, m=m, r_i=4.02)
    nominal = {"R_i": 11.11, "R_e": 19.44, "r_e": float(sprag.r_e), "m": m}

    def nu(change):
        x = nominal | {name: nominal[name] + change}
        found = triangle(OA=x["R_i"], OC_e=x["R_e"] - x["r_e"], m=x["m"])
        return strut(OA=x["R_i"], OB=x["R_e"], beta=found.beta)[0]

    expected = (nu(STEP) - nu(-STEP)) / (2 * STEP)
    assert float(getattr(wedge_angle_sensitivities(sprag), name)) == pytest.approx(
        float(expected), rel=1e-7
    )
