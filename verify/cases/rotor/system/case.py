"""Any rotor of coaxial shafts: exact transfer matrices beside beams, on an engineer's own file."""

from verify.cases.rotor.system import figures as shown
from verify.cases.rotor.system.claims import CHECKS
from verify.cases.rotor.system.fem import fem
from verify.cases.rotor.system.inputs import SystemInputs
from verify.cases.rotor.system.messages import findings, summary, too_large
from verify.cases.rotor.system.model import CRITICALS, FREQUENCIES, analytic
from verify.cases.rotor.system.sketch import sketch
from verify.cases.rotor.system.warnings import warnings
from verify.core.case import Case, Output, Scan

SYSTEM = Case(
    id="rotor-system",
    title="Rotor of coaxial shafts",
    paper="huang2022",
    place="Fig. 1: two rotors with bearings between them; no dimension is printed",
    lead="Shafts in segments, discs, bearings, links and unbalances as an engineer describes them. "
    "Exact transfer matrices find every frequency and critical speed; beams of finer and finer "
    "elements go to the same values. The numbers are this project's own.",
    inputs=SystemInputs,
    analytic=analytic,
    reference=fem,
    levels=(1, 2, 4, 8),
    scans=(
        Scan(vary=("speed=5000r/min,9000r/min", "supports[1].k=1e7N/m,6e7N/m,3e8N/m"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        *(
            Output(key=f"critical {g}.{k}", symbol=f"n_c{k}", unit="r/min",
                   what=f"critical speed {k}, {what}")
            for g, what in ((1, "the first shaft's unbalance"), (2, "unbalance of another speed"))
            for k in range(1, CRITICALS + 1)
        ),
        *(
            Output(key=f"frequency {k}", symbol=f"f_{k}", unit="Hz",
                   what=f"natural frequency {k} at the speed")
            for k in range(1, FREQUENCIES + 1)
        ),
        Output(key="torsion", symbol="f_t", unit="Hz", what="lowest torsional frequency"),
        Output(key="amplitude", symbol="|r|", unit="µm", what="amplitude of the probe's node"),
        Output(key="support load", symbol="F", unit="N", what="load of supports[1]"),
        Output(key="link load", symbol="F", unit="N", what="load of links[1]"),
    ),
    readings=(
        "an unbalance turns with the shaft that bears it, not with the first one",
        "critical speeds are the rotor's, whichever shaft's unbalance meets them",
    ),
    assumptions=(
        "nodes are the ends of segments; bearings, discs and clutches act at a node",
        "Timoshenko's beams with Hutchinson's shear coefficient; rigid discs",
        "linear bearings, which do not change with the speed",
        "frequencies and critical speeds without damping; the response with it",
        "unbalances of shafts that turn at different speeds add their amplitudes",
    ),
    findings=findings,
    summary=summary,
    warnings=warnings,
    equations=shown.equations,
    too_large=too_large,
    sketch=sketch,
    figures=shown.figures,
)  # fmt: skip
