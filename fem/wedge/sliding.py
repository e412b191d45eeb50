"""Wedged rollers whose ring is driven along the axis up to slip and beyond."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from fem.wedge.flat import Sector, State
from fem.wedge.flat_place import Place
from fem.wedge.flat_start import Start
from fem.wedge.pulled import Borne, Pulled, ample, creeping, pulled, sector

Array = NDArray[np.float64]


def under_load(one: Pulled, start: Start, cells: int) -> tuple[State, State]:
    """Two states of the clutch with ample friction: under torque alone, then with axial load."""
    mu = ample(one, Place.overlapping(one.q, *start.d))
    there = sector(one.q, start, cells, mu, driven=False)
    rest = there.rest(start.drags)
    return rest, pulled(one, there, rest)


def driven(there: Sector, stuck: State, displacements: Sequence[float]) -> Array:
    """States with the ring displaced to `displacements` [m] along z at constant N, as rows (m, 8).

    The columns are u_z [m] of the ring; the displacement [m] of its bore into the wedge; F_t/N of
    both contacts and F_z/N of both contacts, for the normals of the mesh; and N at the ring and
    T, both relative to the state `stuck`.
    """
    path, state = [_row(stuck, stuck, 0.0)], stuck
    for u in displacements:
        state = creeping(there, state, axial_displacements=_rim(there, u))
        path.append(_row(state, stuck, u))
    return np.array(path)


def let_out(there: Sector, stuck: State, displacements: Sequence[float]) -> Array:
    """States with the ring displaced along z without rotation, as rows (m, 8).

    The rollers then move out of the wedge. The columns are those of `driven`.
    """
    path, state = [_row(stuck, stuck, 0.0)], stuck
    for u in displacements:
        state = there.at(stuck.drags, after=state.solution, axial_displacements=_rim(there, u))
        path.append(_row(state, stuck, u))
    return np.array(path)


def _rim(there: Sector, u: float) -> dict[str, float]:
    return {there.place.q.names.race_held: u}


def _row(state: State, stuck: State, u: float) -> list[float]:
    b, drag = Borne.on_mesh(state), state.drags[1] - stuck.drags[1]
    return [
        u, drag, *(b.F_t / b.N), *(b.F_z / b.N), b.N[1] / Borne.on_mesh(stuck).N[1],
        state.torque / stuck.torque,
    ]  # fmt: skip
