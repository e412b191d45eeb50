"""Expected errors of formulas, computed before a comparison and independently of the formulas."""
