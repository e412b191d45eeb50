"""General causes of differences between formula and finite elements; tolerances of solvers."""

from verify.core import source_code
from verify.core.case import Case
from verify.judging.budget_statement import Cause, Constant, Rerun, Without

TIGHTER, LOOSER = 0.01, 100.0  # tighter tolerance over the usual one, unless round-off prevents it
# stopping tolerances of the iterative solvers, by module; others solve directly
TOLERANCES = (
    "fem.beam.large_newton:TOLERANCE",
    "fem.beam.large_stability:WIDTH",
    "fem.beam.touching_closest:SETTLED",
    "fem.contact.active_sets:STATE_TOLERANCE",
    "fem.contact.cone:EXACT",
    "fem.contact.convex:CONVERGED",
    "fem.contact.nitsche:BOUND",
    "fem.fourier.vibration:TOLERANCE",
    "fem.contact.pressed_line:HIT",
    "fem.contact.point_contact:HIT",
    "fem.wedge.pulled:STILL",
    "fem.wedge.rest:STILL",
    "fem.contact.driven:CLOSE",
    "fem.contact.wedged:HIT",
    "fem.wedge.flat_moved:NEAR",
)
CONTACT = ("fem.contact.problem", "fem.beam.touching", "fem.fourier.contact", "fem.rotor.struts")
# points of what bodies exert on each other; the law itself is exact: no pressure or no gap
INTEGRATED = ("fem.contact.pairing:GAUSS", "fem.fourier.contact:GAUSS")


def reached(case: Case) -> frozenset[str]:
    """Names of the modules that the finite elements of a case use, including the case's module."""
    return frozenset(source_code.modules_of(case.reference)) | {case.reference.__module__}


def tolerances(case: Case, factor: float) -> tuple[Constant, ...]:
    """Changes by `factor` of the stopping tolerances of all solvers that a case uses."""
    modules = reached(case)
    return tuple(
        Constant(target, factor) for target in TOLERANCES if target.partition(":")[0] in modules
    )


def without(case: Case) -> tuple[Without, ...]:
    """Causes that do not exist in the finite elements of a case, with reasons."""
    modules = reached(case)
    found = []
    if not any(name in modules for name in CONTACT):
        found.append(Without(Cause.CONTACT, "the reference model contains no contact"))
    if not any(name.startswith(("fem.plane", "fem.contact.problem")) for name in modules):
        found.append(Without(Cause.PLANE, "the reference is not a plane model"))
    return tuple(found)


def contact(case: Case, levels: tuple[int, ...]) -> tuple[Rerun, ...]:
    """Rerun with more integration points for an exact contact law; empty without such a law."""
    modules = reached(case)
    return tuple(
        Rerun(
            cause=Cause.CONTACT, what="exact contact law, integrated at twice as many points",
            changes=(Constant(target, 2),), levels=levels,
        )
        for target in INTEGRATED if target.partition(":")[0] in modules
    )  # fmt: skip
