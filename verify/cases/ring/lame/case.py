"""Case of a thick ring: race of a clutch under uniform pressure (Lamé)."""

from collections.abc import Iterator
from typing import Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from analytic.ring import lame
from verify.case import (
    AlongLine,
    Case,
    Comparison,
    Level,
    Quantity,
    Scan,
    State,
    balance,
    errors_of,
    given,
    identity,
    picture,
    sketches,
)
from verify.cases.ring import walls
from verify.core.case import Context
from verify.core.figures import Picture, Shape, Sketch
from verify.form.adapter import adapted
from verify.form.sketches import polar
from verify.judging.checks import Order

DIRECT = "direct solution: machine epsilon times the condition number (below 1e7)"
Ends = Literal["plane stress", "plane strain"]
ENDS: tuple[Ends, ...] = ("plane stress", "plane strain")
AROUND = np.linspace(22.5, 337.5, 8)  # degrees: arrows of the sketch


class Ring(Case):
    """Lamé's thick ring is the structural model of every race in the papers.

    Formula and finite elements solve the same problem; they differ only by the discretisation
    error.
    """

    id = "ring-lame"
    title = "Thick ring under uniform pressure"
    source = "huang2018"
    place = "Eq. 6, based on Lamé's formulas"
    levels: ClassVar = (2, 4, 8, 16)
    ends: ClassVar[Ends] = "plane stress"  # ends for the quantities below
    scans: ClassVar = (
        Scan(
            vary=("r_i=5mm,12mm,19.44mm,24mm", "nu=0.1,0.3,0.45", "p_o=0MPa,30MPa,90MPa"),
            star=True,
        ),
    )
    readings: ClassVar = (
        "positive pressures act towards the wall: p_i widens the bore, p_o compresses the rim",
        "the race is computed as an axially short ring (plane stress) and as an axially long ring "
        "(plane strain): in-plane stresses are equal, displacements and energies differ",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain",
        "the pressure is uniform around and along the ring",
        "a quarter is modelled, with symmetry on both cuts",
    )

    r_i: float = given(
        "19.44 mm", "mm", "r_i", "bore radius", gt=0, le=1e5, claims="huang2018:table1-r-e"
    )
    r_o: float = given(
        "26.23 mm", "mm", "r_o", "outer radius", gt=0, le=1e5, claims="huang2018:table1-r-ed"
    )
    p_i: float = given("100 MPa", "MPa", "p_i", "pressure in the bore", ge=-1e5, le=1e5)
    p_o: float = given("30 MPa", "MPa", "p_o", "pressure on the rim", omitted=0.0, ge=-1e5, le=1e5)
    E: float = given("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    R_p: float | None = given(
        None, "MPa", "R_p", "yield strength", omitted=None, gt=0,
        example="1200 MPa",
    )  # fmt: skip

    @model_validator(mode="after")
    def _wall(self) -> Self:
        walls.check_wall(self.r_i, self.r_o)
        if self.p_i == self.p_o == 0:
            raise ValueError("p_i or p_o must differ from 0 MPa: the ring has no load")
        return self

    @Quantity("A", "MPa", "mean of radial and hoop stress", role="step",
              source="Lamé; basis of Eq. 6",
              tex=r"\frac{p_i r_i^2 - p_o r_o^2}{r_o^2 - r_i^2}")  # fmt: skip
    def A(self) -> float:
        return sum(float(s[1]) for s in self._stresses) / 2

    @Quantity("B", "N", "(σ_θ − σ_r) r²/2, equal at all r", role="step",
              source="Lamé; basis of Eq. 6",
              tex=r"\frac{(p_i - p_o) r_i^2 r_o^2}{r_o^2 - r_i^2}")  # fmt: skip
    def B(self) -> float:
        radial, hoop = self._stresses
        return float(hoop[0] - radial[0]) / 2 * self.r_i**2

    @Quantity("u_r(r_i)", "µm", "bore displacement", source="Lamé",
              tex=r"\frac{(1 - \nu) A r_i + (1 + \nu) \frac{B}{r_i}}{E}")  # fmt: skip
    def u_bore(self) -> float:
        return self._displacement(self.r_i)

    @Quantity("u_r(r_o)", "µm", "rim displacement", source="Lamé",
              tex=r"\frac{(1 - \nu) A r_o + (1 + \nu) \frac{B}{r_o}}{E}")  # fmt: skip
    def u_rim(self) -> float:
        return self._displacement(self.r_o)

    @Quantity("U", "J/m", "strain energy", source="Lamé",
              tex=r"\pi (p_i r_i u_r(r_i) - p_o r_o u_r(r_o))")  # fmt: skip
    def U(self) -> float:
        return float(lame.strain_energy(E=self.E, nu=self.nu, ends=self.ends, **self._loads))

    @Quantity("σ_θ(r_i)", "MPa", "bore hoop stress", source="Lamé", tex=r"A + \frac{B}{r_i^2}")
    def hoop_bore(self) -> float:
        return float(self._stresses[1][0])

    @Quantity("σ_θ(r_o)", "MPa", "rim hoop stress", source="Lamé", tex=r"A + \frac{B}{r_o^2}")
    def hoop_rim(self) -> float:
        return float(self._stresses[1][2])

    @Quantity("σ_r(r_m)", "MPa", "mid-wall radial stress", source="Lamé",
              tex=r"A - \frac{4 B}{(r_i + r_o)^2}")  # fmt: skip
    def radial_mid(self) -> float:
        return float(self._stresses[0][1])

    @Quantity("σ_θ(r_m)", "MPa", "mid-wall hoop stress", source="Lamé",
              tex=r"A + \frac{4 B}{(r_i + r_o)^2}")  # fmt: skip
    def hoop_mid(self) -> float:
        return float(self._stresses[1][1])

    @Quantity("σ_z", "MPa", "axial stress, plane strain", source="Lamé", tex=r"2 \nu A")
    def axial(self) -> float:
        return float(lame.axial_stress(nu=self.nu, ends="plane strain", **self._loads))

    @property
    def _loads(self) -> dict[str, Any]:
        return {"r_i": self.r_i, "r_o": self.r_o, "p_i": self.p_i, "p_o": self.p_o}

    @property
    def _stresses(self) -> tuple[lame.Array, lame.Array]:
        """Radial and hoop stresses [Pa] at bore, mid-wall and rim, each of shape (3,)."""
        return lame.stresses([self.r_i, (self.r_i + self.r_o) / 2, self.r_o], **self._loads)

    def _displacement(self, r: float) -> float:
        plain: dict[str, Any] = {"E": self.E, "nu": self.nu, "ends": self.ends}
        return float(lame.radial_displacement(r, **plain, **self._loads))

    def as_long(self) -> Self:
        """The ring in plane strain."""
        return self.variant(ends="plane strain")

    def reference(self, level: int) -> Level:
        """Results of a quarter of the ring: plane stress, plane strain, straight cell edges."""
        from verify.cases.ring.lame.reference import solve

        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Order]:
        """Rows: thin and long ring against Lamé; orders of convergence."""
        ring, long = Ring, self.as_long()
        thin_and_long = (State(self, "", ENDS[0]), State(long, "strain", ENDS[1]))
        both: dict[str, Any] = {"sensitivity": walls.FAST}
        stress = {
            "largest pressure or hoop stress":
            max(abs(self.p_i), abs(self.p_o), *np.abs(self._stresses[1]))
        }  # fmt: skip
        for state, ends in zip(thin_and_long, ENDS, strict=True):
            thick: Any = state.case
            scale = {f"largest wall displacement, {ends}": max(abs(thick.u_bore), abs(thick.u_rim))}
            for u in (ring.u_bore, ring.u_rim):
                yield identity(u, state=state, scale=scale, order=4, **both)
        for state in thin_and_long:
            yield identity(ring.U, state=state, order=4, **both)
        for state in thin_and_long:
            for sigma in (ring.hoop_bore, ring.hoop_rim, ring.radial_mid, ring.hoop_mid):
                yield identity(sigma, state=state, scale=stress, order=2, **both)
        yield identity(ring.axial, scale=stress, order=4, **both)
        load = abs(self.p_i) * self.r_i + abs(self.p_o) * self.r_o
        for state in thin_and_long:
            residual = "balance_strain" if state.key else "balance"
            yield balance(residual, f"balance of forces, {state.words}", "ΣF_x", "N/mm",
                          of={"sum of the pressure forces": load}, bound=1e-9,
                          because=DIRECT)  # fmt: skip
        order: dict[str, Any] = {"symbol": "p", "unit": "1"}
        for state in thin_and_long:
            yield Order(name=f"order of convergence of the strain energy, {state.words}", order=4,
                        **order, errors=errors_of(ring.U, state=state),
                        **walls.SQUARED)  # fmt: skip
        yield Order(name="order of convergence of the displacement in the L2 norm", order=3,
                    **order, errors=displacement_errors(""))  # fmt: skip
        yield Order(name="order of convergence of the strain energy, straight cell edges", order=2,
                    **order, errors=errors_of(ring.U, "U_straight",
                                              state=thin_and_long[1]))  # fmt: skip
        yield Order(name="order of convergence of the displacement in the L2 norm, straight cell "
                    "edges", order=2, **order, errors=displacement_errors("_straight"))  # fmt: skip

    def figures(self) -> Iterator[AlongLine]:
        """Figures: stresses and displacement over the wall of the long ring."""
        long = self.as_long()
        scale = max(abs(self.p_i), abs(self.p_o), *np.abs(self._stresses[1]))
        yield from walls.profiles(
            self, "plane strain", lambda r: lame.stresses(r, **self._loads),
            lambda r: lame.radial_displacement(
                r, E=self.E, nu=self.nu, ends="plane strain", **self._loads
            ),
            stress=scale, moved=max(abs(long.u_bore), abs(long.u_rim)),
        )  # fmt: skip

    def pictures(self) -> Iterator[Picture]:
        """Pictures of the hoop stress and the von Mises stress of the long ring."""
        for data, what in (("hoop_stress", "Hoop"), ("von_mises", "Von Mises")):
            caption = f"{what} stress, plane strain, element averages"
            yield picture("plane strain", data, caption, mirror="xy")

    def sketch(self) -> Sketch:
        """Sketch of the ring with the pressures in its bore and on its rim."""
        inner = self.r_i / self.r_o
        pushed = [f"{p / 1e6:.4g} MPa {where}" for p, where in
                  ((self.p_i, "in the bore"), (self.p_o, "on the rim")) if p]  # fmt: skip
        return sketches.sketch(
            f"ring under {' and '.join(pushed)}; a quarter is modelled, with symmetry on both cuts",
            walls.quarter(inner), _pressure(self.p_i, inner - 0.2, inner, "p_i"),
            _pressure(self.p_o, 1.2, 1.0, "p_o"),
            walls.radii(((f"r_o = {self.shown('r_o')}", 140, 1.0),
                         (f"r_i = {self.shown('r_i')}", 217, inner))),
        )  # fmt: skip

    def warnings(self) -> Iterator[str]:
        """Warnings if the ring yields, strains are large, or the wall is thin."""
        _, hoop = lame.stresses([self.r_i, self.r_o], **self._loads)
        radial = np.array([-self.p_i, -self.p_o])
        shear = np.maximum.reduce([abs(hoop - radial), abs(hoop), abs(radial)])  # Tresca, σ_z = 0
        worst = int(np.argmax(shear))
        where, stress = ("bore", "rim")[worst], float(shear[worst])
        strain, wall = stress / self.E, self.r_o - self.r_i
        if self.R_p is not None and stress > self.R_p:
            yield (
                f"Tresca stress {stress / 1e6:.4g} MPa at the {where} exceeds R_p = "
                f"{self.shown('R_p')}: the ring yields, and Lamé's theory is not valid"
            )
        if strain > 2e-3 and self.R_p is None:
            yield f"strain reaches {strain:.2%} at the {where}: most steels yield; enter R_p"
        if strain > 1e-2:
            yield f"strain reaches {strain:.2%}: the theory of small strains has an equal error"
        if wall < 0.02 * self.r_o:
            yield (
                f"the wall is {wall / self.r_o:.1%} of r_o: out-of-roundness and bending, "
                "which Lamé's theory neglects, have larger effects than the pressure"
            )


def displacement_errors(edges: str) -> Any:
    """Function that returns mesh sizes h and relative L2 errors of the displacement field.

    The long ring is compared with Lamé's solution. `edges` is "_straight" for straight cell edges.
    """

    def errors(context: Context) -> tuple[list[float], list[float]]:
        q, found = context.inputs, []
        for result in context.fem:
            x, u, w = (result.arrays[f"{name}{edges}"] for name in ("x", "u", "weight"))
            r = np.hypot(*x)
            exact = lame.radial_displacement(
                np.clip(r, q.r_i, q.r_o), E=q.E, nu=q.nu, ends="plane strain", r_i=q.r_i,
                r_o=q.r_o, p_i=q.p_i, p_o=q.p_o,
            )  # fmt: skip
            error = ((u - exact * x / r) ** 2).sum(axis=0) @ w
            found.append(float(np.sqrt(error / (exact**2 @ w))))
        return [result.h for result in context.fem], found

    return errors


def _pressure(p: float, start: float, end: float, label: str) -> Iterator[Shape]:
    """Arrows of a pressure from radius `start` to `end`; reversed if `p` is negative."""
    ends = (start, end) if p > 0 else (end, start)
    for k, degrees in enumerate(AROUND if p else ()):
        first, last = (polar(r, degrees) for r in ends)
        yield sketches.arrow(first, last, "" if k else label)


LAME = adapted(Ring)
