"""Problems that are solved by one call, against formulas that share no code with them."""

import numpy as np
import pytest

from analytic.freewheel import ContactMaterial, InnerCam, RollerClutch, loaded, required_friction
from analytic.polyhedral import Sector, rim_displacement
from analytic.sprag import LogSprag, Motion, SpragClutchParts, engage_suddenly
from analytic.sprag.transient import LongStepError
from analytic.spring import two_stages
from fem.beam import compress_spring
from fem.plane import solve_polygon_ring
from fem.wedge import solve_freewheel
from meshes.freewheel import inner_cam_sector
from meshes.polyhedral import polygon_half_sector
from meshes.spring import spring_centre_line

STAR = {"R": 21e-3, "X": 14.9e-3, "r": 3e-3, "z": 10}
SIZES = {"L": 12e-3, "r_b": 8e-3, "R_a": 28e-3}
T, F_AX, MU = 30.0, 600.0, 0.1


@pytest.fixture(scope="module")
def freewheel():
    return solve_freewheel(
        inner_cam_sector, **STAR, **SIZES, E=206e9, nu=0.3, mu=MU, T=T, F_ax=F_AX, cells=6
    )


def test_a_freewheel_bears_its_loads_at_the_angle_of_the_formulas(freewheel):
    steel = ContactMaterial(E=206e9, nu=0.3)
    clutch = RollerClutch(cam=InnerCam(**STAR), **SIZES, roller=steel, inner=steel, outer=steel)
    state = loaded(clutch, T)
    assert freewheel.torque == pytest.approx(T, rel=1e-3)
    assert freewheel.axial_load == pytest.approx(F_AX, rel=1e-3)
    assert freewheel.alpha == pytest.approx(float(state.alpha), rel=1e-3)
    assert freewheel.pressures == pytest.approx([float(state.p_i), float(state.p_o)], rel=5e-3)
    mu_req = float(required_friction(alpha=state.alpha, T=T, F_ax=F_AX, R=STAR["R"]))
    assert freewheel.required_friction == pytest.approx([mu_req, mu_req], rel=2e-3)
    assert not freewheel.slides


@pytest.mark.parametrize(
    ("changes", "message"),
    [({"mu": 0.05}, r"mu must be above tan\(alpha\) = 0\.05278"), ({"T": 0.0}, "must be T > 0 N m"),
     ({"F_ax": -1.0}, "F_ax >= 0 N")],
)  # fmt: skip
def test_loads_and_friction_of_a_freewheel_are_checked(changes, message):
    given = STAR | SIZES | {"E": 206e9, "nu": 0.3, "mu": MU, "T": T} | changes
    with pytest.raises(ValueError, match=message):
        solve_freewheel(inner_cam_sector, **given)


def test_a_polygon_ring_grows_as_by_its_series():
    size = {"z": 6, "d_e": 80.0, "d_i": 72.0}
    material = {"E": 210e3, "nu": 0.3, "assumption": "plane strain"}
    ring = solve_polygon_ring(polygon_half_sector, **size, fillet=2.0, p=10.0, **material)
    theta = np.linspace(0, np.pi / 6, 7)
    series = rim_displacement(theta, sector=Sector(**size, rho=2.0), p=10.0, **material).real
    assert ring.growth(theta) == pytest.approx(series, rel=1e-3)
    cells = ring.solution.in_body("ring").polar()[2].max()  # a little below the surface
    assert cells < ring.fillet_stress < 1.05 * cells
    with pytest.raises(ValueError, match="theta must be between 0 and pi/6 rad"):
        ring.growth(0.6)


SPRING = {"n": 4, "L1": 11.6e-3, "radius": 0.5e-3, "alpha": np.radians(80)}
STRIP = {"b": 0.1e-3, "h": 56e-3, "E": 206e9}


@pytest.mark.slow("a spring that touches itself, pressed in four steps")
def test_a_pressed_spring_has_both_stages():
    """Free as by the energy method, then stiffer with neighbours that press."""
    line = spring_centre_line(**SPRING, tail="arc", tips=True, per_arc=4, per_leaf=4)
    free = two_stages(**SPRING, **STRIP, head="free", tail="arc", theory="thin")
    curve = compress_spring(
        line, np.array([0.05, 0.8, 1.2, 1.6]) * float(free.U_A), **STRIP, nu=0.3
    )
    assert curve.F[0] / curve.U[0] == pytest.approx(float(free.k1), rel=3e-3)
    assert np.all(curve.press[:2] == 0)
    assert curve.press[2].sum() > 0
    slope = np.diff(curve.F) / np.diff(curve.U)
    assert slope[2] > 1.3 * free.k1


def test_what_is_no_spring_is_refused():
    line = spring_centre_line(**SPRING, tail="arc", per_arc=2, per_leaf=2)
    with pytest.raises(ValueError, match="tips=True"):
        compress_spring(line, [1e-3], **STRIP, nu=0.3)
    with pytest.raises(ValueError, match="head must be one of free, hinged, guided, got 'held'"):
        compress_spring(line, [1e-3], **STRIP, nu=0.3, head="held")
    tips = spring_centre_line(**SPRING, tail="arc", tips=True, per_arc=2, per_leaf=2)
    with pytest.raises(ValueError, match="must be positive and ascending"):
        compress_spring(tips, [1e-3, 0.5e-3], **STRIP, nu=0.3)


def test_an_engagement_locks_with_nearly_twice_the_force_at_rest():
    sprag = LogSprag.from_wedge_angle(
        R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3, nu_0=np.radians(3.15)
    )
    parts = SpragClutchParts(
        sprag=sprag, n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3
    )
    motion = Motion(
        m_g=1.8e-3, I_g=1.18e-8, I_bi=1.41e-3, I_be=1.41e-3, K_r=0.01, alpha_max=0.5, C_rl=0.1,
        k_out=1e5, mu_s=0.12, mu_c=0.08, gamma_b=1.0,
    )  # fmt: skip
    course = engage_suddenly(parts, motion, T=25.0, duration=0.01)
    assert course.verdict == "locks"
    assert 1.6 < course.peak_factor < 2.0
    rest = 25.0 / (12 * 11.11e-3 * np.tan(sprag.nu_0))  # of rigid parts; load opens the angle
    assert 0.85 * rest < course.N_static < rest
    with pytest.raises(LongStepError):
        engage_suddenly(parts, motion, T=25.0, duration=0.01, dt=2e-3)
