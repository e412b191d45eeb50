"""Command design."""
