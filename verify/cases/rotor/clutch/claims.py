"""What a clutch's formulas claim, beside struts: closed forms, uneven states, misprints."""

import math
from collections.abc import Callable
from functools import partial
from typing import Any

from analytic.rotor.clutch import LINE_CONTACT
from verify.cases.rotor.clutch.assertions import (
    DIFFERENCES,
    Misprint,
    another_lever,
    by_differences,
    displacements,
    no_coupling,
    one_angle,
    palmgrens,
    whole_displacement,
)
from verify.cases.rotor.clutch.inputs import ClutchInputs
from verify.cases.rotor.clutch.model import ENTRIES, STATES, corrected, tangent, tilted
from verify.cases.rotor.clutch.series import over_angle, over_offset, over_yield
from verify.cases.rotor.clutch.tilted import left_out
from verify.core.case import Values
from verify.judging.checks import Approximation, Exact, Fact, Identity, Limit
from verify.judging.tolerance_checks import SUBJECT, Agreement, Deviation

Interval = Callable[[Any, Any], tuple[float, float] | None]
TILTED = {"K_y,γx": "coupling of y and the tilt about x", "K_x,γy": "coupling of x and the tilt "
          "about y"}  # fmt: skip
SAME = "the same problem on both sides, to round-off"
SERIES = 4e-3  # that a series may be uncertain by
SHARE = 0.05  # of what Eq. 3 leaves out, that expectations are given to
INCLINED = "derived: forces along struts inclined by ν, directions cos ψ − tan ν sin ψ in Eq. 3, "\
    "and what tilting forces take; to a twentieth of either"  # fmt: skip
UNITS = {"K_xx": "N/mm", "K_yy": "N/mm", "K_tilt": "N m/rad", "K_zz": "N m/rad", "K_xz": "N",
         "K_xy": "N/mm", "K_yz": "N"}  # fmt: skip
WHAT = {
    "K_xx": "stiffness along x", "K_yy": "stiffness along y", "K_tilt": "tilting stiffness",
    "K_zz": "torsional stiffness", "K_xz": "coupling of bending and torsion",
    "K_xy": "coupling of x and y by the wedge angle",
    "K_yz": "coupling of y and torsion by the wedge angle",
}  # fmt: skip
IN_STATE = {
    "uniform": "uniform", "offset": "with an offset", "crown": "with a crown",
    "gap": "with sprags missing", "together": "with offset, crown and gap",
}  # fmt: skip


def expected(entry: str, state: str) -> Interval:
    """Interval of formula/struts - 1: the general formulas over the same corrected for ν.

    What both have in common cancels, so that no fault of a formula moves it.
    """

    def interval(q: ClutchInputs, _: Values) -> tuple[float, float]:
        K = float(corrected(q, STATES[state])[ENTRIES[entry]])
        left_out = tilted(q, STATES[state]) if entry == "K_tilt" else 0.0
        width = SHARE * (math.tan(q.nu) ** 2 + left_out / K)
        m = float(tangent(q, STATES[state])[ENTRIES[entry]]) / (K - left_out) - 1
        return m - width, m + width

    return interval


def first_order(q: ClutchInputs, v: Values) -> tuple[float, float] | None:
    """The same for the coupling's first term in eps = dx/delta_0; squares of eps^2 left out.

    The next term of the sum over cos psi, and the yield that the torque takes back; nothing where
    eps is too large for a first term, or sprags too few for fourth powers to sum to 3/8 of Z.
    """
    n, eps = LINE_CONTACT, q.e / v["delta_0"]
    after = ((n - 2) * (n - 3) / 8 + (2 - n) * (n - 1) / 4) * eps**2
    neglected = math.tan(q.nu) ** 2
    width = (neglected + eps**2) ** 2
    if width > SERIES or q.Z < 5:
        return None
    return -after - neglected - width, -after - neglected + width


def approximation(entry: str, state: str, key: str = "") -> Approximation:
    return Approximation(
        name=f"{WHAT[entry]}, {IN_STATE[state]}", symbol=entry, unit=UNITS[entry],
        fem=f"{entry}, {state}", analytic=key or f"{entry}, {state}", formal=2,
        interval=expected(entry, state), source=INCLINED,
    )  # fmt: skip


def identity(entry: str, state: str, key: str = "") -> Identity:
    return Identity(
        name=f"{WHAT[entry]}, {IN_STATE[state]}", symbol=entry, unit=UNITS[entry], formal=2,
        fem=f"{entry}, {state}", analytic=key or f"{entry}, {state}", demand=1e-9,
        demand_reason=SAME,
    )  # fmt: skip


def along(entry: str, state: str, scale: str, demand: float, reason: str) -> Identity:
    """An entry that Eq. 3 leaves out whole, with forces along the struts."""
    return Identity(
        name=f"{WHAT[entry]}, {IN_STATE[state]}", symbol=entry, unit=UNITS[entry], formal=2,
        fem=f"{entry}, {state}", analytic=f"{entry}, {state}, along struts",
        scale=f"{scale}, {state}", demand=demand, demand_reason=reason,
    )  # fmt: skip


def leading(q: ClutchInputs, _: Values) -> tuple[float, float]:
    """Eq. 3 alone: cos^2 for cos^2 + tan^2 nu sin^2 of every sprag, and the next term twice."""
    neglected = math.tan(q.nu) ** 2
    return -neglected, -neglected + 2 * neglected**2


def held_ends(q: ClutchInputs, v: Values) -> tuple[float, float]:
    """The same with struts held in both races: their forces turn with them, by Q/l; squares off."""
    length = q.R_e - q.R_i
    terms = (math.tan(q.nu) ** 2, v["delta_0"] / (LINE_CONTACT * length))
    return terms[1] - terms[0] - sum(terms) ** 2, terms[1] - terms[0] + sum(terms) ** 2


CHECKS = (
    *(
        Approximation(name=f"{WHAT[entry]}, uniform", symbol=entry, unit="N/mm",
                      fem=f"{entry}, uniform", analytic=entry, formal=2, interval=leading,
                      source="derived: Eq. 3 leaves tan²ν out; the next term, twice")
        for entry in ("K_xx", "K_yy")
    ),
    approximation("K_tilt", "uniform", "K_tilt"),
    identity("K_zz", "uniform", "K_zz"),
    Approximation(name=f"{WHAT['K_xz']} by an offset, first order", symbol="K_xz", unit="N",
                  fem="K_xz, offset", analytic="K_xz, first order", formal=2, interval=first_order,
                  source="derived: tan²ν, and the next term of the series in Δx/δ_0"),
    approximation("K_xz", "offset"),
    approximation("K_xx", "crown"),
    approximation("K_tilt", "crown"),
    approximation("K_xx", "gap"),
    approximation("K_yy", "gap"),
    approximation("K_tilt", "gap"),
    identity("K_xz", "gap"),
    identity("K_zz", "gap"),
    *(approximation(entry, "together") for entry in ENTRIES),
    *(
        Approximation(name=f"{what}, aside and tilted", symbol=entry, unit="N",
                      fem=f"{entry}, tilted", analytic=f"{entry}, tilted", formal=2,
                      interval=partial(left_out, entry),
                      source="derived: forces inclined by ν, points that sink and move along the "
                      "axis as the race tilts; to a twentieth of either")
        for entry, what in TILTED.items()
    ),
    *(
        along(entry, state, scale, demand, reason)
        for state, demand, reason in (("gap", 1e-9, SAME), ("together", 1e-6, "slices of a crown"))
        for entry, scale in (("K_xy", "K_xx"), ("K_yz", "K_xz"))
    ),
    Approximation(name="stiffness along x, ends held in both races", symbol="K_xx", unit="N/mm",
                  fem="K_xx, pinned", analytic="K_xx", formal=2, interval=held_ends,
                  source="derived: tan²ν and Q/(k l), their sum's square left out"),
    Identity(name="torsional stiffness, ends held in both races", symbol="K_zz", unit="N m/rad",
             fem="K_zz, pinned", analytic="K_zz, pinned", formal=2, demand=1e-8,
             demand_reason=SAME),
    *(
        Exact(name=f"entries off the diagonal, {name}", symbol="K_ab", unit="N/mm", fem=key,
              scale="K_xx", bound=1e-12, bound_reason="sums over even sprags, round-off")
        for name, key in (("uniform", "off-diagonal"),
                          ("ends held in both races", "off-diagonal, pinned"))
    ),
    Exact(name="axial stiffness, uniform", symbol="K_z", unit="N/mm", fem="axial", scale="K_xx",
          bound=1e-12, bound_reason="forces lie across the axis"),
    *(
        Exact(name=f"torque, {name}", symbol="M_z − T", unit="N m", fem=key, scale="T",
              bound=1e-11, bound_reason="Newton's tolerance 1e-12")
        for name, key in (("uniform", "torque"), ("ends held in both races", "torque, pinned"))
    ),
    Identity(name="exponent of the stiffness over the torque", symbol="p", unit="1",
             fem="exponent", analytic="exponent", formal=2, demand=1e-9,
             demand_reason="a power law on both sides"),
    Limit(name="stiffness along x as the wedge angle vanishes", symbol="d_0", unit="1",
          points=over_angle, exponent=2, demand=1e-8, demand_reason=SAME),
    Limit(name="torsional stiffness as yields vanish, ends held in both races", symbol="d_0",
          unit="1", points=over_yield, exponent=1, demand=1e-8, demand_reason=SAME),
    Limit(name="coupling linear in a small offset", symbol="d_0", unit="1", points=over_offset,
          exponent=2, demand=1e-6, demand_reason="the next term of the series"),
    Deviation(name="tangent against differences of the loads, 1e-8", symbol="ΔK/K_xx", unit="1",
              size=by_differences, accepted=DIFFERENCES,
              source=SUBJECT, whole="K_xx", fem_needed=False,
              by="differences of the loads", everywhere=True),
    Fact(name="five displacements, all of them held", symbol="K_ps", unit="1",
         margin=displacements(5), fem_needed=False, printed=("huang2022:clutch-stiffness-dofs",)),
    Fact(name="six displacements, the axial one free", symbol="K_s", unit="1",
         margin=displacements(6), fem_needed=False, printed=("huang2022:clutch-element-dofs",)),
    Agreement(name="exponent of Palmgren's line contact", symbol="n", unit="1", pair=palmgrens,
              accepted=1e-12, source="the same power, to round-off", by="theory", fem_needed=False,
              everywhere=True,
              printed=("huang2022:exponent-numerator", "huang2022:exponent-denominator")),
    Misprint(name="Eq. 9 with one angle for all sprags", symbol="F_r", unit="1",
             erratum="huang2022:eq-9-sprag-index", margin=one_angle),
    Misprint(name="Eq. 10 with whole displacements", symbol="P_s", unit="1",
             erratum="huang2022:eq-10-increments", margin=whole_displacement),
    Misprint(name="a torque with another lever than Eq. 4's", symbol="M_z", unit="1",
             erratum="huang2022:eq-9-torque-row", margin=another_lever),
    Misprint(name="bending and torsion coupled by the torque alone", symbol="K_xz", unit="1",
             erratum="huang2022:eq-11-bending-torsion", margin=no_coupling, fem_needed=True),
)  # fmt: skip
