"""Rotors of coaxial shafts: input data in SI units.

    shaft = Shaft([Element(0.25, 0.05)] * 4)
    disc = Disc.cylinder(2, 0.3, 0.05, 0.04, 7850.0)
    rotor = Rotor([shaft], [disc], [Support(0, 1e8, cxx=2e3), Support(4, 1e8, 2e8, cxx=2e3)])
    modes(rotor, 300.0).frequencies                   # rad/s, and .whirl, .damping, .shapes
    campbell(rotor, np.linspace(0, 1000, 51)).frequencies
    critical_speeds(rotor).speeds
    unbalance_response(rotor, np.linspace(0, 1000, 501), {2: 1e-4}).orbit(2, 250)

Nodes are the ends of the given elements, numbered from 0 along the first shaft, then along the next
shaft. Each node has the unknowns (x, y, z, theta_x, theta_y, theta_z), right-handed.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from fem.rotor.assemble import System, assemble
from fem.rotor.blocks import Block, blocks
from fem.rotor.damping import Damping
from fem.rotor.elements import Array
from fem.rotor.parts import STEEL, Disc, Element, Link, Material, Shaft, SpeedSupport, Support

__all__ = [
    "STEEL", "Disc", "Element", "Link", "Material", "Rotor", "Shaft", "SpeedSupport", "Support",
]  # fmt: skip
THEORIES = ("timoshenko", "rayleigh", "euler")


@dataclass(frozen=True)
class Rotor:
    """Shafts with discs, supports and links, in SI units.

    Each given element is divided into `refine` elements. `theory` is "timoshenko", "rayleigh" (no
    shear) or "euler" (also no rotary inertia). Raises ValueError for nodes that do not exist, and
    for overlapping discs on a shaft.
    """

    shafts: Sequence[Shaft]
    discs: Sequence[Disc] = ()
    supports: Sequence[Support | SpeedSupport] = ()
    links: Sequence[Link] = ()
    refine: int = 1
    theory: str = "timoshenko"
    damping: Damping | None = None

    def __post_init__(self) -> None:
        if not self.shafts:
            raise ValueError("a rotor needs at least one shaft")
        if self.theory not in THEORIES:
            raise ValueError(f"theory must be one of {', '.join(THEORIES)}, got {self.theory!r}")
        if self.refine != int(self.refine) or self.refine < 1:
            raise ValueError(f"refine must be a whole number >= 1, got {self.refine}")
        count = self.stations
        named = [("disc", d.node) for d in self.discs]
        named += [("support", s.node) for s in self.supports]
        named += [("link", n) for link in self.links for n in (link.a, link.b)]
        for what, node in named:
            if node != int(node) or not 0 <= node < count:
                raise ValueError(
                    f"the node of a {what} must exist, got node {node}: nodes are 0 to {count - 1}"
                )
        self._check_discs()

    def _check_discs(self) -> None:
        wide = [d for d in self.discs if d.width > 0]
        for _, group in self._by_shaft(wide):
            for left, right in pairwise(sorted(group, key=lambda d: self.z[d.node])):
                gap = float(self.z[right.node] - self.z[left.node])
                gap -= (left.width + right.width) / 2
                if gap < -1e-9 * (left.width + right.width):
                    raise ValueError(
                        f"discs must not overlap: the discs at nodes {left.node} and {right.node} "
                        f"overlap by {-gap:g} m"
                    )

    def _by_shaft(self, discs: Sequence[Disc]) -> list[tuple[int, list[Disc]]]:
        return [
            (k, [d for d in discs if self.shaft_of[d.node] == k]) for k in range(len(self.shafts))
        ]

    @property
    def stations(self) -> int:
        """Number of numbered nodes."""
        return sum(len(s.elements) + 1 for s in self.shafts)

    @cached_property
    def first_nodes(self) -> NDArray[np.int64]:
        """Number of the first node of each shaft."""
        counts = [len(s.elements) + 1 for s in self.shafts]
        return np.concatenate([[0], np.cumsum(counts)[:-1]])

    @cached_property
    def z(self) -> Array:
        """Axial positions (stations,) [m] of the numbered nodes."""
        return np.concatenate(
            [s.z + np.cumsum([0.0, *(e.length for e in s.elements)]) for s in self.shafts]
        )

    @cached_property
    def shaft_of(self) -> NDArray[np.int64]:
        """Index (stations,) of the shaft of each numbered node."""
        return np.repeat(np.arange(len(self.shafts)), [len(s.elements) + 1 for s in self.shafts])

    @cached_property
    def system(self) -> System:
        """Assembled matrices."""
        return assemble(self)

    @cached_property
    def blocks(self) -> list[Block]:
        """Independent blocks of the matrices; supports have their coefficients at zero speed."""
        return blocks(self.system)

    @property
    def M(self) -> Array:
        """Mass matrix (n, n), six unknowns per node; inner nodes of refined elements are last."""
        return self.system.M

    @property
    def K(self) -> Array:
        """Stiffness matrix (n, n), without supports that depend on the speed."""
        return self.system.K

    @property
    def C(self) -> Array:
        """Damping matrix (n, n), without supports that depend on the speed."""
        return self.system.C

    @property
    def G(self) -> Array:
        """Skew-symmetric gyroscopic matrix (n, n) for a speed of 1 rad/s."""
        return self.system.G
