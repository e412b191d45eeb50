"""Case polyhedral-locking."""
