"""Case polyhedral-pressure."""
