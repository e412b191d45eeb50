"""Expected errors of the formulas of the polyhedral ring clutch."""
