"""Expected errors of the formulas of sprag clutches."""
