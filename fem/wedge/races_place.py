"""Position of a strut between two round races, for finite elements."""

from typing import TYPE_CHECKING, Protocol, Self

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D


class Place(Protocol):
    """Position and outline of a strut, whose pole is at the distance `D` [m] from the axis.

    `overlaps` are the overlaps of the undeformed outlines with both races, and H is their sum.
    `bends` is the part of the overlaps that is included in the mesh. `OA` and `OB` are the radii at
    which forces act. `spiral` contains the pole, the first radius, the direction of this radius,
    and the growth. `arc` contains the centre and the radius. The motion of the strut is evaluated
    at the point `core`.
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
