"""The rotor of a user's file as input of the transfer matrices; impossible rotors are rejected."""

from collections.abc import Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any, Self

import numpy as np
from pydantic import model_validator

from analytic.rotor.inertia import cylinder_inertia
from analytic.rotor.transfer_model import (
    Segment,
    SegmentedShaft,
    StationDisc,
    StationLink,
    StationSupport,
    TransferMatrixRotor,
)
from analytic.rotor.transfer_supported import check_supported
from verify.cases.rotor.description import DiscInputs, SpringInputs
from verify.cases.rotor.system.inputs import CoaxialRotor
from verify.core.inputs import EntryError

ROUNDED = 0.01  # permissible relative excess of rounded numbers over a bound


class DescribedRotor(CoaxialRotor):
    """A user's description of a rotor, with the rotor for the transfer matrices."""

    @model_validator(mode="after")
    def _is_rotor(self) -> Self:
        check_widths(self.discs, self.rotor)
        self._links_join_shafts()
        check_supported(self.rotor, tuple(shaft.name for shaft in self.shafts))
        return self

    def _links_join_shafts(self) -> None:
        for k, link in enumerate(self.links, start=1):
            a, b = (self.shafts[self.rotor.shaft_of[n - 1]] for n in (link.node, link.to))
            if a == b:
                raise EntryError(
                    "links", k, f"to = {link.to}",
                    f"node {link.node} must be on a shaft other than {a.name}: a link joins two "
                    "shafts",
                )  # fmt: skip
            if link.k_turn > 0 and a.ratio != b.ratio:
                raise EntryError(
                    "links", k, f"k_turn = {link.k_turn:g} N m/rad",
                    f"shafts {a.name} and {b.name} have different speeds: set the torsional "
                    "stiffness k_turn between them to 0",
                )  # fmt: skip

    @cached_property
    def rotor(self) -> TransferMatrixRotor:
        """Rotor for the transfer matrices; raises EntryError for invalid entries."""
        made = (
            SegmentedShaft(
                ratio=shaft.ratio,
                segments=tuple(
                    Segment(length=s.length, d_o=s.d_o, d_i=s.d_i, E=s.E, nu=s.nu, rho=s.rho)
                    for s in self.segments if s.shaft == shaft.name
                ),
            )
            for shaft in self.shafts
        )  # fmt: skip
        supports, links = self._springs()
        return TransferMatrixRotor(
            shafts=tuple(made), discs=discs_of(self.discs), supports=supports, links=links
        )

    def _springs(self) -> tuple[tuple[StationSupport, ...], tuple[StationLink, ...]]:
        """Bearings and links; raises EntryError for bad coefficients or links with equal nodes."""
        supports, links = [], []
        for k, entry in enumerate(self.supports, start=1):
            try:
                supports.append(StationSupport(node=entry.node - 1, **coefficients(entry)))
            except ValueError as error:
                raise EntryError("supports", k, "", str(error)) from error
        for k, link in enumerate(self.links, start=1):
            if link.node == link.to:
                raise EntryError("links", k, f"to = {link.to}", "must differ from node")
            try:
                links.append(StationLink(a=link.node - 1, b=link.to - 1, **coefficients(link)))
            except ValueError as error:
                raise EntryError("links", k, "", str(error)) from error
        return tuple(supports), tuple(links)

    @property
    def places(self) -> tuple[float, ...]:
        """Axial position of each node [m]."""
        start = [self.shafts[k].start for k in self.rotor.shaft_of]
        return tuple(z0 + z for z0, z in zip(start, self.rotor.places, strict=True))

    def unbalanced(self) -> dict[float, dict[int, complex]]:
        """Complex unbalances [kg m], first by speed ratio of the shaft, then by node (from 0)."""
        found: dict[float, dict[int, complex]] = {}
        for u in self.unbalances:
            ratio = self.shafts[self.rotor.shaft_of[u.node - 1]].ratio
            group = found.setdefault(ratio, {})
            group[u.node - 1] = group.get(u.node - 1, 0.0) + u.value * np.exp(1j * u.angle)
        return found


def coefficients(spring: SpringInputs) -> dict[str, Any]:
    """Coefficients of a bearing, by the names that the formulas use."""
    return {
        "kxx": spring.k, "kyy": spring.kyy, "kxy": spring.kxy, "cxx": spring.c, "cyy": spring.cyy,
        "k_tilt": spring.k_tilt, "c_tilt": spring.c_tilt, "k_turn": spring.k_turn,
    }  # fmt: skip


def inertia_of(disc: DiscInputs) -> tuple[float, float, float]:
    """Mass [kg], polar and diametral moment [kg m²]; raises ValueError if undetermined."""
    given = (disc.mass, disc.polar, disc.diametral)
    if disc.d_o is None or disc.width is None:
        if disc.mass is None or disc.polar is None or disc.diametral is None:
            raise ValueError(
                "give either mass, polar and diametral of the disc, or d_o and width of a cylinder"
            )
        return disc.mass, disc.polar, disc.diametral
    if not disc.d_i < disc.d_o:
        raise ValueError(
            f"d_i must be below d_o, got d_i = {disc.d_i * 1e3:g} mm, d_o = {disc.d_o * 1e3:g} mm"
        )
    own = cylinder_inertia(
        d_o=disc.d_o, d_i=disc.d_i, width=disc.width, rho=disc.rho, mass=disc.mass
    )
    m, p, d = (x if g is None else g for g, x in zip(given, own, strict=True))
    return m, p, d


def discs_of(discs: Sequence[DiscInputs]) -> tuple[StationDisc, ...]:
    """Discs of the formulas; raises EntryError if the mass of a disc is not determined."""
    found = []
    for k, disc in enumerate(discs, start=1):
        try:
            mass, polar, diametral = inertia_of(disc)
        except ValueError as error:
            raise EntryError("discs", k, "", str(error)) from error
        if polar > 2 * diametral * (1 + ROUNDED):
            raise EntryError(
                "discs", k, f"polar = {polar:.6g} kg m^2",
                f"must not exceed twice the diametral moment, {2 * diametral:.6g} kg m^2",
            )  # fmt: skip
        found.append(StationDisc(node=disc.node - 1, mass=mass, polar=polar, diametral=diametral))
    return tuple(found)


def check_widths(discs: Sequence[DiscInputs], rotor: TransferMatrixRotor) -> None:
    """Raise EntryError if two discs of a shaft overlap."""
    wide = sorted(
        (rotor.shaft_of[d.node - 1], rotor.places[d.node - 1], d.width or 0.0, k)
        for k, d in enumerate(discs, start=1)
    )
    for (shaft, z, width, k), (other, z2, width2, k2) in pairwise(wide):
        over = (width + width2) / 2 - (z2 - z)
        if shaft == other and width > 0 and width2 > 0 and over > 1e-9 * (width + width2):
            raise EntryError(
                "discs", k2, "",
                f"overlaps discs[{k}] by {over * 1e3:.4g} mm: reduce a width, or move a disc",
            )  # fmt: skip
