"""Plane frames at large displacement and rotation: geometrically exact beams with contact terms.

Simo, A finite strain beam formulation. The three-dimensional dynamic problem, part I (1985);
Reissner, On one-dimensional finite-strain beam theory: the plane problem (1972).
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from fem.beam.large_arc import collect, follow
from fem.beam.large_balance import Balance
from fem.beam.large_elements import reference
from fem.beam.large_loading import (
    Forces,
    Loading,
    Mask,
    Movements,
    held_components,
    loading,
    movement,
    nothing,
)
from fem.beam.large_march import March
from fem.beam.large_stability import CriticalPoint, critical_points, linear_buckling
from fem.beam.large_state import BeamState, Path
from fem.beam.section import (
    Array,
    Bodies,
    Loads,
    Sections,
    Supports,
    check_elements,
    check_rigid_motions,
    element_sections,
)
from fem.beam.terms import Term


class LargeFrame:
    """Plane frame of geometrically exact beams; the given shape is free of stress.

    Parameters
    ----------
    points, elements
        Nodes (n, 2) [length]; straight elements (m, 2), or curved elements (m, 3): ends, middle.
    sections
        One section, or a section for each of `bodies` (name to element numbers), with finite `GA`.
    supports
        For each supported node, the components "x", "y", "r" (rotation) that are fixed at zero.
    terms
        Additional terms such as contact; see `fem.beam.terms`.

    Raises
    ------
    ValueError
        For unknown names, missing shear stiffness, or folded elements.

    Examples
    --------
    A strip bent to a circle by an end couple, and its buckling load as a column:

    >>> import numpy as np
    >>> from fem.beam.section import Section
    >>> x = np.linspace(0, 1, 41)
    >>> k = 2 * np.arange(20)
    >>> frame = LargeFrame(
    ...     np.column_stack([x, 0 * x]), np.column_stack([k, k + 2, k + 1]),
    ...     sections=Section(EA=1e6, EI=1.0, GA=4e5), supports={0: "xyr"},
    ... )
    >>> path = frame.under_loads({40: (0, 0, 2 * np.pi)}, [0.5, 1.0])
    >>> (path.u[-1, 40] + [1, 0, 0]).round(4) + 0.0
    array([0.    , 0.    , 6.2832])
    >>> loads, modes = frame.linear_buckling({40: (-1, 0, 0)})
    >>> round(float(loads[0]) / (np.pi**2 / 4), 4)
    1.0
    """

    def __init__(
        self,
        points: ArrayLike,
        elements: ArrayLike,
        *,
        sections: Sections,
        supports: Supports,
        bodies: Bodies | None = None,
        terms: Sequence[Term] = (),
    ) -> None:
        self.points, nodes = np.asarray(points, float), np.asarray(elements, int)
        if nodes.ndim != 2 or nodes.shape[1] not in (2, 3):
            raise ValueError(f"elements must have 2 or 3 nodes each, got an array {nodes.shape}")
        check_elements(len(self.points), nodes)
        chosen = element_sections(len(nodes), sections, bodies)
        if not np.all(np.isfinite([s.GA for s in chosen])):
            raise ValueError("every section of a geometrically exact beam needs a finite GA")
        self.elements = reference(self.points, nodes, chosen)
        self.held = held_components(len(self.points), supports)
        self.terms = tuple(terms)
        self._sections, self._supports, self._bodies = sections, supports, bodies
        self._reached: BeamState | None = None  # last state of the terms

    def rest(self) -> BeamState:
        """Reference state without load; the history of all terms (contact, friction) is cleared."""
        n = len(self.points)
        u = np.zeros((n, 3), np.longdouble)
        for term in self.terms:
            term.start(np.column_stack([self.points, np.zeros(n)]))
        self._reached = BeamState(0.0, u, nothing(n), self.held, np.zeros(3 * n), 0.0)
        return self._reached

    def under_loads(
        self,
        loads: Loads | None,
        factors: Iterable[float],
        *,
        follower: Forces | None = None,
        distributed: Forces | None = None,
        since: BeamState | None = None,
    ) -> Path:
        """Equilibrium states under the loads times each of the `factors`.

        `loads`: for each node, a dead force (x, y) and couple. `follower`: for each node, a force
        that rotates with the node, given in the reference state. `distributed`: for each element, a
        dead force (x, y) per reference length. With `since` (a state of another path), these loads
        are added to the loads of that state. Terms store only the last state of the last path.

        Raises
        ------
        ValueError
            For unknown nodes and elements, possible rigid motions, or loads that are not finite.
        ArithmeticError
            If no equilibrium is found; the message states the factor and the residual.
        """
        pattern = loading(self.elements, loads, follower, distributed)
        return self._reach(pattern, self.held, factors, since)

    def displaced(
        self,
        moved: Movements,
        factors: Iterable[float],
        *,
        loads: Loads | None = None,
        since: BeamState | None = None,
    ) -> Path:
        """Equilibrium states at the node displacements `moved` times each of the `factors`.

        `moved` has components "x", "y" and the rotation "r" for each node. `reactions` include the
        forces that the displacements require. `loads` act in full in every state. With `since` (a
        state of another path), displacements and loads are added to those of that state.

        Raises
        ------
        ValueError, ArithmeticError
            See `under_loads`.
        """
        pattern, held = movement(len(self.points), moved)
        if loads:
            acting = loading(self.elements, loads, None, None)
            since = self._reach(acting, self.held | held, [1.0], since).last
        return self._reach(pattern, self.held | held, factors, since)

    def along_arc(
        self,
        loads: Loads | None,
        *,
        first: float,
        steps: int = 200,
        until: Callable[[BeamState], bool] | None = None,
        largest: float = 0.05,
        follower: Forces | None = None,
        distributed: Forces | None = None,
        moved: Movements | None = None,
        since: BeamState | None = None,
    ) -> Path:
        """States along the equilibrium path, with increasing or decreasing load or displacement.

        `first` is the first change of the factor; it defines step size and direction. Step sizes
        adapt to the number of Newton iterations, up to `largest`. The size of a step is the root
        mean square of the displacements (divided by the diagonal of the frame) and rotations [rad]
        of all nodes. The path ends after `steps` steps, or with the first state for which `until`
        returns True.

        Raises
        ------
        ValueError
            See `under_loads`; also if neither a load nor a displacement acts.
        ArithmeticError
            If a step does not converge, or if `until` returns True for no state within `steps`.
        """
        moving, held = movement(len(self.points), moved or {})
        pattern = loading(self.elements, loads, follower, distributed).plus(1.0, moving)
        march = self._march(pattern, self.held | held, since)
        start = march.state
        return self._end(Path(start, collect(follow(march, first, largest), steps, until), pattern))

    def buckling(self, path: Path) -> tuple[CriticalPoint, ...]:
        """Limit points and bifurcations between the states of a path, with their modes.

        Terms may store Lagrange multipliers, but no other history: friction is not permitted.

        Raises
        ------
        ValueError
            If terms dissipated energy on the path.
        """
        if path.last.dissipated:
            raise ValueError("critical points require a path without dissipation (friction)")
        balance = self._balance(path.start, path.pattern, path.start.held)
        return tuple(critical_points(balance, path))

    def linear_buckling(
        self, loads: Loads | None, *, count: int = 1, distributed: Forces | None = None
    ) -> tuple[Array, Array]:
        """Load factors (count,) and modes (count, n, 3) of linearised buckling.

        The `terms` of the frame (contact, friction, springs) are ignored. Displacements before
        buckling are assumed to be small. The largest displacement of a mode is 1.
        """
        pattern = loading(self.elements, loads, None, distributed)
        check_rigid_motions(self.points, self.elements.nodes, ~self.held)
        none = nothing(len(self.points))
        balance = Balance(self.points, self.elements, (), none, pattern, self.held)
        return linear_buckling(balance, count)

    def imperfect(self, mode: Array, amplitude: float, terms: Sequence[Term] = ()) -> "LargeFrame":
        """Frame with its stress-free shape displaced by `amplitude` times a mode (n, 3).

        `terms` are the additional terms of this new frame.
        """
        return LargeFrame(
            self.points + amplitude * mode[:, :2], self.elements.nodes,
            sections=self._sections, supports=self._supports, bodies=self._bodies, terms=terms,
        )  # fmt: skip

    def section_forces(self, state: BeamState) -> tuple[Array, Array]:
        """Undeformed positions of the Gauss points (m, q, 2), and N, V, M there (m, q, 3).

        Signs: see `fem.beam.section.FrameSolution`. Tension is positive; V = -dM/ds at small load.
        """
        e = self.elements
        strain, _, _ = e.strains(state.exact)
        stations = e.shape.astype(float) @ self.points[e.nodes]
        return stations, e.moduli * strain

    def _balance(self, start: BeamState, pattern: Loading, held: Mask) -> Balance:
        base = start.loading.plus(-start.factor, pattern)
        return Balance(self.points, self.elements, self.terms, base, pattern, held)

    def _reach(
        self, pattern: Loading, held: Mask, factors: Iterable[float], since: BeamState | None
    ) -> Path:
        targets = [float(factor) for factor in factors]
        if not np.isfinite(targets).all():
            raise ValueError(f"factors must be finite numbers, got {targets}")
        march = self._march(pattern, held, since)
        start = march.state
        return self._end(Path(start, tuple(march.reach(f) for f in targets), pattern))

    def _march(self, pattern: Loading, held: Mask, since: BeamState | None) -> March:
        if self.terms and since is not None and since is not self._reached:
            raise ValueError(
                "the terms of the model store the history of one load path only: continue from "
                "the last state of this path, or from the unloaded state"
            )
        start, self._reached = (since or self.rest()).at(0.0), None
        start = replace(start, held=start.held | held)
        if not self.terms:
            check_rigid_motions(self.points, self.elements.nodes, ~start.held)
        return March(self._balance(start, pattern, start.held), start)

    def _end(self, path: Path) -> Path:
        self._reached = path.last
        return path
