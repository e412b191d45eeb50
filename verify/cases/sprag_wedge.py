"""A logarithmic sprag wedged between its races (Huang, Zhao, Liu, Eqs. 6, 7, 9, 10)."""

from verify.case import Case, Output
from verify.cases.sprag_inputs import WedgeInputs
from verify.cases.sprag_wedge_claims import CHECKS
from verify.cases.sprag_wedge_fem import LEVELS, fem
from verify.cases.sprag_wedge_model import analytic


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = True) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


WEDGE = Case(
    id="sprag-wedge",
    title="Logarithmic sprag wedged between its races",
    paper="huang2018",
    place="Eqs. 6, 7, 9, 10",
    lead="x",
    inputs=WedgeInputs,
    analytic=analytic,
    fem=fem,
    levels=LEVELS,
    checks=CHECKS,
    outputs=(
        output("nu", "ν(T)", "deg", "wedge angle under torque, at the inner contact (Eq. 10)"),
    ),
)  # fmt: skip
