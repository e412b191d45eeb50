"""Bounds of the subject rotor."""
