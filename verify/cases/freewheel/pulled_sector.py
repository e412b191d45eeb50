"""Sectors of a freewheel under torque that are pulled along the axis, and what contacts bear."""

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from verify.cases.contact.errors import fem_errors
from verify.cases.freewheel.fem import Place, Sector, State
from verify.cases.freewheel.sweep import COARSE, FIRST, SPLIT, Start, after, rigid_force
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.contact.along import Along
    from verify.cases.freewheel.pulled import Pulled

Array = NDArray[np.float64]

AMPLE = 2.0  # friction over what statics asks for, where forces are measured
HARDER = 0.85  # d ln(approach)/d ln(T), about
NEAR, MOST = 1e-4, 12  # how near the torque coarse meshes come, and in how many steps
STILL = 1e-6  # of both approaches: what the roller may move while the ring creeps
EDGES = 1e-4  # of a value, as the ends of contacts lie between two nodes
PROBE = 0.3  # mu P'/G, the first step of the ring along z; it says how far all would yield


@dataclass(frozen=True)
class Borne:
    """What the contacts of one roller bear per length [N/m]: `N`, `F_t`, `F_z` (2,), star and ring.

    F_t is positive into the wedge, F_z as it acts on the races.
    """

    N: Array
    F_t: Array
    F_z: Array

    @classmethod
    def by(cls, state: State) -> "Borne":
        """Along the flat as it is turned, and the ray through the roller: where formulas stand."""
        N, F_t = np.array([state.on_flat, state.on_race]).T
        return cls(N, F_t, F_z=np.array([touch.force_z for touch in state.solution.touches]))

    @classmethod
    def on_mesh(cls, state: State) -> "Borne":
        """By the normals of the mesh, on which Coulomb's law acts and moments balance."""
        star, ring = state.solution.touches
        return cls(
            N=np.array([star.normal_force, ring.normal_force]),
            F_t=np.array([-star.friction_force, ring.friction_force]),
            F_z=np.array([star.force_z, ring.force_z]),
        )

    @property
    def tangent(self) -> float:
        """F_t/N at the mean angle of both contacts: they tilt to either side of the bisector."""
        return math.tan(float(np.arctan(self.F_t / self.N).mean()))

    @property
    def required(self) -> Array:
        """Resultant of the friction over N (2,)."""
        return np.asarray(np.hypot(self.F_t, self.F_z) / self.N)


def lever_left(mu: float, place: Place) -> float:
    """F_z/F_t that friction leaves for the axis at the angle of a place.

    The solver's cone stands on the normals of the mesh, thus at the angle where a state starts. The
    torque belongs to the one at which it rests, with the star as it is turned.
    """
    return math.sqrt((mu / math.tan(place.psi / 2)) ** 2 - 1)


def slipping(state: State) -> Array:
    """Share of N (2,) on nodes that slip; 1 where contact is lost."""
    return np.array([1 - touch.sticking_share for touch in state.solution.touches])


def fem_along(*, driven: bool) -> "Along":
    """The star is clamped along z as well, the ring's rim loaded or driven, rollers are free."""
    from fem.contact.along import Along

    return Along(supports={"star.bore": 0.0} | ({"ring.rim": 0.0} if driven else {}))


def sector(q: "Pulled", start: Start, cells: int, mu: float, *, driven: bool) -> Sector:
    place = Place.overlapping(q, *start.d)
    return Sector(place, start.widths, cells, mu=mu, along=fem_along(driven=driven))


def ample(q: "Pulled", place: Place) -> float:
    """Friction that holds torque and axial load well."""
    return AMPLE * math.tan(place.psi / 2) * math.hypot(1.0, q.F_ax * q.R / q.T)


@lru_cache(maxsize=8)
def wedged(q: "Pulled") -> Start:
    """Where the clutch lies under its torque, by coarse meshes."""
    P = rigid_force(q) / q.L
    whole = FIRST * P * (1 - q.nu**2) / q.E
    d = SPLIT * whole, (1 - SPLIT) * whole
    now = Start(d, (math.sqrt(q.r * d[0] / 2), math.sqrt(q.r * d[1] / 3)), (0.0, 0.0))
    for _ in range(MOST):
        state = now.state(q, COARSE)
        share = q.T / (state.torque * q.L)
        now = after(state).scaled(share**HARDER)
        if abs(share - 1) < NEAR:
            return now
    raise fem_errors().NotFoundError(f"the torque is missed by {share - 1:.1%}")


def at_torque(q: "Pulled", cells: int) -> Start:
    """The same on meshes of `cells`, whose zones stay where they are."""
    start = wedged(q)
    state = start.state(q, cells)
    found = after(state).scaled((q.T / (state.torque * q.L)) ** HARDER)
    return replace(found, widths=start.widths)


def pulled(q: "Pulled", there: Sector, rest: State) -> State:
    """The clutch at rest, then loaded on the ring's rim by F_ax/T of the torque that it has."""
    force = {"ring.rim": q.F_ax / q.T * rest.torque / q.z}
    return there.at(rest.drags, axial_forces=force, after=rest.solution)


def yielding(q: "Pulled", there: Sector, stuck: State) -> float:
    """How far [m] the ring would yield along z up to the limit if nothing slipped."""
    borne = Borne.on_mesh(stuck)
    N = borne.N.mean()
    u = PROBE * q.mu * N * 2 * (1 + q.nu) / q.E
    first = there.at(stuck.drags, after=stuck.solution, axial_displacements={"ring.rim": u})
    limit = N * math.sqrt(q.mu**2 - borne.tangent**2)
    return float(u * limit / Borne.on_mesh(first).F_z[0])


def creeping(there: Sector, state: State, ahead: float = 0.0, **along: Any) -> State:
    """On from `state` with the roller in its place: what it is let out, the ring takes it back.

    The ring turns on then, and N stays; by `ahead` [m] from the start, where that is known to be
    needed: then nodes that slip do so in the last solve, too. NotFoundError where the roller does
    not come to rest, or a solve finds no equilibrium.
    """
    drags, size = (state.drags[0], state.drags[1] + ahead), state.start.d_i + state.start.d_o
    for _ in range(MOST):
        new = there.at(drags, after=state.solution, **along)
        out, _ = new.motion
        if abs(out) <= STILL * size:
            return new
        drags = drags[0], drags[1] - 2 * out
    raise fem_errors().NotFoundError(f"the roller moves by {out:.1e} m after {MOST} steps")


def field(state: State) -> Field:
    """The sector under both loads: u_z and the shear stress along z."""
    solution = state.solution
    cells = solution.plane.cells()
    assert solution.along is not None
    corners = cells["cells"].astype(np.int64)
    u_z = solution.along.u[: len(cells["points"])]
    shear = np.hypot(*solution.along.stress().T)
    return Field(
        name="sector", points=cells["points"], cells=corners,
        point_data={"displacement": cells["displacement"], "u_z": u_z},
        cell_data={"shear_z": shear, "log_shear_z": np.log10(np.maximum(shear, 1.0) / 1e6),
                   "von_mises": cells["von_mises"]},
        units={"displacement": "m", "u_z": "m", "shear_z": "Pa", "log_shear_z": "1",
               "von_mises": "Pa"},
    )  # fmt: skip
