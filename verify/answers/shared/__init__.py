"""Assumptions that the formula and the reference of a case share, by subject."""
