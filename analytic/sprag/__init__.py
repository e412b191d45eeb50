"""Logarithmic sprag clutches."""
