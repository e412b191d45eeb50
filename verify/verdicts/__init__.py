"""Verdicts on formulas: whether, and in which range, a formula may be used, and its safe side."""
