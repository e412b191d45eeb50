"""What each case says of the causes of its differences, by its id.

Kept apart from the cases' own modules: many of these are read by finite elements of other cases,
whose results would count as another code's with every word that is added here.
"""

from collections.abc import Mapping

from verify.budget_statement import Statement
from verify.cases import (
    contact_budget,
    freewheel_budget,
    polyhedral_budget,
    ring_budget,
    rotor_budget,
    sprag_budget,
    spring_budget,
)

STATEMENTS: Mapping[str, Statement] = {
    **ring_budget.STATEMENTS, **polyhedral_budget.STATEMENTS, **freewheel_budget.STATEMENTS,
    **sprag_budget.STATEMENTS, **spring_budget.STATEMENTS, **contact_budget.STATEMENTS,
    **rotor_budget.STATEMENTS,
}  # fmt: skip
