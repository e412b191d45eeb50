"""Case polyhedral-ring."""
