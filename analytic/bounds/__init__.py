"""Expected errors of formulas, found before and without the formulas themselves."""
