"""Rows on the onset of slip of a freewheel, at the clamping angle by finite elements."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from analytic.freewheel import criterion
from fem.wedge.slip_limit import HELD
from verify.case import Comparison, Quantity
from verify.core.case import Context
from verify.core.figures import Array
from verify.judging.tolerance_checks import (
    SUBJECT,
    Agreement,
    Deviation,
    Pair,
    suites,
)

ONSET, CONE = 1e-3, 5e-3  # acceptance of the subject
CONTACT = 2e-3  # also of F_t/F_n, the required friction without axial load
ALONE = "the same tolerance as for F_t/F_n, which is the required friction without axial load"
SHARE = 1e-3  # tolerance of F_t/(mu N) over the wedge angles
COULOMB = "Coulomb's law of friction"


def at_slip(mu_T: Quantity, mu_req: Quantity) -> Iterator[Comparison]:
    """Rows on friction at full slip: without and with axial load, and over the wedge angle."""

    def judged(check: Agreement | Deviation, q: Quantity) -> Comparison:
        return Comparison(check=check, quantity=q, shares=COULOMB)

    yield judged(
        Agreement(name="friction at which both contacts slip completely, torque alone (Eq. 1)",
                  symbol="μ/tan α",
                  unit="1", pair=onset, accepted=ONSET, source=SUBJECT), mu_T,
    )  # fmt: skip
    yield judged(
        Agreement(name="friction below which no equilibrium exists under the axial load "
                       "(Eqs. 8-10)",
                  symbol="μ/μ_req", unit="1", pair=axial_onset, accepted=CONE, source=SUBJECT),
        mu_req,
    )  # fmt: skip
    for where, part in enumerate(("star", "ring")):
        yield judged(
            Agreement(name=f"required friction on the {part}, Eqs. 8, 9 with the clamping angle "
                           "of the finite elements",
                      symbol="μ_req", unit="1", pair=partial(of_contact, where=where),
                      accepted=CONTACT, source=suites(ALONE)), mu_req,
        )  # fmt: skip
    yield judged(
        Deviation(name="friction forces of slipping contacts lie on the friction cone",
                  symbol="F/(μF_n) − 1",
                  unit="1", size=on_the_cone, accepted=CONE, source=SUBJECT, whole="μF_n"), mu_req,
    )  # fmt: skip
    yield judged(
        Deviation(name="rollers with tan α < μ are held, and rollers with tan α > μ are released",
                  paper_only=True, symbol="ΔF_t/(μF_n)", unit="1", size=over_angles, accepted=SHARE,
                  source=suites("the same sensitivity as for the onset of "
                                "slip"), whole="μF_n"), mu_T,
    )  # fmt: skip


def required(context: Context, *, loaded: bool, of_mesh: bool = False) -> float:
    """mu_req by Eq. 9 at the clamping angle by finite elements, with the load ratio of the inputs.

    With `of_mesh`, the angle follows from the normals of the mesh, as in the solver's friction.
    """
    turned, meshed = context.fem[-1].arrays["tan"]
    tan = meshed if of_mesh else turned
    q = context.inputs
    F_ax = q.F_ax if loaded else 0.0
    return float(criterion.required_friction(alpha=np.arctan(tan), T=q.T, F_ax=F_ax, R=q.R))


def onset(context: Context) -> Pair:
    """Pair of tan(alpha) and the friction coefficient at which both contacts slip completely."""
    share, half = context.fem[-1].arrays["onset"]
    tan = context.fem[-1].arrays["tan"][1]
    off = share * tan / required(context, loaded=False, of_mesh=True) - 1
    words = f"slip starts at {_of_required(off)}, {ONSET:.1%} accepted"
    return Pair(1 / (1 + off), 1.0, 2 * half, words)


def axial_onset(context: Context) -> Pair:
    """Pair of mu_req by Eq. 9 and the friction coefficient at slip under the axial load."""
    share, half = context.fem[-1].arrays["axial_onset"]
    tan, q = context.fem[-1].arrays["tan"][1], context.inputs
    needed = required(context, loaded=True, of_mesh=True)
    off = share * tan * np.hypot(1.0, q.F_ax * q.R / q.T) / needed - 1
    words = f"slip starts at {_of_required(off)}, {CONE:.1%} accepted"
    return Pair(1 / (1 + off), 1.0, half, words)


def _of_required(off: float) -> str:
    return "no μ near μ_req" if np.isnan(off) else f"a μ that differs from μ_req by {off:+.3%}"


def of_contact(context: Context, where: int) -> Pair:
    """Pair of mu_req by Eq. 9 and the friction coefficient that the forces of a contact require."""
    before, now = (_off(context, r.arrays["loaded"][:, where]) for r in context.fem[-2:])
    words = f"error {now:+.3%}, {CONTACT:.1%} accepted"
    return Pair(1 / (1 + now), 1.0, abs(now - before), words)


def _off(context: Context, forces: Array) -> float:
    N, F_t, F_z = forces
    found = criterion.required_friction_of_contact(F_n=N, F_t=F_t, F_a=F_z)
    return float(found / required(context, loaded=True) - 1)


def on_the_cone(context: Context) -> tuple[float, float, str]:
    """Largest relative deviation of the friction force from mu N at full slip.

    The maximum is taken over both contacts of this clutch, and of clutches with changed angles.
    """
    arrays, mu = context.fem[-1].arrays, context.inputs.mu
    last = arrays["creep"][-1] / mu
    slid = [row for row in arrays["angles"] if row[3] > 0]
    found = [np.hypot(last[2:4], last[4:6]), *(np.hypot(row[3::2], row[4::2]) for row in slid)]
    off = np.abs(np.concatenate(found) - 1).max()
    return float(off), 0.0, f"friction forces differ from μF_n by {off:.2%}, {CONE:.1%} accepted"


def over_angles(context: Context) -> tuple[float, float, str]:
    """Largest deviation of F_t/(mu N) from tan(alpha)/mu, over clutches of several angles.

    If tan(alpha) exceeds mu, the fraction of N that remains after release is judged instead.
    """
    k, left, ratio = context.fem[-1].arrays["angles"].T[:3]
    mu = context.inputs.mu
    alpha = np.arctan(k * mu)
    out = criterion.self_releasing(alpha=alpha, mu=mu)
    needed = criterion.required_friction(alpha=alpha, T=1.0, F_ax=0.0, R=1.0) / mu
    missed = np.where(out, SHARE * left / (1 - HELD), np.abs(ratio - needed))
    return float(missed.max()), 0.0, f"largest deviation {missed.max():.1e}"
