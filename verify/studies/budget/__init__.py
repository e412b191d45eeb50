"""Error budgets: one cause of the difference of formula and finite elements changed, rerun."""
