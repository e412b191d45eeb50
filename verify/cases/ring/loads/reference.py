"""Finite-element model of a race under n sprags: half a pitch, plane stress."""

from typing import Any

import numpy as np

from verify.case import Level
from verify.cases.ring.loads.inputs import LoadsInputs, Wall
from verify.core.figures import Array, Field

CELLS = 4  # on half the patch of the coarsest mesh
ROUND = 1e-11  # relative: machine epsilon times the ring over its cells (below 1e5)
AROUND, ACROSS = 9, 5  # stations of the stresses inside
ALONG = 16  # stations of the profiles on the walls
AWAY = 2.0  # distance from the patch's middle, in half-widths, beyond which results are compared


def stations(q: LoadsInputs) -> Array:
    """Points (r [m], theta), shape (2, m), over half a pitch; those near the patch are omitted."""
    r, theta = np.meshgrid(
        np.linspace(q.r_i, q.r_o, ACROSS), np.linspace(0, np.pi / q.n, AROUND), indexing="ij"
    )
    points = np.array([r.ravel(), theta.ravel()])
    x, y = points[0] * np.cos(points[1]), points[0] * np.sin(points[1])
    return np.asarray(points[:, np.hypot(x - q.radius, y) > AWAY * q.half_width])


def wall_angles(q: LoadsInputs) -> Array:
    """Angles [rad], (m,), at which walls are evaluated: from outside the patch to half a pitch."""
    return np.linspace(AWAY * q.half_width / q.radius, np.pi / q.n, ALONG)


def fem_sector(
    *, r_i: float, r_o: float, n: int, loaded: Wall, a: float, P: float, material: Any, level: int
) -> Any:
    """Solution of half a pitch of a ring with the load P [N/m] on a patch of half-width `a`."""
    from fem.plane.patch import solve_under_patch
    from meshes.ring.sector import half_sector

    return solve_under_patch(
        half_sector(r_i=r_i, r_o=r_o, n=n, loaded=loaded, patch=a, refine=level, cells=CELLS),
        material=material, assumption="plane stress", supports={"load cut": "n", "free cut": "n"},
        radius=r_i if loaded == "bore" else r_o, a=a, P=P,
    )  # fmt: skip


def solve(q: LoadsInputs, level: int) -> Level:
    """Results of half a pitch on the mesh of `level`."""
    from fem.plane.material import Elastic
    from fem.plane.patch import polar_nodes

    sector = fem_sector(
        r_i=q.r_i, r_o=q.r_o, n=q.n, loaded=q.loaded, a=q.half_width, P=q.P,
        material=Elastic(E=q.E, nu=q.nu), level=level,
    )  # fmt: skip
    sign = 1.0 if q.loaded == "bore" else -1.0
    walls = {name: polar_nodes(sector, name) for name in ("bore", "rim")}
    far = "rim" if q.loaded == "bore" else "bore"
    near_u, far_u = sign * walls[q.loaded][1], sign * walls[far][1]
    wall = sector.on_boundary(q.loaded)
    mean = sign * wall.mean(wall.polar()[0])
    pitch = np.pi / q.n
    other = q.r_o if q.loaded == "bore" else q.r_i
    r, theta = np.array([[q.radius, other, other], [pitch, 0.0, pitch]])
    hoop = sector.at(np.array([r * np.cos(theta), r * np.sin(theta)])).polar()[2]
    cut = sector.reaction("free cut")  # along the inward normal if the ring is pulled
    inside, turn = stations(q)
    within = sector.at(np.array([inside * np.cos(turn), inside * np.sin(turn)])).polar()
    values = {
        "load": near_u[0], "between": near_u[-1], "far_load": far_u[0], "far_between": far_u[-1],
        "mean": mean, "ripple": (near_u[0] - near_u[-1]) / mean,
        "hoop_between": hoop[0], "far_hoop_load": hoop[1], "far_hoop_between": hoop[2],
        "hoop_force": cut[1] * np.cos(pitch) - cut[0] * np.sin(pitch),
        "strain_energy": 2 * q.n * sector.strain_energy,
    }  # fmt: skip
    values = {key: float(value) for key, value in values.items()}
    round_off = max(sector.residual**0.5, ROUND)
    arrays = {f"{name} nodes": nodes for name, nodes in walls.items()}
    arrays["stresses"] = np.array(within[1:])
    along = np.array([np.cos(wall_angles(q)), np.sin(wall_angles(q))])
    for name, r in (("bore", q.r_i), ("rim", q.r_o)):
        u_r, _, around, _ = sector.at(r * along).polar()
        arrays[f"{name} hoop stress"] = around
        if name == q.loaded:
            arrays["displacement"] = sign * u_r
    cells = sector.cells()
    x, u = cells["points"], cells["displacement"]
    field = Field(
        name="half a pitch", points=x, cells=cells["cells"].astype(np.int64),
        point_data={"displacement": u, "radial_displacement": (x * u).sum(axis=1) / np.hypot(*x.T)},
        cell_data={"stress": cells["stress"], "von_mises": cells["von_mises"]},
        units={"displacement": "m", "radial_displacement": "m", "stress": "Pa", "von_mises": "Pa"},
    )  # fmt: skip
    u_it = {key: round_off * abs(value) for key, value in values.items()}
    return Level(h=1 / (CELLS * level), values=values, u_it=u_it, arrays=arrays, fields=(field,))
