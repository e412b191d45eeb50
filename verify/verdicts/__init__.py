"""Verdicts of formulas: may a formula be used, in which range, and on which side does it err."""
