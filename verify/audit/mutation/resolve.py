"""Cases whose finite elements use formulas: they must be solved again with a mutant of a formula.

Stored levels of unchanged code are not valid for such a mutant: the statuses of rows could differ
from those of a new run. The key of stored levels contains the formulas that they use.
"""

from collections.abc import Sequence
from functools import cache

from verify.audit.mutation.trial import Bench
from verify.core.case import Case
from verify.core.source_code import modules_of

# s of one core for all levels: these cases are solved with the mutant. Cases that take longer are
# not used for mutants of formulas on which their levels depend.
SOLVED = {
    "rotor-clutch": 1.0, "spring-stages": 1.5, "contact-roller-flat": 4.0, "rotor-shaft": 9.0,
    "sprag-engagement": 14.0,
}  # fmt: skip
QUICK = 5.0  # s: the others are solved last, after the tests


@cache
def formulas_in(case: Case) -> frozenset[str]:
    """Modules of formulas that the finite-element levels of a case use."""
    return frozenset(name for name in modules_of(case.reference) if name.startswith("analytic."))


def split(module: str, benches: Sequence[Bench]) -> tuple[list[Bench], list[Bench], list[Bench]]:
    """Return cases with valid stored levels, fast cases to solve again, slow cases to solve again.

    A case is solved again if its finite elements use formulas of `module`. Cases that take too long
    are not included.
    """
    stored = [bench for bench in benches if module not in formulas_in(bench.load.case)]
    moved = [
        bench for bench in benches
        if module in formulas_in(bench.load.case) and bench.load.case.id in SOLVED
    ]  # fmt: skip
    moved.sort(key=lambda bench: SOLVED[bench.load.case.id])
    quick = [bench for bench in moved if SOLVED[bench.load.case.id] <= QUICK]
    return stored, quick, moved[len(quick) :]


def seconds(benches: Sequence[Bench]) -> float:
    """Time [s] for solving the cases."""
    return sum(SOLVED[bench.load.case.id] for bench in benches)
