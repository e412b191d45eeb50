"""The claims about a freewheel's friction: what it asks for, where slip starts, what slips then."""

from typing import Any

import numpy as np

from analytic.freewheel import criterion
from verify.cases.freewheel.friction.formulas import (
    both_contacts,
    limit_creep,
    limit_load,
    normal_force,
    one_contact,
    two_tangents,
    whole_load,
)
from verify.cases.freewheel.slip_limit import HELD
from verify.core.case import Context
from verify.core.figures import Array
from verify.judging.checks import Approximation, Exact, Identity
from verify.judging.tolerance_checks import (
    SUBJECT,
    Agreement,
    Deviation,
    Pair,
    PaperDeviation,
    suites,
)

ONSET, CONE = 1e-3, 5e-3  # acceptance of the subject
OWN = 2e-3  # and of F_t/F_n, which is the required friction without an axial load
ALONE = "as F_t/F_n, which it is without an axial load"
SHARE = 1e-3  # of F_t/(mu N) over the wedge angles
ANGLE = "two bodies that enclose the star say alpha, friction along surfaces by its size"
TILTED = f"{ANGLE}, surfaces tilt under N"
HEAVY: Any = {"own_demand": 0.03, "own_reason": "surfaces tilt by more, the heavier the load"}
ROOT: Any = {"demand": 0.015, "own_demand": 0.05}  # what a root of a small difference asks for
LIMITED, CREEPS = "it goes as √((μ/tan α)² − 1)", "it goes as 1/√((μ/tan α)² − 1)"
STATICS = 1e-6  # of a value: what forces in balance may miss
BALANCED = "forces in balance, on any mesh"


def required(context: Context, *, loaded: bool, of_mesh: bool = False) -> float:
    """Eq. 9 at the angle that finite elements have; their loads are in the ratio of the inputs.

    The mesh's own angle is that of its normals, on which the solver's friction acts.
    """
    turned, meshed = context.fem[-1].arrays["tan"]
    tan = meshed if of_mesh else turned
    q = context.inputs
    F_ax = q.F_ax if loaded else 0.0
    return float(criterion.required_friction(alpha=np.arctan(tan), T=q.T, F_ax=F_ax, R=q.R))


def onset(context: Context) -> Pair:
    """All of both contacts slips where friction is tan(alpha)."""
    share, half = context.fem[-1].arrays["onset"]
    tan = context.fem[-1].arrays["tan"][1]
    off = share * tan / required(context, loaded=False, of_mesh=True) - 1
    words = f"slip starts at {_of_required(off)}, {ONSET:.1%} accepted"
    return Pair(1 / (1 + off), 1.0, 2 * half, words)


def axial_onset(context: Context) -> Pair:
    """With friction mu_req the axial load is the limit, at which the clutch slips."""
    share, half = context.fem[-1].arrays["axial onset"]
    tan, q = context.fem[-1].arrays["tan"][1], context.inputs
    needed = required(context, loaded=True, of_mesh=True)
    off = share * tan * np.hypot(1.0, q.F_ax * q.R / q.T) / needed - 1
    words = f"slip starts at {_of_required(off)}, {CONE:.1%} accepted"
    return Pair(1 / (1 + off), 1.0, half, words)


def _of_required(off: float) -> str:
    return "no μ near μ_req" if np.isnan(off) else f"μ_req {off:+.3%}"


def of_contact(context: Context, where: int) -> Pair:
    """Resultant over N of one contact against Eq. 9."""
    before, now = (_off(context, r.arrays["loaded"][:, where]) for r in context.fem[-2:])
    words = f"off by {now:+.3%}, {OWN:.1%} accepted"
    return Pair(1 / (1 + now), 1.0, abs(now - before), words)


def _off(context: Context, forces: Array) -> float:
    N, F_t, F_z = forces
    found = criterion.required_friction_of_contact(F_n=N, F_t=F_t, F_a=F_z)
    return float(found / required(context, loaded=True) - 1)


def on_the_cone(context: Context) -> tuple[float, float, str]:
    """Resultant over mu N where all slips, of all contacts and clutches."""
    arrays, mu = context.fem[-1].arrays, context.inputs.mu
    last = arrays["creep"][-1] / mu
    slid = [row for row in arrays["angles"] if row[3] > 0]
    found = [np.hypot(last[2:4], last[4:6]), *(np.hypot(row[3::2], row[4::2]) for row in slid)]
    off = np.abs(np.concatenate(found) - 1).max()
    return float(off), 0.0, f"within {off:.2%} of μF_n, {CONE:.1%} accepted"


def over_angles(context: Context) -> tuple[float, float, str]:
    """How far F_t/(mu N) is off tan(alpha)/mu up to 1; beyond next to nothing is left of N."""
    k, left, ratio = context.fem[-1].arrays["angles"].T[:3]
    mu = context.inputs.mu
    alpha = np.arctan(k * mu)
    out = criterion.self_releasing(alpha=alpha, mu=mu)
    needed = criterion.required_friction(alpha=alpha, T=1.0, F_ax=0.0, R=1.0) / mu
    missed = np.where(out, SHARE * left / (1 - HELD), np.abs(ratio - needed))
    return float(missed.max()), 0.0, f"off by {missed.max():.1e} at most"


CHECKS = (
    Identity(name="tangential force of a roller (Eq. 3, corrected)", symbol="F_t", unit="N",
             fem="F_t", analytic="F_t", demand=STATICS, demand_reason=BALANCED),
    Identity(name="axial force of a roller, F_ax/z", symbol="F_a", unit="N", fem="F_a",
             analytic="F_a", scale="F_t", demand=STATICS, demand_reason=BALANCED),
    Approximation(name="normal force under torque", symbol="F_n", unit="N", fem="N", analytic="N",
                  interval=normal_force, source=TILTED, formal=2, **HEAVY),
    Approximation(name="required friction, torque alone (Eqs. 1, 2)", symbol="μ_req", unit="1",
                  fem="mu_t", analytic="mu_t", interval=both_contacts, source=ANGLE, formal=2),
    Approximation(name="required friction (Eqs. 8, 9)", symbol="μ_req", unit="1", fem="mu_req",
                  analytic="mu_req", interval=one_contact, source=TILTED, formal=2, **HEAVY),
    Approximation(name="required friction, Eq. 8 with the F_ax of Eq. 9 (as printed)",
                  symbol="μ_req", unit="1", fem="mu_req", analytic="Eq. 8 printed",
                  interval=whole_load, source=f"{TILTED}; z times a roller's axial force",
                  formal=2, **HEAVY),
    Approximation(name="tan α, Eq. 8 as printed", symbol="tan α", unit="1", fem="mu_t",
                  analytic="mu_req", interval=two_tangents,
                  source=f"{ANGLE}; √(1 + (F_ax R/T)²) of it is no tangent", formal=2),
    Approximation(name="limit of the axial load (Eq. 9)", symbol="F_ax,lim", unit="N",
                  fem="F_lim", analytic="F_lim", interval=limit_load, source=TILTED, formal=2,
                  demand_reason=LIMITED, own_reason=LIMITED, **ROOT),
    Approximation(name="creep of the ring that slips along the axis, F_t/F_a", symbol="R dφ/du_z",
                  unit="1", fem="creep", analytic="creep", interval=limit_creep,
                  source=f"Coulomb: slip is along the resultant; {TILTED}", formal=2,
                  demand_reason=CREEPS, own_reason=CREEPS, **ROOT),
    Agreement(name="torque alone: friction at which all slips (Eq. 1)", symbol="μ/tan α", unit="1",
              pair=onset, accepted=ONSET,
              source=SUBJECT),
    Agreement(name="friction below which the axial load finds no rest (Eqs. 8-10)",
              symbol="μ/μ_req", unit="1", pair=axial_onset, accepted=CONE,
              source=SUBJECT),
    Agreement(name="required friction on the star, at its own angle (Eqs. 8, 9)", symbol="μ_req",
              unit="1", pair=lambda context: of_contact(context, 0), accepted=OWN,
              source=suites(ALONE)),
    Agreement(name="required friction on the ring, at its own angle (Eqs. 8, 9)", symbol="μ_req",
              unit="1", pair=lambda context: of_contact(context, 1), accepted=OWN,
              source=suites(ALONE)),
    Deviation(name="slipping contacts are on the friction cone", symbol="F/(μF_n) − 1", unit="1",
              size=on_the_cone, accepted=CONE,
              source=SUBJECT, whole="μF_n"),
    PaperDeviation(name="wedge angles: held below tan α = μ, let out above",
                   symbol="ΔF_t/(μF_n)", unit="1", size=over_angles, accepted=SHARE,
                   source=suites("as sharp as the onset of slip"), whole="μF_n"),
    Exact(name="balance of a roller along the axis", symbol="ΣF_a", unit="N", fem="balance",
          scale="F_t", bound=1e-9, bound_reason="the solver's balance of a body that only contact "
          "holds"),
)  # fmt: skip
