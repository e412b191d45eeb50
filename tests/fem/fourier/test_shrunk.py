"""A ring shrunk on a shaft beside Lamé, and the slope of a pressure that is known."""

import numpy as np
import pytest
from skfem import MeshQuad1

from fem.fourier.shrunk import edge_slope, shrink_pressure
from fem.fourier.solid import FourierSolid
from fem.plane.material import Elastic
from meshes.revolution.cylinder import half_cylinder
from meshes.revolution.section import stations


def test_the_slope_at_the_edge_is_extrapolated_over_the_distance():
    r = np.geomspace(1e-5, 0.1, 60)
    p = r**-0.226 * np.exp(3 * r)  # a slope of -0.226 + 3 r
    assert edge_slope(r[::-1], p[::-1], 1e-3) == pytest.approx(-0.226, abs=1e-6)


def test_a_ring_as_long_as_its_shaft_presses_evenly_as_lame_s_does():
    fine = {"first": 0.2, "growth": 1.2, "refine": 2}
    nodes = stations(start=1.0, end=0.0, **fine)
    shaft = half_cylinder(R=1.0, contact=nodes, overhang=0.0, first=0.2, refine=2)
    ring = MeshQuad1.init_tensor(stations(start=1.0, end=2.0, **fine), nodes)
    ring = ring.with_boundaries({"bore": lambda x: x[0] == 1, "start": lambda x: x[1] == 0})
    bodies = [
        (FourierSolid(mesh, Elastic(E=3.0, nu=0.3), {"start": "z"}, degree=2), name)
        for mesh, name in ((shaft, "rim"), (ring, "bore"))
    ]
    pressure = shrink_pressure(bodies, nodes[::2])
    # E / ((r_o² + r_f²)/(r_o² - r_f²) + 1), both free to change their length
    assert pressure == pytest.approx(3.0 / (5 / 3 + 1), rel=1e-3)
