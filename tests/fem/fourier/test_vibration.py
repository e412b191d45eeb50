"""Rotating elastic bodies against closed forms: inertia, rigid rotors, rings, whole cylinders."""

import numpy as np
import pytest
from scipy.linalg import eigh

from analytic.rotor.cylinder import Cylinder
from fem.fourier import vibration
from fem.fourier.solid import FourierSolid
from fem.fourier.vibration import RotatingSolid
from fem.fourier.vibration_mounts import Mount, RigidDisc
from fem.fourier.vibration_parts import mean_motion
from fem.plane.material import Elastic
from meshes.join import join
from meshes.revolution.section import section

E, NU, RHO = 210e9, 0.3, 7850.0
STEEL = Elastic(E=E, nu=NU)
HARD = Elastic(E=E * 1e3, nu=NU)  # rigid to 1e-6 beside the springs
R_I, R_O, B = 0.05, 0.2, 0.06
MASS = RHO * np.pi * (R_O**2 - R_I**2) * B
POLAR = MASS * (R_O**2 + R_I**2) / 2
DIAMETRAL = MASS * ((R_O**2 + R_I**2) / 4 + B**2 / 12)  # about its centre


def tube(start=-B / 2, r_i=R_I, r_o=R_O, b=B, cells=(2, 2)):
    return section(r=np.linspace(r_i, r_o, cells[0] + 1), z=start + np.linspace(0, b, cells[1] + 1))


def solid(mesh, material=HARD, supports=None):
    return FourierSolid(mesh, material, supports or {}, degree=2)


def whirl(K, M, G, speed):
    """Forward and backward frequencies, growing, of K v + w speed G v - w^2 M v = 0."""
    zero = np.zeros_like(K)
    left = np.block([[K, zero], [zero, M]])
    w = 1 / eigh(np.block([[-speed * G, M], [M, zero]]), left, eigvals_only=True)
    return np.sort(w[w > 0]), np.sort(-w[w < 0])


def held(**more):
    """The tube on a spring at each end face, which differ."""
    springs = (Mount(boundary="start", k=2e7, k_tilt=1e4), Mount(boundary="end", k=3e7))
    return RotatingSolid(solid(tube()), RHO, springs=springs, **more)


def test_a_rigid_rotor_on_springs_whirls_as_its_four_unknowns_do():
    """A disc has no critical speed in tilt, as its polar moment exceeds the diametral one."""
    a = B / 2
    K = np.array([[5e7, 1e7 * a], [1e7 * a, 5e7 * a**2 + 1e4]])  # centre's x and slope
    M, G = np.diag([MASS, DIAMETRAL]), np.diag([0.0, POLAR])
    for speed in (0.0, -300.0):
        ahead, behind = whirl(K, M, G, speed)
        found = held().modes(speed, 2)
        assert found.forward == pytest.approx(ahead, rel=1e-5)
        assert found.backward == pytest.approx(behind, rel=1e-5)
    ahead = eigh(M - G, K, eigvals_only=True)
    behind = eigh(M + G, K, eigvals_only=True)[::-1]
    speeds, _ = held().critical_speeds(1)
    assert speeds == pytest.approx([ahead[-1] ** -0.5], rel=1e-5)
    backward, _ = held().critical_speeds(2, excitation=-1.0)
    assert backward == pytest.approx(behind**-0.5, rel=1e-5)


def test_splitting_has_as_many_digits_at_a_low_speed_where_a_difference_has_four():
    body = RotatingSolid(solid(tube(b=0.9, start=0), STEEL, {"start": "rt", "end": "rt"}), RHO)
    fast, slow = body.modes(1.0, 2), body.modes(1e-4, 2)
    assert fast.splitting == pytest.approx(fast.forward - fast.backward, rel=1e-6)
    assert slow.splitting == pytest.approx(fast.splitting * 1e-4, rel=1e-9)
    assert abs((slow.forward - slow.backward) / slow.splitting - 1).max() > 1e-7


def test_two_rotors_in_one_another_whirl_as_their_eight_unknowns_do():
    """The inner one against the outer one's turn at 1.5 times its speed, a spring between."""
    inner = {"r_i": 0.0, "r_o": 0.04, "b": 0.1, "start": -0.05}
    mesh = join({"outer": tube(), "inner": tube(**inner)})
    m = RHO * np.pi * 0.04**2 * 0.1
    polar, diametral = m * 0.04**2 / 2, m * (0.04**2 / 4 + 0.1**2 / 12)
    found = RotatingSolid(
        solid(mesh), RHO, {"outer": 1.0, "inner": -1.5},
        springs=(
            Mount(boundary="outer.rim", k=4e7, k_tilt=2e5),
            Mount(boundary="inner.rim", k=1e7, k_tilt=1e5),
            Mount(boundary="inner.rim", to="outer.bore", k=2e7, k_tilt=3e4),
        ),
    ).modes(180.0, 4)  # fmt: skip
    K = np.zeros((4, 4))  # x outer, x inner, slopes
    for first, outer, between, own in ((0, 4e7, 2e7, 1e7), (2, 2e5, 3e4, 1e5)):
        K[first : first + 2, first : first + 2] = [
            [outer + between, -between], [-between, own + between]
        ]  # fmt: skip
    M, G = np.diag([MASS, m, DIAMETRAL, diametral]), np.diag([0, 0, POLAR, -1.5 * polar])
    ahead, behind = whirl(K, M, G, 180.0)
    assert found.forward == pytest.approx(ahead, rel=1e-5)
    assert found.backward == pytest.approx(behind, rel=1e-5)


@pytest.mark.parametrize("n", [2, 5])
def test_a_thin_ring_s_waves_are_carried_along_by_its_turn(n):
    r"""Inextensional bending: w^2 - 2 w W c - w_0^2 = 0, c = n (n^2-1)/(n^2+1) (Bryan 1890).

    w_0 = n (n^2 - 1)/sqrt(n^2 + 1) sqrt(E I/(rho A R^4)), with E/(1 - nu^2) as the ring is long.
    """
    R, h, speed = 1.0, 0.01, 20.0
    mesh = tube(start=0, r_i=R - h / 2, r_o=R + h / 2, b=h, cells=(2, 1))
    body = RotatingSolid(solid(mesh, STEEL, {"start": "z", "end": "z"}), RHO, n=n)
    w_0 = n * (n**2 - 1) / np.sqrt(n**2 + 1) * np.sqrt(E / (1 - NU**2) / 12 / RHO) * h / R**2
    c = n * (n**2 - 1) / (n**2 + 1)
    mean = np.sqrt(w_0**2 + (c * speed) ** 2)
    found = body.modes(speed, 1)
    thin = 1e-4 * n**2  # what shear and stretching add, (n h/R)^2 times about one
    assert found.forward[0] == pytest.approx(mean + c * speed, rel=thin)
    assert found.backward[0] == pytest.approx(mean - c * speed, rel=thin)
    assert found.forward[0] - found.backward[0] == pytest.approx(2 * c * speed, rel=thin)


@pytest.mark.parametrize("r_i", [0.0, 0.02])
def test_a_cylinder_s_whirl_converges_to_elasticity_s_at_order_four(r_i):
    r_o, L, speed = 0.04, 0.16, 5e3
    exact = Cylinder(r_o=r_o, r_i=r_i, E=E, nu=NU, rho=RHO).whirl(np.pi / L, Omega=speed)
    errors = []
    for n in (2, 4, 8):
        mesh = tube(start=0, r_i=r_i, r_o=r_o, b=L, cells=(n, 2 * n))
        body = RotatingSolid(solid(mesh, STEEL, {"start": "rt", "end": "rt"}), RHO)
        found = body.modes(speed, 1)
        errors.append([found.forward[0] / exact[0][0] - 1, found.backward[0] / exact[1][0] - 1])
    assert np.all(np.array(errors) > 0)  # conforming elements are too stiff
    assert np.all(np.log2(np.array(errors[:-1]) / errors[1:]) > 3.6)
    assert np.all(np.array(errors[-1]) < 1e-5)


def test_modes_are_of_unit_mass_and_their_residual_is_checked(monkeypatch):
    body = held()
    shapes = body.modes(100.0, 2).forward_shapes
    q = (body.T.T @ shapes) / np.asarray(body.T.multiply(body.T).sum(axis=0)).ravel()[:, None]
    assert np.diag(q.T @ body.M @ q) == pytest.approx(1, rel=1e-9)
    exact = vibration.eigsh

    def rough(*args, **more):
        w, x = exact(*args, **more)
        return w, x + 1e-3 * abs(x).max() * np.cos(np.arange(x.size)).reshape(x.shape)

    monkeypatch.setattr(vibration, "eigsh", rough)
    with pytest.raises(ArithmeticError, match="modes of harmonic 1 have too large"):
        body.modes(100.0, 2)


RIM = (Mount(boundary="rim", k=1.0),)


def tube_with(rho=RHO, springs=RIM, **more):
    return RotatingSolid(solid(tube()), rho, springs=springs, **more)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: tube_with(rho=-1.0), "density must be positive"),
        (lambda: tube_with(rho={"cup": 1.0}), "no body 'cup'"),
        (lambda: tube_with(ratio=np.nan), "no finite ratio"),
        (lambda: tube_with(n=0), "n >= 1"),
        (lambda: tube_with(n=2), "springs and discs require harmonic n = 1"),
        (lambda: Mount(boundary="rim", k=-1.0), "not be negative, got k=-1"),
        (lambda: RigidDisc(boundary="rim", mass=1.0, polar=1.0, diametral=0.4),
         "polar <= 2 diametral"),
        (lambda: mean_motion(solid(tube(r_i=0.0)).basis, "axis"),
         "the boundary 'axis' has no mean motion"),
        (lambda: held().modes(np.inf), "finite speed"),
        (lambda: tube_with(springs=()).K, "harmonic 1: the bodies can still make"),
        (lambda: tube_with(springs=(Mount(boundary="start", k=1e6),)).K,
         "harmonic 1: the bodies can still make"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
