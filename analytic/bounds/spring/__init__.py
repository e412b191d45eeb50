"""Expected errors of spring formulas."""
