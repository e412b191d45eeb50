"""Command sweep."""
