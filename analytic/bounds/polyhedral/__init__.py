"""Expected errors of the polyhedral ring clutch's formulas."""
