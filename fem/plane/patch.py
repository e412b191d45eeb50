"""Plane bodies under Hertz's pressure on a patch of a round wall, and displacements of the wall."""

from dataclasses import replace
from typing import Any

import numpy as np
from skfem.mesh import Mesh2D

from fem.plane.geometry import Array
from fem.plane.material import Assumption, Elastic
from fem.plane.solution import PlaneSolution
from fem.plane.solve import solve_plane


def solve_under_patch(
    mesh: Mesh2D, *, material: Elastic, assumption: Assumption, supports: Any, radius: float,
    a: float, P: float,
) -> PlaneSolution:  # fmt: skip
    """Solution of the body under half of the line load P [force/length] on its boundary "patch".

    The patch extends from the x axis along the arc of `radius` about the origin to the half-width a
    [length]. The other half of the load acts on the other side of the axis. At the end
    of the patch, the pressure falls to zero as a square root. With equal cells, this causes an
    integration error of order 3/2, about 1e-5 of the load. The result is therefore scaled to the
    load P/2.
    """
    peak = 2 * P / (np.pi * a)

    def pressure(x: Array) -> Array:
        arc = radius * np.arctan2(x[1], x[0])
        return np.asarray(peak * np.sqrt(np.maximum(1 - (arc / a) ** 2, 0.0)))

    body = solve_plane(
        mesh, materials=material, assumption=assumption, supports=supports,
        pressures={"patch": pressure},
    )  # fmt: skip
    patch = body.on_boundary("patch")
    k = P / 2 / float(patch.weight @ pressure(patch.x))
    return replace(body, u=k * body.u, internal=k * body.internal, f=k * body.f)


def polar_nodes(body: PlaneSolution, name: str) -> Array:
    """Angle [rad], u_r and u_theta [length] (3, m) of the nodes on `name`, sorted by angle.

    The polar coordinates are about the origin. The cells must be quadratic.
    """
    mesh, basis = body.basis.mesh, body.basis
    facets = mesh.boundaries[name]
    corners = basis.nodal_dofs[:, np.unique(mesh.facets[:, facets])]
    dofs = np.hstack([corners, basis.facet_dofs[:2, facets]])
    x, y = basis.doflocs[:, dofs[0]]
    theta = np.arctan2(y, x)
    order = np.argsort(theta)
    u_x, u_y = body.u[dofs]
    c, s = np.cos(theta), np.sin(theta)
    return np.array([theta, u_x * c + u_y * s, u_y * c - u_x * s])[:, order]
