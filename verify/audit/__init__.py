"""Mutants, changes since a release, other machines."""
