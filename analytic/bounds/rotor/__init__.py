"""Expected errors of rotor formulas."""
