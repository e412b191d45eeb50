"""Solution of a plane problem, and quantities evaluated from it.

Quantities are integrals over named boundaries and bodies, or energies. Stresses are evaluated at
quadrature points from the displacement gradient, without smoothing.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from skfem import Basis

from fem.plane.axis import depth, has_area, hoop_strain, on_axis
from fem.plane.cells import Cells
from fem.plane.discretisation import Array, Indices, facet_basis, named_cells, named_facets
from fem.plane.geometry import shapes, shapes_in
from fem.plane.incompressible import nearly_incompressible
from fem.plane.locate import locate
from fem.plane.means import Mean
from fem.plane.mixed import MixedCells, cells_of
from fem.plane.samples import Samples
from fem.plane.supports import Conditions, nearest_node
from fem.plane.ties import Tied
from fem.plane.traces import Trace


@dataclass(frozen=True)
class Held:
    """Ties and mean motions of a solution; the mean motions of displacements u are `rows` @ u."""

    tied: Tied
    rows: csr_array
    means: Mapping[str, Mean]

    def on_means(self, conditions: Conditions, reaction: Array) -> Array:
        """Forces (k,) conjugate to the mean motions, calculated from `reaction` (unknowns,)."""
        led = self.tied.led(conditions)
        rows = [led.beside(row) for row in (self.rows @ self.tied.P).toarray()]
        force, *_ = np.linalg.lstsq(np.array(rows).T, led.beside(self.tied.P.T @ reaction))
        return np.asarray(force)


@dataclass(frozen=True)
class PlaneSolution:
    """Displacements `u` (unknowns,) on `basis`, in equilibrium with the loads.

    `internal` (unknowns,) are the forces of the stresses, `f` the forces of the loads; their
    difference is the reaction of the supports. `lam`, `mu`, `ratio` are given per cell. `residual`
    is the energy of the last correction of the solver relative to the total energy. This ratio is
    the square of a relative displacement. With `turn`, x is the radius of a body of revolution and
    y its axial coordinate; integrals and forces then refer to the full circumference.
    """

    basis: Basis
    u: Array
    internal: Array
    f: Array
    lam: Array
    mu: Array
    ratio: Array
    thickness: float
    residual: float
    conditions: Conditions
    turn: bool = False
    held: Held | None = None

    @cached_property
    def strain_energy(self) -> float:
        """Half the integral of stress times strain, for the whole thickness [force x length].

        The energy is computed from the strains, not from u . K u. In slender bodies, the round-off
        of K times large rigid motions would exceed the strain energy.
        """
        return self.thickness * self._cells().strain_energy(self.u)

    @property
    def potential_energy(self) -> float:
        """Strain energy minus the work of the loads, f . u [force x length].

        The potential energy is stationary at the solution: its error is of second order in the
        error of u. Under loads without prescribed displacements, it is minus half the work of the
        loads; the compliance is then -2 x potential energy / force^2.
        """
        return self.strain_energy - float(self.f @ self.u)

    def reaction(self, boundary: str) -> tuple[float, float, float]:
        """Force (x, y) and moment about the origin that the supports of `boundary` exert.

        At a corner with several supports, the force is divided among the supports. In a body of
        revolution, x is the sum of the radial forces off the axis, y the axial force, and the
        moment is zero.
        """
        named_facets(self.basis.mesh, boundary)  # an unknown name is an error, not a zero
        return self._resultant(self.conditions.of(boundary))

    def reaction_at(self, point: tuple[float, float]) -> tuple[float, float]:
        """Force (x, y) that an anchor at `point` exerts.

        In a body of revolution, the result is the total force on the ring through the point.
        """
        node = nearest_node(self.basis, point)
        x, y, _ = self._resultant(self.conditions.anchored_at(node))
        return x, y

    def mean_reaction(self, boundary: str) -> dict[str, float]:
        """Force (x, y) and moment (r, about `Mean.about`) for prescribed motions of `boundary`."""
        means = {} if self.held is None else self.held.means
        if self.held is None or boundary not in means:
            known = ", ".join(means) or "none"
            raise ValueError(
                f"boundary {boundary!r} must have a prescribed mean motion; boundaries with mean "
                f"motions: {known}"
            )
        force, first = self._on_means, 0
        for name, mean in means.items():
            if name == boundary:
                break
            first += len(mean.held)
        return dict(zip(means[boundary].held, force[first:].tolist(), strict=False))

    def displacement_at(self, point: tuple[float, float]) -> tuple[float, float]:
        """Displacement (x, y) of the node at `point`. Raises ValueError if there is no node."""
        x, y = self.u[nearest_node(self.basis, point)]
        return float(x), float(y)

    def at(self, points: Array) -> Samples:
        """Samples at `points` (2, m), each from the cell that contains the point, with weight 1.

        For a point on an edge between cells, or in overlapping bodies, one of the cells is used.
        Raises ValueError for the first point that is outside by more than 1e-4 of a cell; this
        margin covers circles approximated by parabolas. On the axis of a body of revolution,
        u_r/r is replaced by du_r/dr.
        """
        points = np.asarray(points, float)
        if points.ndim != 2 or len(points) != 2 or not np.all(np.isfinite(points)):
            raise ValueError(f"points must be finite and of shape (2, m), got shape {points.shape}")
        cells, X = locate(self.basis.mesh, points)
        N, slope = shapes_in(self.basis.mesh, cells, self.basis.elem.elem, X[:, :, None])
        local = self.u[np.asarray(self.basis.element_dofs)[:, cells]].reshape(len(N), 2, cells.size)
        u = np.einsum("nim,nm->im", local, N[..., 0])
        grad = np.einsum("nim,jnm->ijm", local, slope[..., 0])
        one, no_side = np.ones(cells.size), np.zeros((2, 0))
        return Samples(points.copy(), u, self._stress(points, u, grad, cells), one, no_side)

    def on_boundary(self, name: str) -> Samples:
        """Samples along the boundary `name`; on an internal boundary, means of both sides.

        A boundary on the axis of a body of revolution has no area: its weights are lengths.
        """
        facets = named_facets(self.basis.mesh, name)
        near = self._along(facet_basis(self.basis, facets))
        if np.any(self.basis.mesh.f2t[1, facets] < 0):
            return near
        far = self._along(facet_basis(self.basis, facets, side=1))
        no_side = np.zeros((2, 0))
        return Samples(near.x, near.u, (near.stress + far.stress) / 2, near.weight, no_side)

    def in_body(self, name: str | None = None) -> Samples:
        """Samples in the cells of the body `name`, or in all cells."""
        cells = np.arange(self.lam.size)
        if name is not None:
            cells = named_cells(self.basis.mesh, name)
        own = self._cells()
        grad = own.gradient(self.u)[cells].transpose(3, 2, 0, 1)
        x = np.asarray(self.basis.global_coordinates())[:, cells]
        N, _ = shapes(self.basis.elem.elem, self.basis.X)
        u = np.einsum("mni,nq->imq", self.u[own.dofs[cells]], N)
        return Samples(
            x.reshape(2, -1),
            u.reshape(2, -1),
            self._stress(x, u, grad, cells).reshape(4, -1),
            own.dx[cells].ravel(),
            np.zeros((2, 0)),
        )

    def mean_displacement(
        self, boundary: str, direction: tuple[float, float] | Callable[[Array], Array]
    ) -> float:
        """Mean of u . direction over `boundary`.

        The direction is a vector, or a function f(x) that returns an array (2, m).
        """
        side = self.on_boundary(boundary)
        d = direction(side.x) if callable(direction) else np.reshape(direction, (2, 1))
        return side.mean((side.u * d).sum(axis=0))

    def cells(self) -> dict[str, Array]:
        """Mesh, displacements and stresses for pictures and files, as plain arrays.

        `points` (vertices, 2), `cells` (m, 3 or 4), `displacement` (vertices, 2), and for each cell
        the mean `stress` (m, 4: xx, yy, xy, zz or hoop) and `von_mises` (m,).
        """
        mesh, s = self.basis.mesh, self.in_body()
        weight = s.weight.reshape(mesh.nelements, -1)
        stress = np.array([
            (row.reshape(weight.shape) * weight).sum(axis=1) / weight.sum(axis=1)
            for row in s.stress
        ])  # fmt: skip
        xx, yy, xy, zz = stress
        mises = np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * xy**2)
        return {
            "points": mesh.doflocs[:, : mesh.nvertices].T.copy(),
            "cells": mesh.t.T.copy(),
            "displacement": self.u[self.basis.nodal_dofs].T.copy(),
            "stress": stress.T.copy(),
            "von_mises": mises,
        }

    def _cells(self) -> Cells:
        return cells_of(self.basis, self.lam, self.mu, turn=self.turn)

    @cached_property
    def _mixed(self) -> MixedCells | None:
        """Mixed cells, or None if no material is nearly incompressible."""
        if not nearly_incompressible(self.lam, self.mu):
            return None
        return MixedCells.of(self.basis, self.lam, self.mu, turn=self.turn)

    def _along(self, side: Trace) -> Samples:
        """Samples from the cells on one side of facets."""
        x = np.asarray(side.global_coordinates())
        u, grad = side.displacement(self.u)
        swept = self.turn and has_area(self.basis.mesh, side.find)
        return Samples(
            x.reshape(2, -1),
            u.reshape(2, -1),
            self._stress(x, u, grad, side.tind).reshape(4, -1),
            (np.asarray(side.dx) * depth(x, swept)).ravel(),
            np.asarray(side.normals).reshape(2, -1),
        )

    def _stress(self, x: Array, u: Array, grad: Array, cells: Indices) -> Array:
        """Stress (4, m, ...) at `x` (2, m, ...) in `cells` (m,), from u and its gradient."""
        column = -1, *[1] * (grad.ndim - 3)
        lam, mu, ratio = (a[cells].reshape(column) for a in (self.lam, self.mu, self.ratio))
        trace, hoop = grad[0, 0] + grad[1, 1], np.zeros(())
        if self.turn:
            reach = self.basis.mesh.p[0, self.basis.mesh.t[:, cells]].max(axis=0)
            hoop = hoop_strain(u[0], grad[0, 0], x[0], reach.reshape(column))
            trace = trace + hoop
        if self._mixed is not None:
            trace = self._mixed.dilatation_at(self.u, x, cells)
        dilation = lam * trace
        xx, yy = dilation + 2 * mu * grad[0, 0], dilation + 2 * mu * grad[1, 1]
        zz = dilation + 2 * mu * hoop if self.turn else ratio * (xx + yy)
        return np.array([xx, yy, mu * (grad[0, 1] + grad[1, 0]), zz])

    @cached_property
    def _on_means(self) -> Array:
        """Force (k,) along each prescribed mean motion."""
        assert self.held is not None
        return self.held.on_means(self.conditions, self.internal - self.f)

    def _resultant(self, chosen: NDArray[np.bool_]) -> tuple[float, float, float]:
        reaction = self.internal - self.f
        if self.held is None:
            forces = self.conditions.forces(reaction)
        else:
            if self.held.means:
                reaction = reaction - self.held.rows.T @ self._on_means
            forces = self.held.tied.forces(self.conditions, reaction)
        x, y = (self.conditions.direction * forces)[:, chosen]
        at = self.basis.doflocs[:, self.conditions.dofs[0, chosen]]
        if self.turn:
            return float(x[~on_axis(self.basis.mesh, at)].sum()), float(y.sum()), 0.0
        return float(x.sum()), float(y.sum()), float(at[0] @ y - at[1] @ x)
