"""Bounds of the subject contact."""
