"""Case polyhedral-map."""
