"""Comparisons with second solvers, by subject."""
