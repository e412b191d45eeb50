"""Any rotor of coaxial shafts from a user's file: exact transfer matrices against beams."""

from typing import ClassVar

from verify.case import Level, Scan, drawn_by
from verify.cases.rotor.system import advice as advised
from verify.cases.rotor.system import comparisons as compared
from verify.cases.rotor.system import figures as drawn
from verify.cases.rotor.system import sketch as sketched
from verify.cases.rotor.system import warnings as odd
from verify.cases.rotor.system.formulas import TransferRotor
from verify.form.adapter import adapted


class RotorSystem(TransferRotor):
    """Rotor of coaxial shafts with discs, bearings, clutches and unbalances, described in a file.

    Exact transfer matrices give each natural frequency and critical speed; refined beam elements
    converge to these values. The default inputs were chosen for this project.
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
        "an unbalance rotates with the shaft on which it is mounted",
        "critical speeds are computed for the unbalance of each shaft, and stated as speeds of the "
        "first shaft",
    )
    assumptions: ClassVar = (
        "the nodes are the ends of the segments; each bearing, disc and clutch acts at a node",
        "Timoshenko's beams with Hutchinson's shear coefficient; rigid discs",
        "linear bearings whose coefficients do not depend on the speed",
        "frequencies and critical speeds are computed without damping, the response with damping",
        "if shafts rotate at different speeds, the amplitudes due to their unbalances are added",
    )

    comparisons = compared.rows
    figures = drawn_by(drawn.figures)
    sketch = sketched.sketch
    warnings = odd.warnings
    advice = advised.findings
    summary = advised.summary
    refusal = advised.refusal

    def reference(self, level: int) -> Level:
        """Results of beams; each segment is divided into `level` elements."""
        from verify.cases.rotor.system.reference import solve

        return solve(self, level)


SYSTEM = adapted(RotorSystem)
