"""Sweeps, regions of validity, error budgets, second solvers, readings and designs."""
