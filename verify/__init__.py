"""Pairs every formula with a finite-element model and judges the difference."""
