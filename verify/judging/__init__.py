"""Convergence, verdicts, the kinds of checks, and how a row is explained."""
