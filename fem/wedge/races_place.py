"""Position of a strut between two round races, for finite elements."""

from typing import TYPE_CHECKING, Protocol, Self

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D


class Place(Protocol):
    """Position and outline of a strut, whose pole is at the distance `D` [m] from the axis.

    `overlaps` are those of the undeformed outlines at both contacts, and H is their sum. `bends` is
    the part of the overlaps that is included in the mesh. `OA` and `OB` are the radii at which
    forces act. `spiral` contains pole, first radius, its direction and growth; `arc` contains
    centre and radius. Motion is evaluated at `core`.
    """

    @property
    def D(self) -> float: ...
    @property
    def OA(self) -> float: ...
    @property
    def OB(self) -> float: ...
    @property
    def H(self) -> float: ...
    @property
    def overlaps(self) -> tuple[float, float]: ...
    @property
    def bends(self) -> tuple[float, float]: ...
    @property
    def touched(self) -> tuple[float, float]: ...
    @property
    def core(self) -> tuple[float, float]: ...
    @property
    def spiral(self) -> tuple[tuple[float, float], float, float, float]: ...
    @property
    def arc(self) -> tuple[tuple[float, float], float]: ...
    def mesh(self, zones: tuple[float, float], cells: int) -> "Mesh2D": ...
    def settled(
        self, outwards: float, races: tuple[float, float], opened: tuple[float, float]
    ) -> Self: ...
