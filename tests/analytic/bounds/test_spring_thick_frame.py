"""What plane elasticity adds to a thin frame, beside the force method's own shear and curvature."""

import math

import pytest

from analytic.bounds.spring.thick_frame import added
from analytic.spring import frame

SHAPE = {"n": 10, "L1": 11.6e-3, "radius": 0.45e-3, "alpha": math.radians(80)}


def by_frame(shape, *, b, wide):
    """Shares of the thin frame's flexibility that shear and curvature add."""
    k = [
        frame.stiffness(**shape, b=b, h=0.056, E=206e9, nu=0.3, theory=theory, plane_strain=wide)
        for theory in ("bending", "shear", "thick")
    ]
    return k[0] / k[1] - 1, k[0] / k[2] - k[0] / k[1]


@pytest.mark.parametrize("wide", [False, True])
@pytest.mark.parametrize("change", [{}, {"alpha": math.radians(45), "n": 5}, {"L1": 0.03}])
def test_shear_is_the_frame_s_and_curvature_up_to_the_next_power_of_thickness(wide, change):
    shape, off, shares = SHAPE | change, [], []
    for b in (1e-4, 5e-5):
        shear, curvature = by_frame(shape, b=b, wide=wide)
        found = added(**shape, b=b, nu=0.3, wide=wide)
        assert found.shear == pytest.approx(shear, rel=1e-8)
        off.append(found.curvature - curvature)
        shares.append(curvature)
    assert abs(off[0]) < 0.03 * abs(shares[0])
    assert off[0] / off[1] == pytest.approx(16, rel=0.05)  # (b/R)^4


def test_what_comes_next_is_smaller_by_the_slenderness():
    found = added(**SHAPE, b=1e-4, nu=0.3, wide=False)
    assert found.next_order(0.1) >= 0.1 * abs(found.both)
