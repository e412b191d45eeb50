"""Bounds of the subject spring."""
