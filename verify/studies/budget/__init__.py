"""Error budgets: reruns of a comparison without single causes of its difference."""
