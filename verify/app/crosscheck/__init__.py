"""Command crosscheck."""
