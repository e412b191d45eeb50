"""Case that compares crowns of Lundberg, of Johns and Gohar, and of the paper."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import Any, ClassVar, Self

import numpy as np

from analytic.contact.crown import johns_gohar, lundberg
from verify.case import Comparison, Computed, Level, Quantity, Scan, State, drawn_by
from verify.cases.contact.roller import comparisons, figures, half_space, texts
from verify.cases.contact.roller.crown_claims import (
    AT_ENDS,
    MID,
    deviations,
    printed_designs,
    uneven,
)
from verify.cases.contact.roller.crown_figures import drawn
from verify.cases.contact.roller.crowned import CrownedRoller
from verify.cases.contact.roller.formulas import MIDDLE, StripRoller
from verify.cases.contact.roller.inputs import DESIGNS, EVEN, Design, Divided, ending
from verify.cases.contact.roller.profiles import even_crowns
from verify.cases.contact.roller.profiles import gap as gap_again
from verify.cases.contact.window import named
from verify.core.case import Check
from verify.core.figures import Array, Picture, Sketch
from verify.core.references import BY_HALF_SPACE
from verify.form.adapter import adapted
from verify.judging.tolerance_checks import SUBJECT, suites

NEAR_END = 0.1e-3  # m, nearly the half-width, from the ends
FAR = 5.0  # a uniform pressure is judged up to this distance from the ends, in half-widths
BESIDE = (
    "deviation of Hertz's pressure from the pressure by strips, ± 0.3 %, which is the accepted "
    "error of strips"
)


class ComparedCrowns(Divided, StripRoller):
    """Crowns of Lundberg, of Johns and Gohar, and of the paper are compared on a half-space.

    The first two make the pressure uniform except near the ends. The crown of the paper has three
    parameters and a straight middle. Each crown carries the load for which it is designed.
    """

    id = "contact-roller-crowns"
    title = "Comparison of crowns of a roller"
    source = "huang2018"
    place = "Eq. 1, Figs. 11 and 12"
    method = BY_HALF_SPACE
    levels: ClassVar = (16, 24, 32)
    scans: ClassVar = (Scan(vary=("F=1500N,3407N,6000N", "L=6mm,9mm"), star=True),)
    readings: ClassVar = texts.READINGS[:2]
    assumptions: ClassVar = texts.ASSUMPTIONS[:4]
    crown: ClassVar[str] = "Lundberg"  # of the quantities

    @Quantity("A_1", "µm", "scale of the drop of Lundberg's crown and of Johns and Gohar's crown",
              source="Lundberg", role="step", tex=r"\frac{F}{\pi l E*}")  # fmt: skip
    def A_1(self) -> float:
        return float(self.F / (np.pi * self.L * self.E_star))

    @Quantity("z", "µm", "drop of Lundberg's crown at y = l/2 - d", source="Lundberg", role="step",
              tex=r"A_1 \ln\left(\frac{1}{1 - (2 y/l)^2}\right) "
              r"= A_1 \ln\left(\frac{1}{1 - (1 - \frac{2 d}{l})^2}\right)")  # fmt: skip
    def drop(self) -> float:
        return float(self._even("Lundberg")(np.array(self.L / 2 - self.d)))

    @Quantity(
        "z_e", "µm", "drop of Johns and Gohar's crown at the ends", source="Johns and Gohar",
        role="step",
        tex=r"A_1 \ln\left(\frac{1}{1 - (1 - 0.6065 b/l) \cdot (2 y/l)^2}\right) "
        r"= A_1 \ln\left(\frac{l}{\exp\left(-\frac{1}{2}\right) b}\right)",
    )  # fmt: skip
    def end_drop(self) -> float:
        return float(self._even("Johns")(np.array(self.L / 2)))

    @Quantity("p_max{0}", "MPa", "largest pressure outside the end zones d, (K_1, K_2, z_m) = {0}, "
              "strips", equation="1", role="step").over(DESIGNS)  # fmt: skip
    def p_max_of(self, design: Design) -> float:
        return self.designed(design).p_max

    def gap(self, y: Array) -> Array:
        """Gap [m], at y [m], between race and roller; the crown gives uniform pressure under F."""
        return self._even(self.crown)(y)

    def _even(self, crown: str) -> Callable[[Array], Array]:
        made: dict[str, Any] = {"load": self.F, "length": self.L, "E_star": self.E_star}
        if crown == "Lundberg":
            return lambda y: lundberg(y, **made)
        return lambda y: johns_gohar(y, half_width=self.b, **made)

    def with_crown(self, name: str) -> Self:
        """The roller with the crown `name` for uniform pressure."""
        return self if name == self.crown else self.variant(crown=name)

    def designed(self, design: Design) -> CrownedRoller:
        """The roller with the crown `design` of the paper, for Q = F."""
        same = {name: getattr(self, name) for name in Divided.model_fields}
        return CrownedRoller(**same, **design._asdict(), Q=self.F)

    def reference(self, level: int) -> Level:
        """Results of all crowns on the half-space."""
        values: dict[str, float] = {}
        u_it: dict[str, float] = {}
        arrays: dict[str, Array] = {}
        fields = []
        for name, crown in even_crowns(self).items():
            end = ending(name)
            found = half_space.pressed(self, level, crown=crown)
            beside = half_space.grid_scatter(self, found, level, crown=crown)
            even = np.sqrt(self.F / self.L * self.E_star / (np.pi * self.R))
            off = float(np.abs(found.beyond(FAR * self.b) / even - 1).max())
            values |= named(found.values | {"uneven": off}, end)
            # the largest value of a uniform pressure has no definite place
            u_it |= named({key: u for key, u in beside.items() if key != "p_max"}, end)
            arrays |= named(half_space.along(found), end)
            fields.append(half_space.patch(found, name))
        for design in DESIGNS:
            end = f"_of_{design!s}"
            found = half_space.pressed(self, level, crown=gap_again(self, design))
            near = float(found.beyond(NEAR_END).max())
            values |= named({"p_max": found.values["p_max"], "uneven": found.unevenness,
                             "near": near}, end)  # fmt: skip
            arrays |= named(half_space.along(found), end)
        return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=tuple(fields))

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows: uniform pressures, strips against the half-space, and designs of the paper."""
        q = ComparedCrowns
        for name, words in EVEN.items():
            interval = partial(self._near_strips, name)
            yield comparisons.estimated(
                q.p_0, f"p_mid{ending(name)}", name=f"{MIDDLE}, {words}", symbol="p", order=1,
                by=comparisons.HALF_SPACE, expected=Computed(interval, BESIDE),
                sensitivity=(0.01, ""), shares=comparisons.SHARED,
            )  # fmt: skip
        third = suites(
            "a third of 6 %, which is the accepted error of this load for a roller without crown"
        )
        for name, words in EVEN.items():
            state = State(self.with_crown(name), ending(name)[1:], words)
            for one, what, bound, source in (
                (q.p_mid, MIDDLE, MID, SUBJECT), (q.delta, "approach", MID, SUBJECT),
                (q.F_d, "load in both end zones d", AT_ENDS, third),
            ):  # fmt: skip
                yield comparisons.agreeing(
                    f"{what}, {words}: strips and half-space agree within {bound:.1%}",
                    one, bound, 0.0, source, state=state,
                )  # fmt: skip
        for name, words in EVEN.items():
            yield Comparison(check=uneven(f"uneven{ending(name)}", words, FAR), quantity=q.p_0)
        yield from printed_designs()
        yield from deviations()

    def _near_strips(self, name: str) -> tuple[float, float] | None:
        """Interval of the error of the uniform pressure: its deviation from strips, ± MID.

        The uniform pressure is computed separately here. Otherwise, an error of the judged value
        would also shift the interval.
        """
        if not self.is_default:
            return None
        even = float(np.sqrt(self.F / self.L * self.E_star / (np.pi * self.R)))
        m = even / self.with_crown(name).p_mid
        return m * (1 - MID) - 1, m * (1 + MID) - 1

    refusal = half_space.too_short

    def warnings(self) -> Iterator[str]:
        """Warning if the contact is wide compared with the roller."""
        yield from texts.of_width(self.b, self.R_1)

    figures = drawn_by(drawn)

    def sketch(self) -> Sketch:
        """Sketch of the roller with the first crown of the paper."""
        return figures.sketch(self.designed(DESIGNS[0]))

    def pictures(self) -> Iterator[Picture]:
        """Pictures of the pressure on the contact patch, one per crown for uniform pressure."""
        picture = figures.patch()
        for name, words in EVEN.items():
            yield replace(picture, field=name, caption=f"{words}: {picture.caption}")


CROWNS = adapted(ComparedCrowns)
