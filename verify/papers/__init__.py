"""Printed contents of the five papers, as data."""
