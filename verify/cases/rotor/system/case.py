"""Any rotor of coaxial shafts: exact transfer matrices beside beams, on an engineer's own file."""

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar

from verify.case import Comparison, Drawn, Level, Scan
from verify.cases.rotor.system import advice, comparisons, figures, sketch, warnings
from verify.cases.rotor.system.formulas import TransferRotor
from verify.core.case import Check
from verify.core.figures import Sketch
from verify.form.adapter import adapted


class RotorSystem(TransferRotor):
    """Shafts in segments, discs, bearings, links and unbalances as an engineer describes them.

    Exact transfer matrices find every frequency and critical speed; beams of finer and finer
    elements go to the same values. The numbers are this project's own.
    """

    id = "rotor-system"
    title = "Rotor of coaxial shafts"
    source = "huang2022"
    place = "Fig. 1: two rotors with bearings between them; no dimension is printed"
    levels: ClassVar = (1, 2, 4, 8)
    scans: ClassVar = (
        Scan(vary=("speed=5000r/min,9000r/min", "supports[1].k=1e7N/m,6e7N/m,3e8N/m"), star=True),
    )
    readings: ClassVar = (
        "an unbalance turns with the shaft that bears it, not with the first one",
        "critical speeds are the rotor's, whichever shaft's unbalance meets them",
    )
    assumptions: ClassVar = (
        "nodes are the ends of segments; bearings, discs and clutches act at a node",
        "Timoshenko's beams with Hutchinson's shear coefficient; rigid discs",
        "linear bearings, which do not change with the speed",
        "frequencies and critical speeds without damping; the response with it",
        "unbalances of shafts that turn at different speeds add their amplitudes",
    )

    def reference(self, level: int) -> Level:
        """Beams, every segment cut into `level` elements."""
        from verify.cases.rotor.system.reference import solve

        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Every frequency, critical speed and load, and those of a companion."""
        return comparisons.rows(self)

    def advice(self) -> Iterator[str]:
        """Whether the operating speeds are clear of critical ones, the verdict first."""
        yield from advice.findings(self)

    def summary(self) -> Mapping[str, Any]:
        """Every critical speed with its distance."""
        return advice.summary(self)

    def warnings(self) -> Iterator[str]:
        """What is odd about the rotor."""
        yield from warnings.warnings(self)

    def refusal(self) -> str:
        """Why beams are not taken."""
        return advice.refusal(self)

    def sketch(self) -> Sketch:
        """Half a section of the rotor."""
        return sketch.sketch(self)

    def figures(self) -> tuple[Drawn]:
        """Campbell diagram, modes, response, convergence."""
        return (Drawn(figures.figures),)


SYSTEM = adapted(RotorSystem)
