"""Cross-sections of plane beams, and solutions of frames."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_array
from scipy.sparse.csgraph import connected_components

from fem.beam.links import Solver, Ties, check_ties, positive_factor, tied_solver, ties

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

DOFS = "xyr"  # displacements and rotation (counter-clockwise) of a node
MAX_CORRECTIONS = 60
CONVERGED = 1e-24  # relative energy, the square of relative displacements
ROUND_OFF = 1e-18
RESIDUAL_LIMIT = 1e-12


@dataclass(frozen=True, kw_only=True)
class Section:
    """Axial stiffness `EA`, bending stiffness `EI` and shear stiffness `GA` of a cross-section.

    `GA` is shear area times G. It may be infinite (Euler-Bernoulli) for elements that allow it.
    """

    EA: float
    EI: float
    GA: float = math.inf

    def __post_init__(self) -> None:
        if not (self.EA > 0 and self.EI > 0 and self.GA > 0):
            raise ValueError(f"EA, EI and GA must be positive, got {self}")
        if not (math.isfinite(self.EA) and math.isfinite(self.EI)):
            raise ValueError(f"EA and EI must be finite, got {self}")


Sections = Section | Mapping[str, Section]
Bodies = Mapping[str, Indices]
Supports = Mapping[int, str | Mapping[str, float]]
Loads = Mapping[int, tuple[float, float, float]]


@dataclass(frozen=True)
class FrameSolution:
    """Solution of a frame.

    `u` (nodes, 3) are displacements and rotations. `reactions` (nodes, 3) are the forces and
    couples that the supports exert; at free nodes they are round-off. `f` (3 nodes,) are the loads.
    `residual` is the energy of the solver's last correction relative to the total energy. This
    ratio is the square of a relative displacement. `section_forces` (elements, k, 3) are axial
    force, shear force and bending moment at the `stations` (elements, k, 2) of each element: both
    ends of a straight element, the Gauss points of a curved element. `link_forces` (links,) are
    positive if they separate the two points of a link along its direction. Tension is positive. The
    moment EI d(rotation)/ds and the shear force along the normal (the tangent rotated by +90 deg)
    follow the direction of the element: V = -dM/ds.
    """

    points: Array
    u: Array
    reactions: Array
    f: Array
    strain_energy: float
    residual: float
    between_nodes: float = 0.0  # energy of loads along elements, part of strain_energy
    stations: Array = field(default_factory=lambda: np.zeros((0, 2, 2)))
    section_forces: Array = field(default_factory=lambda: np.zeros((0, 2, 3)))
    link_forces: Array = field(default_factory=lambda: np.zeros(0))

    @property
    def potential_energy(self) -> float:
        """Strain energy minus the work of the loads [force x length].

        It is stationary at the solution: the effect of an error of u is of second order. Under
        loads without prescribed displacements, it is minus half the work of the loads; the
        compliance is then -2 x potential energy / force^2.
        """
        # energy of elements between fixed ends is half of the work of their loads there
        return self.strain_energy - 2 * self.between_nodes - float(self.f @ self.u.ravel())

    def reaction(self, node: int) -> tuple[float, float, float]:
        """Force (x, y) and couple that the supports exert on `node`."""
        x, y, couple = self.reactions[node]
        return float(x), float(y), float(couple)


def check_elements(count: int, elements: Indices) -> None:
    """Raise ValueError for unknown nodes and for nodes without an element."""
    named = set(elements.ravel().tolist())
    if unknown := sorted(named - set(range(count))):
        raise ValueError(f"no node {unknown[0]}: the frame has nodes 0 to {count - 1}")
    if idle := sorted(set(range(count)) - named):
        raise ValueError(f"every node must belong to an element, but node {idle[0]} does not")


def element_sections(count: int, sections: Sections, bodies: Bodies | None) -> list[Section]:
    """Section of every element.

    Raises ValueError for unknown bodies and for elements without a section.
    """
    if isinstance(sections, Section):
        return [sections] * count
    found: list[Section | None] = [None] * count
    for name, section in sections.items():
        if name not in (bodies or {}):
            raise ValueError(f"no body {name!r}; bodies: {', '.join(bodies or {}) or 'none'}")
        for i in (bodies or {})[name]:
            found[int(i)] = section
    complete = [section for section in found if section is not None]
    if len(complete) < count:
        raise ValueError(f"{count - len(complete)} of {count} elements have no section")
    return complete


def solve_supported(
    points: Array,
    elements: Indices,
    K: csc_array,
    f: Array,
    supports: Supports,
    loads: Loads,
    strains: Callable[[Array], Array],
    forces: Callable[[Array], tuple[float, Array]],
    tied: Ties | None = None,
) -> tuple[FrameSolution, Array]:
    """Solution and strains of a frame under nodal `loads`, with `supports` and links applied.

    Each node has three unknowns. `strains` is linear in the displacements (nodes, 3). `forces`
    returns the strain energy and the internal forces (nodes, 3) for given strains. The strains are
    sums over the corrections, each with full precision. Strains calculated from the total
    displacement would contain the round-off of large rigid motions, which causes large errors of
    the forces in stiff members.
    """
    n = len(points)
    f, u = f.copy(), np.zeros(3 * n)
    for node, load in loads.items():
        f[_rows(n, node)] += load
    free = np.ones(3 * n, bool)
    for node, support in supports.items():
        items = dict.fromkeys(support, 0.0) if isinstance(support, str) else support
        for component, value in items.items():
            if component not in DOFS:
                raise ValueError(f"node {node}: components must be x, y or r, got {component!r}")
            i = _rows(n, node).start + DOFS.index(component)
            free[i], u[i] = False, value
    tied = tied or ties(n, ())
    alone = True
    if tied.count:
        alone = check_ties(tied, points, _parts(n, elements), free)
    else:
        check_rigid_motions(points, elements, free)
    solve = _factorised(csc_array(K[free][:, free]), csc_array(tied.B[:, free]), alone)
    change, stiff = math.inf, abs(K)
    strained, correction = strains(u.reshape(-1, 3)), np.zeros(3 * n)
    pushing = np.zeros(tied.count)
    for _ in range(MAX_CORRECTIONS):
        energy, internal = forces(strained)
        residual = (f + tied.B.T @ pushing - internal.ravel())[free]
        apart = tied.g - tied.B @ u
        correction[free], more = solve(residual, apart)
        work = abs(float(residual @ correction[free])) + abs(float(apart @ more))
        u, pushing = u + correction, pushing + more
        strained = strained + strains(correction.reshape(-1, 3))
        before = change
        size = abs(f @ u) + 2 * energy + ROUND_OFF * (abs(u) @ (stiff @ abs(u)))
        change = work / float(size) if size else 0.0
        if change < CONVERGED or not change < before / 2:
            break
    if not change < RESIDUAL_LIMIT:
        raise ArithmeticError(
            f"the linear solver did not converge: the energy of the last correction is "
            f"{change:.1e} of the total energy, at most {RESIDUAL_LIMIT:.0e} is allowed"
        )
    energy, internal = forces(strained)
    reactions = internal - (f + tied.B.T @ pushing).reshape(-1, 3)
    solution = FrameSolution(
        points, u.reshape(-1, 3), reactions, f, energy, change, link_forces=pushing
    )
    return solution, strained


def _factorised(K: csc_array, B: csc_array, alone: bool) -> Solver:
    try:
        if B.shape[0]:
            return tied_solver(K, B, alone)
        factor = positive_factor(K)
    except RuntimeError as error:  # SuperLU's error for a zero pivot
        raise ValueError(
            "the frame is a mechanism: support the part that can move freely"
        ) from error
    return lambda residual, _: (factor.solve(residual), np.zeros(0))


def _rows(n: int, node: int) -> slice:
    if not 0 <= node < n:
        raise ValueError(f"no node {node}: the frame has nodes 0 to {n - 1}")
    return slice(3 * node, 3 * node + 3)


def _parts(count: int, elements: Indices) -> Indices:
    """For each node, the number of the connected part of the frame to which the node belongs."""
    first = np.repeat(elements[:, :1], elements.shape[1], axis=1).ravel()
    joined = csc_array((np.ones(first.size), (first, elements.ravel())), shape=(count, count))
    return np.asarray(connected_components(joined, directed=False)[1], dtype=np.int64)


def check_rigid_motions(points: Array, elements: Indices, free: NDArray[np.bool_]) -> None:
    """Raise ValueError if a connected part of the frame can move rigidly."""
    part = _parts(len(points), elements)
    parts = int(part.max()) + 1
    for k in range(parts):
        members = np.flatnonzero(part == k)
        at = points[members] - points[members].mean(axis=0)
        x, y = (at / max(np.ptp(at, axis=0).max(), 1e-300)).T
        one, zero = np.ones_like(x), np.zeros_like(x)
        modes = np.stack([[one, zero, zero], [zero, one, zero], [-y, x, one]])  # mode, dof, node
        held = modes.transpose(2, 1, 0)[~free.reshape(-1, 3)[members]]
        _, s, v = np.linalg.svd(np.vstack([held, np.zeros((3, 3))]), full_matrices=False)
        if s[2] < 1e-9:
            motion = ", ".join(
                f"{c:+.2g} {word}"
                for c, word in zip(v[2], ("x", "y", "rotation"), strict=True)
                if abs(c) > 1e-9
            )
            which = "the frame" if parts == 1 else f"the part of node {members[0]}"
            raise ValueError(f"{which} can move rigidly ({motion}): support it against this motion")
