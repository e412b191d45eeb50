"""What each case says of the causes of its differences, by its id.

Kept apart from the cases' own modules: many of these are read by finite elements of other cases,
whose results would count as another code's with every word that is added here.
"""

from collections.abc import Mapping

from verify.budget.statement import Statement
from verify.cases import ring_budget

STATEMENTS: Mapping[str, Statement] = {**ring_budget.STATEMENTS}
