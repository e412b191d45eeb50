"""Roller freewheel under torque and axial load, solved with finite elements."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from fem.wedge.flat_place import Names, Pitch, Place
from fem.wedge.pulled import Borne, Pulled, at_torque, pulled, sector

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

    from fem.contact.solution import ContactSolution

ZONE = 1.5  # half-widths of even cells about each contact
STAR = Names("star", "ring", "star.flat", "ring.bore", "star.bore", "ring.rim")


@dataclass(frozen=True)
class FreewheelState:
    """Equilibrium of a freewheel with flats on the inner part, the star.

    In each pair of numbers, the first belongs to the star, the second to the ring. `torque` [N m]
    and `axial_load` [N] of the clutch are calculated from the solution. `alpha` [rad] is the
    clamping angle, half of the angle between flat and ring. Values for one roller: normal forces
    `N` [N], `approaches` [m], half-widths `widths` [m], largest `pressures` [Pa], and
    `required_friction` [1] (resultant friction divided by N). `slides` is True if a contact slides.
    `solution` contains displacements and stresses of one pitch per unit length.
    """

    torque: float
    axial_load: float
    alpha: float
    N: tuple[float, float]
    approaches: tuple[float, float]
    widths: tuple[float, float]
    pressures: tuple[float, float]
    required_friction: tuple[float, float]
    slides: bool
    solution: "ContactSolution"


def solve_freewheel(
    mesh: "Callable[..., Mesh2D]", *, R: float, X: float, r: float, z: int, L: float, r_b: float,
    R_a: float, E: float, nu: float, mu: float, T: float, F_ax: float = 0.0, cells: int = 8,
) -> FreewheelState:  # fmt: skip
    """State of a freewheel with flats on the star under T [N m], then also the axial load F_ax [N].

    `mesh` generates one pitch: `meshes.freewheel.inner_cam_sector`, or a function with the same
    arguments. Dimensions [m]: radius R of the ring bore, distance X of the flats, `z` rollers of
    radius r and length L, bore radius r_b of the star, outer radius R_a of the ring. Material: E
    [Pa], nu, friction coefficient `mu` of all contacts. `cells` is the number of cells on half of
    each fine zone. The model assumes plane strain and small displacements. Both loads are accurate
    to 1e-3.

    Raises ValueError unless mu exceeds tan(alpha) without load and the loads are positive (F_ax may
    be 0). Raises ArithmeticError if no equilibrium is found, for example if the clutch slips
    axially.

    >>> from meshes.freewheel import inner_cam_sector
    >>> clutch = {"R": 21e-3, "X": 14.9e-3, "r": 3e-3, "z": 10, "L": 12e-3, "r_b": 8e-3}
    >>> steel = {"E": 206e9, "nu": 0.3, "mu": 0.1}
    >>> state = solve_freewheel(inner_cam_sector, **clutch, R_a=28e-3, **steel, T=20.0, cells=4)
    >>> without_load = math.acos((14.9 + 3) / (21 - 3)) / 2
    >>> print(f"{math.degrees(without_load):.2f} deg, at 20 N m {math.degrees(state.alpha):.2f}")
    3.02 deg, at 20 N m 3.19
    """
    if not (0 < T < math.inf and 0 <= F_ax < math.inf):
        raise ValueError(f"loads must be T > 0 N m and F_ax >= 0 N, got {T:g} N m and {F_ax:g} N")

    def drawn(place: Place, widths: tuple[float, float], cells: int) -> "Mesh2D":
        zones: Any = ZONE * widths[0], ZONE * widths[1]
        return mesh(
            R=R, X=X, R_a=R_a, r_b=r_b, r=r, z=z, centre=(place.x, place.y), zones=zones,
            cells=cells,
        )  # fmt: skip

    q = Pitch(sense=1, race=R, flat=X, r=r, r_b=r_b, R_a=R_a, z=z, E=E, nu=nu, names=STAR,
              mesh=drawn)  # fmt: skip
    steepest = math.tan(q.rigid_angle / 2)
    if not mu > steepest:
        raise ValueError(
            f"mu must be above tan(alpha) = {steepest:.4g} of the clutch without load, got {mu:g}"
        )
    one = Pulled(q, L, T, F_ax, mu)
    start = at_torque(one, cells)
    there = sector(q, start, cells, mu, driven=False)
    rest = there.rest(start.drags)
    state = pulled(one, there, rest) if F_ax else rest
    borne = Borne.by(state)
    return FreewheelState(
        torque=state.torque * L, axial_load=float(np.abs(borne.F_z).mean()) * L * z,
        alpha=(state.place.psi + state.tilt) / 2, N=_pair(borne.N * L),
        approaches=(state.place.d_i, state.place.d_o), widths=state.widths,
        pressures=state.peaks, required_friction=_pair(borne.required),
        slides=bool(state.solution.slides), solution=state.solution,
    )  # fmt: skip


def _pair(values: Any) -> tuple[float, float]:
    first, second = values
    return float(first), float(second)
