"""Stiffness of a sprag clutch between two rotors (Eqs. 1-11), beside struts between rigid hubs."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, ClassVar

from verify.case import Comparison, Drawn, Level, Scan
from verify.cases.rotor.clutch import advice, comparisons, figures
from verify.cases.rotor.clutch.formulas import ClutchStiffness
from verify.core.case import Check
from verify.core.figures import Sketch
from verify.core.references import Method
from verify.form.adapter import adapted


class ClutchLink(ClutchStiffness):
    """A clutch that a torque presses is a bearing and a torsion spring.

    Its stiffness follows from one potential; beside it stand struts between rigid hubs, inclined as
    the sprags are, in exact kinematics. What the equations leave out is derived, and so are the
    rows' intervals.
    """

    id = "rotor-clutch"
    title = "Sprag clutch as a link of two rotors"
    source = "huang2022"
    place = "Eqs. 1-11"
    method: ClassVar = Method("struts in exact kinematics", "struts")
    levels: ClassVar = (16, 32, 64, 128)
    scans: ClassVar = (
        Scan(
            vary=(
                "T=5N m,15N m,40N m", "Z=8,12,24", "nu=2.5deg,3.15deg,5deg", "n_s=11,41",
                "e=0.3µm,1µm", "drop=0.3µm,1µm",
            ),
            star=True,
        ),
    )  # fmt: skip
    readings: ClassVar = (
        "d_t of Eq. 4 is R_i tan ν, which T = Z N R_i tan ν asks for",
        "k_n of Eq. 2 is the constant of a whole sprag's law for both contacts; its slope is the "
        "tangent stiffness",
        "the twist of Eq. 8 counts the preload's",
        "2 L(x_k) of Eq. 6: both contacts have the crown",
    )
    assumptions: ClassVar = (
        "rigid races; sprags are forces along lines that yield as line contacts do",
        "sprags roll, so that their lines keep their distance from the axis",
        "an offset and a gap are held by the bearings; the torque stays the same",
        "the crown is a parabola; Eq. 6 takes any",
    )

    def reference(self, level: int) -> Level:
        """Struts, `level` slices for each sprag."""
        from verify.cases.rotor.clutch.reference import solve

        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Closed forms, uneven states, limits, misprints."""
        return comparisons.rows(self)

    def advice(self) -> Iterator[str]:
        """Stiffnesses, couplings, and what Eq. 3 leaves out."""
        yield from advice.findings(self)

    def summary(self) -> Mapping[str, Any]:
        """Stiffnesses in SI units."""
        return advice.summary(self)

    def warnings(self) -> Iterator[str]:
        """Where the stiffness means little."""
        return advice.warnings(self)

    def refusal(self) -> str:
        """Why struts are not asked."""
        return advice.refusal(self)

    def sketch(self) -> Sketch:
        """Both races with the sprags between them."""
        return figures.sketch(self)

    def figures(self) -> Sequence[Drawn]:
        """Stiffness over torque, offset, crown and gap."""
        return (Drawn(figures.figures),)


CLUTCH = adapted(ClutchLink)
