"""Error budgets: reruns of a comparison without one cause of its difference."""
