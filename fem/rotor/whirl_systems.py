"""Many undamped rotors with the same layout, in the complex coordinate of forward whirl.

Node n, from 0, has the unknowns (r, phi) at 2n and 2n + 1. Critical speeds Omega satisfy K v =
Omega^2 (M - G_1) v. For the elements, see `fem.rotor.elements`. Matrices are dense (m, 2 nodes, 2
nodes).
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from fem.rotor.elements import (
    Array,
    Sections,
    bending_stiffness,
    rotary_mass,
    translational_mass,
)
from fem.rotor.parts import Material


class Discs(NamedTuple):
    """Discs at one `node`: mass [kg], polar and diametral moment of inertia [kg m^2], each (m,)."""

    node: int
    mass: Array
    polar: Array
    diametral: Array


class Springs(NamedTuple):
    """Springs `k` (m,) between the unknowns i and j of all systems; j is None for the ground."""

    i: int
    j: int | None
    k: Array


@dataclass(frozen=True, kw_only=True)
class WhirlSystems:
    """Set of m systems, each with `nodes` nodes and e tubular elements.

    The elements begin at the nodes `first` (e,). `length`, `d_o`, `d_i` (m, e) are in [m]; `kappa`
    (e,) are shear coefficients. All elements have the same material.
    """

    nodes: int
    first: tuple[int, ...]
    length: Array
    d_o: Array
    d_i: Array
    kappa: Array
    material: Material
    discs: tuple[Discs, ...] = ()
    springs: tuple[Springs, ...] = ()

    @cached_property
    def elements(self) -> tuple[Array, Array, Array]:
        """Stiffness, mass and gyroscopic matrices (m, e, 4, 4) of the elements."""
        E, nu, rho = self.material.E, self.material.nu, self.material.rho
        A = np.pi / 4 * (self.d_o**2 - self.d_i**2)
        I = np.pi / 64 * (self.d_o**4 - self.d_i**4)  # noqa: E741 - the book's symbol
        GA = self.kappa * E / (2 * (1 + nu)) * A
        sections = Sections(
            L=self.length.ravel(), EI=E * I.ravel(), shear=GA.ravel(), EA=E * A.ravel(),
            GJ=E / (1 + nu) * I.ravel(), mass=rho * A.ravel(), rotary=rho * I.ravel(),
            polar=2 * rho * I.ravel(),
        )  # fmt: skip
        shape = (*self.length.shape, 4, 4)
        K, rotary = bending_stiffness(sections).reshape(shape), rotary_mass(sections).reshape(shape)
        return K, translational_mass(sections).reshape(shape) + rotary, 2 * rotary

    def matrices(self) -> tuple[Array, Array, Array]:
        """Matrices K, M and G_1 (m, 2 nodes, 2 nodes) of the systems."""
        shape = (self.length.shape[0], 2 * self.nodes, 2 * self.nodes)
        K, M, G = np.zeros(shape), np.zeros(shape), np.zeros(shape)
        for whole, parts in zip((K, M, G), self.elements, strict=True):
            for e, node in enumerate(self.first):
                at = slice(2 * node, 2 * node + 4)
                whole[:, at, at] += parts[:, e]
        for disc in self.discs:
            r, phi = 2 * disc.node, 2 * disc.node + 1
            M[:, r, r] += disc.mass
            M[:, phi, phi] += disc.diametral
            G[:, phi, phi] += disc.polar
        for i, j, k in self.springs:
            K[:, i, i] += k
            if j is not None:
                K[:, j, j] += k
                K[:, i, j] -= k
                K[:, j, i] -= k
        return K, M, G

    def energies(self, v: Array) -> tuple[Array, Array]:
        """Energies v K v and v (M - G_1) v (m, k) of the shapes v (m, 2 nodes, k)."""
        K, M, G = self.elements
        ends = v[:, np.array([2 * n for n in self.first])[:, None] + np.arange(4)]  # m, e, 4, k
        stiff = np.einsum("meik,meik->mk", ends, K @ ends)
        inert = np.einsum("meik,meik->mk", ends, (M - G) @ ends)
        for disc in self.discs:
            inert += disc.mass[:, None] * v[:, 2 * disc.node] ** 2
            inert += (disc.diametral - disc.polar)[:, None] * v[:, 2 * disc.node + 1] ** 2
        for i, j, k in self.springs:
            stiff += k[:, None] * (v[:, i] - (0 if j is None else v[:, j])) ** 2
        return stiff, inert

    def critical_speeds(self, count: int) -> tuple[Array, Array]:
        """Lowest forward critical speeds (m, count) [rad/s] and shapes (m, 2 nodes, count).

        Shapes are scaled to v K v = 1. If fewer speeds exist, the missing values are NaN.
        """
        K, M, G = self.matrices()
        inverse = np.linalg.inv(np.linalg.cholesky(K))
        squares, v = np.linalg.eigh(inverse @ (M - G) @ inverse.swapaxes(1, 2))
        squares, v = squares[:, : -count - 1 : -1], v[:, :, : -count - 1 : -1]
        speeds = 1 / np.sqrt(np.where(squares > 0, squares, np.nan))
        return speeds, inverse.swapaxes(1, 2) @ v
