"""Every plane mesh has the names, lengths, areas and normals of its outline, to order four."""

from math import cos, pi, sin, sqrt, tan

import numpy as np
import pytest

from meshes.contact.block import block, full_block, half_block
from meshes.contact.disc import half_disc, quarter_disc
from meshes.contact.race import half_race
from meshes.contact.roller import half_roller
from meshes.contact.round import full_disc, full_ring
from meshes.contact.tilted import INNER, tilted_half_disc
from meshes.freewheel.sector import inner_cam_sector, outer_cam_sector
from meshes.polyhedral.half_sector import half_sector as polyhedral_sector
from meshes.ring.quarter import quarter_ring
from meshes.ring.sector import half_sector
from tests.meshes.measures import measure, nodes, side

R, R_I, R_O, ZONE = 0.01, 0.02, 0.03, 1e-3  # [m]
FINE = {"R": R, "zone": ZONE}
RACE = {"r_i": R_I, "r_o": R_O}
BLOCK = {"width": 1.0, "depth": 1.4, "zone": 0.1}
WALL = R_O - R_I
Z, D_E, D_I, FILLET = 6, 0.08, 0.072, 0.02
APOTHEM = (D_I / 2 + FILLET * (1 / cos(pi / Z) - 1)) * cos(pi / Z)
FLAT = APOTHEM * tan(pi / Z) - FILLET * tan(pi / Z)
HOLE = (APOTHEM * FLAT + FILLET * FLAT + FILLET**2 * pi / Z) / 2
# rollers between flat and circle [m]
X, X_O, ROLLER, ZONES = 11.39565e-3, 14.9e-3, 2.5e-3, (1.5e-4, 2e-4)
IN_RING = sqrt((16.5e-3 - ROLLER) ** 2 - (X + ROLLER) ** 2), X + ROLLER
ON_SHAFT = sqrt((10e-3 + ROLLER) ** 2 - (X_O - ROLLER) ** 2), X_O - ROLLER
SHAPES = {  # mesh by refinement; lengths of boundaries and areas; centres and radii of circles
    "even block of triangles": (
        lambda k: block(x=(-1.0, 2.0), y=(0.5, 1.0), nx=3 * k, ny=2 * k, cells="tri", order=1),
        {"block": 1.5, "left": 0.5, "right": 0.5, "bottom": 3.0, "top": 3.0}, {},
    ),
    "half block": (
        lambda k: half_block(**BLOCK, refine=k),
        {"": 1.4, "axis": 1.4, "side": 1.4, "surface": 1.0, "bottom": 1.0}, {},
    ),
    "full block above": (
        lambda k: full_block(**BLOCK, refine=k, above=True),
        {"block": 2.8, "left": 1.4, "right": 1.4, "axis": 1.4, "surface": 2.0, "bottom": 2.0}, {},
    ),
    "quarter disc": (
        lambda k: quarter_disc(**FINE, refine=k),
        {"": pi / 4 * R**2, "surface": pi / 2 * R, "axis": R, "middle": R},
        {"surface": ((0, R), R)},
    ),
    "half disc below": (
        lambda k: half_disc(**FINE, refine=k, below=True),
        {"disc": pi / 2 * R**2, "surface": pi * R, "axis": R, "middle": 2 * R},
        {"surface": ((0, -R), R)},
    ),
    "half race": (
        lambda k: half_race(**RACE, zone=ZONE, refine=k),
        {"race": pi / 2 * (R_O**2 - R_I**2), "bore": pi * R_I, "rim": pi * R_O, "axis": 2 * WALL},
        {"bore": ((0, R_I), R_I), "rim": ((0, R_I), R_O)},
    ),
    "half roller": (
        lambda k: half_roller(R=R, zones=(1e-4, 3e-4), refine=k),
        {"roller": pi / 2 * R**2, "near": pi / 2 * R, "far": pi / 2 * R, "cut": 2 * R},
        {"near": ((0, 0), R), "far": ((0, 0), R)},
    ),
    "ring": (
        lambda k: full_ring(**RACE, around=24 * k, across=3),
        {"ring": pi * (R_O**2 - R_I**2), "bore": 2 * pi * R_I, "rim": 2 * pi * R_O},
        {"bore": ((0, 0), R_I), "rim": ((0, 0), R_O)},
    ),
    "disc": (
        lambda k: full_disc(R=R, around=24 * k),
        {"disc": pi * R**2, "rim": 2 * pi * R}, {"rim": ((0, 0), R)},
    ),
    "tilted half disc": (
        lambda k: tilted_half_disc(**FINE, tilt=-0.2, refine=k),
        {"disc": pi / 2 * R**2, "surface": pi * R, "inner": 2 * INNER * R,
         "outer": 2 * (1 - INNER) * R, "axis": None},
        {"surface": ((0, 0), R)},
    ),
    "quarter ring": (
        lambda k: quarter_ring(**RACE, refine=k),
        {"inner half": pi / 4 * (0.025**2 - R_I**2), "outer half": pi / 4 * (R_O**2 - 0.025**2),
         "bore": pi / 2 * R_I, "middle": pi / 2 * 0.025, "rim": pi / 2 * R_O,
         "x=0": WALL, "y=0": WALL},
        {"bore": ((0, 0), R_I), "middle": ((0, 0), 0.025), "rim": ((0, 0), R_O)},
    ),
    "ring's half sector": (
        lambda k: half_sector(**RACE, n=12, loaded="bore", patch=ZONE, refine=k),
        {"ring": pi / 24 * (R_O**2 - R_I**2), "bore": pi / 12 * R_I, "rim": pi / 12 * R_O,
         "load cut": WALL, "free cut": WALL, "patch": ZONE},
        {"bore": ((0, 0), R_I), "rim": ((0, 0), R_O), "patch": ((0, 0), R_I)},
    ),
    "polyhedral half sector": (
        lambda k: polyhedral_sector(z=Z, d_e=D_E, d_i=D_I, fillet=FILLET, refine=k),
        {"ring": D_E**2 / 8 * pi / Z - HOLE, "rim": D_E / 2 * pi / Z, "fillet": FILLET * pi / Z,
         "flat": FLAT, "bore": FLAT + FILLET * pi / Z, "mid": D_E / 2 - APOTHEM,
         "corner": (D_E - D_I) / 2},
        {"rim": ((0, 0), D_E / 2),
         "fillet": (((D_I / 2 - FILLET) * cos(pi / Z), (D_I / 2 - FILLET) * sin(pi / Z)), FILLET)},
    ),
    "freewheel's inner cam": (
        lambda k: inner_cam_sector(
            R=16.5e-3, R_a=21e-3, X=X, r_b=7.5e-3, r=ROLLER, z=8, centre=IN_RING, zones=ZONES,
            refine=k,
        ),
        {"star": X**2 * tan(pi / 8) - 7.5e-3**2 * pi / 8, "star.flat": 2 * X * tan(pi / 8),
         "star.bore": 7.5e-3 * pi / 4, "star.left": X / cos(pi / 8) - 7.5e-3, "star.right": None,
         "ring": pi / 8 * (21e-3**2 - 16.5e-3**2), "ring.bore": pi / 4 * 16.5e-3,
         "ring.rim": pi / 4 * 21e-3, "ring.left": 4.5e-3, "ring.right": 4.5e-3,
         "roller": pi * ROLLER**2, "roller.inner": None, "roller.outer": None},
        {"star.bore": ((0, 0), 7.5e-3), "ring.bore": ((0, 0), 16.5e-3),
         "ring.rim": ((0, 0), 21e-3), "roller.inner": (IN_RING, ROLLER),
         "roller.outer": (IN_RING, ROLLER)},
    ),
    "freewheel's outer cam": (
        lambda k: outer_cam_sector(
            R_s=10e-3, X_o=X_O, r_b=4e-3, R_a=21e-3, r=ROLLER, z=8, centre=ON_SHAFT, zones=ZONES,
            refine=k,
        ),
        {"shaft": pi / 8 * (100e-6 - 16e-6), "shaft.rim": pi / 4 * 10e-3, "shaft.bore": pi * 1e-3,
         "shaft.left": 6e-3, "shaft.right": 6e-3, "cup": 21e-3**2 * pi / 8 - X_O**2 * tan(pi / 8),
         "cup.flat": 2 * X_O * tan(pi / 8), "cup.rim": pi / 4 * 21e-3, "cup.left": None,
         "cup.right": 21e-3 - X_O / cos(pi / 8), "roller.inner": None, "roller.outer": None},
        {"shaft.bore": ((0, 0), 4e-3), "shaft.rim": ((0, 0), 10e-3), "cup.rim": ((0, 0), 21e-3),
         "roller.inner": (ON_SHAFT, ROLLER)},
    ),
}  # fmt: skip
every_shape = pytest.mark.parametrize(("make", "exact", "circles"), SHAPES.values(), ids=SHAPES)


@every_shape
def test_lengths_and_areas_converge_with_the_fourth_power_of_the_cells(make, exact, circles):
    meshes = make(2), make(4)
    assert set(meshes[0].boundaries) == set(exact) - {""} - set(meshes[0].subdomains)
    for name, value in exact.items():
        if value is None:
            continue
        coarse, fine = (measure(mesh, name) / value - 1 for mesh in meshes)
        assert abs(coarse) < 1e-4, name
        if abs(fine) > 1e-11:  # round-off
            assert np.log2(coarse / fine) == pytest.approx(4, abs=0.15), (name, coarse, fine)


@every_shape
def test_named_boundaries_close_the_outline_and_nodes_lie_on_their_circles(make, exact, circles):
    mesh = make(1)
    outer = mesh.boundary_facets()
    named = np.unique(np.concatenate(list(mesh.boundaries.values())))
    np.testing.assert_array_equal(np.intersect1d(named, outer), np.sort(outer))
    for name, (centre, radius) in circles.items():
        away = np.hypot(*(nodes(mesh, name) - np.reshape(centre, (2, 1))))
        np.testing.assert_allclose(away, radius, rtol=1e-12)
    # int x . n = 2 A and int n = 0 over the outline of outward normals, exact on parabolas
    edge = side(mesh, outer)
    flux = (np.asarray(edge.global_coordinates()) * edge.normals).sum(axis=0)
    assert (flux * edge.dx).sum() == pytest.approx(2 * measure(mesh), rel=1e-10)
    total = (edge.normals * edge.dx).sum(axis=(1, 2))
    np.testing.assert_allclose(total, 0, atol=1e-10 * sqrt(measure(mesh)))
