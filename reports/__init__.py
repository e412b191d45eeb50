"""Writes the results of the verification: pages and tables."""
