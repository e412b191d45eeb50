"""What the cases of line contact of two elastic bodies share, and the error of Hertz's theory."""

from collections.abc import Iterator

from analytic.bounds.contact.line_bodies import InRace, OfDiscs
from analytic.contact import hertz_line
from verify.case import Comparison, Quantity, approximation, given
from verify.cases.contact.expected import BLUNT, expected
from verify.cases.contact.line import figures
from verify.cases.contact.line.hertz import HERTZ, LineContact
from verify.cases.contact.line.inputs import softness
from verify.core.figures import Picture


class TwoBodies(LineContact):
    """Line contact of two elastic bodies, which may have different materials."""

    E_1: float = given(
        "206 GPa",
        "GPa",
        "E_1",
        "Young's modulus of the roller (with two rollers: of the upper roller)",
        gt=0,
        le=1e5,
    )
    nu_1: float = given(
        0.3,
        "1",
        "ν_1",
        "Poisson's ratio of the roller (with two rollers: of the upper roller)",
        ge=0,
        le=0.45,
    )
    E_2: float = given(
        "206 GPa",
        "GPa",
        "E_2",
        "Young's modulus of the race (with two rollers: of the lower roller)",
        gt=0,
        le=1e5,
    )
    nu_2: float = given(
        0.3,
        "1",
        "ν_2",
        "Poisson's ratio of the race (with two rollers: of the lower roller)",
        ge=0,
        le=0.45,
    )

    @Quantity("E*", "GPa", "contact modulus, plane strain", role="step", source="Hertz",
              tex=r"\frac{1}{\frac{1 - \nu_1^2}{E_1} + \frac{1 - \nu_2^2}{E_2}}")  # fmt: skip
    def E_star(self) -> float:
        return float(hertz_line.contact_modulus(**self.materials, assumption="plane strain"))

    @Quantity("a", "µm", "half-width, Hertz", source=HERTZ,
              tex=r"\sqrt{\frac{4 P R'}{\pi E*}}")  # fmt: skip
    def a(self) -> float:
        return float(hertz_line.half_width(P=self.P, R=self.relative, E_star=self.E_star))

    @property
    def softness(self) -> float:
        return softness(self.E_1, self.nu_1) + softness(self.E_2, self.nu_2)

    @property
    def materials(self) -> dict[str, float]:
        """Young's moduli [Pa] and Poisson's ratios, as arguments of the formulas."""
        return {"E_1": self.E_1, "nu_1": self.nu_1, "E_2": self.E_2, "nu_2": self.nu_2}

    def against(
        self, known: OfDiscs | InRace, approach: Quantity, sources: tuple[str, str, str],
        shares: str = "",
    ) -> Iterator[Comparison]:  # fmt: skip
        """Rows: errors of Hertz's theory judged against the derived errors `known`.

        `sources` states the derivation for pressure and half-width, for the approach, and for the
        shear stress.
        """
        by, (contact, between, below) = type(self), sources
        yield approximation(by.p_0, order=2, expected=expected(known.pressure, contact))
        yield approximation(by.a, order=2, expected=expected(known.width, contact))
        yield approximation(approach, order=2, expected=expected(known.approach, between),
                            shares=shares)  # fmt: skip
        yield approximation(by.tau_max, order=2,
                            expected=expected(known.shear, below, least=BLUNT))  # fmt: skip

    figures = figures.two_bodies

    def pictures(self) -> Iterator[Picture]:
        """Pictures of stresses near the contact."""
        yield from figures.pictures(self.guess)
