"""Inputs of any rotor of coaxial shafts; the default has two shafts, one inside the other."""

from typing import Self

import numpy as np
from pydantic import model_validator

from verify.case import Case, count, given, table
from verify.cases.rotor import description
from verify.cases.rotor.description import (
    DiscInputs,
    LinkInputs,
    SegmentInputs,
    ShaftInputs,
    SupportInputs,
    UnbalanceInputs,
)
from verify.core import units

RPM = np.pi / 30
MOST_NODES = 150
FREQUENCIES, CRITICALS = 6, 3  # compared frequencies; compared critical speeds of each unbalance


def critical_name(group: int) -> str:
    """Name of the critical speeds that the unbalance of a shaft excites, in results."""
    return {1: "critical_first", 2: "critical_other"}.get(group, f"critical_{group}")


def _segments() -> tuple[SegmentInputs, ...]:
    """Default segments: a tube on a longer solid shaft."""
    tube = [(0.06, 0.07), (0.12, 0.07), (0.12, 0.07), (0.06, 0.06)]
    core = [(0.06, 0.03), (0.10, 0.035), (0.12, 0.035), (0.12, 0.035), (0.12, 0.035),
            (0.12, 0.035), (0.10, 0.035), (0.06, 0.03)]  # fmt: skip
    return (
        *(SegmentInputs(shaft="outer", length=z, d_o=d, d_i=0.05) for z, d in tube),
        *(SegmentInputs(shaft="inner", length=z, d_o=d) for z, d in core),
    )


class CoaxialRotor(Case):
    """Coaxial shafts with discs, bearings, links and unbalances."""

    speed_from: float = given(
        "5600 r/min",
        "r/min",
        "n_1",
        "lower limit of the operating speeds of the first shaft",
        ge=0,
        le=1e6,
    )
    speed_to: float = given(
        "9000 r/min",
        "r/min",
        "n_2",
        "upper limit of the operating speeds of the first shaft",
        gt=0,
        le=1e6,
    )
    margin: float = given(
        0.15,
        "1",
        "m_n",
        "separation margin of critical speeds from the operating speeds",
        ge=0,
        lt=1,
    )
    speed: float = given(
        "9000 r/min", "r/min", "n", "speed at which frequencies and amplitudes are reported", gt=0,
        le=1e6,
    )  # fmt: skip
    probe: int = count(4, "", "node whose amplitude is reported", ge=1, le=10_000)
    shafts: tuple[ShaftInputs, ...] = table(
        (ShaftInputs(name="outer", ratio=1.0, start=0.16), ShaftInputs(name="inner", ratio=1.4)),
        "Shafts. All speeds are those of the first shaft, whose ratio must be 1.",
        required=True,
    )
    segments: tuple[SegmentInputs, ...] = table(
        _segments(),
        "Segments, in their order along each shaft. Their ends are the nodes, numbered from 1 "
        "along the first shaft, then onwards along the next shaft.",
        required=True,
    )
    discs: tuple[DiscInputs, ...] = table(
        (
            DiscInputs(node=2, mass=3.0, polar=0.0090, diametral=0.0050, width=0.02),
            DiscInputs(node=4, mass=4.0, polar=0.0160, diametral=0.0085, width=0.02),
            DiscInputs(node=7, d_o=0.2, d_i=0.03, width=0.02),
            DiscInputs(node=13, d_o=0.22, d_i=0.035, width=0.025),
        ),
        "Rigid discs at nodes: mass, polar and diametral moment of inertia. For omitted values, "
        "give d_o, d_i, width and rho of a cylinder. Discs of one shaft must not overlap.",
    )
    supports: tuple[SupportInputs, ...] = table(
        (
            SupportInputs(node=1, k=6e7, c=800.0),
            SupportInputs(node=6, k=4e7, c=600.0),
            SupportInputs(node=14, k=4e7, c=600.0),
        ),
        "Bearings to the ground.",
        required=True,
    )
    links: tuple[LinkInputs, ...] = table(
        (LinkInputs(node=5, to=11, k=5e7, c=300.0),),
        "Bearings and clutches between two shafts.",
    )
    unbalances: tuple[UnbalanceInputs, ...] = table(
        (
            UnbalanceInputs(node=4, value=units.parse("14 g mm", "g mm")),
            UnbalanceInputs(node=13, value=units.parse("50 g mm", "g mm"), angle=np.pi / 2),
        ),
        "Unbalances, each of which rotates with its shaft.",
    )

    @model_validator(mode="after")
    def _sensible(self) -> Self:
        if not self.speed_from < self.speed_to:
            raise ValueError(
                f"speed_from must be below speed_to, got speed_from = {self.speed_from / RPM:g} "
                f"r/min, speed_to = {self.speed_to / RPM:g} r/min"
            )
        description.check_shafts(self.shafts, self.segments)
        nodes = len(self.segments) + len(self.shafts)
        if nodes > MOST_NODES:
            raise ValueError(
                f"the segments have {nodes} nodes; at most {MOST_NODES} are allowed: use fewer "
                "segments"
            )
        description.check_nodes(
            nodes, discs=self.discs, supports=self.supports, links=self.links,
            unbalances=self.unbalances,
        )  # fmt: skip
        if self.probe > nodes:
            raise ValueError(f"probe = {self.probe} must be one of the nodes 1 to {nodes}")
        return self
