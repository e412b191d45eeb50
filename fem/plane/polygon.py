"""A ring with a polygonal bore under pressure by finite elements, in one call."""

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
    """A solved ring of outside diameter `d_e` [length] with `z` flats; `solution` has its fields.

    `fillet_stress` is the largest hoop stress [stress] in the fillets of the corners.
    """

    d_e: float
    z: int
    fillet_stress: float
    solution: PlaneSolution

    def growth(self, theta: ArrayLike) -> Array:
        """Radial displacement [length] of the outside at angles [rad] measured from a flat.

        Angles are 0 to pi/z, the angle of a corner; the ring is periodic.
        """
        theta = np.atleast_1d(np.asarray(theta, float))
        if not np.all((theta >= 0) & (theta <= np.pi / self.z * (1 + 1e-12))):
            raise ValueError(f"theta lies between 0 and pi/{self.z} rad, got {theta.tolist()}")
        return radial(self.solution, self.d_e / 2, theta)


def solve_polygon_ring(
    mesh: "Callable[..., Mesh2D]", *, z: int, d_e: float, d_i: float, fillet: float, E: float,
    nu: float, p: float, assumption: Literal["plane strain", "plane stress"] = "plane stress",
    refine: int = 2,
) -> PolygonRing:  # fmt: skip
    """A ring with `z` flats under the pressure `p` [stress] on its bore; any consistent units.

    `mesh` generates half a sector: `meshes.polyhedral.polygon_half_sector`, or a function with the
    same arguments. Outside diameter `d_e`, diameter `d_i` of the circle through the rounded
    corners, and their radius `fillet` [length]; E [stress], nu. With `refine` 2, the error of the
    growth is about 1e-4. ValueError for dimensions without a ring.

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
