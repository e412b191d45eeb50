"""Thick rings."""
