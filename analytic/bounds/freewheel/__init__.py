"""Expected errors of the formulas of roller freewheels."""
