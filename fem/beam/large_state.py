"""Equilibrium states of a geometrically exact frame, and paths of them."""

from dataclasses import dataclass, replace

import numpy as np

from fem.beam.large_elements import Extended
from fem.beam.large_loading import Loading, Mask
from fem.beam.section import Array


@dataclass(frozen=True)
class BeamState:
    """One state in equilibrium.

    `exact` (n, 3) are displacements and rotation in extended precision; `internal` (3n,) are the
    loads in balance with elements and terms. `work` is the work of loads and moved supports along
    the path, a fourth-order integral over its steps. `residuals` are the relative residuals of the
    Newton iterations of the last step. `negative` is the number of negative pivots of its tangent
    with prescribed supports: 0 if the state is stable under the control of the path.
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
        """Displacements and rotation (n, 3)."""
        return self.exact.astype(float)

    @property
    def reactions(self) -> Array:
        """Force and couple that supports exert on the nodes (n, 3), zero on free nodes."""
        f = np.where(self.held, self.internal - self.loading.forces(self.exact), 0.0)
        return f.reshape(-1, 3)

    @property
    def potential_energy(self) -> float:
        """Stored energy less the potential of the dead loads [force x length]."""
        return self.strain_energy + self.term_energy - float(self.loading.dead @ self.u.ravel())

    def at(self, factor: float) -> "BeamState":
        """The state as the start of a path that counts from `factor`."""
        return replace(self, factor=factor, residuals=(), steps=0)


State = BeamState  # its name in version 0.1


@dataclass(frozen=True)
class Path:
    """States in the order in which a driver reached them from `start`.

    `held` is the number of supported and prescribed displacements.
    """

    start: BeamState
    states: tuple[BeamState, ...]
    pattern: Loading  # loading that the factor multiplies

    @property
    def last(self) -> BeamState:
        return self.states[-1] if self.states else self.start

    @property
    def factors(self) -> Array:
        """Factor of the pattern of loads or movement (k,)."""
        return np.array([state.factor for state in self.states])

    @property
    def u(self) -> Array:
        """Displacements and rotations (k, n, 3)."""
        return np.array([state.u for state in self.states])

    @property
    def reactions(self) -> Array:
        """Forces and couples that the supports exert (k, n, 3)."""
        return np.array([state.reactions for state in self.states])

    @property
    def strain_energy(self) -> Array:
        """Strain energy of the elements (k,)."""
        return np.array([state.strain_energy for state in self.states])

    @property
    def term_energy(self) -> Array:
        """Stored by the terms (k,)."""
        return np.array([state.term_energy for state in self.states])

    @property
    def potential_energy(self) -> Array:
        """Stored energy less the exact potential of the dead loads (k,)."""
        return np.array([state.potential_energy for state in self.states])

    @property
    def work(self) -> Array:
        """Work of loads and moved supports since the reference state (k,)."""
        return np.array([state.work for state in self.states])

    @property
    def dissipated(self) -> Array:
        """Energy that the terms lost (k,)."""
        return np.array([state.dissipated for state in self.states])

    @property
    def residuals(self) -> tuple[tuple[float, ...], ...]:
        """Relative residuals of the Newton iterations of each state's last step."""
        return tuple(state.residuals for state in self.states)

    @property
    def negative(self) -> Array:
        """Negative pivots of the tangent (k,)."""
        return np.array([state.negative for state in self.states])
