"""Fault detection: deliberate changes of references, formulas, judging and finite elements."""
