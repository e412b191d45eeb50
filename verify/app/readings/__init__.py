"""Command definitions."""
