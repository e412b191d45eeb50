"""Writes what the verification found: pages and tables."""
