"""Bodies of revolution whose loads vary around the axis: one (r, z) problem per harmonic.

FourierSolid(mesh, Elastic(E=210e9, nu=0.3), {"middle": "z"}).solve(
    {0: {"rim": (-p, 0, 0)}, 2: {"rim": (-p, 0, 0)}})       # p (1 + cos 2 t) on the rim
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from scipy.sparse import csr_array
from skfem import Basis, ElementVector
from skfem.mesh import Mesh2D

from fem.cholesky import Cholesky
from fem.fourier.condensed import Selected, flexibility
from fem.fourier.harmonic_cells import HarmonicCells
from fem.fourier.loads import Tractions, surface_load, turn_of
from fem.fourier.solution import FourierSolution, HarmonicSolution
from fem.fourier.supports import check_components, check_held, free_unknowns
from fem.plane.discretisation import Array, Indices, named_facets, vector_basis
from fem.plane.incompressible import refuse
from fem.plane.loads import moduli
from fem.plane.material import Elastic
from fem.plane.ordering import nested_dissection

AMPLITUDES = 3  # along r, t and z
RESIDUAL_LIMIT = 1e-8  # relative to the load's forces, after the correction


@dataclass(frozen=True)
class FourierSolid:
    """Linear elastic bodies on a `mesh` of their half-section: x is r >= 0, y is z.

    `materials` is one material, or one for each body in `mesh.subdomains`. `supports` states, for
    each boundary, the components "r", "t", "z" that are zero in every harmonic. `degree` of the
    displacements is 1 or 2, by default the degree of the mesh. Raises ValueError for unknown names,
    and for cells that have no material or nu > 0.45, are folded, or cross the axis.
    """

    mesh: Mesh2D
    materials: Elastic | Mapping[str, Elastic]
    supports: Mapping[str, str] = field(default_factory=dict)
    degree: int | None = None

    def __post_init__(self) -> None:
        check_components(self.supports)
        for name in self.supports:
            named_facets(self.mesh, name)
        _ = self.cells  # raises for a wrong mesh and wrong materials here

    @cached_property
    def basis(self) -> Basis:
        """Basis with three amplitudes per node."""
        plane = vector_basis(self.mesh, self.degree, turn=True)
        return Basis(
            self.mesh, ElementVector(plane.elem.elem, AMPLITUDES), quadrature=plane.quadrature
        )

    @cached_property
    def cells(self) -> HarmonicCells:
        """Cells with their moduli."""
        lam, mu, _ = moduli(self.mesh, self.materials, "axisymmetric")
        refuse(self.mesh, lam, mu, "harmonics of nearly incompressible bodies are not covered")
        return HarmonicCells.of(self.basis, lam, mu)

    @cached_property
    def _first(self) -> csr_array:
        """Part K_0 of the stiffness, the only part that the harmonic n = 0 requires."""
        return self.cells.stiffness_parts((0,))[0]

    @cached_property
    def parts(self) -> tuple[csr_array, csr_array, csr_array]:
        """Parts K_0, K_1, K_2 of the stiffness, for one radian."""
        second, third = self.cells.stiffness_parts((1, 2))
        return self._first, second, third

    def stiffness(self, signed: int) -> csr_array:
        """Stiffness of harmonic |`signed`|, for one radian, without zero entries.

        A negative `signed` denotes the antisymmetric harmonic.
        """
        if signed:
            K_0, K_1, K_2 = self.parts
            return K_0 + signed * K_1 + signed**2 * K_2
        K = self._first.copy()
        K.eliminate_zeros()
        return K

    @cached_property
    def place(self) -> Indices:
        """Position (unknowns,) of every unknown in the order of elimination."""
        return nested_dissection(self.basis)

    def harmonic(self, n: int, *, antisymmetric: bool = False) -> "Harmonic":
        """Factorised harmonic `n`, with the displacements (U cos n t, V sin n t, W cos n t).

        If `antisymmetric`, the displacements are (U sin n t, V cos n t, W sin n t). Raises
        ValueError unless n is a whole number >= 0, and if a body can move rigidly.
        """
        return Harmonic.of(self, _whole(n), antisymmetric)

    def flexibility(self, n: int, f: Array) -> Array:
        """Work f_i . u_j (k, k) of each load f_i on the displacements u_j that the load f_j causes.

        The loads are the columns of `f` (unknowns, k). The method is intended for forces on few
        unknowns, such as pressures on one surface: these unknowns are eliminated last, and the
        displacements of all others are not computed. The harmonics are symmetric. Raises ValueError
        under the conditions that are stated for `harmonic`.
        """
        return next(self.flexibilities((n,), f))

    def flexibilities(self, orders: Iterable[int], f: Array) -> Iterator[Array]:
        """Results of `flexibility` for each of the harmonics `orders`, for the same loads `f`."""
        place = np.where(np.any(f, axis=1), self.basis.N, 0) + self.place
        higher: Selected | None = None
        factor: Cholesky | None = None
        for n in map(_whole, orders):
            if n < 2:
                own = Harmonic.of(self, n, False, place)
                yield flexibility(own.factor, own.T, f)
                continue
            # from n = 2 on no rigid motion is left, and the same unknowns are free
            if higher is None:
                T = free_unknowns(self.basis, self.supports, n, False, place)
                higher = Selected.of(self.parts, T)
            K = turn_of(n) * higher.stiffness(n)
            if factor is None:
                factor = Cholesky(K)
            else:
                factor.renew(K)
            yield flexibility(factor, higher.T, f)

    def solve(self, tractions: Mapping[int, Tractions]) -> FourierSolution:
        """Solution as the sum of symmetric harmonics n under `tractions[n][boundary]`.

        The tractions are amplitudes (t_r, t_t, t_z) [stress].
        """
        return FourierSolution(tuple(self.harmonic(n).solve(own) for n, own in tractions.items()))


@dataclass(frozen=True)
class Harmonic:
    """Harmonic `n` of `solid`, with factorised stiffness K of the full circumference; u = T q."""

    solid: FourierSolid
    n: int
    antisymmetric: bool
    T: csr_array
    K: csr_array
    factor: Cholesky

    @classmethod
    def of(
        cls, solid: FourierSolid, n: int, antisymmetric: bool, place: Indices | None = None
    ) -> "Harmonic":
        """Harmonic factorised in the order `place` (unknowns,); by default the order of `solid`."""
        place = solid.place if place is None else place
        T = free_unknowns(solid.basis, solid.supports, n, antisymmetric, place)
        check_held(solid.basis, T, n, antisymmetric)
        K = turn_of(n) * (T.T @ solid.stiffness(-n if antisymmetric else n) @ T)
        return cls(solid, n, antisymmetric, T, K, Cholesky(K))

    def solve(self, tractions: Tractions) -> HarmonicSolution:
        """Solution under tractions with amplitudes (t_r, t_t, t_z) [stress], by boundary.

        The amplitudes are numbers or functions f(x).
        """
        f = surface_load(self.solid.basis, tractions, self.n)
        u = self.displacements(f)
        return HarmonicSolution(
            self.solid.basis, self.solid.cells, self.n, self.antisymmetric, u, f
        )

    def displacements(self, f: Array) -> Array:
        """Displacement amplitudes (unknowns, ...) under the forces `f` (unknowns, ...).

        The solution is corrected once by its residual. Raises ArithmeticError if the residual
        exceeds 1e-8 of the forces.
        """
        load = self.T.T @ f
        q = self.factor.solve(load)
        q += self.factor.solve(load - self.K @ q)
        missed = abs(load - self.K @ q).max(initial=0.0)
        if not missed <= RESIDUAL_LIMIT * abs(load).max(initial=0.0):
            raise ArithmeticError(
                f"harmonic {self.n}: the residual of the linear solver is {missed:.1e}, too "
                f"large for forces up to {abs(load).max():.1e}"
            )
        return np.asarray(self.T @ q)


def _whole(n: int) -> int:
    if n != int(n) or n < 0:
        raise ValueError(f"a harmonic must be a whole number >= 0, got {n}")
    return int(n)
