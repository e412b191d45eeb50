"""Rollers between flats and a ring under torque and axial load: their contact forces."""

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import NDArray

from fem.wedge.flat import Sector, State
from fem.wedge.flat_place import Pitch, Place
from fem.wedge.flat_start import Start, after, guessed_inside, loaded, rigid_force
from fem.wedge.rest import Unrest, at_rest

if TYPE_CHECKING:
    from fem.contact.along import Along

Array = NDArray[np.float64]

AMPLE = 2.0  # friction over that required by statics, where forces are measured
HARDER = 0.85  # d ln(approach)/d ln(T), about
NEAR, MOST = 1e-4, 12  # how near the torque coarse meshes come; steps of a ring that creeps
STILL = 1e-6  # of both approaches: allowed movement of the roller while the ring creeps
EDGES = 1e-4  # relative to a value, as the ends of contacts lie between two nodes
PROBE = 0.3  # mu P'/G, the first step of the ring along z; it would be the deflection of all


@dataclass(frozen=True)
class Pulled:
    """Pitch `q` with rollers of length `L` [m], and loads and friction of the clutch.

    The loads are the torque `T` [N m] and the axial load `F_ax` [N]; `mu` is the friction
    coefficient.
    """

    q: Pitch
    L: float
    T: float
    F_ax: float
    mu: float

    @property
    def lever(self) -> float:
        """Ratio F_ax R/T of axial load to torque."""
        return self.F_ax * self.q.race / self.T


@dataclass(frozen=True)
class Borne:
    """Contact forces of one roller per length [N/m]: `N`, `F_t`, `F_z` (2,) at cam and ring.

    F_t is positive into the wedge; F_z acts on the races.
    """

    N: Array
    F_t: Array
    F_z: Array

    @classmethod
    def by(cls, state: State) -> Self:
        """Contact forces with the directions that the formulas use.

        At the cam, N and F_t are normal and tangential to the flat in its rotated position. At the
        ring, they act along the ray through the roller, and perpendicular to the ray.
        """
        N, F_t = np.array([state.on_flat, state.on_race]).T
        return cls(N, F_t, F_z=np.array([touch.force_z for touch in state.solution.touches]))

    @classmethod
    def on_mesh(cls, state: State) -> Self:
        """Contact forces for the normals of the mesh, which satisfy Coulomb's law."""
        cam, ring = state.solution.touches
        return cls(
            N=np.array([cam.normal_force, ring.normal_force]),
            F_t=np.array([-cam.friction_force, ring.friction_force]),
            F_z=np.array([cam.force_z, ring.force_z]),
        )

    @property
    def tangent(self) -> float:
        """Ratio F_t/N as the tangent of the mean of the angles atan(F_t/N) of both contacts."""
        return math.tan(float(np.arctan(self.F_t / self.N).mean()))

    @property
    def required(self) -> Array:
        """Resultant friction divided by N (2,)."""
        return np.asarray(np.hypot(self.F_t, self.F_z) / self.N)


def lever_left(mu: float, place: Place) -> float:
    """Ratio F_z/F_t at the friction limit, for the wedge angle of the roller at `place`.

    The friction cone of the solver refers to the normals of the mesh, at the angle of the initial
    position. The torque depends on the angle in equilibrium, with the cam in its rotated position.
    """
    return math.sqrt((mu / math.tan(place.psi / 2)) ** 2 - 1)


def slipping(state: State) -> Array:
    """Share (2,) of N at nodes that slip, for each contact; 1 if contact is lost."""
    return np.array([1 - touch.sticking_share for touch in state.solution.touches])


def held_along(q: Pitch, *, driven: bool) -> "Along":
    """Supports along z: the cam is clamped, and rollers are free.

    If `driven`, the displacement of the rim of the ring is prescribed; otherwise the rim is loaded.
    """
    from fem.contact.along import Along

    rim = {q.names.race_held: 0.0} if driven else {}
    return Along(supports={q.names.cam_held: 0.0} | rim)


def sector(q: Pitch, start: Start, cells: int, mu: float, *, driven: bool) -> Sector:
    """Pitch at the initial position `start`, with the friction coefficient `mu`.

    If `driven`, the rim of the ring is displaced along z; otherwise the rim is loaded along z.
    """
    place = Place.overlapping(q, *start.d)
    return Sector(place, start.widths, cells, mu=mu, along=held_along(q, driven=driven))


def ample(one: Pulled, place: Place) -> float:
    """Friction coefficient well above the value that torque and axial load require."""
    return AMPLE * math.tan(place.psi / 2) * math.hypot(1.0, one.F_ax * one.q.race / one.T)


@lru_cache(maxsize=8)
def wedged(q: Pitch, L: float, T: float) -> Start:
    """Approximate state of the clutch under its torque [N m], on coarse meshes."""
    return loaded(
        q, guessed_inside(q, rigid_force(q, T) / L), lambda state: T / (state.torque * L),
        power=HARDER, near=NEAR, what="the torque",
    )  # fmt: skip


def at_torque(one: Pulled, cells: int) -> Start:
    """Approximate state of the clutch under its torque, with `cells` cells on half of each zone.

    The fine zones have the half-widths that were found on coarse meshes.
    """
    start = wedged(one.q, one.L, one.T)
    state = start.state(one.q, cells)
    found = after(state).scaled((one.T / (state.torque * one.L)) ** HARDER)
    return replace(found, widths=start.widths)


def pulled(one: Pulled, there: Sector, rest: State) -> State:
    """State of the clutch under torque and a subsequent axial load on the rim of the ring.

    The axial load is F_ax/T times the torque of the solution.
    """
    force = {one.q.names.race_held: one.F_ax / one.T * rest.torque / one.q.z}
    return there.at(rest.drags, axial_forces=force, after=rest.solution)


def yielding(one: Pulled, there: Sector, stuck: State) -> float:
    """Displacement [m] of the ring along z at the friction limit, calculated without slip."""
    q, borne = one.q, Borne.on_mesh(stuck)
    N = borne.N.mean()
    u = PROBE * one.mu * N * 2 * (1 + q.nu) / q.E
    rim = {q.names.race_held: u}
    first = there.at(stuck.drags, after=stuck.solution, axial_displacements=rim)
    limit = N * math.sqrt(one.mu**2 - borne.tangent**2)
    return float(u * limit / Borne.on_mesh(first).F_z[0])


def creeping(there: Sector, state: State, ahead: float = 0.0, **along: Any) -> State:
    """State after `state`, with the creep of the roller compensated by rotation of the ring.

    The roller therefore remains in its position, and N is constant. In the first solution, the ring
    is rotated by `ahead` [m]. If this is the necessary rotation, nodes that slip also slip in the
    last solution. Raises NotFoundError if the roller does not come to rest, or if a solution finds
    no equilibrium.
    """
    size = state.start.d_i + state.start.d_o

    def unrest(new: State) -> Unrest:
        out, _ = new.motion
        return Unrest(abs(out), size, (new.drags[0], new.drags[1] - 2 * out))

    return at_rest(
        lambda drags: there.at(drags, after=state.solution, **along),
        (state.drags[0], state.drags[1] + ahead), unrest, body="roller", most=MOST, still=STILL,
    )  # fmt: skip
