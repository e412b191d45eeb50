"""Case of a press fit: a race in its housing, two walls joined by contact only (Lamé)."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, ClassVar

import numpy as np

from verify.case import (
    Comparison,
    Level,
    Scan,
    State,
    balance,
    identity,
    picture,
)
from verify.cases.contact.press_fit import figures as drawn
from verify.cases.contact.press_fit.formulas import FitFormulas
from verify.cases.contact.press_fit.inputs import FITS
from verify.cases.contact.press_fit.reference import jitter, solve
from verify.core.figures import Picture
from verify.form.adapter import adapted

FAST = 1e-3, "on smooth fields, curved quadratic cells have errors far below 1 %, even if coarse"
DIRECT = "direct solution: machine epsilon times the condition number of the stiffness matrix"
MOST_CELLS = 400_000
SCATTERED = 1e-3  # limit for the scatter of the pressure due to rounded positions, relative to it
AROUND = 150  # about the number of nodes on a quarter of the finest mesh
THINNEST = 0.04  # wall over r_f: cells along the circumference must be shorter


class PressFit(FitFormulas):
    """A race and its housing touch along a whole circle; their meshes do not match there.

    The contact must transmit a uniform pressure. The interference is given as a number and, in
    another fit, by overlapping meshes. In a further fit, a solid shaft replaces the race.
    """

    id = "contact-press-fit"
    title = "Race pressed into its housing"
    source = "huang2018"
    place = "Eq. 6, based on Lamé's formulas; Table 1, radii of the outer race"
    levels: ClassVar = (1, 2, 4)
    scans: ClassVar = (
        Scan(vary=("r_i=5mm,12mm,19.44mm", "E_o=70GPa,206GPa", "nu_i=0.2,0.3"), star=True),
    )
    readings: ClassVar = (
        "δ is the interference of the radii, half of the interference of the diameters",
        "some fits have axially short walls (plane stress), the others axially long walls (plane "
        "strain)",
    )
    assumptions: ClassVar = (
        "the paper gives no fit: the housing (aluminium, rim radius 40 mm), δ and p_o are assumed; "
        "p_i is the force of the 12 sprags of the paper (3.4 kN each, over a length of 9 mm), "
        "distributed uniformly over the bore",
        "linear elasticity, small strain, no friction on the fit",
        "a quarter of each wall is modelled, with symmetry on both cuts",
    )

    def reference(self, level: int) -> Level:
        """Results of quarters of both walls, for all fits."""
        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: pressure, displacements, stresses, energy and balances of all fits."""
        fit = PressFit
        hoops = ((fit.hoop_inner_bore, "r_i"), (fit.hoop_inner_rim, "r_f"),
                 (fit.hoop_outer_bore, "r_f"), (fit.hoop_outer_rim, "r_o"))  # fmt: skip
        moved = ((fit.u_inner_bore, "r_i"), (fit.u_inner_rim, "r_f"),
                 (fit.u_outer_bore, "r_f"), (fit.u_outer_rim, "r_o"))  # fmt: skip
        load = max(self.p_i * self.r_i, self.p_o * self.r_o, self.p * self.r_f)
        for one in FITS:
            of = self.of(one) if one.key else self
            state = State(of, one.key, one.words)
            yield identity(fit.p, order=4, state=state, sensitivity=FAST)
            shared: dict[str, Any] = {
                "state": replace(state, displayed=not one.key), "sensitivity": FAST,
            }  # fmt: skip
            yield identity(
                fit.scatter, order=2, scale={f"mean contact pressure, {one.name}": of.p}, **shared
            )
            for q, r in moved[one.walls == "shaft" :]:
                yield identity(q, order=4, scale={f"largest displacement, {one.name}": of.moved},
                               symbol=f"u_r({r})", **shared)  # fmt: skip
            for q, r in hoops if one.walls == "rings" else ():
                yield identity(q, order=2, scale={f"largest stress, {one.name}": of.stress_scale},
                               symbol=f"σ_θ({r})", **shared)  # fmt: skip
            yield identity(fit.U, order=4, **shared)
            for wall in ("inner", "outer"):
                residual = f"{wall}_balance_{one.key}".removesuffix("_")
                yield balance(residual, f"balance of forces on the {wall} wall, {one.words}",
                              "ΣF_x", "N/mm", of={"load": load}, bound=1e-9,
                              because=DIRECT)  # fmt: skip

    figures = drawn.profiles

    def pictures(self) -> Iterator[Picture]:
        """Pictures: hoop stress of the rings, von Mises stress with a shaft."""
        for name, data, what in (
            ("rings", "hoop_stress", "Hoop stress of both rings"),
            ("shaft", "von_mises", "Von Mises stress with a solid shaft"),
        ):
            yield picture(f"{name}, plane stress", data,
                          f"{what}, plane stress (mean value of each cell)",
                          mirror="xy", displacement="")  # fmt: skip

    sketch = drawn.sketch

    def refusal(self) -> str:
        """Reason for not solving thin walls or small interferences; "" for other inputs."""
        wall = self.thinnest
        if wall < THINNEST * self.r_f:
            return (
                f"a wall of {wall * 1e3:.4g} mm is thinner than {THINNEST:.0%} of r_f: the cells "
                "are too long for a uniform pressure; run `check` without --fem"
            )
        if jitter(self, AROUND) > SCATTERED * min(self.of(fit).p for fit in FITS):
            return (
                f"delta = {self.delta * 1e6:.3g} µm is so small against r_f = {self.r_f * 1e3:.4g} "
                f"mm that round-off changes the pressure by more than {SCATTERED:g}: run `check` "
                "without --fem"
            )
        thin = np.log(min(2 * self.r_f / (self.r_f + self.r_i),
                          2 * self.r_o / (self.r_o + self.r_f)))  # fmt: skip
        finest = self.levels[-1]
        around = 12 * finest * max(12.0, np.pi / 2 / np.sqrt(2 * thin))
        cells = around * finest * (np.log(self.r_o / self.r_i) / 0.4 + 4)
        if cells <= MOST_CELLS:
            return ""
        return (
            f"walls this thin need {cells:,.0f} cells, more than {MOST_CELLS:,}: run `check` "
            "without --fem"
        )

    def warnings(self) -> Iterator[str]:
        """Warnings if a stress exceeds R_p, or if R_p is not given and a strain exceeds 0.2 %."""
        for fit, words in ((FITS[0], "the rings"), (FITS[3], "the hub of the solid shaft")):
            of = self.of(fit)
            centre = of.p if fit.walls == "shaft" else self.p_i
            pressures = (centre, of.p, of.p, self.p_o)
            worst = max(abs(s + p) for s, p in zip(of.hoops, pressures, strict=True))
            if self.R_p is not None and worst > self.R_p:
                yield (
                    f"Tresca stress {worst / 1e6:.4g} MPa in {words} exceeds R_p = "
                    f"{self.shown('R_p')}: the fit yields and its pressure decreases"
                )
            strain = worst / min(self.E_i, self.E_o)
            if strain > 2e-3 and self.R_p is None:
                yield f"strain reaches {strain:.2%} in {words}: most metals yield; enter R_p"


PRESS_FIT = adapted(PressFit)
