"""Task of a spring design, and the parameters that a search may vary."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

from pydantic import model_validator

from verify.answers.assumed.complete import complete
from verify.answers.assumed.registry import DESIGN_SPRING_TASK as CASE
from verify.answers.assumed.rules import Assumed
from verify.core.inputs import InputError, Inputs, build, quantity, read_parameter_file, word
from verify.core.unit_systems import System, system_of
from verify.studies.design.sweep import Sweep

Arcs = Literal["centre line", "inner"]
Head = Literal["guided", "free"]
Tail = Literal["mid-leaf", "arc"]
MOST_CANDIDATES = 300_000

SWEEPS = {
    sweep.name: sweep
    for sweep in (
        Sweep(name="n", unit="1", what="numbers of segments", default=[8, 10, 12, 14],
              low=4, high=200, whole=True),
        Sweep(name="b", unit="mm", what="available strip thicknesses",
              default=["0.09 mm", "0.1 mm", "0.11 mm", "0.12 mm"],
              low=0, above=True, high=10),
        Sweep(name="L1", unit="mm", symbol="L_1", what="straight lengths of head and tail",
              default="10 mm : 14 mm : 41", low=0, above=True, high=1e3),
        Sweep(name="r", unit="mm", what="inner radii of the arcs",
              default="0.35 mm : 0.65 mm : 7", low=0, above=True, high=100),
        Sweep(name="alpha", unit="deg", symbol="α", what="angles of the arcs",
              default="77 deg : 83 deg : 7", low=20, high=90),
    )
}  # fmt: skip


class Demands(Inputs):
    """Required force and displacement of the spring, its material, and the limits of the design."""

    F_w: float = quantity("5 N", "N", "F_w", "working force", gt=0, le=1e5)
    L_w: float | None = quantity(
        "17.3 mm", "mm", "L_w", "length of the spring at the working force; or give U_w",
        omitted=None, gt=0, le=1e4,
    )  # fmt: skip
    U_w: float | None = quantity(
        None, "mm", "U_w", "working displacement, instead of L_w", omitted=None, gt=0, le=1e4,
        example="8.3 mm",
    )  # fmt: skip
    h: float = quantity("56 mm", "mm", "h", "width", gt=0, le=1e4, claims="wang2023:h")
    E: float = quantity("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5, claims="wang2023:E")
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45, claims="wang2023:nu")
    width_factor: float | None = quantity(
        None, "1", "f",
        "ratio of stiffness, wide to narrow strip; by default that of a leaf, computed as a plate",
        omitted=None, ge=1, le=1.3, example="1.0957",
    )  # fmt: skip
    arcs: Arcs = word(
        "centre line",
        "radius of the arcs in k_1: of the true centre line or, as in Eqs. 1-9, of the inner side",
    )
    head: Head = word("guided", "head guided by the roller or, as in Eqs. 1-9, free")
    tail: Tail = word(
        "mid-leaf", "clamping point of the tail: mid-leaf or, as in Eqs. 1-9, end of the arc"
    )
    wedge: float = quantity(
        "27 mm", "mm", "L_max", "length of the wedge, the largest free length",
        gt=0, le=1e4,
    )  # fmt: skip
    room: float | None = quantity(
        "15 mm",
        "mm",
        "H_max",
        "available transverse space; the spring needs 2 (L_1/2 + r + b)",
        omitted=None,
        gt=0,
        le=1e4,
    )
    sigma: float = quantity(
        "500 MPa", "MPa", "σ_max", "permissible bending stress at F_w", gt=0, le=1e5
    )
    margin: float = quantity(
        "15 %", "%", "m_A",
        "margin of U_w to U_A, where leaves touch (linear theory overestimates U_A by up to 1/8)",
        omitted=0.0, ge=0, le=1000,
    )  # fmt: skip
    sway: float | None = quantity(
        "20 %", "%", "m_cr", "margin of U_w to U_cr, where the spring buckles laterally",
        omitted=None, ge=0, le=1000,
    )  # fmt: skip
    friction: float = quantity(
        0.15, "1", "µ", "friction of touching leaves, in finite elements", omitted=0.0, ge=0, le=1,
        claims="wang2023:fea-friction-coefficient",
    )  # fmt: skip
    b_tolerance: float | None = quantity(
        "0.002 mm", "mm", "t_b", "tolerance of the thickness, ±", omitted=None, ge=0, le=1
    )
    k_band: float | None = quantity(
        "8 %",
        "%",
        "δ_k",
        "permissible change of stiffness by the tolerance of the thickness",
        omitted=None,
        gt=0,
        le=1000,
    )
    e_max: float = quantity(
        "3 %", "%", "e_r", "largest |U_w - Δ|/Δ", gt=0, le=100,
        claims="wang2023:rule-displacement-error-max",
    )  # fmt: skip
    ratio_min: float = quantity(
        0.3, "1", "Δ'_min", "smallest U_w/L_0", ge=0, lt=1,
        claims="wang2023:rule-displacement-ratio-min",
    )  # fmt: skip
    ratio_max: float = quantity(
        0.6, "1", "Δ'_max", "largest U_w/L_0", gt=0, le=1,
        claims="wang2023:rule-displacement-ratio-max",
    )  # fmt: skip
    z_max: float | None = quantity(
        240.0, "1", "z_max", "largest L_0/b, a rule without evidence", omitted=None, gt=0, le=1e6,
        claims="wang2023:rule-length-thickness-max",
    )  # fmt: skip

    @model_validator(mode="after")
    def _consistent(self) -> "Demands":
        if (self.L_w is None) == (self.U_w is None):
            given = "neither is given" if self.L_w is None else "both are given"
            raise ValueError(f"exactly one of L_w and U_w must be given: {given}")
        if not self.ratio_min < self.ratio_max:
            raise ValueError(
                f"ratio_min must be less than ratio_max, got ratio_min = {self.ratio_min:g}, "
                f"ratio_max = {self.ratio_max:g}"
            )
        if (self.b_tolerance is None) != (self.k_band is None):
            missing = "b_tolerance" if self.b_tolerance is None else "k_band"
            raise ValueError(f"b_tolerance and k_band must be given together: {missing} is missing")
        wide = 1 / (1 - self.nu**2)
        if self.width_factor is not None and self.width_factor > wide * (1 + 1e-12):
            raise ValueError(
                f"width_factor = {self.width_factor:g} must not exceed 1/(1 - ν²) = {wide:.5g}, "
                "the factor of an infinitely wide strip"
            )
        if self.L_w is not None and not self.L_w < self.wedge:
            raise ValueError(
                f"L_w must be less than wedge, got L_w = {self.L_w * 1e3:g} mm, "
                f"wedge = {self.wedge * 1e3:g} mm"
            )
        return self


@dataclass(frozen=True)
class Task:
    """A design task: demands, SI values of all varied parameters, and assumed inputs."""

    name: str
    demands: Demands
    ranges: Mapping[str, tuple[float, ...]]
    assumed: tuple[Assumed, ...] = ()
    system: System = "mm"

    @property
    def count(self) -> int:
        """Number of candidates."""
        return math.prod(len(values) for values in self.ranges.values())


def load(path: Path) -> Task:
    """Design task from the parameter file `path`.

    Raises InputError, which states the fault in one line, if the file is wrong.
    """
    case, name, raw = read_parameter_file(path)
    if case != CASE:
        raise InputError(
            f"{path}: case must be {CASE}, design-sprag or sprag-clutch, got {case[:60]!r}"
        )
    whole, assumed = complete(CASE, Demands, raw, str(path))
    return replace(task(whole, name, str(path)), assumed=assumed, system=system_of(raw))


def task(raw: Mapping[str, Any], name: str, where: str) -> Task:
    """Design task from the raw inputs of a parameter file; `where` names the file in messages.

    Raises InputError if an input is unknown, missing or out of its range.
    """
    known = (*Demands.model_fields, *SWEEPS)
    for key in raw:
        if key not in known:
            raise InputError(
                f"{where}: inputs.{key[:40]!s}: unknown key; allowed keys: {', '.join(known)}"
            )
    demands = build(Demands, {k: v for k, v in raw.items() if k not in SWEEPS}, where)
    assert isinstance(demands, Demands)
    if missing := [key for key in SWEEPS if key not in raw]:
        raise InputError(f"{where}: inputs: missing {', '.join(missing)}")
    ranges = {k: sweep.read(raw[k], f"{where}: inputs.{k}") for k, sweep in SWEEPS.items()}
    found = Task(name, demands, ranges)
    if found.count > MOST_CANDIDATES:
        raise InputError(
            f"{where}: inputs: n, b, L1, r and alpha make {found.count:,} candidates, "
            f"the maximum is {MOST_CANDIDATES:,}: give coarser ranges"
        )
    return found


def default() -> Task:
    """The task that the template describes."""
    ranges = {k: sweep.read(sweep.default, f"inputs.{k}") for k, sweep in SWEEPS.items()}
    return Task(f"my {CASE}", Demands(), ranges)
