"""Sprag clutch - flexible rotor system: 22 nodes, three critical speeds, and no dimensions."""

from collections.abc import Sequence

from verify.cases.rotor.sprag import figures as shown
from verify.cases.rotor.sprag import tables
from verify.cases.rotor.sprag.claims import FITTED_SPEEDS, IDENTITIES, SHARES
from verify.cases.rotor.sprag.elastic import ELASTIC
from verify.cases.rotor.sprag.fem import LEVELS, fem
from verify.cases.rotor.sprag.inputs import RPM, SpragRotorInputs
from verify.cases.rotor.sprag.linear import LINEAR_ROWS
from verify.cases.rotor.sprag.model import MODES, ORDERS, analytic
from verify.core.case import Case, Output, Scan, Values
from verify.core.figures import Equation
from verify.core.tex import tex


def findings(q: SpragRotorInputs, v: Values) -> Sequence[str]:
    speeds = ", ".join(f"{v[f'forward critical {k}'] / RPM:.0f}" for k in ORDERS)
    near = min((abs(q.rig_speed / v[f"forward critical {k}"] - 1), k) for k in ORDERS)
    return (
        f"the central system has forward critical speeds at {speeds} r/min, to which twelve "
        "unknowns were fitted: no evidence for any of them",
        f"{q.rig_speed / RPM:.5g} r/min lies {near[0]:.0%} off critical speed {near[1]}",
        f"{q.T:.3g} N m press its sprags by {v['yield'] * 1e6:.2g} µm: an offset of "
        f"{q.offset * v['yield'] * 1e6:.2g} µm is what couples bending and torsion here",
    )  # fmt: skip


def warnings(q: SpragRotorInputs, v: Values) -> Sequence[str]:
    found = []
    for k in ORDERS:
        off = abs(q.rig_speed / v[f"forward critical {k}"] - 1)
        if off < 0.1:
            found.append(
                f"{q.rig_speed / RPM:.5g} r/min is within {off:.1%} of critical speed {k}: "
                "orbits there say more about the damping than about the stiffness"
            )
    if q.zeta_high > 0.05:
        found.append("peaks 3 and 5 lie 12 % apart: damping ratios above 5 % merge them")
    return found


def equations(_q: SpragRotorInputs, v: Values) -> Sequence[Equation]:
    return (
        Equation(tex=r"M \ddot q + (C + \Omega G)\dot q + K q = f", place="Sec. 1, before Fig. 6"),
        Equation(tex=r"K v = \Omega^2 (M - G_1) v", place="forward critical speeds, r = x + iy"),
        Equation(tex=r"C = \alpha M + \beta K, \quad \zeta = \frac{1}{2}\left("
                     r"\frac{\alpha}{\omega} + \beta \omega\right)", place="Sec. 1, before Fig. 6"),
        Equation(tex=r"K_{xz} = (n - 1) K_{xx} d_t \frac{\Delta x}{\delta_0}",
                 numbers=rf"= {tex(v['coupling'])}\ \mathrm{{N}}",
                 place="coupling by an offset, first order"),
    )  # fmt: skip


SPRAG_ROTOR = Case(
    id="rotor-sprag",
    title="Sprag clutch - flexible rotor system",
    paper="huang2022",
    place="Sec. 1, Fig. 1; Secs. 2.1 to 2.3",
    lead="The paper's 22 nodes with twelve unknown dimensions and stiffnesses: none is printed, "
    "only three critical speeds are. Many sets of parameters have all three; what else the paper "
    "says is asked of every one of them. One set, reached from the middle of all ranges (the "
    "central system), is computed by exact transfer matrices, by finer and finer beams and as "
    "elastic bodies.",
    inputs=SpragRotorInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(
            vary=("speed=2000r/min,5000r/min,10000r/min", "T=8N m,15N m,25N m", "offset=0.1,0.2"),
            star=True,
        ),
    ),
    checks=(*IDENTITIES, *FITTED_SPEEDS, *LINEAR_ROWS, *ELASTIC, *SHARES),
    outputs=(
        *(Output(key=f"forward critical {k}", symbol=f"n_{k}", unit="r/min",
                 what=f"critical speed {k} (forward), central system") for k in ORDERS),
        *(Output(key=f"natural frequency {i + 1}", symbol=f"f_{i + 1}", unit="Hz",
                 what=f"natural frequency {i + 1} at the speed of comparison")
          for i in range(MODES)),
        *(Output(key=f"amplitude {n}", symbol=f"x_{n}", unit="µm",
                 what=f"amplitude of node {n} at the rig's speed, no damping") for n in (4, 19)),
        Output(key="torsion, clutch", symbol="f_c", unit="Hz",
               what="torsional frequency of the clutch between both rotors"),
        Output(key="coupling", symbol="K_xz", unit="N",
               what="coupling of bending and torsion by the offset"),
        Output(key="yield", symbol="δ_0", unit="µm", what="deformation of the sprags under T",
               judged=False),
    ),
    readings=(
        "orders 1, 3 and 5 are the three lowest forward whirls: unbalance drives no other on "
        "isotropic supports, and the response peaks there; orders 2, 4 and 6 are their backward "
        "partners, though these lie below",
        "the paper's mesh is what was fitted: one beam element in each of the 20",
        "node 12 is the drum's free end: it moves more than node 11 in every overhung drum",
    ),
    assumptions=(
        "linear vibration about the preloaded state; isotropic bearings unless told otherwise",
        "both rotors turn at one speed (engaged clutch); steel; Hutchinson's shear coefficients",
        "Rayleigh damping acts on absolute motion: damping ratios at critical speeds 1 and 5 are "
        "even over their range in the sets of parameters",
        "both unbalances in phase (no angle is printed); shares with them opposite stand beside",
        "a clutch load uneven in space (offset of the rings), all sprags on one contact law",
    ),
    quick=False,
    findings=findings,
    warnings=warnings,
    equations=equations,
    tables=tables.tables,
    sketch=tables.sketch,
    figures=shown.figures,
)  # fmt: skip
