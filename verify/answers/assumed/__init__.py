"""Assumed values of inputs that a parameter file omits, each with its source."""
