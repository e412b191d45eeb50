"""Case polyhedral-clutch."""
