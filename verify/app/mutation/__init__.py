"""Command mutation."""
