"""Expected errors of contact formulas."""
