"""Uniform rotating shaft: three beam theories, two kinds of elements, and the elastic body."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from verify.case import Level, Scan, drawn_by
from verify.cases.rotor.shaft import comparisons as compared
from verify.cases.rotor.shaft import figures as drawn
from verify.cases.rotor.shaft.comparisons import CEILING
from verify.cases.rotor.shaft.formulas import BeamTheories
from verify.cases.rotor.shaft.inputs import MODES
from verify.core.case import Context
from verify.core.figures import Table
from verify.form.adapter import adapted

FASTEST = 600.0  # rim speed [m/s] that hardly any steel withstands


class UniformShaft(BeamTheories):
    """Beam elements by Euler's, Rayleigh's and Timoshenko's theories against closed-form solutions.

    The whirl frequencies of the uniform shaft as an elastic body are also known exactly and give
    the errors of the three beam theories. The paper prints no dimensions; the dimensions here were
    chosen for this project.
    """

    id = "rotor-shaft"
    title = "Uniform rotating shaft"
    source = "huang2022"
    place = "Sec. 1: rotors of Timoshenko's beam elements (Nelson)"
    levels: ClassVar = (1, 2, 4, 8)
    scans: ClassVar = (
        Scan(
            vary=(
                "L=200mm,300mm,400mm,600mm,1200mm", "d_i=0mm,30mm,50mm",
                "n=2000r/min,10000r/min,30000r/min",
            ),
            star=True,
        ),
    )  # fmt: skip
    readings: ClassVar = (
        "the shear coefficient is Hutchinson's; with Cowper's coefficient, the error of "
        "Timoshenko's beam decreases only with (d_o/L)²",
        "the inertia terms in Ω² and the centrifugal stiffening are both neglected, because they "
        "cancel each other if cross-sections rotate as rigid discs",
    )
    assumptions: ClassVar = (
        "rigid bearings hold both ends in the transverse direction; the ends can move along the "
        "axis and tilt",
        "linear elasticity without damping",
        "critical speeds are those of synchronous forward whirl",
    )

    comparisons = compared.rows
    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch

    def reference(self, level: int) -> Level:
        """Results of beam elements, weak forms, and the elastic body."""
        from verify.cases.rotor.shaft.reference import solve

        return solve(self, level)

    def warnings(self) -> Iterator[str]:
        """Warnings if a theory is inaccurate, or if the speed is almost critical or too high."""
        if (error := self.euler.at_rest(1) / self.exact.at_rest(1) - 1) > 0.02:
            yield (
                f"the error of Euler's beam in the frequency of mode 1 is {error:+.1%}: use "
                "Timoshenko's theory"
            )
        worst = max((self.at_rest(j) / self.exact.at_rest(j) - 1 for j in MODES), key=abs)
        if abs(worst) > CEILING:
            yield (
                "the error of Timoshenko's beam in the frequencies of modes 1 to 3 is up to "
                f"{worst:+.2%}: the shaft is too short or thin-walled"
            )
        near = min(abs(self.n / self.exact.critical - 1), 1.0)
        if near < 0.1:
            yield f"{self.n * 30 / np.pi:.5g} r/min is within {near:.0%} of the critical speed"
        if (rim := self.n * self.d_o / 2) > FASTEST:
            yield f"the rim speed is {rim:.0f} m/s: steel bursts at about {FASTEST:.0f} m/s"

    def tables(self, context: Context) -> Iterator[Table]:
        """Table of the frequencies of all theories and of the elastic body."""
        yield drawn.frequencies(context)


SHAFT = adapted(UniformShaft)
