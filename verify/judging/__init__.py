"""Judging: grid convergence, verdicts, kinds of checks, and explanations of rows."""
