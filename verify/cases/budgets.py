"""Causes of the difference between formula and reference, by id of the case.

The causes are not in the modules of the cases. Finite-element modules import many modules of cases,
so that a changed text in such a module would invalidate stored results.
"""

from collections.abc import Mapping

from verify.cases.contact import budget as contact_budget
from verify.cases.freewheel import budget as freewheel_budget
from verify.cases.polyhedral import budget as polyhedral_budget
from verify.cases.ring import budget as ring_budget
from verify.cases.rotor import budget as rotor_budget
from verify.cases.sprag import budget as sprag_budget
from verify.cases.spring import budget as spring_budget
from verify.judging.budget_statement import Statement

STATEMENTS: Mapping[str, Statement] = {
    **ring_budget.STATEMENTS, **polyhedral_budget.STATEMENTS, **freewheel_budget.STATEMENTS,
    **sprag_budget.STATEMENTS, **spring_budget.STATEMENTS, **contact_budget.STATEMENTS,
    **rotor_budget.STATEMENTS,
}  # fmt: skip
