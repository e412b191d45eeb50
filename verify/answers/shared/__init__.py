"""Assumptions that formula and reference of a case share, by subject."""
