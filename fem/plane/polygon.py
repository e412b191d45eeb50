"""Ring with a polygonal bore under pressure, solved with finite elements."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import ArrayLike

from fem.plane.discretisation import Array
from fem.plane.material import Elastic
from fem.plane.sectors import largest_hoop_stress, radial
from fem.plane.solution import PlaneSolution
from fem.plane.solve import solve_plane

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D


@dataclass(frozen=True)
class PolygonRing:
    """Solution of a ring of outside diameter `d_e` [length] with `z` flats.

    `fillet_stress` is the largest hoop stress [stress] in the fillets of the corners. `solution`
    contains displacements and stresses.
    """

    d_e: float
    z: int
    fillet_stress: float
    solution: PlaneSolution

    def growth(self, theta: ArrayLike) -> Array:
        """Radial displacement [length] of the outer surface at angles [rad] from mid-flat.

        Angles must be between 0 and pi/z, the angle of a corner; the ring is periodic.
        """
        theta = np.atleast_1d(np.asarray(theta, float))
        if not np.all((theta >= 0) & (theta <= np.pi / self.z * (1 + 1e-12))):
            raise ValueError(f"theta must be between 0 and pi/{self.z} rad, got {theta.tolist()}")
        return radial(self.solution, self.d_e / 2, theta)


def solve_polygon_ring(
    mesh: "Callable[..., Mesh2D]", *, z: int, d_e: float, d_i: float, fillet: float, E: float,
    nu: float, p: float, assumption: Literal["plane strain", "plane stress"] = "plane stress",
    refine: int = 2,
) -> PolygonRing:  # fmt: skip
    """Solution of a ring with `z` flats under the pressure `p` [stress] on its bore.

    All units must be consistent. `mesh` generates half a sector:
    `meshes.polyhedral.polygon_half_sector`, or a function with the same arguments. `d_e` is the
    outside diameter, `d_i` the diameter of the circle through the rounded corners, `fillet` the
    radius of the corners [length]; E [stress], nu. With `refine` 2, the error of the radial
    displacement is about 1e-4 of the largest radial displacement, and less for a thin wall. Raises
    ValueError for dimensions that do not give a ring.

    >>> from meshes.polyhedral import polygon_half_sector
    >>> size = {"z": 6, "d_e": 80.0, "d_i": 72.0, "fillet": 2.0}  # mm, with MPa
    >>> ring = solve_polygon_ring(polygon_half_sector, **size, E=210e3, nu=0.3, p=10.0)
    >>> print(f"above a flat {ring.growth(0.0)[0] * 1e3:.2f} µm")
    above a flat 14.81 µm
    """
    solution = solve_plane(
        mesh(z=z, d_e=d_e, d_i=d_i, fillet=fillet, refine=refine), materials=Elastic(E=E, nu=nu),
        assumption=assumption, supports={"mid": "n", "corner": "n"}, pressures={"bore": p},
    )  # fmt: skip
    corner = np.pi / z
    centre = (d_i / 2 - fillet) * np.array([np.cos(corner), np.sin(corner)])
    stress = largest_hoop_stress(solution.on_boundary("fillet"), centre, corner, p)
    return PolygonRing(d_e, z, stress, solution)
