"""Command portable."""
