"""Expected errors of formulas, computed before a comparison and without the formulas."""
