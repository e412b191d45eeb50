"""Errors that formulas may have, known beforehand and without the formulas themselves."""
