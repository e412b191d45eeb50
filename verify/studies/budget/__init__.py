"""Error budgets: a comparison is repeated with single causes of its difference removed."""
