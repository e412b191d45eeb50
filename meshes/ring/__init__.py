"""Rings and sectors of rings."""
