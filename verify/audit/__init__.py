"""Audits of the suite: fault detection (mutants), changes since a release, other machines."""
