"""Equilibrium states of a geometrically exact frame, and paths of states."""

from dataclasses import dataclass, replace

import numpy as np

from fem.beam.large_elements import Extended
from fem.beam.large_loading import Loading, Mask
from fem.beam.section import Array


@dataclass(frozen=True)
class BeamState:
    """Equilibrium state of a frame.

    `exact` (n, 3) are displacements and rotations in extended precision; `internal` (3n,) are the
    loads in balance with elements and terms. `work` is the work of loads and prescribed
    displacements along the path, integrated over the steps of the path with fourth order.
    `residuals` are the relative residuals of the Newton iterations of the last step. `negative` is
    the number of negative pivots of the tangent with prescribed supports: 0 if the state is stable
    under the loads or prescribed displacements of the path.
    """

    factor: float
    exact: Extended
    loading: Loading
    held: Mask
    internal: Array
    strain_energy: float
    term_energy: float = 0.0
    dissipated: float = 0.0
    work: float = 0.0
    residuals: tuple[float, ...] = ()
    steps: int = 1
    negative: int = 0

    @property
    def u(self) -> Array:
        """Displacements and rotations (n, 3)."""
        return self.exact.astype(float)

    @property
    def reactions(self) -> Array:
        """Forces and couples that supports exert on the nodes (n, 3); zero at free nodes."""
        f = np.where(self.held, self.internal - self.loading.forces(self.exact), 0.0)
        return f.reshape(-1, 3)

    @property
    def potential_energy(self) -> float:
        """Stored energy minus the potential of the dead loads [force x length]."""
        return self.strain_energy + self.term_energy - float(self.loading.dead @ self.u.ravel())

    def at(self, factor: float) -> "BeamState":
        """Copy of the state as the start of a new path; the load factor of the copy is `factor`."""
        return replace(self, factor=factor, residuals=(), steps=0)


State = BeamState  # its name in version 0.1


@dataclass(frozen=True)
class Path:
    """Equilibrium states in the order in which they were computed, beginning at `start`.

    `pattern` is the loading that the factor multiplies.
    """

    start: BeamState
    states: tuple[BeamState, ...]
    pattern: Loading  # loading that the factor multiplies

    @property
    def last(self) -> BeamState:
        return self.states[-1] if self.states else self.start

    @property
    def factors(self) -> Array:
        """Factors (k,) of the loads or prescribed displacements."""
        return np.array([state.factor for state in self.states])

    @property
    def u(self) -> Array:
        """Displacements and rotations (k, n, 3)."""
        return np.array([state.u for state in self.states])

    @property
    def reactions(self) -> Array:
        """Forces and couples (k, n, 3) that the supports exert."""
        return np.array([state.reactions for state in self.states])

    @property
    def strain_energy(self) -> Array:
        """Strain energy (k,) of the elements."""
        return np.array([state.strain_energy for state in self.states])

    @property
    def term_energy(self) -> Array:
        """Energy (k,) stored by the additional terms (contact, springs)."""
        return np.array([state.term_energy for state in self.states])

    @property
    def potential_energy(self) -> Array:
        """Stored energy minus the potential of the dead loads (k,)."""
        return np.array([state.potential_energy for state in self.states])

    @property
    def work(self) -> Array:
        """Work (k,) of loads and prescribed displacements since the reference state."""
        return np.array([state.work for state in self.states])

    @property
    def dissipated(self) -> Array:
        """Energy (k,) dissipated by the additional terms (friction)."""
        return np.array([state.dissipated for state in self.states])

    @property
    def residuals(self) -> tuple[tuple[float, ...], ...]:
        """Relative residuals of the Newton iterations in the last step that leads to each state."""
        return tuple(state.residuals for state in self.states)

    @property
    def negative(self) -> Array:
        """Number of negative pivots of the tangent stiffness in each state (k,)."""
        return np.array([state.negative for state in self.states])
